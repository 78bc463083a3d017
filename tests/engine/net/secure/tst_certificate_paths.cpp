#include "apps/lab/lossy_relay.h"
#include "tests/engine/net/secure/made_certificates.h"
#include "tests/engine/net/secure/raw_certificate_client.h"

namespace carina
{

/// The transports where the host has a certificate: what held with a code alone holds.
class TestCertificatePaths : public QObject
{
    Q_OBJECT

private:
    HostCertificate read(const char* name) const
    {
        return *HostCertificate::read(m_made->certificate(name), m_made->key(name));
    }
    /// Also one that is over: an attacker presents it all the same.
    HostCertificate unchecked(const char* name) const
    {
        QFile certificate{m_made->path(QLatin1String{name}, "pem")};
        QFile key{m_made->path(QLatin1String{name}, "key")};
        if (!certificate.open(QIODevice::ReadOnly) || !key.open(QIODevice::ReadOnly))
            return {};
        return {QSslCertificate::fromData(certificate.readAll()), QSslKey{key.readAll(), QSsl::Ec},
                "carina.example"};
    }
    /// A client that wants a certificate from our authority for this name.
    ExpectedCertificate expected(const char* name = "carina.example") const
    {
        return *ExpectedCertificate::read(name, m_made->certificate("ours"));
    }
    struct CertifiedHost : TestHost {
        explicit CertifiedHost(HostCertificate certificate, std::uint16_t port = 0) : TestHost{port}
        {
            transport->present(std::move(certificate));
        }
    };

private Q_SLOTS:
    void initTestCase()
    {
        if (!MadeCertificates::canBeMade())
            QSKIP("the program openssl is not installed");
        m_made = std::make_unique<MadeCertificates>();
        m_made->make(QStringLiteral("host"));
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
        QTRY_VERIFY_WITH_TIMEOUT(!client.heard.paths.empty() && !host.heard.paths.empty(), kSoonMs);
        QVERIFY((host.heard.paths.begin()->second == Credential{Role::Observer, std::nullopt}));
        QVERIFY((client.heard.paths.begin()->second == Credential{Role::Observer, std::nullopt}));
        client.send("question");
        QTRY_COMPARE_WITH_TIMEOUT(host.heard.received.size(), std::size_t{1}, kSoonMs);
        QVERIFY(host.heard.received[0] == textBytes("question"));
        host.transport->send(1, textBytes("answer"));
        QTRY_COMPARE_WITH_TIMEOUT(client.heard.received.size(), std::size_t{1}, kSoonMs);
        QCOMPARE(host.transport->handshakes(), std::size_t{0});
    }

    void datagramsAreNoLongerThanWithACode()
    {
        CertifiedHost host{read("host")};
        lab::LossyRelay relay{host.port(), {}, 1};
        TestClient client{relay.port(), host.keys.at(Role::Trainee), Role::Trainee, expected()};
        QTRY_VERIFY_WITH_TIMEOUT(!client.heard.paths.empty(), kSoonMs);
        client.transport.send(1, std::vector<std::byte>(kLargestDatagram));
        QTRY_COMPARE_WITH_TIMEOUT(host.heard.received.size(), std::size_t{1}, kSoonMs);
        QCOMPARE(relay.toHost().back().bytes.size(), qsizetype(kLargestDatagram) + 29);
        for (const auto& passed : relay.toHost())
            QVERIFY(passed.bytes.size() <= 1200);
    }

    void hostThatIsNotTrustedIsNotJoined()
    {
        struct Untrusted {
            MadeCertificates::Wanted made;
            const char* name;
            Errc code;
        };
        const std::vector<Untrusted> all{{{.authority = QStringLiteral("another")},
                                          "carina.example",
                                          Errc::CertificateUntrusted},
                                         {{.days = -1}, "carina.example", Errc::CertificateExpired},
                                         {{}, "other.example", Errc::CertificateOfAnother},
                                         {{}, "127.0.0.2", Errc::CertificateOfAnother}};
        std::vector<std::unique_ptr<CertifiedHost>> hosts;
        std::vector<std::unique_ptr<TestClient>> clients;
        for (const Untrusted& one : all) {
            m_made->make(QStringLiteral("bad"), one.made);
            hosts.push_back(std::make_unique<CertifiedHost>(unchecked("bad")));
            clients.push_back(std::make_unique<TestClient>(hosts.back()->port(),
                                                           hosts.back()->keys.at(Role::Trainee),
                                                           Role::Trainee, expected(one.name)));
        }
        for (std::size_t i = 0; i < all.size(); ++i) {
            QTRY_VERIFY_WITH_TIMEOUT(clients[i]->heard.refusal.has_value(), kSoonMs);
            QCOMPARE(clients[i]->heard.refusal->code, all[i].code);
            QVERIFY(clients[i]->heard.paths.empty());
            QVERIFY(hosts[i]->heard.paths.empty()); // nobody proved a role to such a host
        }
    }

    void neitherEndDoesWithoutTheCertificate()
    {
        TestHost plain;
        TestClient wantsOne{plain.port(), plain.keys.at(Role::Trainee), Role::Trainee, expected()};
        CertifiedHost certified{read("host")};
        TestClient wantsNone{certified.port(), certified.keys.at(Role::Trainee)};
        QTRY_VERIFY_WITH_TIMEOUT(wantsOne.heard.refusal && wantsNone.heard.refusal, kSoonMs);
        QCOMPARE(*wantsOne.heard.refusal, (Error{Errc::CertificateMissing, "carina.example"}));
        QCOMPARE(*wantsNone.heard.refusal, (Error{Errc::CertificateNeeded, {}}));
        QVERIFY(plain.heard.paths.empty() && certified.heard.paths.empty());
        QVERIFY(wantsOne.heard.paths.empty() && wantsNone.heard.paths.empty());
        QCOMPARE(wantsNone.transport.tries(), ClientCredentials::kRejectionsBelieved);
        QCOMPARE(certified.transport->handshakes(), std::size_t{0});
    }

    void wrongKeyIsRefusedAfterTheCertificate()
    {
        CertifiedHost host{read("host")};
        TestClient guesses{host.port(), randomKey(), Role::Trainee, expected()};
        TestClient observes{host.port(), host.keys.at(Role::Observer), Role::Trainee, expected()};
        QTRY_VERIFY_WITH_TIMEOUT(guesses.heard.refusal && observes.heard.refusal, kSoonMs);
        for (const TestClient* client : {&guesses, &observes}) {
            QCOMPARE(client->heard.refusal->code, Errc::WrongCode);
            // The first learns which session it is, and derives its key.
            QCOMPARE(client->transport.tries(), 1 + ClientCredentials::kRejectionsBelieved);
        }
        QVERIFY(host.heard.paths.empty());
        QCOMPARE(host.transport->handshakes(), std::size_t{0});
    }

    void oneWhoseKeyIsNotDerivedYetComesInOnceItIs()
    {
        CertifiedHost host{read("host")};
        const AccessKey key = host.keys.at(Role::Trainee);
        host.keys.erase(Role::Trainee);
        TestClient client{host.port(), key, Role::Trainee, expected()};
        QTRY_VERIFY_WITH_TIMEOUT(client.transport.tries() > ClientCredentials::kRejectionsBelieved,
                                 kSoonMs);
        QVERIFY(!client.heard.refusal && host.heard.paths.empty());
        host.keys.emplace(Role::Trainee, key);
        QTRY_VERIFY_WITH_TIMEOUT(!client.heard.paths.empty(), kSoonMs);
    }

    void replayedDatagramsChangeNothing()
    {
        CertifiedHost host{read("host")};
        lab::LossyRelay relay{host.port(), {}, 1};
        TestClient client{relay.port(), host.keys.at(Role::Trainee), Role::Trainee, expected()};
        QTRY_VERIFY_WITH_TIMEOUT(!client.heard.paths.empty(), kSoonMs);
        client.send("once");
        QTRY_COMPARE_WITH_TIMEOUT(host.heard.received.size(), std::size_t{1}, kSoonMs);
        for (const auto& passed : std::vector{relay.toHost()})
            relay.replay(passed);
        client.send("again");
        QTRY_COMPARE_WITH_TIMEOUT(host.heard.received.size(), std::size_t{2}, kSoonMs);
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
        QTRY_VERIFY_WITH_TIMEOUT(client->isIn(), kSoonMs);
        const std::uint16_t port = client->port();
        client.reset(); // without a word
        client.emplace(host.port(), expected(), std::nullopt, port);
        QTRY_COMPARE_WITH_TIMEOUT(host.transport->handshakes(), std::size_t{1}, kSoonMs);
        QTRY_VERIFY_WITH_TIMEOUT(client->isAsked(), kSoonMs);
        client->send("let me in all the same");
        client->send("please");
        QTRY_VERIFY_WITH_TIMEOUT(client->isAsked(), kSoonMs);
        QVERIFY(host.heard.ended.empty() && host.heard.received.empty());
        client.reset();
        client.emplace(host.port(), expected(), key, port);
        QTRY_VERIFY_WITH_TIMEOUT(client->isIn(), kSoonMs);
        QVERIFY(host.heard.ended == std::vector<PeerAddress>{1});
        QCOMPARE(host.transport->paths(), std::size_t{1});
        QCOMPARE(host.transport->handshakes(), std::size_t{0});
        client->send("back");
        QTRY_COMPARE_WITH_TIMEOUT(host.heard.received.size(), std::size_t{1}, kSoonMs);
        QVERIFY(host.heard.received[0] == textBytes("back"));
    }

    void hostThatComesBackIsFound()
    {
        auto host = std::make_unique<CertifiedHost>(read("host"));
        const std::uint16_t port = host->port();
        const auto keys = host->keys;
        TestClient client{port, keys.at(Role::Trainee), Role::Trainee, expected()};
        QTRY_VERIFY_WITH_TIMEOUT(!client.heard.paths.empty(), kSoonMs);
        host.reset(); // without a word
        host = std::make_unique<CertifiedHost>(read("host"), port);
        host->keys = keys;
        QTRY_COMPARE_WITH_TIMEOUT(client.heard.paths.size(), std::size_t{2}, kSoonMs);
    }

    void handshakeWithoutProofIsForgotten()
    {
        CertifiedHost host{read("host")};
        const RawCertificateClient client{host.port(), expected(), std::nullopt};
        QTRY_VERIFY_WITH_TIMEOUT(client.isAsked(), kSoonMs);
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
        QTRY_VERIFY_WITH_TIMEOUT((said += client.readAll()).contains("Verification: OK"), kSoonMs);
        QVERIFY2(said.contains("ECDHE-ECDSA-CHACHA20-POLY1305"), said.constData());
        QVERIFY2(said.contains("DTLSv1.2"), said.constData());
        client.kill();
        client.waitForFinished();
        QVERIFY(host.heard.paths.empty());
    }

private:
    std::unique_ptr<MadeCertificates> m_made;
};

} // namespace carina

QTEST_GUILESS_MAIN(carina::TestCertificatePaths)
#include "tst_certificate_paths.moc"
