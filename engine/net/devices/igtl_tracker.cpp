#include "engine/net/devices/igtl_tracker.h"

#include "engine/core/monotonic_clock.h"
#include "engine/net/devices/device_port.h"

#include <QTimer>

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr std::chrono::milliseconds kBeforeReconnecting{500};

IgtlClientSettings igtlSettingsOf(const TrackerDescription& description)
{
    IgtlClientSettings settings{{}, description.igtlPoses, description.rate_hz};
    for (const DescribedTool& tool : description.tools)
        settings.devices.push_back(tool.device.empty() ? tool.name : tool.device);
    return settings;
}

std::string textOf(const std::vector<std::byte>& bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

} // namespace

/// The client and its socket, on the tracker's thread.
class IgtlTracker::Connection : public QObject
{
public:
    explicit Connection(IgtlTracker& tracker) : m_tracker{tracker}, m_client{tracker.m_settings}
    {
        m_timer.setSingleShot(true);
        m_timer.setTimerType(Qt::PreciseTimer);
        connect(&m_timer, &QTimer::timeout, this, [this] { m_isClosed ? open() : serve(); });
    }

    void begin()
    {
        auto port = DevicePort::make(
            m_tracker.m_address, {.opened =
                                      [this] {
                                          m_client.start(monotonicNow());
                                          serve();
                                      },
                                  .arrived = [this] { serve(); },
                                  .closed = [this](const std::string& why) { openLater(why); }});
        m_port = *std::move(port); // make() of the tracker looked at the address
        open();
    }

    void end()
    {
        m_timer.stop();
        if (m_port->isOpen())
            m_port->act({.bytes = textOf(m_client.farewell())});
        m_port->close();
        m_port.reset();
    }

private:
    void open()
    {
        m_isClosed = false;
        m_port->close();
        m_port->open();
    }

    void openLater(const std::string& why)
    {
        if (std::exchange(m_isClosed, true))
            return;
        // Not from within the socket's own signal.
        QMetaObject::invokeMethod(
            this, [this] { closeBroken(); }, Qt::QueuedConnection);
        m_tracker.say(m_tracker.m_address + ": " + why);
        m_timer.start(kBeforeReconnecting);
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
        const QByteArray bytes = m_port->readAll();
        if (!bytes.isEmpty())
            m_client.take(std::as_bytes(std::span{bytes.constData(), std::size_t(bytes.size())}),
                          now);
        if (m_client.isLost())
            return openLater(m_client.trouble());
        m_port->act({.bytes = textOf(m_client.advance(now))});
        for (const IgtlSight& sight : m_client.takeSights())
            m_tracker.take(sight, now);
        const std::string trouble = m_client.trouble();
        m_tracker.say(trouble.empty() ? trouble : m_tracker.m_address + ": " + trouble);
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(m_client.nextWake() - now);
        m_timer.start(std::max(left, std::chrono::milliseconds{1}));
    }

    IgtlTracker& m_tracker;
    IgtlClient m_client;
    std::unique_ptr<DevicePort> m_port;
    QTimer m_timer{this};
    bool m_isClosed = false; ///< and will be opened again
};

Result<std::unique_ptr<IgtlTracker>> IgtlTracker::make(const TrackerDescription& description,
                                                       ReadSessionClock clock)
{
    const auto port = DevicePort::make(description.address, {[] {}, [] {}, [](const auto&) {}});
    if (!port || isSerialPort(description.address))
        return fail(Errc::WrongAddress, description.address);
    return std::unique_ptr<IgtlTracker>{new IgtlTracker{description, std::move(clock)}};
}

IgtlTracker::IgtlTracker(const TrackerDescription& description, ReadSessionClock clock)
    : m_address{description.address},
      m_settings{igtlSettingsOf(description)},
      m_clock{std::move(clock)}
{
    for (const DescribedTool& tool : description.tools)
        m_tools.push_back({tool.name, tool.role, &m_tracked.emplace_back().history});
    m_thread.setObjectName(QStringLiteral("carina-openigtlink"));
}

IgtlTracker::~IgtlTracker() { stop(); }

Result<void> IgtlTracker::start()
{
    if (m_connection)
        return {};
    m_connection = std::make_unique<Connection>(*this);
    m_connection->moveToThread(&m_thread);
    m_thread.start();
    QMetaObject::invokeMethod(m_connection.get(), [c = m_connection.get()] { c->begin(); });
    return {};
}

void IgtlTracker::stop()
{
    if (!m_connection)
        return;
    QMetaObject::invokeMethod(
        m_connection.get(), [c = m_connection.get()] { c->end(); }, Qt::BlockingQueuedConnection);
    m_thread.quit();
    m_thread.wait();
    m_connection.reset();
}

std::string IgtlTracker::trouble() const
{
    const std::lock_guard lock{m_mutex};
    return m_trouble;
}

void IgtlTracker::say(std::string trouble)
{
    const std::lock_guard lock{m_mutex};
    m_trouble = std::move(trouble);
}

void IgtlTracker::take(const IgtlSight& sight, LocalTime now)
{
    const auto present = m_clock();
    if (!present)
        return;
    Tool& tool = m_tracked[sight.tool];
    if (sight.X_TO)
        tool.X_TO = sight.X_TO;
    if (!tool.X_TO)
        return; // never seen yet: a lost pose is never an identity
    const PoseSample sample{.time = *present - (now - sight.exposed),
                            .X_FO = *tool.X_TO,
                            .validity = sight.X_TO ? Validity::Tracked : Validity::Lost};
    tool.history.push(tool.filter.moving(sample));
}

} // namespace carina
