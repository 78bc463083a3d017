#include "engine/net/secure/dtls_record.h"
#include "evaluation/network/lossy_relay.h"
#include "tests/engine/net/secure/transports.h"
#include "tests/support/test_class.h"

namespace carina::host_transport_test
{
namespace
{

const std::string kNewTrainee = "trainee:" + kSession + ":new";

QByteArray firstHelloOf(QUdpSocket& catcher)
{
    RawClient client{catcher.localPort(), kNewTrainee, {}};
    if (!catcher.waitForReadyRead(kHandshakeMs))
        return {};
    return readRaw(catcher)->bytes;
}

} // namespace

class TestHostTransport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void rightKeyIsLetInAsItsRole()
    {
        TestHost host;
        RawClient client{host.port(), kNewTrainee, host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(client.isIn() && !host.heard.paths.empty(), kHandshakeMs);
        QVERIFY((host.heard.paths.begin()->second == Credential{Role::Trainee, std::nullopt}));
        client.send("hello");
        QTRY_COMPARE_WITH_TIMEOUT(host.heard.received.size(), std::size_t{1}, kHandshakeMs);
        QVERIFY(host.heard.received[0] == textBytes("hello"));
    }

    void anyOtherKeyIsToldSoAndForgotten_data()
    {
        QTest::addColumn<QByteArray>("identity");
        const QByteArray session = QByteArray::fromStdString(kSession);
        QTest::newRow("wrong key") << QByteArray{"trainee:" + session + ":new"};
        QTest::newRow("of another participant") << QByteArray{"trainee:" + session + ":1"};
        QTest::newRow("of another session")
            << QByteArray{"trainee:" + QByteArray(32, '0') + ":new"};
        QTest::newRow("nonsense") << QByteArray{"root"};
    }
    void anyOtherKeyIsToldSoAndForgotten()
    {
        QFETCH(const QByteArray, identity);
        TestHost host;
        RawClient client{host.port(), identity.toStdString(), host.keys.at(Role::Observer)};
        QTRY_VERIFY_WITH_TIMEOUT(!client.answers.empty()
                                     && isWrongKeyAlert(octets(client.answers.back())),
                                 kHandshakeMs);
        QVERIFY(host.heard.paths.empty());
        QCOMPARE(host.transport->handshakes(), std::size_t{0});
    }

    void oneWhoseKeyIsNotDerivedYetIsLeftWaiting()
    {
        TestHost host;
        host.keys.erase(Role::Trainee);
        RawClient client{host.port(), kNewTrainee, randomKey()};
        // Cookie request, then the host's part; no word about the key.
        QTRY_COMPARE_WITH_TIMEOUT(client.answers.size(), std::size_t{2}, kHandshakeMs);
        QTRY_COMPARE_WITH_TIMEOUT(host.transport->handshakes(), std::size_t{0}, kHandshakeMs);
        QCOMPARE(client.answers.size(), std::size_t{2});
    }

    void strangerGetsACookieAndNothingElse()
    {
        TestHost host;
        QUdpSocket stranger;
        QVERIFY(stranger.bind(kLoopback, 0));
        const QByteArray hello = firstHelloOf(stranger);
        stranger.writeDatagram(hello, kLoopback, host.port());
        QTRY_VERIFY_WITH_TIMEOUT(stranger.hasPendingDatagrams(), kHandshakeMs);
        const QByteArray answer = readRaw(stranger)->bytes;
        QVERIFY(answer.size() < hello.size()); // of no use for flooding others
        QCOMPARE(int{octets(answer)[13]}, 3);  // HelloVerifyRequest
        QCOMPARE(host.transport->handshakes(), std::size_t{0});
    }

    /// As somebody sends them who forges the address of a neighbour.
    void floodOfHellosWithoutCookieKeepsNobodyOut()
    {
        TestHost host;
        QUdpSocket flood;
        QVERIFY(flood.bind(kLoopback, 0));
        const QByteArray hello = firstHelloOf(flood);
        for (int i = 0; i < 500; ++i) {
            flood.writeDatagram(hello, kLoopback, host.port());
            host.pump.serve();
        }
        QCOMPARE(host.transport->handshakes(), std::size_t{0});
        const LocalTime begin = monotonicNow();
        RawClient client{host.port(), kNewTrainee, host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(client.isIn() && !host.heard.paths.empty(), kHandshakeMs);
        // Had each been counted, this source could say hello again after 7 s only.
        QVERIFY(monotonicNow() - begin
                < (500 - HelloLimiter::kBurst) * HelloLimiter::kInterval / 2);
    }

    void pathIsEndedOnRequest()
    {
        TestHost host;
        RawClient client{host.port(), kNewTrainee, host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(client.isIn() && !host.heard.paths.empty(), kHandshakeMs);
        const std::size_t answers = client.answers.size();
        host.transport->end(host.heard.paths.begin()->first, host.heard, monotonicNow());
        QCOMPARE(host.transport->paths(), std::size_t{0});
        QTRY_COMPARE_WITH_TIMEOUT(client.answers.size(), answers + 1, kHandshakeMs); // close_notify
    }

    void whatIsNotEncryptedIsNotHeard()
    {
        TestHost host;
        RawClient client{host.port(), kNewTrainee, host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(client.isIn() && !host.heard.paths.empty(), kHandshakeMs);
        QUdpSocket stranger;
        QVERIFY(stranger.bind(kLoopback, 0));
        QByteArray plain{23, '\0'}; // an application record in the clear
        plain.replace(0, 13, QByteArray::fromHex("17fefd0000000000000001000a"));
        QByteArray encrypted = plain; // and one that only pretends
        encrypted[4] = 1;
        for (const QByteArray& bytes : {QByteArray{}, QByteArray{"CA"}, QByteArray(1201, '\x16'),
                                        QByteArray(9000, 'C'), plain, encrypted})
            stranger.writeDatagram(bytes, kLoopback, host.port());
        client.send("hello");
        QTRY_VERIFY_WITH_TIMEOUT(!host.heard.received.empty(), kHandshakeMs);
        QCOMPARE(host.heard.received.size(), std::size_t{1});
        QCOMPARE(host.heard.paths.size(), std::size_t{1});
        QVERIFY(!stranger.hasPendingDatagrams());
    }

    void replayedDatagramsChangeNothing()
    {
        TestHost host;
        LossyRelay relay{host.port(), {}, 1};
        TestClient client{relay.port(), host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(!client.heard.paths.empty(), kHandshakeMs);
        client.send("once");
        QTRY_COMPARE_WITH_TIMEOUT(host.heard.received.size(), std::size_t{1}, kHandshakeMs);
        const auto captured = relay.toHost(); // from the first hello on
        for (int i = 0; i < 2; ++i)
            for (const auto& passed : captured)
                relay.replay(passed);
        client.send("again");
        QTRY_COMPARE_WITH_TIMEOUT(host.heard.received.size(), std::size_t{2}, kHandshakeMs);
        QVERIFY(host.heard.received[1] == textBytes("again"));
        QVERIFY(host.heard.ended.empty());
        QCOMPARE(host.heard.paths.size(), std::size_t{1});
        QVERIFY(client.heard.ended.empty());
    }

    void clientThatRestartsFromItsPortIsBackAtOnce()
    {
        TestHost host;
        std::optional<RawClient> client;
        client.emplace(host.port(), kNewTrainee, host.keys.at(Role::Trainee));
        QTRY_VERIFY_WITH_TIMEOUT(client->isIn(), kHandshakeMs);
        const std::uint16_t port = client->port();
        client.reset(); // without a word
        const LocalTime begin = monotonicNow();
        client.emplace(host.port(), kNewTrainee, host.keys.at(Role::Trainee), port);
        QTRY_VERIFY_WITH_TIMEOUT(client->isIn(), kHandshakeMs);
        QVERIFY(monotonicNow() - begin < 1s);
        QCOMPARE(client->port(), port);
        QCOMPARE(host.transport->paths(), std::size_t{1});
        QVERIFY(host.heard.ended == std::vector<PeerAddress>{1});
        QVERIFY(host.heard.paths.contains(2));
        client->send("back");
        QTRY_COMPARE_WITH_TIMEOUT(host.heard.received.size(), std::size_t{1}, kHandshakeMs);
    }

    void pathIsReplacedOnlyByOneThatIsProved()
    {
        TestHost host;
        LossyRelay relay{host.port(), {}, 1};
        TestClient client{relay.port(), host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(!client.heard.paths.empty(), kHandshakeMs);
        // A stranger at the same address and port, as the host sees it, with another key.
        const std::uint16_t clientPort = relay.toHost().back().clientPort;
        QUdpSocket catcher;
        QVERIFY(catcher.bind(kLoopback, 0));
        relay.replay({clientPort, firstHelloOf(catcher)});
        client.send("still here");
        QTRY_COMPARE_WITH_TIMEOUT(host.heard.received.size(), std::size_t{1}, kHandshakeMs);
        QVERIFY(host.heard.ended.empty());
    }

    void silentPathsAndHandshakesAreForgotten()
    {
        TestHost host;
        RawClient client{host.port(), kNewTrainee, host.keys.at(Role::Trainee)};
        QTRY_COMPARE_WITH_TIMEOUT(host.transport->paths(), std::size_t{1}, kHandshakeMs);
        const LocalTime now = monotonicNow();
        host.transport->serve(host.heard, now + HostTransport::kPathTimeout - 1s);
        QCOMPARE(host.transport->paths(), std::size_t{1});
        host.transport->serve(host.heard, now + HostTransport::kPathTimeout);
        QCOMPARE(host.transport->paths(), std::size_t{0});
        QVERIFY(host.heard.ended == std::vector<PeerAddress>{1});
    }

    void takenPortIsNamed()
    {
        TestHost host;
        const auto other = HostTransport::bind(host.port(), false);
        QVERIFY(!other);
        QCOMPARE(other.error(), (Error{Errc::AddressInUse, std::to_string(host.port())}));
    }

    void hostIsReachedFromElsewhereOnlyWhenOpen()
    {
        const auto closed = HostTransport::bind(0, false);
        const auto open = HostTransport::bind(0, true);
        QVERIFY(closed && open);
        const auto answers = [](HostTransport& transport, const QHostAddress& address) {
            QUdpSocket other; // the port is free at this address if nobody listens there
            return !other.bind(address, transport.port(), QAbstractSocket::DontShareAddress);
        };
        const QHostAddress elsewhere{QStringLiteral("127.0.0.2")};
        QVERIFY(answers(**closed, kLoopback));
        QVERIFY(!answers(**closed, elsewhere));
        QVERIFY(answers(**open, elsewhere));
    }
};

CARINA_TEST(TestHostTransport)

} // namespace carina::host_transport_test

#include "tst_host_transport.moc"
