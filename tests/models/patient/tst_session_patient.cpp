#include "models/patient/session_patient.h"

#include "engine/anatomy/patient/patient_name.h"
#include "models/errors/error_text.h"
#include "tests/engine/net/anatomy_transfer/transfer_ends.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

namespace carina::session_patient_test
{

using namespace test;

/// A session in virtual time, and a computer over real sockets that hands out its patient.
class TestSessionPatient : public QObject
{
    Q_OBJECT

private:
    static SharedPatientModel patientNamed(const std::string& name, const std::string& contentHash)
    {
        Anatomy anatomy = carriedSample().anatomy;
        anatomy.name = name;
        anatomy.contentHash = contentHash;
        return *patientOf(std::move(anatomy));
    }
    static fact::AnatomyChosen somebody() { return {kSetHash, "Somebody else"}; }
    void follow()
    {
        m_model->follow([this](const SharedPatientModel& patient) -> Result<void> {
            if (m_refused)
                return tl::unexpected(*m_refused);
            m_laid.push_back(patient->contentHash());
            return {};
        });
    }
    void makeModel(int licenceShown_ms)
    {
        m_model = std::make_unique<SessionPatient>(
            *m_node, FakeSessionNode::kStation,
            patientNamed("First", madeHash(parametersOf(BuiltinPatient::Adult))),
            m_folder->path().toStdString(), licenceShown_ms);
    }
    [[nodiscard]] bool saysFault(Errc code) const
    {
        return m_model->notice().contains(errorText({code, {}})) && m_model->canFetchAgain();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<FakeSessionNode> m_node;
    std::unique_ptr<ServingHost> m_host;
    std::unique_ptr<SessionPatient> m_model;
    std::vector<std::string> m_laid;
    std::optional<Error> m_refused;

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_node = std::make_unique<FakeSessionNode>(FakeSessionNode::kTrainee);
        m_host = std::make_unique<ServingHost>(1);
        m_laid.clear();
        m_refused.reset();
        makeModel(SessionPatient::kLicenceShown_ms);
    }
    void cleanup() { m_model.reset(); }

    void leavesThePatientThatIsTheSessions()
    {
        follow();
        QCOMPARE(m_model->notice(), QString{}); // nothing was chosen yet
        m_node->decide(fact::AnatomyChosen{madeHash(parametersOf(BuiltinPatient::Adult)), "Adult"});
        QTest::qWait(2 * SessionPatient::kInterval_ms);
        QCOMPARE(m_model->notice(), QString{});
        QVERIFY(m_laid.empty());
        QVERIFY(!m_model->canStop() && !m_model->canFetchAgain());
    }

    void goesToAnotherStation()
    {
        constexpr StationId kRoom{1};
        m_node->addStation("Room 5");
        m_node->decide(fact::AnatomyChosen{madeHash(parametersOf(BuiltinPatient::Adult)), "Adult"});
        m_node->decideAt(kRoom, somebody());
        importInto(m_folder->path().toStdString(), carriedSample());
        follow();
        QVERIFY(m_laid.empty());
        m_model->setStation(kRoom);
        QTRY_COMPARE_WITH_TIMEOUT(m_laid, std::vector<std::string>{kSetHash}, kSoon_ms);
    }

    void fetchesThePatientThatIsNotHere()
    {
        m_node->hostDoor = doorAt(m_host->port());
        m_node->decide(somebody());
        follow();
        QVERIFY(m_model->notice().contains(QStringLiteral("built-in patient “First” is shown")));
        QVERIFY(m_model->notice().contains(QStringLiteral("“Somebody else”")));
        QTRY_VERIFY_WITH_TIMEOUT(!m_laid.empty(), kSoon_ms);
        QCOMPARE(m_laid, std::vector<std::string>{kSetHash});
        QCOMPARE(m_model->patient()->contentHash(), kSetHash);
        QCOMPARE(m_model->patient()->name(), std::string{"Somebody else"});
        QCOMPARE(m_model->notice(), QStringLiteral("The session's patient “Somebody else” has "
                                                   "arrived\nCC0 by Somebody"));
        QVERIFY(!m_model->canStop() && !m_model->canFetchAgain());
    }

    void waitsUntilTheHostLetsItIn()
    {
        m_node->decide(somebody());
        follow();
        QTest::qWait(2 * SessionPatient::kInterval_ms);
        QVERIFY(m_laid.empty());
        QVERIFY(m_model->notice().contains(QStringLiteral("is requested …")));
        m_node->hostDoor = doorAt(m_host->port());
        QTRY_VERIFY_WITH_TIMEOUT(!m_laid.empty(), kSoon_ms);
    }

    void takesWhatWasImportedHereWithoutAsking()
    {
        importInto(m_folder->path().toStdString(), carriedSample());
        m_node->decide(somebody());
        follow();
        QTRY_VERIFY_WITH_TIMEOUT(!m_laid.empty(), kSoon_ms);
        QCOMPARE(m_model->patient()->name(), std::string{"Somebody else"});
        QCOMPARE(m_model->notice(), QString{});
    }

    void saysThatAPatientIsOfAnotherVersion()
    {
        m_node->hostDoor = doorAt(m_host->port());
        m_node->decide(fact::AnatomyChosen{"builtin-adult-99", "Adult"});
        follow();
        QTRY_VERIFY_WITH_TIMEOUT(m_model->canFetchAgain(), kSoon_ms);
        QVERIFY(m_model->notice().contains(errorText({Errc::VersionMismatch, "Adult"})));
    }

    void saysWhyThePatientDoesNotComeAndAsksAgain()
    {
        m_host->isNamed = false;
        m_node->hostDoor = doorAt(m_host->port());
        m_node->decide(somebody());
        follow();
        QTRY_VERIFY_WITH_TIMEOUT(saysFault(Errc::SetNotNamed), kSoon_ms);
        QVERIFY(m_model->notice().contains(QStringLiteral("built-in patient “First” is shown")));
        QVERIFY(!m_model->canStop());
        m_host->isNamed = true;
        m_model->fetchAgain();
        QVERIFY(!m_model->canFetchAgain());
        QTRY_VERIFY_WITH_TIMEOUT(!m_laid.empty(), kSoon_ms);
    }

    void saysWhyItAsksAgain()
    {
        m_node->hostDoor = doorAt(m_host->port());
        m_host->server.reset();
        m_node->decide(somebody());
        follow();
        const QString silent =
            errorText({Errc::HostSilent, "TCP " + std::to_string(m_node->hostDoor->port)});
        QTRY_VERIFY_WITH_TIMEOUT(m_model->notice().contains(silent), kSoon_ms);
        QVERIFY(m_model->canStop());
    }

    void stopsWhenAPersonWantsIt()
    {
        ScriptedHost slow{[](RawPeer& peer, const Frame& frame) {
            if (std::holds_alternative<Want>(frame))
                peer.say(Offer{40'000'000, std::string(64, 'a'), "CC BY"});
            else
                peer.say(Chunk{bytesOf(QByteArray(60'000, 'x'))});
        }};
        m_node->hostDoor = doorAt(slow.port());
        m_node->decide(somebody());
        follow();
        QTRY_VERIFY_WITH_TIMEOUT(
            m_model->notice().contains(QStringLiteral("is being received: 0 of 40\u00a0MB")),
            kSoon_ms);
        QVERIFY(m_model->notice().endsWith(QStringLiteral("\nCC BY")));
        QVERIFY(m_model->canStop());
        m_model->stop();
        QVERIFY(m_model->notice().contains(
            QStringLiteral("The transfer of the session's patient “Somebody else” was stopped")));
        QVERIFY(!m_model->canStop() && m_model->canFetchAgain());
    }

    void licenceLeavesThePictureThoughTheSetStillComes()
    {
        ScriptedHost slow{[](RawPeer& peer, const Frame& frame) {
            if (std::holds_alternative<Want>(frame))
                peer.say(Offer{40'000'000, std::string(64, 'a'), "CC BY"});
        }};
        makeModel(SessionPatient::kInterval_ms);
        m_node->hostDoor = doorAt(slow.port());
        m_node->decide(somebody());
        follow();
        const QString licence = QStringLiteral("\nCC BY");
        QTRY_VERIFY_WITH_TIMEOUT(m_model->notice().endsWith(licence), kSoon_ms);
        QTRY_VERIFY_WITH_TIMEOUT(!m_model->notice().contains(licence), kSoon_ms);
        QVERIFY(m_model->notice().contains(QStringLiteral("is being received: 0 of 40\u00a0MB")));
    }

    void keepsThePatientWhereTheOtherCannotBeLaid()
    {
        m_refused = Error{Errc::OtherPatient, {}};
        m_node->hostDoor = doorAt(m_host->port());
        m_node->decide(somebody());
        follow();
        QTRY_VERIFY_WITH_TIMEOUT(saysFault(Errc::OtherPatient), kSoon_ms);
        QCOMPARE(m_model->patient()->name(), std::string{"First"});
    }

    void followsTheSessionToAnotherPatient()
    {
        m_node->decide(somebody()); // nobody lets it in
        follow();
        m_node->decide(fact::AnatomyChosen{madeHash(parametersOf(BuiltinPatient::Adult)), "Adult"});
        QTRY_COMPARE_WITH_TIMEOUT(m_model->notice(), QString{}, kSoon_ms);
        QVERIFY(m_laid.empty());
    }
};

CARINA_TEST(TestSessionPatient)

} // namespace carina::session_patient_test

#include "tst_session_patient.moc"
