#include "engine/net/entry/session_secrets.h"
#include "tests/support/test_class.h"

#include <QFile>
#include <QTemporaryDir>

namespace carina::session_secrets_test
{
namespace
{

constexpr const char* kSession = "00112233445566778899aabbccddeeff";

} // namespace

class TestSessionSecrets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_file = m_folder->filePath(QStringLiteral("session.secrets")).toStdString();
    }

    void rolesHaveCodesOfTheirOwn()
    {
        const auto secrets = SessionSecrets::open(m_file, kSession);
        QVERIFY(secrets);
        const JoinCodes& codes = secrets->codes();
        QCOMPARE(codes.size(), std::size_t{3});
        QVERIFY(codes.at(Role::Trainee) != codes.at(Role::Instructor));
        QVERIFY(codes.at(Role::Trainee) != codes.at(Role::Observer));
        QVERIFY(codes.at(Role::Observer) != codes.at(Role::Instructor));
        QVERIFY(!secrets->codeKey(Role::Trainee)); // not derived yet
    }

    void everythingOutlivesAProgram()
    {
        auto before = SessionSecrets::open(m_file, kSession);
        const AccessKey key = randomKey();
        QVERIFY(before->setCodeKey(Role::Observer, key));
        const auto token = before->issueToken(Role::Trainee, ParticipantId{3});
        QVERIFY(token);
        QVERIFY(before->issueToken(Role::Trainee, ParticipantId{3}) == token);

        const auto after = SessionSecrets::open(m_file, kSession);
        QVERIFY(after);
        QVERIFY(after->codes() == before->codes());
        QVERIFY(after->codeKey(Role::Observer) == key);
        QVERIFY(!after->codeKey(Role::Trainee));
        QVERIFY(after->token(Role::Trainee, ParticipantId{3}) == *token);
    }

    void changedCodeAndTokensOutliveAProgram()
    {
        constexpr ParticipantId kAnna{3};
        constexpr ParticipantId kBen{4};
        auto before = SessionSecrets::open(m_file, kSession);
        const JoinCodes old = before->codes();
        QVERIFY(before->setCodeKey(Role::Trainee, randomKey()));
        const auto annas = before->issueToken(Role::Trainee, kAnna);
        QVERIFY(before->issueToken(Role::Trainee, kBen));
        QVERIFY(before->changeCode(Role::Trainee));
        QVERIFY(before->codes().at(Role::Trainee) != old.at(Role::Trainee));
        QVERIFY(before->codes().at(Role::Observer) == old.at(Role::Observer));
        QVERIFY(!before->codeKey(Role::Trainee));
        const auto fresh = before->replaceToken(Role::Trainee, kAnna);
        QVERIFY(fresh && fresh != annas);
        QVERIFY(before->revokeToken(Role::Trainee, kBen));
        QVERIFY(before->revokeToken(Role::Observer, kBen)); // there is none

        const auto after = SessionSecrets::open(m_file, kSession);
        QVERIFY(after->codes() == before->codes());
        QVERIFY(!after->codeKey(Role::Trainee));
        QVERIFY(after->token(Role::Trainee, kAnna) == *fresh);
        QVERIFY(!after->token(Role::Trainee, kBen));
    }

    void whatCannotBeKeptIsNotChanged()
    {
        constexpr ParticipantId kAnna{3};
        auto secrets = SessionSecrets::open(m_file, kSession);
        const JoinCodes codes = secrets->codes();
        const AccessKey key = randomKey();
        QVERIFY(secrets->setCodeKey(Role::Trainee, key));
        const auto token = secrets->issueToken(Role::Trainee, kAnna);
        const QString folder = m_folder->path();
        m_folder.reset();
        QFile inItsPlace{folder};
        QVERIFY(inItsPlace.open(QFile::WriteOnly));
        QCOMPARE(secrets->changeCode(Role::Trainee).error().code, Errc::FileUnwritable);
        QVERIFY(secrets->codes() == codes && secrets->codeKey(Role::Trainee) == key);
        QCOMPARE(secrets->replaceToken(Role::Trainee, kAnna).error().code, Errc::FileUnwritable);
        QVERIFY(secrets->token(Role::Trainee, kAnna) == *token);
        QCOMPARE(secrets->revokeToken(Role::Trainee, kAnna).error().code, Errc::FileUnwritable);
        QVERIFY(!secrets->token(Role::Trainee, kAnna)); // whoever was banned stays out
        QVERIFY(inItsPlace.remove());
    }

    void tokensBelongToOneRoleAndParticipant()
    {
        auto secrets = SessionSecrets::open(m_file, kSession);
        const auto anna = secrets->issueToken(Role::Trainee, ParticipantId{3});
        QVERIFY(secrets->issueToken(Role::Trainee, ParticipantId{4}) != anna);
        QVERIFY(!secrets->token(Role::Instructor, ParticipantId{3}));
        QVERIFY(!secrets->token(Role::Trainee, ParticipantId{5}));
    }

    void onlyTheOwnerMayReadThem()
    {
        QVERIFY(SessionSecrets::open(m_file, kSession));
        const auto owners =
            QFile::ReadOwner | QFile::WriteOwner | QFile::ReadUser | QFile::WriteUser;
        QCOMPARE(QFile::permissions(QString::fromStdString(m_file.string())), owners);
    }

    void thoseOfAnotherSessionAreRefused()
    {
        QVERIFY(SessionSecrets::open(m_file, kSession));
        const auto other = SessionSecrets::open(m_file, std::string(32, '0'));
        QVERIFY(!other);
        QCOMPARE(other.error().code, Errc::FileMalformed);
        QVERIFY(other.error().detail.starts_with(m_file.string()));
    }

    void damagedFilesAreRefused_data()
    {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::newRow("no JSON") << QByteArray{"{"} << QByteArray{};
        QTest::newRow("another schema") << QByteArray{"secrets-1"} << QByteArray{"secrets-9"};
        QTest::newRow("unknown role") << QByteArray{"observer"} << QByteArray{"surgeon"};
        QTest::newRow("a role twice") << QByteArray{"observer"} << QByteArray{"instructor"};
        QTest::newRow("short token") << QByteArray{"\"token\": \""} << QByteArray{"\"token\": \"0"};
        QTest::newRow("nobody's token") << QByteArray{":3\""} << QByteArray{":new\""};
    }
    void damagedFilesAreRefused()
    {
        QFETCH(const QByteArray, from);
        QFETCH(const QByteArray, to);
        QVERIFY(
            SessionSecrets::open(m_file, kSession)->issueToken(Role::Trainee, ParticipantId{3}));
        QFile file{QString::fromStdString(m_file.string())};
        QVERIFY(file.open(QIODevice::ReadWrite));
        QByteArray text = file.readAll();
        QVERIFY(text.contains(from));
        file.resize(0);
        file.seek(0);
        file.write(text.replace(from, to));
        file.close();
        QVERIFY(!SessionSecrets::open(m_file, kSession));
    }

    void withoutADiskThereAreNone()
    {
        QFile blocker{m_folder->filePath(QStringLiteral("file"))};
        QVERIFY(blocker.open(QIODevice::WriteOnly));
        const auto none = SessionSecrets::open(
            m_folder->filePath(QStringLiteral("file/secrets")).toStdString(), kSession);
        QVERIFY(!none);
        QCOMPARE(none.error().code, Errc::FileUnwritable);
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    std::filesystem::path m_file;
};

CARINA_TEST(TestSessionSecrets)

} // namespace carina::session_secrets_test

#include "tst_session_secrets.moc"
