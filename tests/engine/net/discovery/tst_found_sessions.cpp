#include "engine/net/discovery/found_sessions.h"
#include "tests/engine/net/discovery/notices.h"
#include "tests/support/test_class.h"

namespace carina::found_sessions_test
{

class FoundSessionsTest : public QObject
{
    Q_OBJECT

private:
    static constexpr LocalTime kNow{std::chrono::seconds{100}};

private Q_SLOTS:
    void listsWhatItHeardByName()
    {
        FoundSessions found;
        QVERIFY(found.heard({noticeOf(1, "Ward"), "192.0.2.1"}, kNow));
        QVERIFY(found.heard({noticeOf(2, "Airway"), "192.0.2.2"}, kNow));
        const auto list = found.list();
        QCOMPARE(list.size(), std::size_t{2});
        QCOMPARE(list[0].notice.name, std::string{"Airway"});
        QCOMPARE(list[1].notice.name, std::string{"Ward"});
    }

    void repeatsAreNoNews()
    {
        FoundSessions found;
        QVERIFY(found.heard({noticeOf(1), "192.0.2.1"}, kNow));
        QVERIFY(!found.heard({noticeOf(1), "192.0.2.1"}, kNow));
        QVERIFY(found.heard({noticeOf(1, "Ward 4"), "192.0.2.1"}, kNow));
        QCOMPARE(found.list().size(), std::size_t{1});
        QCOMPARE(found.list()[0].notice.name, std::string{"Ward 4"});
    }

    void sessionOfThisComputerIsListedOnceAndByItsOwnAddress()
    {
        FoundSessions found;
        found.heard({noticeOf(1), "192.0.2.1"}, kNow);
        QVERIFY(!found.heard({noticeOf(1), "192.0.2.2"}, kNow));
        QCOMPARE(found.list()[0].address, std::string{"192.0.2.1"});
        QVERIFY(found.heard({noticeOf(1), "127.0.0.1"}, kNow));
        QVERIFY(!found.heard({noticeOf(1), "192.0.2.1"}, kNow));
        QCOMPARE(found.list().size(), std::size_t{1});
        QCOMPARE(found.list()[0].address, std::string{"127.0.0.1"});
    }

    void forgetsWhoDoesNotAnswerAnyMore()
    {
        FoundSessions found;
        found.heard({noticeOf(1), "192.0.2.1"}, kNow);
        found.heard({noticeOf(2), "192.0.2.2"}, kNow);
        const LocalTime later = kNow + FoundSessions::kForgottenAfter;
        found.heard({noticeOf(2), "192.0.2.2"}, later);
        QVERIFY(!found.forget(later - Duration{1}));
        QVERIFY(found.forget(later));
        QCOMPARE(found.list().size(), std::size_t{1});
        QCOMPARE(found.list()[0].address, std::string{"192.0.2.2"});
    }

    void otherAddressDoesNotKeepAGoneHostAlive()
    {
        FoundSessions found;
        found.heard({noticeOf(1), "192.0.2.1"}, kNow);
        const LocalTime later = kNow + FoundSessions::kForgottenAfter;
        found.heard({noticeOf(1), "192.0.2.2"}, later);
        QVERIFY(found.forget(later));
        QVERIFY(found.heard({noticeOf(1), "192.0.2.2"}, later));
    }

    void neverHoldsMoreThanItsLimit()
    {
        FoundSessions found;
        for (int i = 0; i < 200; ++i)
            found.heard({noticeOf(static_cast<std::uint8_t>(i)), "192.0.2.1"}, kNow);
        QCOMPARE(found.list().size(), FoundSessions::kMost);
    }
};

CARINA_TEST(FoundSessionsTest)

} // namespace carina::found_sessions_test

#include "tst_found_sessions.moc"
