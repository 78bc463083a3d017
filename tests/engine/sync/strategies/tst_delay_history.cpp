#include "engine/sync/strategies/delay_history.h"
#include "tests/support/test_class.h"

namespace carina::delay_history_test
{
namespace
{

using namespace std::chrono_literals;

} // namespace

class TestDelayHistory : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void meanAndSigmaAreThePopulations()
    {
        // The textbook set: mean 5, sigma 2 (of a sample it would be 2.138).
        DelayHistory history;
        for (const int ms : {2, 4, 4, 4, 5, 5, 7, 9})
            history.add(ms * 1ms);
        QCOMPARE(history.mean(), Duration{5ms});
        QCOMPARE(history.sigma(), Duration{2ms});
        QCOMPARE(history.delays().back(), Duration{9ms});
        QCOMPARE(history.size(), 8U);
    }

    void holdsTheLastHundred()
    {
        DelayHistory history;
        history.add(1s);
        for (int i = 1; i < 100; ++i) {
            QVERIFY(!history.isFull());
            history.add(3ms);
        }
        QVERIFY(history.isFull());
        QCOMPARE(history.mean(), Duration{1s + 99 * 3ms} / 100);
        history.add(3ms);
        QVERIFY(history.isFull());
        QCOMPARE(history.mean(), Duration{3ms});
        QCOMPARE(history.size(), 100U);
    }

    void equalDelaysHaveNoSigma()
    {
        DelayHistory history;
        for (int i = 0; i < 99; ++i)
            history.add(Duration{20'000'001});
        QCOMPARE(history.sigma(), Duration{});
    }

    void isEmptyOnceCleared()
    {
        DelayHistory history;
        history.add(1ms);
        history.clear();
        QCOMPARE(history.size(), 0U);
    }
};

CARINA_TEST(TestDelayHistory)

} // namespace carina::delay_history_test

#include "tst_delay_history.moc"
