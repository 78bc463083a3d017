#include "engine/io/files/whole_file.h"
#include "engine/net/entry/token_folder.h"
#include "engine/net/entry/token_message.h"
#include "tests/support/test_class.h"

#include <QDir>
#include <QTemporaryDir>

namespace carina::token_folder_test
{
namespace
{

constexpr const char* kSession = "00112233445566778899aabbccddeeff";

} // namespace

class TestTokenFolder : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tokensOutliveAProgram()
    {
        const QTemporaryDir folder;
        const std::filesystem::path tokens =
            folder.filePath(QStringLiteral("tokens")).toStdString();
        const TokenFolder::Token token{ParticipantId{513}, randomKey()};
        QVERIFY(TokenFolder(tokens, Role::Trainee, "Anna/..").keep(kSession, token));
        const auto found = TokenFolder(tokens, Role::Trainee, "Anna/..").find(kSession);
        QVERIFY(found);
        QCOMPARE(found->participant, token.participant);
        QVERIFY(found->key == token.key);

        QVERIFY(!TokenFolder(tokens, Role::Observer, "Anna/..").find(kSession));
        QVERIFY(!TokenFolder(tokens, Role::Trainee, "Ben").find(kSession));
        QVERIFY(!TokenFolder(tokens, Role::Trainee, "Anna/..").find(std::string(32, '0')));
        const QFileInfoList files =
            QDir{QString::fromStdString(tokens.string())}.entryInfoList(QDir::Files);
        QCOMPARE(files.size(), 1);
        QCOMPARE(files[0].permissions() & (QFile::ReadGroup | QFile::ReadOther),
                 QFile::Permissions{});
        QVERIFY(std::filesystem::status(tokens).permissions() == std::filesystem::perms::owner_all);
    }

    /// As an earlier version left it.
    void folderThatOthersMayOpenIsClosedToThem()
    {
        const QTemporaryDir folder;
        const std::filesystem::path tokens =
            folder.filePath(QStringLiteral("tokens")).toStdString();
        std::filesystem::create_directory(tokens);
        std::filesystem::permissions(tokens, std::filesystem::perms{0755});
        QVERIFY(TokenFolder(tokens, Role::Trainee, "Anna").keep(kSession, {}));
        QVERIFY(std::filesystem::status(tokens).permissions() == std::filesystem::perms::owner_all);
    }

    void knowsWhetherOneWasKeptForARoleAndAName()
    {
        const QTemporaryDir folder;
        const std::filesystem::path tokens =
            folder.filePath(QStringLiteral("tokens")).toStdString();
        TokenFolder anna{tokens, Role::Trainee, "Anna"};
        QVERIFY(!anna.hasAny());
        QVERIFY(anna.keep(kSession, {}));
        QVERIFY(TokenFolder(tokens, Role::Trainee, "Anna").hasAny());
        QVERIFY(!TokenFolder(tokens, Role::Observer, "Anna").hasAny());
        QVERIFY(!TokenFolder(tokens, Role::Trainee, "Ben").hasAny());
        QVERIFY(!TokenFolder({}, Role::Trainee, "Anna").hasAny());
    }

    void knowsTheLastSessionOfARoleAndAName()
    {
        const QTemporaryDir folder;
        const std::filesystem::path tokens =
            folder.filePath(QStringLiteral("tokens")).toStdString();
        const TokenFolder::Visit visit{kSession, "2001:db8::1", 45001};
        TokenFolder anna{tokens, Role::Trainee, "Anna"};
        QVERIFY(!anna.lastVisit());
        QVERIFY(anna.keepVisit(visit));
        QVERIFY(!anna.lastVisit()); // there is no way back into it
        QVERIFY(!anna.hasAny());
        QVERIFY(anna.keep(kSession, {}));
        const TokenFolder again{tokens, Role::Trainee, "Anna"};
        QVERIFY(again.lastVisit() == visit);
        QVERIFY(!TokenFolder(tokens, Role::Observer, "Anna").lastVisit());
        QVERIFY(!TokenFolder(tokens, Role::Trainee, "Ben").lastVisit());
        const std::string other(32, '0');
        QVERIFY(anna.keep(other, {}));
        QVERIFY(anna.keepVisit({other, "127.0.0.1", 1}));
        QVERIFY(again.lastVisit() == (TokenFolder::Visit{other, "127.0.0.1", 1}));
        TokenFolder homeless{{}, Role::Trainee, "Anna"};
        QVERIFY(homeless.keepVisit(visit) && !homeless.lastVisit());
    }

    void damagedVisitsAreNone_data()
    {
        QTest::addColumn<QByteArray>("text");
        const QByteArray session{kSession};
        QTest::newRow("nothing") << QByteArray{};
        QTest::newRow("no place") << session;
        QTest::newRow("no port") << session + " 127.0.0.1";
        QTest::newRow("a word as port") << session + " 127.0.0.1 port";
        QTest::newRow("too large a port") << session + " 127.0.0.1 65536";
        QTest::newRow("more behind the port") << session + " 127.0.0.1 1x";
        QTest::newRow("no session") << QByteArray{"Ward 127.0.0.1 1"};
    }
    void damagedVisitsAreNone()
    {
        QFETCH(const QByteArray, text);
        const QTemporaryDir folder;
        TokenFolder anna{folder.path().toStdString(), Role::Trainee, "Anna"};
        QVERIFY(anna.keep(kSession, {}));
        QVERIFY(anna.keepVisit({kSession, "127.0.0.1", 1}));
        const QStringList files =
            QDir{folder.path()}.entryList({QStringLiteral("*.visit")}, QDir::Files);
        QCOMPARE(files.size(), 1);
        QVERIFY(writeWholeFile(folder.filePath(files[0]).toStdString(), text.toStdString()));
        QVERIFY(!anna.lastVisit());
    }

    void damagedTokensAreNone_data()
    {
        QTest::addColumn<QByteArray>("text");
        const QByteArray key(64, 'a');
        QTest::newRow("no number") << QByteArray{" " + key};
        QTest::newRow("too large a number") << QByteArray{"65536 " + key};
        QTest::newRow("no key") << QByteArray{"3"};
        QTest::newRow("no blank") << QByteArray{"3:" + key};
        QTest::newRow("short key") << QByteArray{"3 " + key.chopped(1)};
    }
    void damagedTokensAreNone()
    {
        QFETCH(const QByteArray, text);
        const QTemporaryDir folder;
        const std::filesystem::path tokens = folder.path().toStdString();
        QVERIFY(TokenFolder(tokens, Role::Trainee, "Anna").keep(kSession, {}));
        const QString file =
            QDir{folder.path()}.entryInfoList(QDir::Files).at(0).absoluteFilePath();
        QVERIFY(writeWholeFile(file.toStdString(), text.toStdString()));
        QVERIFY(!TokenFolder(tokens, Role::Trainee, "Anna").find(kSession));
    }

    void withoutAFolderTheyAreRemembered()
    {
        TokenFolder tokens{{}, Role::Trainee, "Anna"};
        QVERIFY(!tokens.find(kSession));
        QVERIFY(tokens.keep(kSession, {ParticipantId{2}, randomKey()}));
        QCOMPARE(tokens.find(kSession)->participant, ParticipantId{2});
        QVERIFY(tokens.hasAny());
    }

    void messagesAreLaidOutAsTheProtocolSays()
    {
        const std::vector<std::byte> request{std::byte{'C'}, std::byte{'T'}, std::byte{1},
                                             std::byte{1}};
        QVERIFY(encodeTokenRequest() == request);
        QVERIFY(isTokenRequest(request));

        TokenFolder::Token token{ParticipantId{0x0102}, {}};
        token.key.fill(std::byte{9});
        std::vector<std::byte> answer{std::byte{'C'}, std::byte{'T'}, std::byte{1},
                                      std::byte{2},   std::byte{2},   std::byte{1}};
        answer.insert(answer.end(), 32, std::byte{9});
        QVERIFY(encodeToken(token) == answer);
        QCOMPARE(decodeToken(answer)->participant, token.participant);
        QVERIFY(decodeToken(answer)->key == token.key);
        QVERIFY(!isTokenRequest(answer));
        QVERIFY(!decodeToken(request));
        answer.push_back({});
        QVERIFY(!decodeToken(answer));
        answer.resize(38);
        answer[3] = std::byte{3};
        QVERIFY(!decodeToken(answer));
    }
};

CARINA_TEST(TestTokenFolder)

} // namespace carina::token_folder_test

#include "tst_token_folder.moc"
