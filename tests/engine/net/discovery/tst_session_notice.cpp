#include "tests/engine/net/discovery/notices.h"
#include "tests/support/test_class.h"

#include <random>

namespace carina::session_notice_test
{

class SessionNoticeTest : public QObject
{
    Q_OBJECT

private:
    static QByteArray bytesOf(const std::vector<std::byte>& bytes)
    {
        return {reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size())};
    }

private Q_SLOTS:
    void questionIsLaidOutAsTheProtocolSays()
    {
        const QByteArray question = bytesOf(encodeQuestion({.nonce = 0x04030201}));
        QCOMPARE(question.size(), 128);
        QCOMPARE(question.left(8), QByteArray::fromHex("4344010101020304"));
        QCOMPARE(question.mid(8), QByteArray(120, '\0'));
        QVERIFY(decodeQuestion(encodeQuestion({.nonce = 0x04030201}))
                == SessionQuestion{.nonce = 0x04030201});
    }

    void questionForOneSessionNamesIt()
    {
        const SessionQuestion asked{9, noticeOf(0xAB).session};
        const QByteArray question = bytesOf(encodeQuestion(asked));
        QCOMPARE(question.mid(8, 16), QByteArray(16, '\xAB'));
        QCOMPARE(question.mid(24), QByteArray(104, '\0'));
        QVERIFY(decodeQuestion(encodeQuestion(asked)) == asked);
    }

    void answerIsLaidOutAsTheProtocolSays()
    {
        const QByteArray answer = bytesOf(encodeAnswer(0x04030201, noticeOf(0xAB, "Ward 3", 258)));
        QCOMPARE(answer, QByteArray::fromHex("4344010201020304") + QByteArray(16, '\xAB')
                             + QByteArray::fromHex("020106") + QByteArray{"Ward 3"});
    }

    void answerComesBackAsItWent()
    {
        for (const std::string& name :
             {std::string{"W"}, std::string{"Übung"}, std::string(64, 'x')}) {
            const SessionNotice notice = noticeOf(7, name, 65535);
            QVERIFY(decodeAnswer(encodeAnswer(9, notice), 9) == notice);
        }
    }

    void noAnswerIsLongerThanItsQuestion()
    {
        QVERIFY(encodeAnswer(1, noticeOf(1, std::string(64, 'x'))).size()
                <= encodeQuestion({.nonce = 1}).size());
    }

    void answerToAnotherQuestionIsNotHeard()
    {
        QVERIFY(!decodeAnswer(encodeAnswer(9, noticeOf(7)), 8));
    }

    void everyCutAndEveryAdditionIsRefused()
    {
        const auto answer = encodeAnswer(9, noticeOf(7));
        for (std::size_t size = 0; size < answer.size(); ++size)
            QVERIFY(!decodeAnswer(std::span{answer}.first(size), 9));
        auto longer = answer;
        longer.push_back({});
        QVERIFY(!decodeAnswer(longer, 9));
        auto question = encodeQuestion({.nonce = 9});
        QVERIFY(!decodeQuestion(std::span{question}.first(127)));
        question.push_back({});
        QVERIFY(!decodeQuestion(question));
    }

    void everyBrokenRuleIsRefused_data()
    {
        QTest::addColumn<int>("at");
        QTest::addColumn<int>("value");
        QTest::newRow("magic") << 0 << int{'c'};
        QTest::newRow("second letter of it") << 1 << int{'A'};
        QTest::newRow("a later version") << 2 << 2;
        QTest::newRow("a question") << 3 << 1;
        QTest::newRow("no name") << 26 << 0;
        QTest::newRow("a name that is not there") << 26 << 7;
        QTest::newRow("no UTF-8") << 27 << 0xFF;
    }

    void everyBrokenRuleIsRefused()
    {
        QFETCH(const int, at);
        QFETCH(const int, value);
        auto answer = encodeAnswer(9, noticeOf(7));
        answer[static_cast<std::size_t>(at)] = static_cast<std::byte>(value);
        QVERIFY(!decodeAnswer(answer, 9));
        QVERIFY(!decodeQuestion(answer));
    }

    void sessionWithoutAPortIsRefused()
    {
        auto answer = encodeAnswer(9, noticeOf(7, "Ward 3", 1));
        answer[24] = {};
        QVERIFY(!decodeAnswer(answer, 9));
    }

    void nameThatIsTooLongIsRefused()
    {
        auto answer = encodeAnswer(9, noticeOf(7, std::string(64, 'x')));
        answer[26] = std::byte{65};
        answer.push_back(std::byte{'x'});
        QVERIFY(!decodeAnswer(answer, 9));
    }

    void whateverComesIsSurvived()
    {
        std::mt19937 random{1};
        const auto answer = encodeAnswer(9, noticeOf(7));
        for (int i = 0; i < 100'000; ++i) {
            auto bytes = answer;
            for (unsigned flips = 1 + random() % 4; flips > 0; --flips)
                bytes[random() % bytes.size()] = static_cast<std::byte>(random());
            bytes.resize(random() % (bytes.size() + 40));
            const auto notice = decodeAnswer(bytes, 9);
            QVERIFY(!notice || (notice->port != 0 && notice->name.size() <= 64));
            QVERIFY(!decodeQuestion(bytes) || bytes.size() == 128);
        }
    }
};

CARINA_TEST(SessionNoticeTest)

} // namespace carina::session_notice_test

#include "tst_session_notice.moc"
