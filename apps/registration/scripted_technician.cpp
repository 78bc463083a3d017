#include "apps/registration/scripted_technician.h"

#include <QAbstractButton>
#include <QScreen>

namespace carina
{
namespace
{

constexpr int kActInterval_ms = 100;
constexpr qint64 kRead_ms = 1200; ///< a person reads a page before acting
constexpr qint64 kVerified_ms = 4500;
constexpr qint64 kPatience_ms = 120'000; ///< a loaded computer draws slowly
constexpr double kMidway = 0.5;

QString pictureName(SiteStep step)
{
    switch (step) {
    case SiteStep::Tracker:
        return QStringLiteral("registration-1-tracker.png");
    case SiteStep::Stylus:
        return QStringLiteral("registration-2-stylus.png");
    case SiteStep::Landmarks:
        return QStringLiteral("registration-3-landmarks.png");
    case SiteStep::Touch:
        return QStringLiteral("registration-4-touch.png");
    case SiteStep::Fit:
        return QStringLiteral("registration-5-fit.png");
    case SiteStep::Verify:
        return QStringLiteral("registration-6-verify.png");
    }
    return {};
}

} // namespace

ScriptedTechnician::ScriptedTechnician(QWidget& window, const RegistrationModel& registration,
                                       QDir folder)
    : m_window{window},
      m_registration{registration},
      m_folder{std::move(folder)},
      m_step{registration.step()}
{
    m_all.start();
    m_inStep.start();
    connect(&m_timer, &QTimer::timeout, this, &ScriptedTechnician::work);
    m_timer.start(kActInterval_ms);
}

void ScriptedTechnician::work()
{
    if (m_registration.step() != m_step) {
        m_step = m_registration.step();
        m_inStep.restart();
    }
    const QString problem = m_registration.problem();
    if (!problem.isEmpty() || m_all.elapsed() > kPatience_ms) {
        m_timer.stop();
        Q_EMIT stuck(problem.isEmpty() ? m_registration.instruction() : problem);
    } else if (m_inStep.elapsed() >= kRead_ms) {
        workAtStep();
    }
}

void ScriptedTechnician::workAtStep()
{
    switch (m_step) {
    case SiteStep::Tracker:
    case SiteStep::Landmarks:
        photographOnce();
        return press("primary");
    case SiteStep::Stylus:
        return swing();
    case SiteStep::Touch:
        return touch();
    case SiteStep::Fit:
        return fit();
    case SiteStep::Verify:
        return verify();
    }
}

void ScriptedTechnician::swing()
{
    if (m_registration.isSwinging()) {
        if (m_registration.progress() >= kMidway)
            photographOnce();
        return;
    }
    press(m_registration.isDone(m_step) ? "next" : "primary");
}

void ScriptedTechnician::touch()
{
    const auto next = m_registration.nextLandmark();
    if (!next)
        return press("next");
    if (2 * *next >= m_registration.landmarks().size() && m_registration.progress() >= kMidway)
        photographOnce();
}

void ScriptedTechnician::fit()
{
    if (!m_registration.isDone(m_step)) {
        m_inStep.restart();
        return press("primary");
    }
    photographOnce();
    press("next");
}

void ScriptedTechnician::verify()
{
    if (m_inStep.elapsed() < kVerified_ms || !m_registration.stylusOnAnatomy())
        return;
    photographOnce();
    m_timer.stop();
    Q_EMIT done();
}

void ScriptedTechnician::photographOnce()
{
    if (m_photographed.insert(m_step).second)
        m_window.screen()
            ->grabWindow(m_window.winId())
            .save(m_folder.filePath(pictureName(m_step)));
}

void ScriptedTechnician::press(const char* button)
{
    m_window.findChild<QAbstractButton*>(QLatin1String{button})->click();
}

} // namespace carina
