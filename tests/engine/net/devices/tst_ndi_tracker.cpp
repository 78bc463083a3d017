#include "engine/net/devices/device_tracker.h"

#include "engine/core/monotonic_clock.h"
#include "tests/evaluation/polaris/served_device.h"
#include "tests/support/patience.h"
#include "tests/support/test_class.h"

#include <QTcpServer>
#include <QTcpSocket>
#include <QTemporaryDir>

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace carina::ndi_tracker_test
{
namespace
{

using namespace std::chrono_literals;

constexpr double kSpeed = 0.1;     // m/s
constexpr double kLateness = 0.04; // s: an exposure and a loaded computer

std::optional<SessionTime> sessionNow() { return SessionTime{monotonicNow().time_since_epoch()}; }

/// From 0 on: a position beyond 100 m is refused.
double xAt(SessionTime t)
{
    static const SessionTime start{monotonicNow().time_since_epoch()};
    return kSpeed * toSeconds(t - start);
}

std::uint16_t freeTcpPort()
{
    QTcpServer server;
    server.listen(QHostAddress::LocalHost);
    return server.serverPort();
}

/// A port of this computer that answers no attempt to connect: as many wait there as it holds.
class SilentHost
{
public:
    SilentHost() : m_listener{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)}
    {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        auto* named = reinterpret_cast<sockaddr*>(&address);
        if (::bind(m_listener, named, size) == 0 && ::listen(m_listener, 0) == 0
            && ::getsockname(m_listener, named, &size) == 0)
            m_port = ntohs(address.sin_port);
        m_waiting.connectToHost(QHostAddress::LocalHost, m_port);
        m_waiting.waitForConnected();
    }
    ~SilentHost() { ::close(m_listener); }
    SilentHost(const SilentHost&) = delete;
    SilentHost& operator=(const SilentHost&) = delete;

    [[nodiscard]] std::uint16_t port() const { return m_port; }

private:
    int m_listener;
    std::uint16_t m_port = 0;
    QTcpSocket m_waiting;
};

/// A device at a pseudo-terminal whose tool moves along x.
class ServedTerminal : public ServedDevice
{
public:
    explicit ServedTerminal(const std::string& link)
        : ServedDevice{
            PolarisLine::terminal(link).value(), {}, [](const std::string&, LocalTime t) {
                return std::optional{
                    PolarisPose{Quat::Identity(),
                                {1e3 * xAt(SessionTime{t.time_since_epoch()}), 0.0, -1500.0},
                                0.1}};
            }}
    {
    }
};

TrackerDescription describedAt(const std::string& address)
{
    const std::vector<ToolMarker> markers{{{0, 0, 0}}, {{0.05, 0, 0}}, {{0, 0.08, 0}}};
    const auto definition =
        NdiToolDefinition::make(NdiToolDefinition::Kind::Pointer, markers, "Carina", "tube");
    TrackerDescription described;
    described.address = address;
    described.fastestRate = 115200;
    described.tools.push_back({"Tube", ToolRole::Tube, definition.value()});
    return described;
}

std::size_t samplesOf(const Tracker& tracker)
{
    return tracker.tools()[0].history->samples().size();
}

} // namespace

class NdiTrackerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tracksADeviceAtATerminal()
    {
        const QTemporaryDir folder;
        const std::string link = folder.filePath(QStringLiteral("port")).toStdString();
        const ServedTerminal device{link};
        const auto tracker = DeviceTracker::make(describedAt(link), sessionNow);
        QVERIFY(tracker);
        QVERIFY((*tracker)->start());
        QTRY_VERIFY_WITH_TIMEOUT(samplesOf(**tracker) > 60, kPatience_ms);
        (*tracker)->stop();
        const TrackedTool tool = (*tracker)->tools()[0];
        QCOMPARE(tool.role, ToolRole::Tube);
        for (const PoseSample& sample : tool.history->samples()) {
            QCOMPARE(sample.validity, Validity::Tracked);
            // The stated x tells when it was exposed.
            const double late = (xAt(sample.time) - sample.X_FO.translation().x()) / kSpeed;
            QVERIFY2(late > -0.002 && late < kLateness, qPrintable(QString::number(late)));
        }
        QCOMPARE((*tracker)->trouble(), std::string{});
    }

    void leavesTheDeviceIdle()
    {
        const QTemporaryDir folder;
        const std::string link = folder.filePath(QStringLiteral("port")).toStdString();
        const ServedTerminal device{link};
        const auto tracker = DeviceTracker::make(describedAt(link), sessionNow);
        QVERIFY(tracker);
        for (int times = 0; times < 2; ++times) {
            const std::size_t before = samplesOf(**tracker);
            QVERIFY((*tracker)->start());
            QTRY_VERIFY_WITH_TIMEOUT(samplesOf(**tracker) > before + 10, kPatience_ms);
            QVERIFY(device.isTracking());
            (*tracker)->stop();
            QTRY_VERIFY(!device.isTracking());
        }
    }

    void leavesADeviceOnTheNetworkIdle()
    {
        const std::uint16_t port = freeTcpPort();
        const ServedDevice device{
            PolarisLine::tcp(port).value(), {.hasRate = false}, [](const std::string&, LocalTime) {
                return std::optional{PolarisPose{Quat::Identity(), {0.0, 0.0, -1500.0}, 0.1}};
            }};
        const auto tracker =
            DeviceTracker::make(describedAt("127.0.0.1:" + std::to_string(port)), sessionNow);
        QVERIFY(tracker);
        QVERIFY((*tracker)->start());
        QTRY_VERIFY_WITH_TIMEOUT(samplesOf(**tracker) > 10, kPatience_ms);
        QVERIFY(device.isTracking());
        (*tracker)->stop();
        QTRY_VERIFY(!device.isTracking());
    }

    void comesBackWhenTheDeviceDoes()
    {
        const QTemporaryDir folder;
        const std::string link = folder.filePath(QStringLiteral("port")).toStdString();
        const auto tracker = DeviceTracker::make(describedAt(link), sessionNow);
        QVERIFY(tracker);
        QVERIFY((*tracker)->start());
        QTRY_VERIFY((*tracker)->trouble().find(link) != std::string::npos);
        {
            const ServedTerminal device{link};
            QTRY_VERIFY_WITH_TIMEOUT(samplesOf(**tracker) > 10, kPatience_ms);
        }
        QTRY_VERIFY_WITH_TIMEOUT(!(*tracker)->trouble().empty(), kPatience_ms);
        QCOMPARE((*tracker)->sightOf(0), ToolSight::Silent);
        const auto lastIsLost = [&] {
            return (*tracker)->tools()[0].history->samples().back().validity == Validity::Lost;
        };
        QTRY_VERIFY(lastIsLost());
        const std::size_t before = samplesOf(**tracker);
        const ServedTerminal device{link};
        QTRY_VERIFY_WITH_TIMEOUT(samplesOf(**tracker) > before + 10, kPatience_ms);
    }

    /// What is off refuses no connection either.
    void saysThatNothingAnswersOnTheNetwork()
    {
        const SilentHost host;
        const auto tracker = DeviceTracker::make(
            describedAt("127.0.0.1:" + std::to_string(host.port())), sessionNow);
        QVERIFY(tracker);
        QVERIFY((*tracker)->start());
        QTRY_VERIFY_WITH_TIMEOUT((*tracker)->trouble().ends_with(": it does not answer"),
                                 kPatience_ms);
    }

    void refusesAnAddressThatIsNone_data()
    {
        QTest::addColumn<QByteArray>("address");
        for (const char* address : {"", "ttyUSB0", "host:", "host:0", "host:65536", ":8765"})
            QTest::newRow(address) << QByteArray{address};
    }

    void refusesAnAddressThatIsNone()
    {
        QFETCH(QByteArray, address);
        const auto tracker = DeviceTracker::make(describedAt(address.toStdString()), sessionNow);
        QVERIFY(!tracker);
        QCOMPARE(tracker.error().code, Errc::WrongAddress);
    }
};

CARINA_TEST(NdiTrackerTest)

} // namespace carina::ndi_tracker_test

#include "tst_ndi_tracker.moc"
