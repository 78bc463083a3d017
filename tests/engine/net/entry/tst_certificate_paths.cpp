#include "evaluation/network/lossy_relay.h"
#include "tests/engine/net/entry/certified_ends.h"
#include "tests/engine/net/entry/raw_certificate_client.h"
#include "tests/support/soon.h"
#include "tests/support/test_class.h"

namespace carina::certificate_paths_test
{

using test::soon;

/// The transports where the host has a certificate: what held with a code alone holds.
class TestCertificatePaths : public QObject
{
    Q_OBJECT

private:
    HostCertificate read(const char* name) const { return readCertificate(*m_made, name); }
    ExpectedCertificate expected(const char* name = "carina.example") const
    {
        return expectedFrom(*m_made, name);
    }
    static bool isIn(const TestClient& client)
    {
        return soon([&] { return !client.heard.paths.empty(); });
    }
    static bool hears(const Recorder& heard, std::size_t count)
    {
        return soon([&] { return heard.received.size() == count; });
    }

private Q_SLOTS:
    void initTestCase()
    {
        if (!MadeCertificates::canBeMade())
            return;
        m_made = std::make_unique<MadeCertificates>();
        m_made->make(QStringLiteral("host"));
    }

    void init()
    {
        if (!m_made)
            QSKIP("the program openssl is not installed");
    }

    void datagramsPassBothWays_data()
    {
        QTest::addColumn<bool>("rsa");
        QTest::addColumn<QByteArray>("name");
        QTest::newRow("by name") << false << QByteArray{"carina.example"};
        QTest::newRow("by address") << false << QByteArray{"127.0.0.1"};
        QTest::newRow("RSA") << true << QByteArray{"carina.example"};
    }
    void datagramsPassBothWays()
    {
        QFETCH(const bool, rsa);
        QFETCH(const QByteArray, name);
        m_made->make(QStringLiteral("kind"), {.rsa = rsa});
        CertifiedHost host{read("kind")};
        TestClient client{host.port(), host.keys.at(Role::Observer), Role::Observer,
                          expected(name)};
        QVERIFY(isIn(client) && !host.heard.paths.empty());
        QVERIFY((host.heard.paths.begin()->second == Credential{Role::Observer, std::nullopt}));
        QVERIFY((client.heard.paths.begin()->second == Credential{Role::Observer, std::nullopt}));
        client.send("question");
        QVERIFY(hears(host.heard, 1));
        QVERIFY(host.heard.received[0] == textBytes("question"));
        host.transport->send(1, textBytes("answer"));
        QVERIFY(hears(client.heard, 1));
        QCOMPARE(host.transport->handshakes(), std::size_t{0});
    }

    void datagramsAreNoLongerThanWithACode()
    {
        CertifiedHost host{read("host")};
        LossyRelay relay{host.port(), {}, 1};
        TestClient client{relay.port(), host.keys.at(Role::Trainee), Role::Trainee, expected()};
        QVERIFY(isIn(client));
        client.transport.send(1, std::vector<std::byte>(kLargestDatagram));
        QVERIFY(hears(host.heard, 1));
        QCOMPARE(relay.toHost().back().bytes.size(), qsizetype(kLargestDatagram) + 29);
        for (const auto& passed : relay.toHost())
            QVERIFY(passed.bytes.size() <= 1200);
    }

    void replayedDatagramsChangeNothing()
    {
        CertifiedHost host{read("host")};
        LossyRelay relay{host.port(), {}, 1};
        TestClient client{relay.port(), host.keys.at(Role::Trainee), Role::Trainee, expected()};
        QVERIFY(isIn(client));
        client.send("once");
        QVERIFY(hears(host.heard, 1));
        for (const auto& passed : std::vector{relay.toHost()})
            relay.replay(passed);
        client.send("again");
        QVERIFY(hears(host.heard, 2));
        QVERIFY(host.heard.received[1] == textBytes("again"));
        QVERIFY(host.heard.ended.empty() && client.heard.ended.empty());
        QCOMPARE(host.heard.paths.size(), std::size_t{1});
    }

    void pathIsReplacedOnlyByOneThatProvedItsRole()
    {
        CertifiedHost host{read("host")};
        const AccessKey key = host.keys.at(Role::Trainee);
        std::optional<RawCertificateClient> client;
        client.emplace(host.port(), expected(), key);
        QVERIFY(soon([&] { return client->isIn(); }));
        const std::uint16_t port = client->port();
        client.reset(); // without a word
        client.emplace(host.port(), expected(), std::nullopt, port);
        QVERIFY(soon([&] { return host.transport->handshakes() == 1; }));
        QVERIFY(soon([&] { return client->isAsked(); }));
        client->send("let me in all the same");
        client->send("please");
        host.pump.serve(); // on loopback they are there once they are sent
        QVERIFY(host.heard.ended.empty() && host.heard.received.empty());
        client.reset();
        client.emplace(host.port(), expected(), key, port);
        QVERIFY(soon([&] { return client->isIn(); }));
        QVERIFY(host.heard.ended == std::vector<PeerAddress>{1});
        QCOMPARE(host.transport->paths(), std::size_t{1});
        QCOMPARE(host.transport->handshakes(), std::size_t{0});
        client->send("back");
        QVERIFY(hears(host.heard, 1));
        QVERIFY(host.heard.received[0] == textBytes("back"));
    }

    void hostThatComesBackIsFound()
    {
        auto host = std::make_unique<CertifiedHost>(read("host"));
        const std::uint16_t port = host->port();
        const auto keys = host->keys;
        TestClient client{port, keys.at(Role::Trainee), Role::Trainee, expected()};
        QVERIFY(isIn(client));
        host.reset(); // without a word
        host = std::make_unique<CertifiedHost>(read("host"), port);
        host->keys = keys;
        // It tries again once it has heard nothing for so long.
        client.transport.serve(client.heard, monotonicNow() + ClientTransport::kSilence);
        QVERIFY(soon([&] { return client.heard.paths.size() == 2; }));
    }

    void handshakeWithoutProofIsForgotten()
    {
        CertifiedHost host{read("host")};
        const RawCertificateClient client{host.port(), expected(), std::nullopt};
        QVERIFY(soon([&] { return client.isAsked(); }));
        QCOMPARE(host.transport->handshakes(), std::size_t{1});
        host.transport->serve(host.heard, monotonicNow() + HostTransport::kHandshakeTimeout);
        QCOMPARE(host.transport->handshakes(), std::size_t{0});
        QVERIFY(host.heard.paths.empty());
    }

    void opensslsOwnClientTrustsTheHost()
    {
        CertifiedHost host{read("host")};
        QProcess client;
        client.setProcessChannelMode(QProcess::MergedChannels);
        client.start(QStringLiteral("openssl"),
                     {QStringLiteral("s_client"), QStringLiteral("-dtls1_2"),
                      QStringLiteral("-brief"), QStringLiteral("-connect"),
                      QStringLiteral("127.0.0.1:%1").arg(host.port()), QStringLiteral("-CAfile"),
                      m_made->path(QStringLiteral("ours"), "pem"),
                      QStringLiteral("-verify_hostname"), QStringLiteral("carina.example"),
                      QStringLiteral("-verify_return_error")});
        QByteArray said;
        QVERIFY(soon([&] { return (said += client.readAll()).contains("Verification: OK"); }));
        QVERIFY2(said.contains("ECDHE-ECDSA-CHACHA20-POLY1305"), said.constData());
        QVERIFY2(said.contains("DTLSv1.2"), said.constData());
        client.kill();
        client.waitForFinished();
        QVERIFY(host.heard.paths.empty());
    }

private:
    std::unique_ptr<MadeCertificates> m_made;
};

CARINA_TEST(TestCertificatePaths)

} // namespace carina::certificate_paths_test

#include "tst_certificate_paths.moc"
