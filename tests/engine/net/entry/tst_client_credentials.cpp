#include "engine/net/entry/client_credentials.h"
#include "tests/support/patience.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

namespace carina::client_credentials_test
{
namespace
{

const std::string kSession = "00112233445566778899aabbccddeeff";
const std::string kOther = "ffeeddccbbaa99887766554433221100";

struct Person {
    explicit Person(std::optional<JoinCode> code = JoinCode::random(),
                    const std::filesystem::path& tokens = {})
        : credentials{Role::Trainee, std::move(code), TokenFolder{tokens, Role::Trainee, "Anna"},
                      [this](const JoinCode&, const SessionKey& session) -> Result<AccessKey> {
                          ++derivations;
                          if (noMemory)
                              return fail(Errc::NotEnoughMemory);
                          AccessKey key{};
                          key[0] = session[0];
                          return key;
                      }}
    {
    }

    std::atomic<int> derivations = 0;
    std::atomic<bool> noMemory = false;
    ClientCredentials credentials;
};

} // namespace

class TestClientCredentials : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void keyIsDerivedOnceForASession()
    {
        Person anna;
        ClientCredentials& credentials = anna.credentials;
        QVERIFY(!credentials.offerFor(kSession));
        QVERIFY(!credentials.mayTry());
        QVERIFY(!credentials.offerFor(kSession)); // not a second time meanwhile
        QTRY_VERIFY_WITH_TIMEOUT(credentials.mayTry(), kPatience_ms);
        const auto offer = credentials.offerFor(kSession);
        QVERIFY(offer);
        QCOMPARE(toText(offer->identity), "trainee:" + kSession + ":new");
        QVERIFY(credentials.offerFor(kSession));
        QCOMPARE(anna.derivations.load(), 1);
        QVERIFY(!credentials.offerFor(kOther)); // needs a key of its own
        QTRY_VERIFY_WITH_TIMEOUT(credentials.mayTry(), kPatience_ms);
        QCOMPARE(anna.derivations.load(), 2);
    }

    void hostThatCannotBeTrustedIsBelievedToBeSoAfterThreeTimes()
    {
        Person anna;
        const Error untrusted{Errc::CertificateUntrusted, "self-signed"};
        for (int i = 1; i < ClientCredentials::kRejectionsBelieved; ++i) {
            anna.credentials.turnedAway(untrusted);
            QVERIFY(!anna.credentials.refusal() && anna.credentials.mayTry());
        }
        anna.credentials.turnedAway(untrusted);
        QVERIFY(!anna.credentials.mayTry());
        QCOMPARE(*anna.credentials.refusal(), untrusted);
    }

    void onlySessionsGetAnOffer()
    {
        Person anna;
        for (const char* hint : {"", "Carina", "00112233445566778899AABBCCDDEEFF"})
            QVERIFY(!anna.credentials.offerFor(hint));
        QCOMPARE(anna.derivations.load(), 0);
        QVERIFY(anna.credentials.mayTry());
    }

    void tokenComesBeforeTheCode()
    {
        Person anna;
        anna.credentials.accepted({{{Role::Trainee, std::nullopt}, kSession}, {}});
        QVERIFY(!anna.credentials.hasToken());
        anna.credentials.keepToken({ParticipantId{4}, randomKey()});
        QVERIFY(anna.credentials.hasToken());
        const auto offer = anna.credentials.offerFor(kSession);
        QCOMPARE(toText(offer->identity), "trainee:" + kSession + ":4");
        QCOMPARE(anna.derivations.load(), 0);
    }

    void tokenThatIsTurnedDownMakesWayForTheCode()
    {
        Person anna;
        anna.credentials.accepted({{{Role::Trainee, std::nullopt}, kSession}, {}});
        anna.credentials.keepToken({ParticipantId{4}, randomKey()});
        const auto offer = anna.credentials.offerFor(kSession);
        for (int i = 0; i < 3; ++i)
            anna.credentials.rejected(*offer);
        QVERIFY(!anna.credentials.hasToken());
        QVERIFY(!anna.credentials.refusal());
        QVERIFY(!anna.credentials.offerFor(kSession));
        QTRY_COMPARE_WITH_TIMEOUT(anna.derivations.load(), 1, kPatience_ms);
    }

    void codeIsGivenUpAfterThreeRejections()
    {
        Person anna{*JoinCode::parse("7KQ2M-X4TN9")};
        const KeyOffer offer{{{Role::Trainee, std::nullopt}, kSession}, {}};
        anna.credentials.rejected(offer);
        anna.credentials.rejected(offer);
        QVERIFY(anna.credentials.mayTry());
        anna.credentials.accepted(offer); // somebody else had said so
        anna.credentials.rejected(offer);
        anna.credentials.rejected(offer);
        QVERIFY(!anna.credentials.refusal());
        anna.credentials.rejected(offer);
        QVERIFY(!anna.credentials.mayTry());
        QCOMPARE(*anna.credentials.refusal(), (Error{Errc::WrongCode, "7KQ2M-X4TN9"}));
        QVERIFY(!anna.credentials.offerFor(kSession));
    }

    void withoutCodeAndTokenThereIsNoWayIn()
    {
        Person anna{std::nullopt};
        QVERIFY(anna.credentials.mayTry()); // the session may be one whose token there is
        QVERIFY(!anna.credentials.offerFor(kSession));
        QCOMPARE(anna.credentials.refusal()->code, Errc::WrongCode);
    }

    /// Who says to be its host, at a place that nobody named, sees no key but the token's.
    void foundHostIsOfferedTheTokenAlone()
    {
        Person anna;
        QVERIFY(!anna.credentials.offerToFound(kSession));
        anna.credentials.accepted({{{Role::Trainee, std::nullopt}, kSession}, {}});
        QVERIFY(!anna.credentials.offerToFound(kSession));
        anna.credentials.keepToken({ParticipantId{4}, randomKey()});
        QVERIFY(anna.credentials.offerToFound(kSession));
        QVERIFY(!anna.credentials.offerToFound(kOther));
        QCOMPARE(anna.derivations.load(), 0);
    }

    /// Her program is started again, and given the same place.
    void sessionOfTheLastTimeIsSought()
    {
        const QTemporaryDir folder;
        const std::filesystem::path tokens{folder.path().toStdString()};
        {
            Person anna{JoinCode::random(), tokens};
            anna.credentials.setPlace("192.0.2.7", 45000);
            QCOMPARE(anna.credentials.sought(), std::string{});
            anna.credentials.accepted({{{Role::Trainee, std::nullopt}, kSession}, {}});
            QCOMPARE(anna.credentials.sought(), std::string{}); // nothing proves who its host is
            anna.credentials.keepToken({ParticipantId{4}, randomKey()});
            QCOMPARE(anna.credentials.sought(), kSession);
        }
        Person again{std::nullopt, tokens};
        again.credentials.setPlace("192.0.2.7", 45000);
        QCOMPARE(again.credentials.session(), std::string{});
        QCOMPARE(again.credentials.sought(), kSession);
        const auto offer = again.credentials.offerToFound(kSession);
        QVERIFY(offer);
        QCOMPARE(toText(offer->identity), "trainee:" + kSession + ":4");
        QVERIFY(!again.credentials.offerToFound(kOther));
        again.credentials.accepted(*offer);
        QCOMPARE(again.credentials.session(), kSession);
    }

    /// Where that is may be another session, whose console is not there yet.
    void nothingIsSoughtForAnotherPlace_data()
    {
        QTest::addColumn<QByteArray>("address");
        QTest::addColumn<int>("port");
        QTest::newRow("another port") << QByteArray{"192.0.2.7"} << 45001;
        QTest::newRow("another address") << QByteArray{"192.0.2.8"} << 45000;
    }
    void nothingIsSoughtForAnotherPlace()
    {
        QFETCH(const QByteArray, address);
        QFETCH(const int, port);
        const QTemporaryDir folder;
        const std::filesystem::path tokens{folder.path().toStdString()};
        TokenFolder kept{tokens, Role::Trainee, "Anna"};
        QVERIFY(kept.keep(kSession, {}) && kept.keepVisit({kSession, "192.0.2.7", 45000}));
        Person anna{std::nullopt, tokens};
        anna.credentials.setPlace(address.toStdString(), std::uint16_t(port));
        QCOMPARE(anna.credentials.sought(), std::string{});
        QVERIFY(!anna.credentials.offerToFound(kSession));
        QVERIFY(anna.credentials.offerFor(kSession)); // if it is there
    }

    /// Another session at the address of the one that this program is in.
    void anotherSessionIsOfferedNothing()
    {
        Person anna;
        anna.credentials.accepted({{{Role::Trainee, std::nullopt}, kSession}, {}});
        QVERIFY(!anna.credentials.offerFor(kOther));
        QCOMPARE(anna.derivations.load(), 0);
        QVERIFY(anna.credentials.mayTry());
    }

    void lackOfMemoryIsTold()
    {
        Person anna;
        anna.noMemory = true;
        bool told = false;
        anna.credentials.onChange([&] { told = true; });
        QVERIFY(!anna.credentials.offerFor(kSession));
        QTRY_VERIFY_WITH_TIMEOUT(told, kPatience_ms);
        QCOMPARE(anna.credentials.refusal()->code, Errc::NotEnoughMemory);
    }
};

CARINA_TEST(TestClientCredentials)

} // namespace carina::client_credentials_test

#include "tst_client_credentials.moc"
