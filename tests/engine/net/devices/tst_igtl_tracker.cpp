#include "engine/net/devices/described_tracker.h"
#include "engine/net/devices/igtl_server.h"

#include "engine/core/monotonic_clock.h"
#include "tests/engine/net/devices/igtl_offers.h"
#include "tests/support/patience.h"
#include "tests/support/test_class.h"

#include <QTcpServer>
#include <QTcpSocket>

namespace carina::igtl_tracker_test
{
namespace
{

using test::tubeOffer;

std::optional<SessionTime> sessionNow() { return SessionTime{monotonicNow().time_since_epoch()}; }

TrackerDescription describedAt(const std::string& address, IgtlPoses poses = IgtlPoses::Transform)
{
    TrackerDescription described;
    described.kind = TrackerKind::OpenIgtLink;
    described.address = address;
    described.igtlPoses = poses;
    described.tools.push_back({"The tube", ToolRole::Tube, {}, "Tube"});
    return described;
}

std::unique_ptr<Tracker> trackerAt(const std::string& address,
                                   IgtlPoses poses = IgtlPoses::Transform)
{
    return describedTracker(describedAt(address, poses), sessionNow).value();
}

std::string addressOf(const IgtlServer& server)
{
    return "127.0.0.1:" + std::to_string(server.port());
}

std::size_t samplesOf(const Tracker& tracker)
{
    return tracker.tools()[0].history->samples().size();
}

} // namespace

class IgtlTrackerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tracksWhatAServerSends_data()
    {
        QTest::addColumn<int>("poses");
        QTest::newRow("TRANSFORM") << int(IgtlPoses::Transform);
        QTest::newRow("TDATA") << int(IgtlPoses::Tdata);
        QTest::newRow("QTDATA") << int(IgtlPoses::Qtdata);
    }

    void tracksWhatAServerSends()
    {
        QFETCH(const int, poses);
        const auto server = IgtlServer::listen({"127.0.0.1", 0}).value();
        const auto tracker = trackerAt(addressOf(*server), static_cast<IgtlPoses>(poses));
        QCOMPARE(tracker->tools()[0].name, std::string{"The tube"});
        QCOMPARE(tracker->tools()[0].role, ToolRole::Tube);
        QVERIFY(tracker->start());
        int given = 0;
        const auto hasCome = [&] {
            ++given;
            server->give(tubeOffer(std::uint64_t(given) << 28U, given)); // 16 a second
            return samplesOf(*tracker) > 5;
        };
        QTRY_VERIFY_WITH_TIMEOUT(hasCome(), kPatience_ms);
        tracker->stop();
        for (const PoseSample& sample : tracker->tools()[0].history->samples()) {
            QCOMPARE(sample.validity, Validity::Tracked);
            const Vec3 p_mm = 1e3 * sample.X_FO.translation();
            QVERIFY(std::abs(p_mm.x() - 123.25) < 1e-4 && std::abs(p_mm.z() + 30.5) < 1e-4);
            QVERIFY(p_mm.y() > 0.5 && p_mm.y() < given + 0.5);
        }
        QCOMPARE(tracker->trouble(), std::string{});
    }

    void tellsTheServerToStop()
    {
        QTcpServer server;
        QVERIFY(server.listen(QHostAddress::LocalHost));
        const auto tracker =
            trackerAt("127.0.0.1:" + std::to_string(server.serverPort()), IgtlPoses::Tdata);
        QVERIFY(tracker->start());
        QTRY_VERIFY(server.hasPendingConnections());
        auto& socket = *server.nextPendingConnection();
        QByteArray heard;
        const auto hears = [&](const char* type) {
            heard += socket.readAll();
            return heard.contains(type);
        };
        QTRY_VERIFY(hears("STT_TDATA"));
        tracker->stop();
        QTRY_VERIFY(hears("STP_TDATA"));
    }

    void comesBackWhenTheServerDoes()
    {
        auto server = IgtlServer::listen({"127.0.0.1", 0}).value();
        const IgtlPlace place{"127.0.0.1", server->port()};
        const auto tracker = trackerAt(addressOf(*server));
        server.reset();
        QVERIFY(tracker->start());
        QTRY_VERIFY(tracker->trouble().find(std::to_string(place.port)) != std::string::npos);
        for (int i = 1; i <= 2; ++i) {
            server = IgtlServer::listen(place).value();
            server->give(tubeOffer(std::uint64_t(i)));
            const std::size_t before = samplesOf(*tracker);
            QTRY_VERIFY_WITH_TIMEOUT(samplesOf(*tracker) > before, kPatience_ms);
            server.reset();
            QTRY_VERIFY_WITH_TIMEOUT(!tracker->trouble().empty(), kPatience_ms);
        }
    }

    void leavesWhoDoesNotSpeakOpenIgtLink()
    {
        QTcpServer other;
        QVERIFY(other.listen(QHostAddress::LocalHost));
        const auto tracker = trackerAt("127.0.0.1:" + std::to_string(other.serverPort()));
        QVERIFY(tracker->start());
        QTRY_VERIFY(other.hasPendingConnections());
        other.nextPendingConnection()->write(QByteArray{100, 'x'});
        QTRY_VERIFY(tracker->trouble().find("OpenIGTLink") != std::string::npos);
        QTRY_VERIFY_WITH_TIMEOUT(other.hasPendingConnections(), kPatience_ms); // and tries again
    }

    void refusesAnAddressThatIsNone_data()
    {
        QTest::addColumn<QByteArray>("address");
        for (const char* address : {"", "/dev/ttyUSB0", "host:", "host:65536", ":18944"})
            QTest::newRow(address) << QByteArray{address};
    }

    void refusesAnAddressThatIsNone()
    {
        QFETCH(const QByteArray, address);
        const auto tracker = describedTracker(describedAt(address.toStdString()), sessionNow);
        QVERIFY(!tracker);
        QCOMPARE(tracker.error().code, Errc::WrongAddress);
    }
};

CARINA_TEST(IgtlTrackerTest)

} // namespace carina::igtl_tracker_test

#include "tst_igtl_tracker.moc"
