#include "engine/sync/loss_meter.h"

#include <QTest>

#include <limits>

namespace carina
{

class TestLossMeter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingIsLostBeforeAnythingCame() { QCOMPARE(LossMeter{}.share(), 0.0); }

    void firstNumberIsTheFirstExpected()
    {
        LossMeter meter;
        meter.add(1000);
        QCOMPARE(meter.share(), 0.0);
    }

    void countsWhatIsMissing()
    {
        LossMeter meter;
        for (const std::uint32_t sequence : {1U, 2U, 4U, 5U, 8U})
            meter.add(sequence); // 3, 6 and 7 are missing of 8
        QCOMPARE(meter.share(), 0.375);
    }

    void lateOnesHaveArrived()
    {
        LossMeter meter;
        for (const std::uint32_t sequence : {1U, 4U, 2U, 3U})
            meter.add(sequence);
        QCOMPARE(meter.share(), 0.0);
    }

    void doublesCountOnce()
    {
        LossMeter meter;
        for (const std::uint32_t sequence : {1U, 1U, 2U, 4U, 4U, 2U})
            meter.add(sequence);
        QCOMPARE(meter.share(), 0.25);
    }

    void whatIsFromBeforeTheFirstIsNotCounted()
    {
        LossMeter meter;
        for (const std::uint32_t sequence : {10U, 9U, 12U})
            meter.add(sequence);
        QCOMPARE(meter.share(), 1.0 / 3.0);
    }

    void oldLossesAreForgotten()
    {
        LossMeter meter;
        meter.add(1);
        meter.add(3); // 2 is lost
        for (std::uint32_t sequence = 4; sequence <= 2 + LossMeter::kWindow - 1; ++sequence)
            meter.add(sequence);
        QCOMPARE(meter.share(), 1.0 / LossMeter::kWindow); // 2 is the oldest of the window
        meter.add(2 + LossMeter::kWindow);
        QCOMPARE(meter.share(), 0.0);
    }

    void oneBehindTheWindowIsNotCounted()
    {
        LossMeter meter;
        meter.add(1);
        meter.add(2 + LossMeter::kWindow); // the window begins at 3
        const double share = meter.share();
        meter.add(2);
        QCOMPARE(meter.share(), share);
        meter.add(3);
        QCOMPARE(meter.share(), share - 1.0 / LossMeter::kWindow);
    }

    void longSilenceIsAllLost()
    {
        LossMeter meter;
        for (std::uint32_t sequence = 1; sequence <= LossMeter::kWindow; ++sequence)
            meter.add(sequence);
        meter.add(1'000'000);
        QCOMPARE(meter.share(), 1.0 - 1.0 / LossMeter::kWindow);
    }

    void numbersMayWrap()
    {
        LossMeter meter;
        meter.add(std::numeric_limits<std::uint32_t>::max());
        meter.add(1); // 0 is lost
        QCOMPARE(meter.share(), 1.0 / 3.0);
        meter.add(0);
        QCOMPARE(meter.share(), 0.0);
    }
};

} // namespace carina

QTEST_GUILESS_MAIN(carina::TestLossMeter)
#include "tst_loss_meter.moc"
