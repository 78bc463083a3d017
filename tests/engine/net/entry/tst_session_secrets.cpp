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
        before->setCodeKey(Role::Observer, key);
        const AccessKey token = before->newToken(Role::Trainee, ParticipantId{3});
        QVERIFY(!SessionSecrets::open(m_file, kSession)->codeKey(Role::Observer)); // until written
        QVERIFY(before->write());

        const auto after = SessionSecrets::open(m_file, kSession);
        QVERIFY(after);
        QVERIFY(after->codes() == before->codes());
        QVERIFY(after->codeKey(Role::Observer) == key);
        QVERIFY(!after->codeKey(Role::Trainee));
        QVERIFY(after->token(Role::Trainee, ParticipantId{3}) == token);
    }

    void changedCodeAndTokensOutliveAProgram()
    {
        constexpr ParticipantId kAnna{3};
        constexpr ParticipantId kBen{4};
        auto before = SessionSecrets::open(m_file, kSession);
        const JoinCodes old = before->codes();
        before->setCodeKey(Role::Trainee, randomKey());
        const AccessKey annas = before->newToken(Role::Trainee, kAnna);
        before->newToken(Role::Trainee, kBen);
        before->changeCode(Role::Trainee);
        QVERIFY(before->codes().at(Role::Trainee) != old.at(Role::Trainee));
        QVERIFY(before->codes().at(Role::Observer) == old.at(Role::Observer));
        QVERIFY(!before->codeKey(Role::Trainee));
        const AccessKey fresh = before->newToken(Role::Trainee, kAnna);
        QVERIFY(fresh != annas);
        before->revokeToken(Role::Trainee, kBen);
        before->revokeToken(Role::Observer, kBen); // there is none
        QVERIFY(before->write());

        const auto after = SessionSecrets::open(m_file, kSession);
        QVERIFY(after->codes() == before->codes());
        QVERIFY(!after->codeKey(Role::Trainee));
        QVERIFY(after->token(Role::Trainee, kAnna) == fresh);
        QVERIFY(!after->token(Role::Trainee, kBen));
    }

    void whatCannotBeWrittenIsUndone()
    {
        constexpr ParticipantId kAnna{3};
        constexpr ParticipantId kBen{4};
        auto secrets = SessionSecrets::open(m_file, kSession);
        const AccessKey trainees = randomKey();
        secrets->setCodeKey(Role::Trainee, trainees);
        const AccessKey annas = secrets->newToken(Role::Trainee, kAnna);
        const SessionSecrets stored = *secrets;
        secrets->changeCode(Role::Trainee);
        secrets->setCodeKey(Role::Trainee, randomKey());
        const AccessKey observers = randomKey();
        secrets->setCodeKey(Role::Observer, observers);
        secrets->revokeToken(Role::Trainee, kAnna);
        secrets->newToken(Role::Trainee, kBen);
        const QString folder = m_folder->path();
        m_folder.reset();
        QFile inItsPlace{folder};
        QVERIFY(inItsPlace.open(QFile::WriteOnly));
        QCOMPARE(secrets->write().error().code, Errc::FileUnwritable);
        secrets->revertTo(stored);
        QVERIFY(secrets->codes() == stored.codes());
        QVERIFY(secrets->codeKey(Role::Trainee) == trainees);
        QVERIFY(secrets->codeKey(Role::Observer) == observers); // which took a second
        QVERIFY(secrets->token(Role::Trainee, kAnna) == annas);
        QVERIFY(!secrets->token(Role::Trainee, kBen));
        QVERIFY(inItsPlace.remove());
    }

    void tokensBelongToOneRoleAndParticipant()
    {
        auto secrets = SessionSecrets::open(m_file, kSession);
        const AccessKey anna = secrets->newToken(Role::Trainee, ParticipantId{3});
        QVERIFY(secrets->newToken(Role::Trainee, ParticipantId{4}) != anna);
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
        auto secrets = SessionSecrets::open(m_file, kSession);
        secrets->newToken(Role::Trainee, ParticipantId{3});
        QVERIFY(secrets->write());
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
