#include "apps/registration/scripted_hand.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr int kLookInterval_ms = 50;

} // namespace

ScriptedHand::ScriptedHand(const RegistrationModel& registration,
                           const SimulatedWorkplace& workplace)
    : m_registration{registration}, m_workplace{workplace}
{
    connect(&m_timer, &QTimer::timeout, this, &ScriptedHand::work);
    m_timer.start(kLookInterval_ms);
}

void ScriptedHand::work()
{
    const Order order = wanted();
    if (order != m_order)
        obey(order);
    m_order = order;
}

ScriptedHand::Order ScriptedHand::wanted() const
{
    if (m_registration.stylus().isLookingForTip())
        return {.task = Task::Swing};
    const SiteStep step = m_registration.step();
    if (step == SiteStep::Tools)
        return wantedOfTool();
    if (step != SiteStep::Touch && step != SiteStep::Verify
        && !m_registration.manikin().isTouching())
        return {};
    const std::vector<LandmarkRow> places = m_registration.places();
    const auto next = std::ranges::find_if(places, &LandmarkRow::isNext);
    if (next == places.end())
        return {};
    return {.task = Task::Hold, .place = next->name, .p_TQ = m_workplace.X_TA * next->p_AQ};
}

ScriptedHand::Order ScriptedHand::wantedOfTool() const
{
    const ToolTask& task = m_registration.toolTask();
    const auto next = task.next();
    if (!next)
        return {};
    Order order{.task = Task::Hold, .place = task.nextName(), .error = kToolTouchError};
    const SimulatedTools& tools = m_workplace.tools;
    if (const auto* onTube = std::get_if<TubeTouchPlace>(&*next))
        order.p_TQ = m_workplace.X_TN_tube * (tools.X_NE * placeOnTube(tools.tube, *onTube));
    else
        order.p_TQ = m_workplace.X_TN_laryngoscope
                     * (tools.X_NL * placeOnBlade(tools.blade, std::get<BladePlace>(*next)));
    return order;
}

void ScriptedHand::obey(const Order& order)
{
    const SessionTime now = *m_workplace.clock();
    switch (order.task) {
    case Task::Park:
        return m_workplace.hand->park(now);
    case Task::Swing:
        return m_workplace.hand->swing(m_workplace.p_TQ_divot, now);
    case Task::Hold:
        return m_workplace.hand->hold(localised(order), now);
    }
}

/// Where the technician takes a place to be, in T.
Vec3 ScriptedHand::localised(const Order& order)
{
    // Of three equal and independent components.
    std::normal_distribution<double> component{0.0, order.error.si / std::sqrt(3.0)};
    const Vec3 error{component(m_random), component(m_random), component(m_random)};
    return order.p_TQ + error;
}

} // namespace carina
