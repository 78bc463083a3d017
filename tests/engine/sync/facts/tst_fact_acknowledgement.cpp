#include "engine/sync/facts/fact_acknowledgement.h"
#include "engine/sync/facts/fact_replication.h"
#include "tests/support/test_class.h"

namespace carina::fact_acknowledgement_test
{
namespace
{

using namespace std::chrono_literals;

constexpr LocalTime kStart{10s};

} // namespace

class TestFactAcknowledgement : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingIsOwedAtFirst()
    {
        const FactAcknowledgement none;
        QVERIFY(!none.isOwed());
        QCOMPARE(none.due(), LocalTime::max());
    }

    void aFactInItsTurnWaits()
    {
        FactAcknowledgement owed;
        owed.arrived(1, kStart);
        QVERIFY(owed.isOwed());
        QCOMPARE(owed.due(), kStart + 25ms);
        // Later ones do not put it off.
        owed.arrived(1, kStart + 20ms);
        QCOMPARE(owed.due(), kStart + 25ms);
        owed.given();
        QVERIFY(!owed.isOwed());
        owed.arrived(1, kStart + 30ms);
        QCOMPARE(owed.due(), kStart + 55ms);
    }

    void manyDoNotWait()
    {
        FactAcknowledgement owed;
        for (int i = 1; i < 8; ++i)
            owed.arrived(1, kStart);
        QCOMPARE(owed.due(), kStart + 25ms);
        owed.arrived(1, kStart + 1ms);
        QCOMPARE(owed.due(), kStart + 1ms);
        owed.given();
        owed.arrived(1, kStart + 2ms); // counted anew
        QCOMPARE(owed.due(), kStart + 27ms);
    }

    void whatTellsOfALossDoesNotWait_data()
    {
        QTest::addColumn<std::size_t>("next");
        QTest::newRow("a repeat, or one that came early") << std::size_t{0};
        QTest::newRow("one that fills a gap") << std::size_t{3};
    }
    void whatTellsOfALossDoesNotWait()
    {
        QFETCH(std::size_t, next);
        FactAcknowledgement owed;
        owed.arrived(1, kStart);
        owed.arrived(next, kStart + 5ms);
        QCOMPARE(owed.due(), kStart + 5ms);
    }

    /// Else each would be sent twice.
    void comesBeforeTheHostRepeats()
    {
        FactSender host{FactNumber{}};
        FactRecord fact;
        fact.number = FactNumber{1};
        const std::vector<FactRecord> log{fact};
        QCOMPARE(host.takeDue(log, 0ms, kStart).size(), std::size_t{1});
        FactAcknowledgement owed;
        owed.arrived(1, kStart);
        QVERIFY(host.takeDue(log, 0ms, owed.due()).empty());
        QVERIFY(host.nextDue(FactNumber{1}) > owed.due());
    }
};

CARINA_TEST(TestFactAcknowledgement)

} // namespace carina::fact_acknowledgement_test

#include "tst_fact_acknowledgement.moc"
