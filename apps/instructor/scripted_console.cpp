#include "apps/instructor/scripted_console.h"

#include "apps/program/control_script.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>

#include <algorithm>

namespace carina
{
namespace
{

constexpr int kStartAfter_ms = 500;
constexpr int kWorkAfter_ms = 3000;
constexpr int kLookInterval_ms = 50;
constexpr int kRateStep_per_min = 5;
constexpr int kTidalVolumeStep_ml = 70;
constexpr int kCompanySettles_ms = 2000;  ///< and has its window by then
constexpr double kTurn_deg_per_s = 100.0; ///< as in the paper's experiment
constexpr int kTurn_ms = 3000;
constexpr int kStill_ms = 1000;

bool isConnected(const LinkReport& link) { return link.state == LinkState::Connected; }

} // namespace

ScriptedConsole::ScriptedConsole(QWidget& window, SessionNode& node, BreathingModel& breathing)
    : m_window{window}, m_node{node}, m_breathing{breathing}
{
    QTimer::singleShot(kStartAfter_ms, this, [this] {
        m_window.findChild<QAction*>(QStringLiteral("start"))->trigger();
    });
    QTimer::singleShot(kWorkAfter_ms, this, &ScriptedConsole::work);
    waitForCompany();
}

void ScriptedConsole::waitForCompany()
{
    auto* look = new QTimer{this};
    connect(look, &QTimer::timeout, this, [this, look] {
        if (!std::ranges::any_of(m_node.links(), isConnected))
            return;
        look->stop();
        QTimer::singleShot(kCompanySettles_ms, this, &ScriptedConsole::turnPatient);
    });
    look->start(kLookInterval_ms);
}

void ScriptedConsole::press(const char* button)
{
    program::fetched(m_window.findChild<QPushButton*>(QLatin1String{button}))->click();
}

void ScriptedConsole::note(const char* key)
{
    if (const auto now = m_node.now())
        m_action[QLatin1String{key}] = QString::number(qint64(now->time_since_epoch().count()));
}

void ScriptedConsole::turnPatient()
{
    m_window.findChild<QDoubleSpinBox*>(QStringLiteral("speed"))->setValue(kTurn_deg_per_s);
    m_action[QStringLiteral("speed_deg_per_s")] = kTurn_deg_per_s;
    note("from_ns");
    press("begin");
    QTimer::singleShot(kTurn_ms, this, [this] {
        note("to_ns");
        press("stop");
    });
    QTimer::singleShot(kTurn_ms + kStill_ms, this, [this] {
        note("until_ns");
        press("reset");
        program::fetched(m_window.findChild<QSpinBox*>(QStringLiteral("rate")));
    });
}

void ScriptedConsole::work()
{
    const auto turnUp = [this](const char* name, int step) {
        auto* control = program::fetched(m_window.findChild<QSpinBox*>(QLatin1String{name}));
        control->setValue(control->value() + step);
    };
    turnUp("rate", kRateStep_per_min);
    turnUp("tidalVolume", kTidalVolumeStep_ml);
    auto* look = new QTimer{this};
    connect(look, &QTimer::timeout, this, [this, look] {
        if (m_breathing.pending(BreathingParameter::Rate)
            || m_breathing.pending(BreathingParameter::TidalVolume))
            return;
        m_inForce = m_node.now();
        look->stop();
    });
    look->start(kLookInterval_ms);
}

QJsonObject ScriptedConsole::report() const
{
    const double rate_per_min = m_breathing.value(BreathingParameter::Rate);
    QJsonObject console{
        {QStringLiteral("breathing_rate_per_min"), rate_per_min},
        {QStringLiteral("tidal_volume_ml"), m_breathing.value(BreathingParameter::TidalVolume)}};
    if (m_inForce) {
        // The breath under way keeps its volume: the next whole one has the new one.
        const SessionTime steady = *m_inForce + fromSeconds(60.0 / rate_per_min);
        console[QStringLiteral("steady_from_ns")] =
            QString::number(qint64(steady.time_since_epoch().count()));
    }
    if (!m_action.isEmpty())
        console[QStringLiteral("action")] = m_action;
    return console;
}

} // namespace carina
