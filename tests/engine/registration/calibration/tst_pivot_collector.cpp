#include "engine/registration/calibration/pivot_collector.h"

#include "tests/engine/registration/calibration/swung_stylus.h"
#include "tests/support/test_class.h"

#include <functional>

namespace carina::pivot_collector_test
{
namespace
{

constexpr double kRate = 60.0; // Hz
constexpr Length kNoise = millimetres(0.35);

using Motion_s = std::function<RigidTransform(double)>;

/// Swings to all sides by `lean`, once round in two seconds, from upright on.
RigidTransform swinging(double t, Angle lean)
{
    const double around = std::numbers::pi * t;
    const double reach = lean.si * std::min(t, 1.0);
    return test::standing(
        rotationFromVector({reach * std::cos(around), reach * std::sin(around), 0.0}));
}

/// Swings to and fro about one axis.
RigidTransform nodding(double t)
{
    return test::standing(rotationFromVector({degrees(30.0).si * std::sin(3.0 * t), 0.0, 0.0}));
}

/// A stylus that is carried through the room and turned meanwhile.
RigidTransform carried(double t)
{
    return {rotationFromVector({0.6 * std::sin(1.3 * t), 0.5 * std::sin(1.7 * t), 0.3 * t}),
            {0.3 * std::sin(1.1 * t), 0.25 * std::cos(0.9 * t), -1.8 + 0.2 * std::sin(2.3 * t)}};
}

/// What came of feeding a motion for some seconds, with a tracker's noise.
struct Fed {
    std::optional<PivotCalibration> pivot{};
    double ended_s = 0.0; ///< when it gave the pivot, or the motion ended
};

Fed feed(PivotCollector& collector, const Motion_s& motion, double seconds, double from_s = 0.0,
         double rate = kRate)
{
    std::mt19937 random{31};
    std::normal_distribution<double> part{0.0, kNoise.si / std::sqrt(3.0)};
    for (int i = 0; i < seconds * rate; ++i) {
        const double t = i / rate;
        const RigidTransform X_TS =
            test::shifted(motion(t), {part(random), part(random), part(random)});
        const auto pivot =
            collector.push(SessionTime{fromSeconds(from_s + t)}, X_TS, Validity::Tracked);
        if (pivot)
            return {pivot, t};
    }
    return {std::nullopt, seconds};
}

const Motion_s kSwinging = [](double t) { return swinging(t, degrees(30.0)); };

} // namespace

class TestPivotCollector : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void beginsAndEndsByItself()
    {
        PivotCollector collector;
        feed(
            collector, [](double) { return test::standing(Quat::Identity()); }, 3.0);
        QCOMPARE(collector.progress().stage, PivotStage::Waiting);
        QCOMPARE(collector.progress().need, PivotNeed::Swing);
        const Fed fed = feed(collector, kSwinging, 30.0, 3.0);
        QVERIFY(fed.pivot.has_value());
        QVERIFY((fed.pivot->p_SQ - test::kTip_S).norm() < 0.4e-3);
        QVERIFY(fed.pivot->uncertainty() <= 0.15e-3);
        QVERIFY2(fed.ended_s >= 3.0 && fed.ended_s < 12.0,
                 qPrintable(QString::number(fed.ended_s)));
        QCOMPARE(collector.progress().stage, PivotStage::Done);
        QCOMPARE(collector.progress().need, PivotNeed::Nothing);
        QCOMPARE(collector.progress().share, 1.0);
    }

    void takesNothingMoreOnceItIsDone()
    {
        PivotCollector collector;
        QVERIFY(feed(collector, kSwinging, 30.0).pivot.has_value());
        QVERIFY(!feed(collector, kSwinging, 30.0, 40.0).pivot);
        collector.restart();
        QCOMPARE(collector.progress().stage, PivotStage::Waiting);
        QVERIFY(feed(collector, kSwinging, 30.0, 80.0).pivot.has_value());
    }

    void lastsAtLeastAsLongAsItIsTold()
    {
        PivotCollector collector{
            {.certainty = millimetres(5.0), .shortest = std::chrono::seconds{7}}};
        const Fed fed = feed(collector, kSwinging, 30.0);
        QVERIFY(fed.pivot.has_value());
        QVERIFY2(fed.ended_s >= 7.0 && fed.ended_s < 9.0, qPrintable(QString::number(fed.ended_s)));
    }

    void goesOnUntilTheTipIsCertain()
    {
        PivotCollector sloppy{{.shortest = std::chrono::seconds{1}}};
        PivotCollector strict{
            {.certainty = millimetres(0.03), .shortest = std::chrono::seconds{1}}};
        const Fed first = feed(sloppy, kSwinging, 60.0);
        const Fed second = feed(strict, kSwinging, 60.0);
        QVERIFY(first.pivot && second.pivot);
        QVERIFY(second.ended_s > 3.0 * first.ended_s);
        QVERIFY(second.pivot->uncertainty() <= 0.03e-3);
    }

    void saysWhatIsMissing_data()
    {
        QTest::addColumn<Motion_s>("motion");
        QTest::addColumn<PivotStage>("stage");
        QTest::addColumn<PivotNeed>("need");
        QTest::newRow("at rest") << Motion_s{[](double) {
            return test::standing(Quat::Identity());
        }} << PivotStage::Waiting << PivotNeed::Swing;
        QTest::newRow("trembling")
            << Motion_s{[](double t) { return swinging(5.0 * t, degrees(1.5)); }}
            << PivotStage::Waiting << PivotNeed::Swing;
        QTest::newRow("swung narrowly")
            << Motion_s{[](double t) { return swinging(t, degrees(5.5)); }} << PivotStage::Swinging
            << PivotNeed::Motion;
        QTest::newRow("about one axis")
            << Motion_s{nodding} << PivotStage::Swinging << PivotNeed::Directions;
        QTest::newRow("in all directions, not long yet")
            << kSwinging << PivotStage::Swinging << PivotNeed::Poses;
    }

    void saysWhatIsMissing()
    {
        QFETCH(Motion_s, motion);
        QFETCH(PivotStage, stage);
        QFETCH(PivotNeed, need);
        PivotCollector collector;
        QVERIFY(!feed(collector, motion, 3.5).pivot);
        QCOMPARE(collector.progress().stage, stage);
        QCOMPARE(collector.progress().need, need);
        QVERIFY(collector.progress().share < 1.0);
    }

    /// The direction that a nodding stylus did not turn is its x axis.
    void namesTheDirectionThatDidNotTurn()
    {
        PivotCollector collector;
        feed(collector, nodding, 4.0);
        const TurnCoverage& coverage = collector.progress().coverage;
        QVERIFY((coverage.dirs_S[0] - Vec3::UnitX()).norm() < 1e-6);
        QVERIFY((coverage.dir_T_least - Vec3::UnitX()).norm() < 1e-6);
        QVERIFY(inDegrees(coverage.turns[0]) < 1e-3);
        QVERIFY(inDegrees(coverage.turns[2]) > 15.0);
    }

    /// With the tip at rest nothing is lost by a pause.
    void waitsForAHandThatPauses()
    {
        PivotCollector collector{{.certainty = millimetres(0.05)}};
        feed(collector, kSwinging, 3.0);
        const int before = collector.progress().poses;
        QVERIFY(before > 30);
        const RigidTransform held = swinging(3.0, degrees(30.0));
        feed(
            collector, [&](double) { return held; }, 10.0, 3.0);
        QCOMPARE(collector.progress().stage, PivotStage::Swinging);
        QVERIFY(collector.progress().poses <= before + 15);
        const Fed fed = feed(
            collector, [](double t) { return swinging(3.0 + t, degrees(30.0)); }, 20.0, 13.0);
        QVERIFY(fed.pivot.has_value());
        QVERIFY((fed.pivot->p_SQ - test::kTip_S).norm() < 0.4e-3);
    }

    void doesNotTakeCarryingForSwinging()
    {
        PivotCollector collector;
        for (int i = 0; i < 60.0 * kRate; ++i) {
            const SessionTime time{fromSeconds(i / kRate)};
            QVERIFY(!collector.push(time, carried(i / kRate), Validity::Tracked));
            QCOMPARE(collector.progress().stage, PivotStage::Waiting);
        }
    }

    void beginsAnewWhereTheTipLeavesItsPlace()
    {
        PivotCollector collector;
        feed(collector, kSwinging, 3.0);
        QCOMPARE(collector.progress().stage, PivotStage::Swinging);
        const RigidTransform aside = RigidTransform::translation({0.05, 0.0, 0.0});
        feed(
            collector, [&](double t) { return aside * swinging(3.0 + t, degrees(30.0)); }, 1.0,
            3.0);
        QCOMPARE(collector.progress().stage, PivotStage::Waiting);
        QCOMPARE(collector.progress().need, PivotNeed::Stillness);
        const Fed fed = feed(
            collector, [&](double t) { return aside * swinging(4.0 + t, degrees(30.0)); }, 30.0,
            4.0);
        QVERIFY(fed.pivot.has_value());
        QVERIFY((fed.pivot->p_TQ - test::kDivot_T - Vec3{0.05, 0.0, 0.0}).norm() < 0.4e-3);
    }

    /// 0.15 m off the markers is within reach by default, and not where 0.1 m is all.
    void leavesPointsOutOfReachAlone()
    {
        PivotCollector collector{{.reach = millimetres(100.0)}};
        feed(collector, kSwinging, 10.0);
        QCOMPARE(collector.progress().stage, PivotStage::Waiting);
    }

    void passesOverWhatIsNoPose()
    {
        PivotCollector collector;
        const SessionTime now{std::chrono::seconds{1}};
        for (int i = 0; i < 600; ++i) {
            const RigidTransform X_TS = swinging(i / kRate, degrees(30.0));
            const SessionTime time = now + fromSeconds(i / kRate);
            QVERIFY(!collector.push(time, X_TS, Validity::Lost));
            QVERIFY(!collector.push(now - Duration{i}, X_TS, Validity::Tracked));
            QVERIFY(!collector.push(time, test::shifted(X_TS, {NAN, 0.0, 0.0}), Validity::Tracked));
        }
        QCOMPARE(collector.progress().stage, PivotStage::Waiting);
    }

    /// The second of two poses of one time is 5 cm off.
    void passesOverASecondPoseOfOneTime()
    {
        PivotCollector collector;
        const Vec3 aside{0.05, 0.0, 0.0};
        std::optional<PivotCalibration> pivot;
        for (int i = 0; i < 600 && !pivot; ++i) {
            const SessionTime time{fromSeconds(i / kRate)};
            const RigidTransform X_TS = swinging(i / kRate, degrees(30.0));
            pivot = collector.push(time, X_TS, Validity::Tracked);
            collector.push(time, test::shifted(X_TS, aside), Validity::Tracked);
        }
        QVERIFY(pivot.has_value());
        QCOMPARE(pivot->outliers, 0);
    }

    void looksAtAWholeWindowBeforeItBegins()
    {
        PivotCollector collector;
        feed(collector, kSwinging, 0.88);
        QCOMPARE(collector.progress().stage, PivotStage::Waiting);
        feed(
            collector, [](double t) { return swinging(0.88 + t, degrees(30.0)); }, 0.1, 0.88);
        QCOMPARE(collector.progress().stage, PivotStage::Swinging);
    }

    void worksAtAnyRate_data()
    {
        QTest::addColumn<double>("rate");
        QTest::newRow("20 Hz") << 20.0;
        QTest::newRow("250 Hz") << 250.0;
    }

    void worksAtAnyRate()
    {
        QFETCH(double, rate);
        PivotCollector collector;
        const Fed fed = feed(collector, kSwinging, 60.0, 0.0, rate);
        QVERIFY(fed.pivot.has_value());
        QVERIFY((fed.pivot->p_SQ - test::kTip_S).norm() < 0.45e-3);
    }
};

CARINA_TEST(TestPivotCollector)

} // namespace carina::pivot_collector_test

#include "tst_pivot_collector.moc"
