#include "tests/engine/physiology/bed.h"
#include "tests/support/test_class.h"

namespace carina::airway_reflexes_test
{

namespace
{

using test::Bed;

void insertBlade(Bed& bed)
{
    bed.care.bladeInMouth = true;
    bed.apply();
    bed.run(10.0);
}

} // namespace

/// What a patient does against blade and tube.
class TestAirwayReflexes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sleepsQuietlyWithoutStimulus();
    void coughsAwake();
    void toleratesABladeInDeepSleep();
    void shutsTheCordsInLightSleep();
    void doesNothingWhenRelaxed();
    void swallowsUnlessRelaxedOrDeeplyAsleep();
    void coughsAgainstATubeAsItWakes();
    void stopsBreathingAfterInduction();
};

void TestAirwayReflexes::sleepsQuietlyWithoutStimulus()
{
    Bed bed{test::kLeanAdult};
    bed.body.give({DrugKind::Propofol, 80.0});
    for (int i = 0; i < 60; ++i) {
        bed.run(5.0);
        QVERIFY(!bed.body.coughs());
        QCOMPARE(bed.body.spasm(), 0.0);
    }
}

void TestAirwayReflexes::coughsAwake()
{
    Bed bed{test::kLeanAdult};
    insertBlade(bed);
    QVERIFY(bed.body.coughs());
    QVERIFY(bed.body.spasm() < 0.05);
}

void TestAirwayReflexes::toleratesABladeInDeepSleep()
{
    Bed bed{test::kLeanAdult};
    bed.holdMask(1.0);
    bed.body.give({DrugKind::Fentanyl, 0.15});
    bed.run(120.0);
    bed.body.give({DrugKind::Propofol, 190.0});
    bed.run(75.0);
    insertBlade(bed);
    QVERIFY(!bed.body.coughs());
    QVERIFY2(bed.body.spasm() < 0.1, qPrintable(QString::number(bed.body.spasm())));
}

// Too little propofol and no relaxant.
void TestAirwayReflexes::shutsTheCordsInLightSleep()
{
    Bed bed{test::kLeanAdult};
    bed.holdMask(1.0);
    bed.body.give({DrugKind::Propofol, 75.0});
    bed.run(75.0);
    insertBlade(bed);
    QVERIFY2(bed.body.spasm() > 0.5, qPrintable(QString::number(bed.body.spasm())));
    QVERIFY(bed.body.coughs());
    bed.body.give({DrugKind::Suxamethonium, 77.0});
    bed.run(75.0);
    QVERIFY2(bed.body.spasm() < 0.1, qPrintable(QString::number(bed.body.spasm())));
    QVERIFY(!bed.body.coughs());
}

void TestAirwayReflexes::doesNothingWhenRelaxed()
{
    Bed bed{test::kTwelve};
    bed.holdMask(1.0);
    bed.body.give({DrugKind::Propofol, 80.0});
    bed.body.give({DrugKind::Rocuronium, 48.0});
    bed.run(75.0);
    insertBlade(bed);
    QVERIFY(!bed.body.coughs());
    QVERIFY(bed.body.spasm() < 0.01);
    QVERIFY(bed.body.tone() < 0.01);
    QCOMPARE(bed.body.breathingLeft(), 0.0);
}

// All of a swallow without drugs and in light sleep.
void TestAirwayReflexes::swallowsUnlessRelaxedOrDeeplyAsleep()
{
    Bed awake{test::kLeanAdult};
    awake.run(1.0);
    QCOMPARE(awake.body.swallowingLeft(), 1.0);
    Bed light{test::kLeanAdult};
    light.body.give({DrugKind::Propofol, 60.0});
    light.run(60.0);
    QVERIFY(light.body.isAnaesthetised());
    QVERIFY2(light.body.swallowingLeft() > 0.9,
             qPrintable(QString::number(light.body.swallowingLeft())));
    Bed deep{test::kLeanAdult};
    deep.body.give({DrugKind::Propofol, 190.0});
    deep.run(75.0);
    QVERIFY2(deep.body.swallowingLeft() < 0.05,
             qPrintable(QString::number(deep.body.swallowingLeft())));
    Bed relaxed{test::kLeanAdult};
    relaxed.body.give({DrugKind::Suxamethonium, 77.0});
    relaxed.run(75.0);
    QVERIFY2(relaxed.body.swallowingLeft() < 0.05,
             qPrintable(QString::number(relaxed.body.swallowingLeft())));
}

void TestAirwayReflexes::coughsAgainstATubeAsItWakes()
{
    Bed bed{test::kLeanAdult};
    bed.body.give({DrugKind::Propofol, 190.0});
    bed.body.give({DrugKind::Suxamethonium, 77.0});
    bed.stopBreathing();
    bed.intubate(TubeSeat::Trachea, 1.0);
    bed.squeezeBag(12.0, 500.0);
    bed.run(90.0);
    QVERIFY(!bed.body.coughs());
    const double wakes_s = bed.runWhile(1800.0, [&] { return !bed.body.coughs(); });
    QVERIFY2(wakes_s > 120.0 && wakes_s < 1200.0, qPrintable(QString::number(wakes_s)));
    QCOMPARE(bed.body.spasm(), 0.0); // the tube is between the cords
}

// The share that is left stops the mechanics, and gives the breath back later.
void TestAirwayReflexes::stopsBreathingAfterInduction()
{
    Bed bed{test::kLeanAdult};
    bed.holdMask(1.0);
    bed.run(180.0);
    bed.body.give({DrugKind::Propofol, 154.0});
    bed.body.give({DrugKind::Suxamethonium, 77.0});
    const auto follow = [&] {
        if (bed.lungs.ownBreathing != bed.body.breathingLeft()
            && bed.body.state().steps % 25 == 0) {
            bed.lungs.ownBreathing = bed.body.breathingLeft();
            bed.apply();
        }
        return true;
    };
    bed.runWhile(90.0, follow);
    QVERIFY(bed.breathing.isStill());
    bed.runWhile(600.0, follow);
    QVERIFY(!bed.breathing.isStill());
    QVERIFY2(bed.body.breathingLeft() > 0.6, qPrintable(QString::number(bed.body.breathingLeft())));
    QVERIFY(bed.breathing.lastBreath().tidalVolume > 0.5 * bed.lungs.pattern.tidalVolume);
}

CARINA_TEST(TestAirwayReflexes)

} // namespace carina::airway_reflexes_test

#include "tst_airway_reflexes.moc"
