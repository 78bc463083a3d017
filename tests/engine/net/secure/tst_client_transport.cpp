#include "evaluation/network/lossy_relay.h"
#include "tests/engine/net/secure/transports.h"
#include "tests/support/test_class.h"

#include <QNetworkDatagram>

namespace carina::client_transport_test
{

class TestClientTransport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void datagramsPassBothWays()
    {
        TestHost host;
        TestClient client{host.port(), host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(!client.heard.paths.empty() && !host.heard.paths.empty(),
                                 kPatience_ms);
        client.send("question");
        QTRY_COMPARE_WITH_TIMEOUT(host.heard.received.size(), std::size_t{1}, kPatience_ms);
        host.transport->send(1, textBytes("answer"));
        QTRY_COMPARE_WITH_TIMEOUT(client.heard.received.size(), std::size_t{1}, kPatience_ms);
        QVERIFY(client.heard.received[0] == textBytes("answer"));
    }

    void largestDatagramStaysWithinTwelveHundredBytes()
    {
        TestHost host;
        LossyRelay relay{host.port(), {}, 1};
        TestClient client{relay.port(), host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(!client.heard.paths.empty(), kPatience_ms);
        const std::vector<std::byte> largest(kLargestDatagram);
        client.transport.send(1, largest);
        QTRY_COMPARE_WITH_TIMEOUT(host.heard.received.size(), std::size_t{1}, kPatience_ms);
        QVERIFY(host.heard.received[0] == largest);
        QCOMPARE(relay.toHost().back().bytes.size(), qsizetype(kLargestDatagram) + 29);
        for (const auto& passed : relay.toHost())
            QVERIFY(passed.bytes.size() <= 1200);
    }

    void wrongCodeIsGivenUpSoon()
    {
        TestHost host;
        TestClient client{host.port(), randomKey()};
        QTRY_VERIFY_WITH_TIMEOUT(client.heard.refusal.has_value(), kPatience_ms);
        QCOMPARE(client.heard.refusal->code, Errc::WrongCode);
        QVERIFY(host.heard.paths.empty());
        QCOMPARE(client.transport.tries(), 4); // the first learnt of the session
        QCOMPARE(client.transport.nextWake(), LocalTime::max());
    }

    void codeOfAnotherRoleOpensNothing()
    {
        TestHost host;
        TestClient client{host.port(), host.keys.at(Role::Trainee), Role::Observer};
        QTRY_VERIFY_WITH_TIMEOUT(client.heard.refusal.has_value(), kPatience_ms);
        QVERIFY(host.heard.paths.empty());
    }

    void triesGoOnWhileTheHostIsDeriving()
    {
        TestHost host;
        const AccessKey key = host.keys.at(Role::Trainee);
        host.keys.erase(Role::Trainee);
        TestClient client{host.port(), key};
        QTRY_VERIFY_WITH_TIMEOUT(client.transport.tries() > 3, kPatience_ms);
        QVERIFY(!client.heard.refusal);
        host.keys.emplace(Role::Trainee, key);
        QTRY_VERIFY_WITH_TIMEOUT(!client.heard.paths.empty(), kPatience_ms);
    }

    void asksLessOftenOfAHostThatOnlyAnswers()
    {
        // As a host does that has had all the handshakes of this address: after the cookie,
        // nothing.
        QUdpSocket host;
        QVERIFY(host.bind(kLoopback, 0));
        QDtlsClientVerifier cookies;
        TestClient client{host.localPort(), randomKey()};
        LocalTime now = monotonicNow();
        const auto triesIn = [&](Duration length) {
            const int before = client.transport.tries();
            for (const LocalTime end = now + length; now < end; now += 10ms) {
                client.transport.serve(client.heard, now);
                while (host.hasPendingDatagrams()) {
                    const QNetworkDatagram asked = host.receiveDatagram();
                    static_cast<void>(cookies.verifyClient(
                        &host, asked.data(), asked.senderAddress(), quint16(asked.senderPort())));
                }
            }
            return client.transport.tries() - before;
        };
        QCOMPARE(triesIn(2s), 7); // beside the one with which it began
        const int later = triesIn(10s);
        QVERIFY2(later >= 9 && later <= 11, qPrintable(QString::number(later)));
    }

    void silenceIsAnsweredByAPathOfItsOwn()
    {
        TestHost host;
        LossyRelay relay{host.port(), {}, 1};
        TestClient client{relay.port(), host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(!client.heard.paths.empty(), kPatience_ms);
        const int before = client.transport.tries();
        relay.setCut(true);
        QTRY_VERIFY_WITH_TIMEOUT(client.transport.tries() > before, kPatience_ms);
        QVERIFY(client.heard.ended.empty()); // the old one is used meanwhile
        relay.setCut(false);
        QTRY_COMPARE_WITH_TIMEOUT(client.heard.paths.size(), std::size_t{2}, kPatience_ms);
        QVERIFY(client.heard.ended == std::vector<PeerAddress>{1});
        client.send("here again");
        QTRY_COMPARE_WITH_TIMEOUT(host.heard.received.size(), std::size_t{1}, kPatience_ms);
    }

    void hostThatComesBackIsFound()
    {
        auto host = std::make_unique<TestHost>();
        const std::uint16_t port = host->port();
        const auto keys = host->keys;
        TestClient client{port, keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(!client.heard.paths.empty(), kPatience_ms);
        host.reset(); // without a word
        host = std::make_unique<TestHost>(port);
        host->keys = keys;
        QTRY_COMPARE_WITH_TIMEOUT(client.heard.paths.size(), std::size_t{2}, kPatience_ms);
    }

    void farewellEndsThePathAtOnce()
    {
        TestHost host;
        TestClient client{host.port(), host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(!client.heard.paths.empty() && !host.heard.paths.empty(),
                                 kPatience_ms);
        client.transport.close();
        // A path that is only silent ends as well, later.
        constexpr auto kSooner =
            std::chrono::duration_cast<std::chrono::milliseconds>(HostTransport::kPathTimeout / 2);
        QTRY_COMPARE_WITH_TIMEOUT(host.transport->paths(), std::size_t{0}, int(kSooner.count()));
        QVERIFY(host.heard.ended == std::vector<PeerAddress>{1});
    }

    void bytesFromElsewhereAreNotHeard()
    {
        TestHost host;
        LossyRelay relay{host.port(), {}, 1};
        TestClient client{relay.port(), host.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(!client.heard.paths.empty(), kPatience_ms);
        QUdpSocket stranger;
        QVERIFY(stranger.bind(kLoopback, 0));
        const std::uint16_t port = relay.toHost().back().clientPort;
        for (const QByteArray& bytes :
             {QByteArray{}, QByteArray{"CA"}, relay.toHost().back().bytes})
            stranger.writeDatagram(bytes, kLoopback, port);
        host.transport->send(1, textBytes("mine"));
        QTRY_COMPARE_WITH_TIMEOUT(client.heard.received.size(), std::size_t{1}, kPatience_ms);
        QVERIFY(client.heard.ended.empty());
    }
};

CARINA_TEST(TestClientTransport)

} // namespace carina::client_transport_test

#include "tst_client_transport.moc"
