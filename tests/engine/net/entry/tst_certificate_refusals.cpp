#include "tests/engine/net/entry/certified_ends.h"
#include "tests/support/soon.h"
#include "tests/support/test_class.h"

namespace carina::certificate_refusals_test
{

using test::soon;

/// Who does not come in where the host has a certificate, or should have one. A client believes it
/// after some tries a quarter of a second apart, so all of them begin together.
class TestCertificateRefusals : public QObject
{
    Q_OBJECT

private:
    /// A host and one who wants to come in.
    struct Ends {
        std::unique_ptr<TestHost> host;
        std::unique_ptr<TestClient> client;

        [[nodiscard]] bool isRefused() const
        {
            return soon([this] { return client->heard.refusal.has_value(); });
        }
        [[nodiscard]] bool isAnybodyIn() const
        {
            return !client->heard.paths.empty() || !host->heard.paths.empty();
        }
    };

    static Ends begin(std::unique_ptr<TestHost> host, std::optional<ExpectedCertificate> expected,
                      const AccessKey& key)
    {
        auto client =
            std::make_unique<TestClient>(host->port(), key, Role::Trainee, std::move(expected));
        return {std::move(host), std::move(client)};
    }
    static Ends begin(std::unique_ptr<TestHost> host, std::optional<ExpectedCertificate> expected)
    {
        const AccessKey key = host->keys.at(Role::Trainee);
        return begin(std::move(host), std::move(expected), key);
    }
    static std::unique_ptr<TestHost> presenting(HostCertificate certificate)
    {
        auto host = std::make_unique<TestHost>();
        host->transport->present(std::move(certificate));
        return host;
    }
    std::unique_ptr<TestHost> certified() const
    {
        return presenting(readCertificate(*m_made, "host"));
    }
    void beginUntrusted(const char* certificate, const char* expectedName)
    {
        m_untrusted.push_back(begin(presenting(uncheckedCertificate(*m_made, certificate)),
                                    expectedFrom(*m_made, expectedName)));
    }

private Q_SLOTS:
    void initTestCase()
    {
        if (!MadeCertificates::canBeMade())
            return;
        m_made = std::make_unique<MadeCertificates>();
        m_made->make(QStringLiteral("host"));
        m_made->make(QStringLiteral("foreign"), {.authority = QStringLiteral("another")});
        m_made->make(QStringLiteral("over"), {.days = -1});
        const auto expected = expectedFrom(*m_made);
        m_wantsOne = begin(std::make_unique<TestHost>(), expected);
        m_wantsNone = begin(certified(), {});
        m_guesses = begin(certified(), expected, randomKey());
        auto host = certified();
        const AccessKey observers = host->keys.at(Role::Observer);
        m_observes = begin(std::move(host), expected, observers);
        m_early = begin(certified(), expected, m_earlyKey);
        m_early.host->keys.erase(Role::Trainee);
        beginUntrusted("foreign", "carina.example");
        beginUntrusted("over", "carina.example");
        beginUntrusted("host", "other.example");
        beginUntrusted("host", "127.0.0.2");
    }

    void init()
    {
        if (!m_made)
            QSKIP("the program openssl is not installed");
    }

    void hostThatIsNotTrustedIsNotJoined_data()
    {
        QTest::addColumn<std::size_t>("number");
        QTest::addColumn<Errc>("code");
        QTest::newRow("of another authority") << std::size_t{0} << Errc::CertificateUntrusted;
        QTest::newRow("over") << std::size_t{1} << Errc::CertificateExpired;
        QTest::newRow("for another name") << std::size_t{2} << Errc::CertificateOfAnother;
        QTest::newRow("for another address") << std::size_t{3} << Errc::CertificateOfAnother;
    }
    void hostThatIsNotTrustedIsNotJoined()
    {
        QFETCH(const std::size_t, number);
        QFETCH(const Errc, code);
        const Ends& ends = m_untrusted.at(number);
        QVERIFY(ends.isRefused());
        QCOMPARE(ends.client->heard.refusal->code, code);
        QVERIFY(!ends.isAnybodyIn()); // nobody proved a role to such a host
    }

    void neitherEndDoesWithoutTheCertificate()
    {
        QVERIFY(m_wantsOne.isRefused() && m_wantsNone.isRefused());
        QCOMPARE(*m_wantsOne.client->heard.refusal,
                 (Error{Errc::CertificateMissing, "carina.example"}));
        QCOMPARE(*m_wantsNone.client->heard.refusal, (Error{Errc::CertificateNeeded, {}}));
        QVERIFY(!m_wantsOne.isAnybodyIn() && !m_wantsNone.isAnybodyIn());
        QCOMPARE(m_wantsNone.client->transport.tries(), ClientCredentials::kRejectionsBelieved);
        QCOMPARE(m_wantsNone.host->transport->handshakes(), std::size_t{0});
    }

    void wrongKeyIsRefusedAfterTheCertificate()
    {
        for (const Ends* ends : {&m_guesses, &m_observes}) {
            QVERIFY(ends->isRefused());
            QCOMPARE(ends->client->heard.refusal->code, Errc::WrongCode);
            // The first learns which session it is, and derives its key.
            QCOMPARE(ends->client->transport.tries(), 1 + ClientCredentials::kRejectionsBelieved);
            QVERIFY(!ends->isAnybodyIn());
            QCOMPARE(ends->host->transport->handshakes(), std::size_t{0});
        }
    }

    void oneWhoseKeyIsNotDerivedYetComesInOnceItIs()
    {
        const TestClient& client = *m_early.client;
        QVERIFY(soon(
            [&] { return client.transport.tries() > ClientCredentials::kRejectionsBelieved; }));
        QVERIFY(!client.heard.refusal && !m_early.isAnybodyIn());
        m_early.host->keys.emplace(Role::Trainee, m_earlyKey);
        QVERIFY(soon([&] { return !client.heard.paths.empty(); }));
    }

private:
    std::unique_ptr<MadeCertificates> m_made;
    std::vector<Ends> m_untrusted;
    Ends m_wantsOne;
    Ends m_wantsNone;
    Ends m_guesses;
    Ends m_observes;
    AccessKey m_earlyKey = randomKey();
    Ends m_early;
};

CARINA_TEST(TestCertificateRefusals)

} // namespace carina::certificate_refusals_test

#include "tst_certificate_refusals.moc"
