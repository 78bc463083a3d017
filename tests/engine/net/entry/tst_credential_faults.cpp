#include "engine/net/entry/session_secrets.h"
#include "engine/net/entry/token_folder.h"
#include "tests/support/struck_child.h"
#include "tests/support/test_class.h"

#include <iostream>
#include <set>

namespace carina::credential_faults_test
{
namespace
{

constexpr const char* kSession = "00112233445566778899aabbccddeeff";
constexpr ParticipantId kFirst{1};
constexpr ParticipantId kSecond{2};

std::filesystem::path secretsIn(const std::filesystem::path& folder)
{
    return folder / "session.secrets";
}

TokenFolder tokensIn(const std::filesystem::path& folder)
{
    return {folder / "tokens", Role::Trainee, "Anna"};
}

/// What the child under faults does: it makes the secrets of a session, gives out two tokens and
/// stores them as those who have them, and tells each that was stored.
int keepUnderFaults(int& argc, char** argv)
{
    const QCoreApplication application{argc, argv};
    const std::filesystem::path folder{argv[1]};
    auto secrets = SessionSecrets::open(secretsIn(folder), kSession);
    if (!secrets)
        secrets = SessionSecrets::open(secretsIn(folder), kSession);
    for (const ParticipantId participant : {kFirst, kSecond}) {
        if (!secrets)
            break;
        const AccessKey token = secrets->newToken(Role::Trainee, participant);
        if (secrets->write())
            std::cout << "issued " << toHex(token) << std::endl;
        if (tokensIn(folder).keep(kSession, {participant, token}))
            std::cout << "kept " << toHex(token) << std::endl;
    }
    return 0;
}

const test::TestEntry kChild{"keep-under-faults", keepUnderFaults};

} // namespace

/// Every write and sync of a session's secrets and of a participant's token struck, one after
/// another.
class TestCredentialFaults : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void losesNothingItReported_data() { test::addFaultKinds(); }
    void losesNothingItReported()
    {
        QFETCH(const QString, kind);
        const auto struck =
            test::strikeEach(QStringLiteral("keep-under-faults"), kind, verifyFiles);
        QVERIFY(struck && *struck >= 5);
        qInfo("%d calls struck", *struck);
    }

private:
    /// That what was told is in the files, and that no file is damaged.
    static void verifyFiles(const std::filesystem::path& folder, const test::StruckChild& child)
    {
        const auto issued = test::allTold(child, "issued");
        const auto kept = test::allTold(child, "kept");
        QVERIFY(child.isStruck || (issued.size() == 2 && kept.size() == 2));
        if (!issued.empty() || std::filesystem::exists(secretsIn(folder))) {
            const auto secrets = SessionSecrets::open(secretsIn(folder), kSession);
            QVERIFY2(secrets, secrets ? "" : secrets.error().detail.c_str());
            QCOMPARE(secrets->codes().size(), std::size_t{3});
            std::set<std::string> stored;
            for (const ParticipantId participant : {kFirst, kSecond})
                if (const auto token = secrets->token(Role::Trainee, participant))
                    stored.insert(toHex(*token));
            for (const std::string& each : issued)
                QVERIFY(stored.contains(each));
        }
        if (!kept.empty()) {
            const auto token = tokensIn(folder).find(kSession);
            QVERIFY(token);
            // The last that was told, or the one that was being stored when the program ended.
            QVERIFY(toHex(token->key) == kept.back() || token->participant == kSecond);
        }
    }
};

CARINA_TEST(TestCredentialFaults)

} // namespace carina::credential_faults_test

#include "tst_credential_faults.moc"
