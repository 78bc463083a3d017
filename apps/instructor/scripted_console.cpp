#include "apps/instructor/scripted_console.h"

#include <QAction>
#include <QSpinBox>
#include <QTimer>

namespace carina
{
namespace
{

constexpr int kStartAfter_ms = 500;
constexpr int kWorkAfter_ms = 3000;
constexpr int kLookInterval_ms = 50;
constexpr int kRateStep_per_min = 5;
constexpr int kTidalVolumeStep_ml = 70;

} // namespace

ScriptedConsole::ScriptedConsole(QWidget& window, SessionNode& node, BreathingModel& breathing)
    : m_window{window}, m_node{node}, m_breathing{breathing}
{
    QTimer::singleShot(kStartAfter_ms, this, [this] {
        m_window.findChild<QAction*>(QStringLiteral("start"))->trigger();
    });
    QTimer::singleShot(kWorkAfter_ms, this, &ScriptedConsole::work);
}

void ScriptedConsole::work()
{
    const auto turnUp = [this](const char* name, int step) {
        auto* control = m_window.findChild<QSpinBox*>(QLatin1String{name});
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
    return console;
}

} // namespace carina
