#include "engine/net/entry/access_key.h"
#include "engine/net/entry/join_code.h"
#include "tests/support/test_class.h"

#include <set>

namespace carina::join_code_test
{

class TestJoinCode : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isReadHoweverItIsTyped_data()
    {
        QTest::addColumn<QByteArray>("typed");
        QTest::newRow("as shown") << QByteArray{"7KQ2M-X4TN9"};
        QTest::newRow("lower case without dash") << QByteArray{"7kq2mx4tn9"};
        QTest::newRow("blanks") << QByteArray{" 7KQ2M X4TN9 "};
        QTest::newRow("dashes elsewhere") << QByteArray{"7K-Q2-MX-4T-N9"};
    }
    void isReadHoweverItIsTyped()
    {
        QFETCH(const QByteArray, typed);
        const auto code = JoinCode::parse(typed.toStdString());
        QVERIFY(code);
        QCOMPARE(code->characters(), std::string{"7KQ2MX4TN9"});
        QCOMPARE(code->text(), std::string{"7KQ2M-X4TN9"});
    }

    void takesLookalikesForWhatIsMeant()
    {
        QVERIFY(JoinCode::parse("oOiIlL-00000") == JoinCode::parse("001111-0000 0"));
    }

    void anythingElseIsNoCode_data()
    {
        QTest::addColumn<QByteArray>("typed");
        QTest::newRow("nothing") << QByteArray{};
        QTest::newRow("nine") << QByteArray{"7KQ2M-X4TN"};
        QTest::newRow("eleven") << QByteArray{"7KQ2M-X4TN99"};
        QTest::newRow("a U") << QByteArray{"UKQ2M-X4TN9"};
        QTest::newRow("another sign") << QByteArray{"7KQ2M_X4TN9"};
        QTest::newRow("beyond ASCII") << QByteArray{"7KQ2M-X4TN\xC3"};
    }
    void anythingElseIsNoCode()
    {
        QFETCH(const QByteArray, typed);
        const auto code = JoinCode::parse(typed.toStdString());
        QVERIFY(!code);
        QCOMPARE(code.error().code, Errc::WrongCode);
    }

    void codesAreDrawnFromAllOfTheAlphabet()
    {
        std::set<std::string> codes;
        std::set<char> characters;
        for (int i = 0; i < 400; ++i) {
            const JoinCode code = JoinCode::random();
            QVERIFY(JoinCode::parse(code.text()) == code);
            codes.insert(code.text());
            characters.insert(code.characters().begin(), code.characters().end());
        }
        QCOMPARE(codes.size(), std::size_t{400});
        QCOMPARE(characters.size(), std::size_t{32});
        for (const char lookalike : {'I', 'L', 'O', 'U'})
            QVERIFY(!characters.contains(lookalike));
    }

    void keyIsWhatTheReferenceMakesOfIt()
    {
        // echo -n 7KQ2MX4TN9 | argon2 0123456789abcdef -id -t 3 -k 262144 -p 1 -l 32 -r
        constexpr auto kTruth = "640b844712f92331e398b7ef67e71afe0859d8225d175bf8f613ec63253324c8";
        SessionKey session{};
        for (std::size_t i = 0; i < session.size(); ++i)
            session[i] = static_cast<std::byte>("0123456789abcdef"[i]);
        const auto key = deriveByArgon2id(*JoinCode::parse("7KQ2M-X4TN9"), session);
        QVERIFY(key);
        QCOMPARE(toHex(*key), std::string{kTruth});
        QVERIFY(keyFromHex(kTruth) == *key);
    }

    void onlySixtyFourDigitsAreAKey()
    {
        const std::string hex = toHex(randomKey());
        QVERIFY(keyFromHex(hex));
        QVERIFY(!keyFromHex(hex.substr(1)));
        QVERIFY(!keyFromHex(hex + "0"));
        std::string other = hex;
        other[0] = 'g';
        QVERIFY(!keyFromHex(other));
        QVERIFY(randomKey() != randomKey());
    }
};

CARINA_TEST(TestJoinCode)

} // namespace carina::join_code_test

#include "tst_join_code.moc"
