#include "engine/net/entry/psk_identity.h"
#include "tests/support/test_class.h"

namespace carina::psk_identity_test
{
namespace
{

constexpr const char* kSession = "00112233445566778899aabbccddeeff";

} // namespace

class TestPskIdentity : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isWrittenAndRead()
    {
        const PskIdentity anna{{Role::Trainee, ParticipantId{7}}, kSession};
        QCOMPARE(toText(anna), std::string{"trainee:"} + kSession + ":7");
        const PskIdentity somebody{{Role::Observer, std::nullopt}, kSession};
        QCOMPARE(toText(somebody), std::string{"observer:"} + kSession + ":new");
        const PskIdentity host{{Role::Instructor, ParticipantId{0}}, kSession};
        for (const PskIdentity& identity : {anna, somebody, host})
            QVERIFY(pskIdentity(toText(identity)) == identity);
    }

    void hasOneSpellingOnly_data()
    {
        QTest::addColumn<QByteArray>("text");
        const QByteArray session{kSession};
        QTest::newRow("nothing") << QByteArray{};
        QTest::newRow("no colon") << QByteArray{"trainee"};
        QTest::newRow("one colon") << QByteArray{"trainee:" + session};
        QTest::newRow("another role") << QByteArray{"surgeon:" + session + ":1"};
        QTest::newRow("upper case") << QByteArray{"Trainee:" + session + ":1"};
        QTest::newRow("short session") << QByteArray{"trainee:0011:1"};
        QTest::newRow("session in upper case") << QByteArray{"trainee:" + session.toUpper() + ":1"};
        QTest::newRow("leading zero") << QByteArray{"trainee:" + session + ":01"};
        QTest::newRow("a number too large") << QByteArray{"trainee:" + session + ":65536"};
        QTest::newRow("more after it") << QByteArray{"trainee:" + session + ":1:"};
        QTest::newRow("nobody's number") << QByteArray{"trainee:" + session + ":"};
    }
    void hasOneSpellingOnly()
    {
        QFETCH(const QByteArray, text);
        QVERIFY(!pskIdentity(text.toStdString()));
    }
};

CARINA_TEST(TestPskIdentity)

} // namespace carina::psk_identity_test

#include "tst_psk_identity.moc"
