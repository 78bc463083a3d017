#include "tests/engine/net/entry/made_certificates.h"
#include "tests/engine/net/node/nodes.h"
#include "tests/support/test_class.h"

#include <QDir>

#include <atomic>

namespace carina::node_certificates_test
{

/// Whole nodes where the host has a certificate: who comes in, comes back, and may do what.
class TestNodeCertificates : public QObject
{
    Q_OBJECT

private:
    std::unique_ptr<SessionNode> certifiedHost(MemoryDisk& disk, std::uint16_t port = 0) const
    {
        HostSettings settings = hostSettings(disk, port);
        settings.certificate = CertificateFiles{m_made->certificate("host"), m_made->key("host")};
        return *SessionNode::host(settings, std::make_unique<MemoryStore>(disk));
    }
    JoinSettings guest(const SessionNode& host, const char* name, Role role = Role::Trainee) const
    {
        JoinSettings settings = joinSettings(host, name, role);
        settings.certificate = ExpectedHost{host.certificateName(), m_made->certificate("ours")};
        return settings;
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

    void guestsComeInByNameOrAddress()
    {
        MemoryDisk disk;
        const auto instructor = certifiedHost(disk);
        QCOMPARE(instructor->certificateName(), std::string{"carina.example"});
        const auto anna = join(guest(*instructor, "Anna"));
        JoinSettings byAddress = guest(*instructor, "Ben");
        byAddress.certificate->name.clear();
        const auto ben = join(byAddress);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna) && isIn(*ben), kPatience_ms);
        anna->propose(kStation, fact::BreathingRateSet{perMinute(12.0)});
        QTRY_VERIFY_WITH_TIMEOUT(anna->refusal().has_value(), kPatience_ms);
        QCOMPARE(anna->refusal()->code, Errc::NotPermitted); // a trainee as ever
    }

    void setsAreAskedForWithATokenAlone()
    {
        // There is no certificate behind that door.
        MemoryDisk disk;
        const auto instructor = certifiedHost(disk);
        const auto anna = join(guest(*instructor, "Anna"));
        QTRY_VERIFY_WITH_TIMEOUT(anna->door().has_value(), kPatience_ms);
        QCOMPARE(anna->door()->offer.identity.who.participant, std::optional{anna->self()});
    }

    void observersChangeNothing()
    {
        MemoryDisk disk;
        const auto instructor = certifiedHost(disk);
        const auto olga = join(guest(*instructor, "Olga", Role::Observer));
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*olga), kPatience_ms);
        const std::size_t facts = disk.facts.size();
        olga->publish(ObjectKind::Tube, "Tube", stillTube(*olga));
        olga->propose(kStation, fact::TidalVolumeSet{5e-4});
        QTRY_VERIFY_WITH_TIMEOUT(olga->refusal().has_value(), kPatience_ms);
        QCOMPARE(olga->refusal()->code, Errc::NotPermitted);
        QTRY_VERIFY_WITH_TIMEOUT(olga->pending().empty(), kPatience_ms);
        QVERIFY(instructor->state()->objects().empty());
        QCOMPARE(disk.facts.size(), facts);
    }

    void codeOfAnotherRoleIsWrong()
    {
        MemoryDisk disk;
        const auto instructor = certifiedHost(disk);
        JoinSettings settings = guest(*instructor, "Mallory", Role::Instructor);
        settings.code = instructor->joinCodes().at(Role::Observer);
        const auto mallory = join(settings);
        QTRY_VERIFY_WITH_TIMEOUT(mallory->refusal().has_value(), kPatience_ms);
        QCOMPARE(mallory->refusal()->code, Errc::WrongCode);
        QCOMPARE(instructor->state()->participants().size(), std::size_t{1});
    }

    void guestsComeBackByTheirTokensAfterTheHostCrashed()
    {
        MemoryDisk disk;
        const QTemporaryDir tokens;
        auto instructor = certifiedHost(disk);
        const std::uint16_t port = instructor->port();
        JoinSettings settings = guest(*instructor, "Anna");
        settings.tokens = tokens.path().toStdString();
        auto anna = join(settings);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kPatience_ms);
        const ParticipantId id = anna->self();
        QTRY_VERIFY_WITH_TIMEOUT(!QDir{tokens.path()}.isEmpty(), kPatience_ms);
        instructor.reset();
        anna.reset();
        settings.code.reset(); // the token alone has to do
        instructor = certifiedHost(disk, port);
        anna = join(settings);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kPatience_ms);
        QCOMPARE(anna->self(), id);
    }

    void neitherEndDoesWithoutTheCertificate()
    {
        MemoryDisk disk;
        const auto certified = certifiedHost(disk);
        JoinSettings withoutOne = guest(*certified, "Anna");
        withoutOne.certificate.reset();
        const auto anna = join(withoutOne);
        MemoryDisk another;
        const auto plain = host(another);
        JoinSettings wantsOne = joinSettings(*plain, "Ben");
        wantsOne.certificate = ExpectedHost{"carina.example", m_made->certificate("ours")};
        const auto ben = join(wantsOne);
        QTRY_VERIFY_WITH_TIMEOUT(anna->refusal() && ben->refusal(), kPatience_ms);
        QCOMPARE(anna->refusal()->code, Errc::CertificateNeeded);
        QCOMPARE(ben->refusal()->code, Errc::CertificateMissing);
        QCOMPARE(plain->certificateName(), std::string{});
        for (const SessionNode* node : {certified.get(), plain.get()})
            QCOMPARE(node->state()->participants().size(), std::size_t{1});
    }

    void filesThatDoNotDoAreToldAtOnce()
    {
        MemoryDisk disk;
        HostSettings settings = hostSettings(disk);
        settings.certificate = CertificateFiles{m_made->certificate("host"), m_made->key("ours")};
        const auto node = SessionNode::host(settings, std::make_unique<MemoryStore>(disk));
        QVERIFY(!node);
        QCOMPARE(node.error().code, Errc::KeyDoesNotFit);
        const auto plain = host(disk);
        JoinSettings guest = joinSettings(*plain, "Anna");
        guest.certificate = ExpectedHost{{}, m_made->certificate("nobody")};
        const auto anna = SessionNode::join(guest);
        QVERIFY(!anna);
        QCOMPARE(anna.error().code, Errc::FileNotFound);
    }

private:
    std::unique_ptr<MadeCertificates> m_made;
};

CARINA_TEST(TestNodeCertificates)

} // namespace carina::node_certificates_test

#include "tst_node_certificates.moc"
