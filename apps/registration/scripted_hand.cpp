#include "apps/registration/scripted_hand.h"

namespace carina
{
namespace
{

constexpr int kLookInterval_ms = 50;
constexpr qint64 kVerifyEach_ms = 3000;

} // namespace

ScriptedHand::ScriptedHand(const RegistrationModel& registration,
                           const SimulatedWorkplace& workplace)
    : m_registration{registration}, m_workplace{workplace}, m_step{registration.step()}
{
    m_inStep.start();
    connect(&m_timer, &QTimer::timeout, this, &ScriptedHand::work);
    m_timer.start(kLookInterval_ms);
}

void ScriptedHand::work()
{
    if (m_registration.step() != m_step) {
        m_step = m_registration.step();
        m_inStep.restart();
    }
    const Order order = wanted();
    if (order != m_order)
        obey(order);
    m_order = order;
}

ScriptedHand::Order ScriptedHand::wanted() const
{
    switch (m_step) {
    case SiteStep::Stylus:
        if (m_registration.isSwinging())
            return {Task::Swing};
        return {m_registration.isDone(SiteStep::Stylus) ? Task::Park : Task::Ready};
    case SiteStep::Touch:
        if (const auto next = m_registration.nextLandmark())
            return {Task::Hold, *next};
        return {};
    case SiteStep::Verify:
        return wantedToVerify();
    case SiteStep::Tracker:
    case SiteStep::Landmarks:
    case SiteStep::Fit:
        break;
    }
    return {};
}

ScriptedHand::Order ScriptedHand::wantedToVerify() const
{
    const auto turn = std::size_t(m_inStep.elapsed() / kVerifyEach_ms);
    const std::size_t landmarks = m_registration.landmarks().size();
    return {Task::Hold, turn % landmarks, int(turn / landmarks)};
}

void ScriptedHand::obey(const Order& order)
{
    const SessionTime now = *m_workplace.clock();
    switch (order.task) {
    case Task::Park:
        return m_workplace.hand->park(now);
    case Task::Ready:
        return m_workplace.hand->hold(m_workplace.p_TQ_divot, now);
    case Task::Swing:
        return m_workplace.hand->swing(m_workplace.p_TQ_divot, now);
    case Task::Hold:
        return m_workplace.hand->hold(localised(order.landmark), now);
    }
}

/// Where the technician takes a landmark to be on the manikin, in T.
Vec3 ScriptedHand::localised(std::size_t landmark)
{
    // Of three equal and independent components.
    std::normal_distribution<double> component{0.0, kLocalisationError.si / std::sqrt(3.0)};
    const Vec3 error{component(m_random), component(m_random), component(m_random)};
    return m_workplace.X_TA * m_registration.landmarks()[landmark].p_AQ + error;
}

} // namespace carina
