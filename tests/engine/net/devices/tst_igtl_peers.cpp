// The example programs of the protocol's own library, as Debian has them, as peers.

#include "engine/core/monotonic_clock.h"
#include "engine/net/devices/device_tracker.h"
#include "tests/engine/net/devices/igtl_offers.h"
#include "tests/support/patience.h"
#include "tests/support/soon.h"
#include "tests/support/test_class.h"

#include <QFileInfo>
#include <QProcess>
#include <QTcpServer>

namespace carina::igtl_peers_test
{
namespace
{

using test::soon;

constexpr double kCircle_mm = 50.0; ///< of the poses that the examples send
constexpr double kTolerance_mm = 1e-3;

#ifdef CARINA_IGTL_PEERS
const QString kPeers = QStringLiteral(CARINA_IGTL_PEERS);
#else
const QString kPeers;
#endif

/// One of the example programs, running until this is destroyed.
class Peer
{
public:
    Peer(const char* name, const QStringList& arguments)
    {
        m_process.setProcessChannelMode(QProcess::MergedChannels);
        m_process.start(kPeers + QLatin1Char{'/'} + QLatin1String{name}, arguments);
        m_process.waitForStarted();
    }
    ~Peer()
    {
        m_process.kill();
        m_process.waitForFinished();
    }
    Peer(const Peer&) = delete;
    Peer& operator=(const Peer&) = delete;

    /// Whether it has printed this, by now.
    [[nodiscard]] bool hasPrinted(const char* text)
    {
        m_printed += m_process.readAll();
        return m_printed.contains(text);
    }
    [[nodiscard]] QByteArray printed() const { return m_printed; }

private:
    QProcess m_process;
    QByteArray m_printed;
};

std::uint16_t freePort()
{
    QTcpServer probe;
    return probe.listen(QHostAddress::LocalHost) ? probe.serverPort() : std::uint16_t{0};
}

std::unique_ptr<DeviceTracker> trackerAt(std::uint16_t port, const char* device, IgtlPoses poses)
{
    TrackerDescription described;
    described.kind = TrackerKind::OpenIgtLink;
    described.address = "127.0.0.1:" + std::to_string(port);
    described.igtlPoses = poses;
    described.tools.push_back({"Tube", ToolRole::Tube, {}, device});
    return DeviceTracker::make(
               described,
               [] { return std::optional{SessionTime{monotonicNow().time_since_epoch()}}; })
        .value();
}

} // namespace

class IgtlPeersTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        if (kPeers.isEmpty())
            QSKIP("Debian's openigtlink-examples and libopenigtlink-dev are not here");
    }

    void trackThemselves_data()
    {
        QTest::addColumn<QByteArray>("program");
        QTest::addColumn<QByteArray>("device");
        QTest::addColumn<int>("poses");
        const auto row = [](const char* program, const char* device, IgtlPoses poses) {
            QTest::newRow(program) << QByteArray{program} << QByteArray{device} << int(poses);
        };
        row("TrackerServer", "Tracker", IgtlPoses::Transform);  // TRANSFORM
        row("TrackerServer2", "Tracker", IgtlPoses::Transform); // POSITION
        row("TrackingDataServer", "Channel 0", IgtlPoses::Tdata);
        row("QuaternionTrackingDataServer", "Channel 0", IgtlPoses::Qtdata);
    }

    /// Their tools go round: x = z = 50 mm cos phi, y = 50 mm sin phi.
    void trackThemselves()
    {
        QFETCH(const QByteArray, program);
        QFETCH(const QByteArray, device);
        QFETCH(const int, poses);
        const std::uint16_t port = freePort();
        QStringList arguments{QString::number(port)};
        if (program.startsWith("TrackerServer"))
            arguments += QStringLiteral("50");
        const Peer peer{program.constData(), arguments};
        const auto tracker = trackerAt(port, device.constData(), static_cast<IgtlPoses>(poses));
        QVERIFY(tracker->start());
        PoseHistory& history = *tracker->tools()[0].history;
        QTRY_VERIFY2_WITH_TIMEOUT(history.samples().size() > 20, tracker->trouble().c_str(),
                                  kPatience_ms);
        tracker->stop();
        for (const PoseSample& sample : history.samples()) {
            const Vec3 p_mm = 1e3 * sample.X_FO.translation();
            QVERIFY(std::abs(p_mm.x() - p_mm.z()) < kTolerance_mm);
            QVERIFY(std::abs(std::hypot(p_mm.x(), p_mm.y()) - kCircle_mm) < kTolerance_mm);
        }
    }

    void readWhatIsGiven_data()
    {
        QTest::addColumn<QByteArray>("program");
        QTest::addColumn<QList<QByteArray>>("words");
        const auto row = [](const char* program, const QList<QByteArray>& words) {
            QTest::newRow(program) << QByteArray{program} << words;
        };
        row("ReceiveClient", {"Receiving TRANSFORM", "123.25", "-30.5", "Receiving POINT",
                              "Name      : Carina", "Receiving : POLYDATA"}); // which it skips
        row("TrackingDataClient", {"Receiving TDATA", "Name       : Tube", "123.25", "-30.5"});
        row("QuaternionTrackingDataClient", {"Name       : Tube", "123.25", "-30.5"});
        row("PolyDataClient", {"Receiving POLYDATA", "point[2] = (7.25, 8.25, 9.25)", "cell[0]"});
    }

    void readWhatIsGiven()
    {
        QFETCH(const QByteArray, program);
        QFETCH(const QList<QByteArray>, words);
        const auto server = IgtlServer::listen({"127.0.0.1", 0}).value();
        std::uint64_t stamp = std::uint64_t{1'700'000'000} << 32U;
        server->give(test::tubeOffer(stamp));
        QStringList arguments{QStringLiteral("127.0.0.1"), QString::number(server->port())};
        if (program.contains("Tracking"))
            arguments += QStringLiteral("50"); // frames a second
        Peer peer{program.constData(), arguments};
        const auto hasReadAll = [&] {
            server->give(test::tubeOffer(++stamp));
            return std::ranges::all_of(
                words, [&](const QByteArray& word) { return peer.hasPrinted(word.constData()); });
        };
        QVERIFY2(soon(hasReadAll, std::chrono::seconds{15}),
                 peer.printed().right(2000).constData());
    }
};

CARINA_TEST(IgtlPeersTest)

} // namespace carina::igtl_peers_test

#include "tst_igtl_peers.moc"
