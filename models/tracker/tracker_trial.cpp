#include "models/tracker/tracker_trial.h"

#include "engine/core/monotonic_clock.h"
#include "models/station/tool_status.h"

namespace carina
{
namespace
{

std::optional<SessionTime> trialTime() { return SessionTime{monotonicNow().time_since_epoch()}; }

} // namespace

TrackerTrial::TrackerTrial() { connect(&m_timer, &QTimer::timeout, this, &TrackerTrial::look); }

Result<void> TrackerTrial::begin(const TrackerDescription& description)
{
    end();
    auto tracker = DeviceTracker::make(description, trialTime);
    if (!tracker)
        return tl::unexpected(tracker.error());
    m_tracker = *std::move(tracker);
    m_address = description.address;
    m_isServer = description.kind == TrackerKind::OpenIgtLink;
    if (const auto started = m_tracker->start(); !started) {
        m_tracker.reset();
        return started;
    }
    m_timer.start(kInterval_ms);
    look();
    return {};
}

void TrackerTrial::end()
{
    m_timer.stop();
    m_tracker.reset();
    m_state = State::Idle;
    Q_EMIT changed();
}

void TrackerTrial::look()
{
    if (m_tracker->found())
        m_state = State::Answers;
    else
        m_state = m_tracker->trouble().empty() ? State::Looking : State::Silent;
    Q_EMIT changed();
}

QString TrackerTrial::text() const
{
    const QString address = QString::fromStdString(m_address);
    if (const auto found = m_tracker ? m_tracker->found() : std::nullopt)
        return foundText(*found);
    switch (m_state) {
    case State::Idle:
        return {};
    case State::Answers:
    case State::Looking:
        return tr("Looking for a tracker at %1 …").arg(address);
    case State::Silent:
        break;
    }
    return m_isServer
               ? tr("▲ No server of OpenIGTLink answers at %1 (%2): see that it runs there and "
                    "listens at this port, and that no firewall is between.")
                     .arg(address, trouble())
               : tr("▲ No tracker answers at %1 (%2): see that it is switched on and connected "
                    "there, that no other program uses it, and that you may open this port.")
                     .arg(address, trouble());
}

/// What the tracker says, without its address.
QString TrackerTrial::trouble() const
{
    QString text = QString::fromStdString(m_tracker->trouble());
    const QString prefix = QString::fromStdString(m_address) + QStringLiteral(": ");
    return text.startsWith(prefix) ? text.mid(prefix.size()) : text;
}

QStringList TrackerTrial::sentTools() const
{
    QStringList names;
    if (const auto found = m_tracker ? m_tracker->found() : std::nullopt)
        for (const std::string& name : found->sent)
            names << QString::fromStdString(name).simplified();
    return names;
}

QString TrackerTrial::foundText(const DeviceFound& found) const
{
    const QString address = QString::fromStdString(m_address);
    QStringList lines;
    if (m_isServer)
        lines << tr("✓ A server answers at %1, and sends: %2.")
                     .arg(address, sentTools().join(QStringLiteral(", ")));
    else
        lines << (found.name.empty()
                      ? tr("✓ A tracker answers at %1.").arg(address)
                      : tr("✓ Found at %1: %2.").arg(address, QString::fromStdString(found.name)));
    if (found.pluggedIn)
        lines << tr("Tools that are plugged in: %1").arg(*found.pluggedIn);
    if (const QString trouble = this->trouble(); !trouble.isEmpty())
        lines << QStringLiteral("▲ ") + trouble;
    for (const ToolStatus& tool : toolStatus(*m_tracker, *trialTime()))
        lines << QStringLiteral("%1 %2: %3")
                     .arg(tool.isVisible ? QStringLiteral("✓") : QStringLiteral("▲"), tool.name,
                          tool.text);
    return lines.join(QLatin1Char('\n'));
}

} // namespace carina
