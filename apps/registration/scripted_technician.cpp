#include "apps/registration/scripted_technician.h"

#include "engine/io/site/site_json.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QScreen>

namespace carina
{
namespace
{

constexpr int kActInterval_ms = 100;
constexpr qint64 kRead_ms = 1200;        ///< a person reads a page before acting
constexpr qint64 kPatience_ms = 200'000; ///< a loaded computer draws slowly
constexpr double kMidway = 0.5;

/// Pages in the order in which they are worked at, the overview last.
QString pictureName(SiteStep step)
{
    const int page = step == SiteStep::Overview ? 8 : int(step);
    return QStringLiteral("registration-%1-%2.png")
        .arg(page)
        .arg(QLatin1StringView{kStepWords[std::size_t(step)]});
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
    case SiteStep::Tools:
        return tools();
    case SiteStep::Overview:
        return overview();
    }
}

void ScriptedTechnician::swing()
{
    if (m_registration.progress() >= kMidway)
        photographOnce();
    if (m_registration.task(m_step).state == TaskState::Done)
        press("next");
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
    if (m_registration.task(m_step).state != TaskState::Done) {
        m_inStep.restart();
        return press("primary");
    }
    photographOnce();
    press("next");
}

void ScriptedTechnician::verify()
{
    if (m_registration.verifying().next())
        return;
    photographOnce();
    press(m_registration.task(m_step).state == TaskState::Done ? "next" : "primary");
}

/// One tool after the other; the first is shown half way.
void ScriptedTechnician::tools()
{
    const ToolTask& task = m_registration.toolTask();
    if (task.isTouching()) {
        const auto places = task.places();
        if (places[places.size() / 2].isTouched)
            photographOnce();
        return;
    }
    const auto& offered = task.offered();
    for (std::size_t i = 0; i < offered.size(); ++i) {
        if (toolOfRole(m_registration.site().tools, offered[i]))
            continue;
        m_window.findChild<QComboBox*>(QStringLiteral("tool"))->setCurrentIndex(int(i));
        return press("primary");
    }
    press("next");
}

/// Everything is done, or a run before has ended before it was.
void ScriptedTechnician::overview()
{
    if (m_registration.nextStep() != SiteStep::Overview)
        return press("primary");
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
