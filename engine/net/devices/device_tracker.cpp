#include "engine/net/devices/device_tracker.h"

#include "engine/core/monotonic_clock.h"
#include "engine/core/prompt_thread.h"
#include "engine/net/devices/device_port.h"

#include <QTimer>

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr std::chrono::milliseconds kBeforeReopening{200};
constexpr std::chrono::milliseconds kFarewell{500}; ///< at most

std::optional<Probe> probeOf(const DescribedTool& tool)
{
    return tool.definition ? std::optional{tool.definition->probe()} : std::nullopt;
}

} // namespace

/// The client and its port, on the tracker's thread.
class DeviceTracker::Line : public QObject
{
public:
    explicit Line(DeviceTracker& tracker)
        : m_tracker{tracker}, m_client{deviceClient(tracker.m_description)}
    {
        m_timer.setSingleShot(true);
        m_timer.setTimerType(Qt::PreciseTimer);
        connect(&m_timer, &QTimer::timeout, this, [this] { m_isClosed ? open() : serve(); });
    }

    void begin()
    {
        auto port = DevicePort::make(
            address(), {.opened =
                            [this] {
                                if (m_tracker.m_log)
                                    m_tracker.m_log->opened(monotonicNow());
                                m_client->start(monotonicNow(), [this](int rate) {
                                    return m_port->holdsRate(rate);
                                });
                                serve();
                            },
                        .arrived = [this] { serve(); },
                        .closed = [this](const std::string& why) { reopenLater(why); }});
        m_port = *std::move(port); // make() of the tracker looked at the address
        open();
    }

    void end()
    {
        m_timer.stop();
        if (!std::exchange(m_isClosed, true)) // nothing is served any more
            leave();
        m_port->close();
        m_port.reset();
    }

private:
    [[nodiscard]] const std::string& address() const { return m_tracker.m_description.address; }

    [[nodiscard]] std::string trouble() const
    {
        std::string text = m_client->trouble();
        if (!text.empty())
            text = address() + ": " + text;
        if (m_tracker.m_log && m_tracker.m_log->hasFailed())
            text += (text.empty() ? "" : "; ") + m_tracker.m_log->file() + " cannot be written";
        return text;
    }

    /// Leaves the device idle. The event loop does not run, so the port is waited for here.
    void leave()
    {
        const LocalTime end = monotonicNow() + kFarewell;
        m_client->leave();
        for (LocalTime now = monotonicNow(); m_port->isOpen() && now < end; now = monotonicNow()) {
            exchange(now);
            m_port->flush(timeUntil(end, now));
            if (m_client->hasLeft())
                return;
            m_port->await(timeUntil(std::min(end, m_client->nextWake()), now));
        }
    }

    [[nodiscard]] static std::chrono::milliseconds timeUntil(LocalTime then, LocalTime now)
    {
        return std::max(std::chrono::ceil<std::chrono::milliseconds>(then - now),
                        std::chrono::milliseconds{1});
    }

    void open()
    {
        m_isClosed = false;
        m_port->close();
        m_port->open();
    }

    void reopenLater(const std::string& why)
    {
        if (std::exchange(m_isClosed, true))
            return; // a port that was unplugged says so until it is closed
        // Not from within the port's own signal.
        QMetaObject::invokeMethod(
            this, [this] { closeBroken(); }, Qt::QueuedConnection);
        m_tracker.say(address() + ": " + why);
        m_timer.start(kBeforeReopening);
    }

    void closeBroken()
    {
        if (m_port && m_isClosed)
            m_port->close();
    }

    void serve()
    {
        if (m_isClosed || !m_port->isOpen())
            return;
        const LocalTime now = monotonicNow();
        exchange(now);
        if (m_isClosed)
            return; // writing found that it is gone
        if (m_client->isLost())
            return reopenLater(m_client->trouble());
        for (const DeviceSight& sight : m_client->takeSights())
            m_tracker.take(sight);
        m_tracker.say(trouble(), m_client->found(), m_client->isSilent());
        m_timer.start(timeUntil(m_client->nextWake(), now));
    }

    /// What has arrived, and what is to be done then.
    void exchange(LocalTime now)
    {
        const QByteArray bytes = m_port->readAll();
        if (!bytes.isEmpty())
            m_client->take(std::as_bytes(std::span{bytes.constData(), std::size_t(bytes.size())}),
                           now);
        if (m_client->isLost())
            return;
        const NdiPortAction action = m_client->advance(now);
        if (m_tracker.m_log)
            m_tracker.m_log->exchanged({bytes.constData(), std::size_t(bytes.size())}, action.bytes,
                                       now);
        m_port->act(action);
    }

    DeviceTracker& m_tracker;
    std::unique_ptr<DeviceClient> m_client;
    std::unique_ptr<DevicePort> m_port;
    QTimer m_timer{this};
    bool m_isClosed = false; ///< and will be opened again
};

Result<std::unique_ptr<DeviceTracker>> DeviceTracker::make(const TrackerDescription& description,
                                                           ReadSessionClock clock,
                                                           std::unique_ptr<DeviceLog> log)
{
    const bool needsHost = description.kind == TrackerKind::OpenIgtLink;
    if (!isDeviceAddress(description.address) || (needsHost && isSerialPort(description.address)))
        return fail(Errc::WrongAddress, description.address);
    return std::unique_ptr<DeviceTracker>{
        new DeviceTracker{description, std::move(clock), std::move(log)}};
}

DeviceTracker::DeviceTracker(TrackerDescription description, ReadSessionClock clock,
                             std::unique_ptr<DeviceLog> log)
    : m_description{std::move(description)}, m_clock{std::move(clock)}, m_log{std::move(log)}
{
    for (const DescribedTool& tool : m_description.tools)
        m_tools.push_back({tool.name, tool.role, &m_tracked.emplace_back().history, probeOf(tool),
                           kPolarisNoise});
    m_sights.resize(m_tools.size());
    m_thread.setObjectName(QStringLiteral("carina-tracker"));
}

DeviceTracker::~DeviceTracker() { stop(); }

Result<void> DeviceTracker::start()
{
    if (m_line)
        return {};
    m_line = std::make_unique<Line>(*this);
    m_line->moveToThread(&m_thread);
    startPromptly([this] { m_thread.start(); });
    QMetaObject::invokeMethod(m_line.get(), [line = m_line.get()] { line->begin(); });
    return {};
}

void DeviceTracker::stop()
{
    if (!m_line)
        return;
    QMetaObject::invokeMethod(
        m_line.get(), [line = m_line.get()] { line->end(); }, Qt::BlockingQueuedConnection);
    m_thread.quit();
    m_thread.wait();
    m_line.reset();
}

std::string DeviceTracker::trouble() const
{
    const std::lock_guard lock{m_mutex};
    return m_trouble;
}

ToolSight DeviceTracker::sightOf(std::size_t tool) const
{
    const std::lock_guard lock{m_mutex};
    if (m_isSilent)
        return ToolSight::Silent;
    return m_found ? m_sights.at(tool) : ToolSight::Unsaid; // of a device that answers
}

std::optional<DeviceFound> DeviceTracker::found() const
{
    const std::lock_guard lock{m_mutex};
    return m_found;
}

void DeviceTracker::say(std::string trouble, std::optional<DeviceFound> found, bool isSilent)
{
    bool wasSilent = false;
    {
        const std::lock_guard lock{m_mutex};
        m_trouble = std::move(trouble);
        m_found = std::move(found);
        wasSilent = std::exchange(m_isSilent, isSilent);
    }
    if (isSilent && !wasSilent)
        loseTools();
}

void DeviceTracker::loseTools()
{
    const auto present = m_clock();
    if (!present)
        return;
    for (Tool& tool : m_tracked)
        if (tool.X_TO)
            tool.history.push({.time = *present, .X_FO = *tool.X_TO, .validity = Validity::Lost});
}

void DeviceTracker::take(const DeviceSight& sight)
{
    {
        const std::lock_guard lock{m_mutex};
        m_sights[sight.tool] = sight.sight;
    }
    const auto present = m_clock();
    const LocalTime now = monotonicNow(); // of the same moment: a log may have been slow
    if (!present)
        return;
    Tool& tool = m_tracked[sight.tool];
    if (sight.X_TO)
        tool.X_TO = sight.X_TO;
    if (!tool.X_TO)
        return; // never seen yet: a lost pose is never an identity
    const PoseSample sample{.time = *present - (now - sight.exposed),
                            .X_FO = *tool.X_TO,
                            .validity = sight.X_TO ? sight.validity : Validity::Lost,
                            .error = sight.error};
    tool.history.push(sample);
}

} // namespace carina
