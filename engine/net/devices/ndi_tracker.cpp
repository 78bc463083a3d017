#include "engine/net/devices/ndi_tracker.h"

#include "engine/core/monotonic_clock.h"
#include "engine/net/devices/device_port.h"

#include <QTimer>

#include <algorithm>
#include <array>
#include <utility>

namespace carina
{
namespace
{

constexpr std::chrono::milliseconds kBeforeReopening{500};
/// What an adapter at a serial port usually holds, best first.
constexpr std::array kUsualRates{921600, 230400, 115200, 57600, 38400, 19200, 9600};

NdiClientSettings settingsOf(const TrackerDescription& description)
{
    NdiClientSettings settings;
    settings.poses = description.poses;
    settings.isSerial = isSerialPort(description.address);
    settings.rates.clear();
    for (const DescribedTool& tool : description.tools)
        settings.tools.push_back({tool.name, tool.definition});
    std::ranges::copy_if(kUsualRates, std::back_inserter(settings.rates),
                         [&](int rate) { return rate <= description.fastestRate; });
    return settings;
}

std::optional<Probe> probeOf(const DescribedTool& tool)
{
    return tool.definition ? std::optional{tool.definition->probe()} : std::nullopt;
}

} // namespace

/// The client and its port, on the tracker's thread.
class NdiTracker::Line : public QObject
{
public:
    explicit Line(NdiTracker& tracker) : m_tracker{tracker}, m_client{tracker.m_settings}
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
                                  .closed = [this](const std::string& why) { reopenLater(why); }});
        m_port = *std::move(port); // make() of the tracker looked at the address
        open();
    }

    void end()
    {
        m_timer.stop();
        if (m_port->isOpen()) {
            m_port->act({.bytes = NdiClient::farewell()});
            static_cast<void>(m_port->readAll());
        }
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

    void reopenLater(const std::string& why)
    {
        if (std::exchange(m_isClosed, true))
            return; // a port that was unplugged says so until it is closed
        QMetaObject::invokeMethod(
            this, [this] { closeBroken(); }, Qt::QueuedConnection);
        m_tracker.say(m_tracker.m_address + ": " + why);
        m_timer.start(kBeforeReopening);
    }

    void closeBroken()
    {
        if (m_port && m_isClosed)
            m_port->close();
    }

    void serve()
    {
        if (m_isClosed)
            return;
        const LocalTime now = monotonicNow();
        const QByteArray bytes = m_port->readAll();
        if (!bytes.isEmpty())
            m_client.take(std::as_bytes(std::span{bytes.constData(), std::size_t(bytes.size())}),
                          now);
        m_port->act(m_client.advance(now));
        for (const NdiMeasurement& measured : m_client.takeMeasurements())
            m_tracker.take(measured, now);
        m_tracker.say(m_client.trouble(), m_client.found());
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(m_client.nextWake() - now);
        m_timer.start(std::max(left, std::chrono::milliseconds{1}));
    }

    NdiTracker& m_tracker;
    NdiClient m_client;
    std::unique_ptr<DevicePort> m_port;
    QTimer m_timer{this};
    bool m_isClosed = false; ///< and will be opened again
};

Result<std::unique_ptr<NdiTracker>> NdiTracker::make(const TrackerDescription& description,
                                                     ReadSessionClock clock)
{
    if (!isDeviceAddress(description.address))
        return fail(Errc::WrongAddress, description.address);
    return std::unique_ptr<NdiTracker>{new NdiTracker{description, std::move(clock)}};
}

NdiTracker::NdiTracker(const TrackerDescription& description, ReadSessionClock clock)
    : m_address{description.address}, m_settings{settingsOf(description)}, m_clock{std::move(clock)}
{
    for (const DescribedTool& tool : description.tools)
        m_tools.push_back({tool.name, tool.role, &m_tracked.emplace_back().history, probeOf(tool),
                           kPolarisNoise});
    m_thread.setObjectName(QStringLiteral("carina-tracker"));
}

NdiTracker::~NdiTracker() { stop(); }

Result<void> NdiTracker::start()
{
    if (m_line)
        return {};
    m_line = std::make_unique<Line>(*this);
    m_line->moveToThread(&m_thread);
    m_thread.start();
    QMetaObject::invokeMethod(m_line.get(), [line = m_line.get()] { line->begin(); });
    return {};
}

void NdiTracker::stop()
{
    if (!m_line)
        return;
    QMetaObject::invokeMethod(
        m_line.get(), [line = m_line.get()] { line->end(); }, Qt::BlockingQueuedConnection);
    m_thread.quit();
    m_thread.wait();
    m_line.reset();
}

std::string NdiTracker::trouble() const
{
    const std::lock_guard lock{m_mutex};
    return m_trouble;
}

std::optional<NdiFound> NdiTracker::found() const
{
    const std::lock_guard lock{m_mutex};
    return m_found;
}

void NdiTracker::say(std::string trouble, std::optional<NdiFound> found)
{
    const std::lock_guard lock{m_mutex};
    m_trouble = std::move(trouble);
    m_found = std::move(found);
}

void NdiTracker::take(const NdiMeasurement& measurement, LocalTime now)
{
    const auto present = m_clock();
    if (!present)
        return;
    const SessionTime exposed = *present - (now - measurement.exposed);
    for (std::size_t i = 0; i < m_tracked.size(); ++i) {
        if (!measurement.tools[i])
            continue;
        Tool& tool = m_tracked[i];
        const NdiTool& seen = *measurement.tools[i];
        PoseSample sample{.time = exposed, .validity = validityOf(seen), .error = seen.error};
        if (seen.X_TO)
            sample.X_FO = *seen.X_TO;
        else if (tool.last)
            sample.X_FO = tool.last->X_FO;
        else
            continue; // never seen yet: a lost pose is never an identity
        if (seen.X_TO)
            tool.last = sample;
        tool.history.push(tool.filter.moving(sample));
    }
}

} // namespace carina
