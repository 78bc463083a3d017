#include "engine/airway/monitor/airway_moment.h"
#include "tests/engine/airway/monitor/monitored_run.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <vector>

namespace carina::airway_moment_test
{

namespace
{

constexpr double kExact = 1e-9;    // m
constexpr double kDrawn = 0.5e-3;  // m, of a way that is drawn by straight pieces
constexpr double kGlottis = 0.125; // height of the glottis in the drawn airway, m

AirwayMoment with(const std::vector<Vec3>& tube, const std::vector<Vec3>& measured = {})
{
    return airwayMoment(SessionTime{}, test::drawnWays(), {Validity::Tracked, tube, measured}, {});
}

/// Of a tube whose tip is there.
AirwayMoment at(const Vec3& p_A_tip) { return with({p_A_tip + Vec3{0.0, 0.0, 0.1}, p_A_tip}); }

/// A way that turns by 150 degrees from the incisors to the trachea, as with a flexed neck: the
/// trachea comes back through the plane at the incisors.
PatientWays turnedFurther()
{
    constexpr double kRadius = 0.060;
    constexpr double kTrachea = 0.125;
    constexpr int kPieces = 80;
    AirwayLandmarks airway;
    for (int i = 0; i <= kPieces; ++i) {
        const double angle = degrees(150.0).si * i / kPieces;
        airway.path_A.emplace_back(0.0, kRadius * std::sin(angle), kRadius * std::cos(angle));
    }
    airway.p_A_incisors = airway.path_A.front();
    airway.p_A_glottis = airway.path_A.back();
    const double angle = degrees(150.0).si;
    const Vec3 down{0.0, std::cos(angle), -std::sin(angle)};
    for (double along = 0.002; along <= kTrachea; along += 0.002)
        airway.path_A.emplace_back(airway.p_A_glottis + along * down);
    return patientWays(airway, std::nullopt, {});
}

/// The way from outside the mouth to an arc length beyond the incisors.
std::vector<Vec3> alongWay(double depth, const PatientWays& ways = test::drawnWays())
{
    const Centreline line = test::routeOf(ways, test::Route::Trachea);
    std::vector<Vec3> tube;
    for (double along = 0.0; along < 0.150 + depth; along += 0.002)
        tube.push_back(pointAlong(line, metres(along)));
    tube.push_back(pointAlong(line, metres(0.150 + depth)));
    return tube;
}

} // namespace

class TestAirwayMoment : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void planeOfTheCordsIsPassedByItsDistance()
    {
        QVERIFY(std::abs(at({0.0, 0.0, kGlottis - 0.02}).pastCords.si - 0.02) < kExact);
        QVERIFY(std::abs(at({0.0, 0.0, kGlottis + 0.01}).pastCords.si + 0.01) < kExact);
        QVERIFY(std::abs(at({0.0, 0.015, kGlottis - 0.02}).pastCords.si - 0.02) < kExact);
    }

    /// In front of the neck no tip is past the cords, as low as it is.
    void tipBesideTheWaysIsNotPastThem()
    {
        QVERIFY(at({0.0, -0.030, kGlottis - 0.04}).pastCords < Length{});
        QVERIFY(at({0.0, -0.030, kGlottis - 0.04}).pastTeeth < Length{});
        QVERIFY(at({0.0, 0.0, kGlottis - 0.04}).pastTeeth > Length{});
    }

    /// 38 mm from the way over the tongue, a quarter of a circle: in front of the vallecula, and as
    /// far from the same place to the side; and under the chin.
    void bladeReachesFartherOnlyInFrontOfTheVallecula()
    {
        const Vec3 middle{0.0, -0.060, kGlottis};
        const auto within = [&](double share, double radius) {
            const double angle = share * degrees(90.0).si;
            return Vec3{middle + radius * Vec3{0.0, std::sin(angle), std::cos(angle)}};
        };
        const auto bladeAt = [](const Vec3& p_A) {
            return airwayMoment(SessionTime{}, test::drawnWays(), {},
                                {.validity = Validity::Tracked, .p_A_tip = p_A})
                .bladePastTeeth;
        };
        const Vec3 lifted = within(0.85, 0.022);
        QVERIFY(at(lifted).pastTeeth < Length{});
        QVERIFY(bladeAt(lifted) > Length{});
        QVERIFY(bladeAt(within(0.85, 0.010)) < Length{}); // in front of the neck
        QVERIFY(bladeAt(within(0.85, 0.060) + Vec3{0.038, 0.0, 0.0}) < Length{});
        QVERIFY(bladeAt(within(0.1, 0.022)) < Length{});
        QVERIFY(bladeAt(within(0.1, 0.040)) > Length{}); // in the tongue
    }

    /// A tip that is held in the trachea is no evidence of that: where it was measured is.
    void evidenceIsThatOfTheMeasuredTip()
    {
        const std::vector<Vec3> shown{{0.0, 0.0, 0.2}, {0.0, 0.0, 0.06}};
        const std::vector<Vec3> measured{{0.0, 0.0, 0.2},
                                         {0.0, 0.5 * 0.0139 * 125.0 / 127.0, 0.06}};
        TubeCurves tube{
            .validity = Validity::Tracked, .p_A_shown = shown, .p_A_measured = measured};
        const AirwayMoment moment = airwayMoment(SessionTime{}, test::drawnWays(), tube, {});
        QVERIFY(std::abs(moment.towardsOesophagus.si) < kDrawn);
        QCOMPARE(moment.p_A_tip, shown.back());
        QVERIFY(moment.besides > Length{});
    }

    void oesophagusIsToldFromTheTrachea()
    {
        const AirwayMoment inTrachea = at({0.0, 0.0, 0.06});
        const AirwayMoment behind = at({0.0, 0.0139 * 125.0 / 127.0, 0.06});
        QVERIFY(std::abs(inTrachea.tracheaToOesophagus.si - 0.0139 * 125.0 / 127.0) < kDrawn);
        QVERIFY(std::abs(inTrachea.towardsOesophagus.si + 0.5 * 0.0139) < kDrawn);
        QVERIFY(std::abs(behind.towardsOesophagus.si - 0.5 * 0.0139) < kDrawn);
    }

    /// At the cords: in front of the notch the glottis, well behind it the hypopharynx.
    void larynxIsToldFromBehindIt()
    {
        const Vec3 notch = test::drawnWays().p_A_notch;
        const Vec3 below{0.0, 0.0, -0.001};
        QVERIFY(at(notch + below - Vec3{0.0, 0.004, 0.0}).towardsOesophagus < millimetres(-4.0));
        QVERIFY(at(notch + below + Vec3{0.0, 0.012, 0.0}).towardsOesophagus > millimetres(4.0));
    }

    void besideTheGlottisIsThePiriformFossa()
    {
        const Vec3 glottis{0.0, 0.0, kGlottis};
        QVERIFY(at(glottis + Vec3{0.004, 0.0, 0.0}).towardsOesophagus < Length{});
        QVERIFY(at(glottis + Vec3{0.013, 0.0, 0.0}).towardsOesophagus > millimetres(2.0));
        QVERIFY(at(glottis - Vec3{0.013, 0.0, 0.0}).towardsOesophagus > millimetres(2.0));
    }

    /// An entry of a session about the blade tells of the tube, too, that lies beside the patient.
    void tubeBesideThePatientIsNoFartherThanAnEntryMaySay()
    {
        QCOMPARE(at({0.2, 0.0, -2.0}).aboveCarina.si, -kFarthestFromCarina.si);
        QCOMPARE(at({-0.5, -0.5, -2.0}).aboveCarina.si, -kFarthestFromCarina.si);
        QVERIFY(at({0.0, -2.0, 1.0}).aboveCarina <= kFarthestFromCarina);
    }

    void distanceFromTheCarinaIsAlongTheAirway()
    {
        QVERIFY(std::abs(at({0.0, 0.0, 0.03}).aboveCarina.si - 0.03) < kExact);
        QVERIFY(std::abs(at({0.003, 0.0, 0.03}).aboveCarina.si - 0.03) < kExact);
        const PatientWays ways = test::drawnWays();
        const Vec3 inRight = 0.8 * ways.p_A_rightEnd;
        QVERIFY(std::abs(at(inRight).aboveCarina.si + inRight.norm()) < kDrawn);
        // 20 mm above the glottis, along a curve
        const Vec3 above =
            pointAlong(ways.overTongue, lengthOf(ways.overTongue) - millimetres(20.0));
        QVERIFY(std::abs(at(above).aboveCarina.si - 0.145) < kDrawn);
    }

    void bronchiAreToldApart()
    {
        const PatientWays ways = test::drawnWays();
        const AirwayMoment right = at(0.8 * ways.p_A_rightEnd);
        const AirwayMoment left = at(0.4 * ways.p_A_leftEnd);
        QVERIFY(std::abs(right.towardsLeft.si + 0.5 * right.rightToLeft.si) < kDrawn);
        QVERIFY(std::abs(left.towardsLeft.si - 0.5 * left.rightToLeft.si) < kDrawn);
        QVERIFY(at({0.0, 0.0, 0.03}).rightToLeft == Length{});
    }

    void depthIsAlongTheTubeFromTheTeeth()
    {
        for (const double depth : {0.02, 0.10, 0.19})
            QVERIFY(std::abs(with(alongWay(depth)).depthAtTeeth.si - depth) < kDrawn);
        QVERIFY(with(alongWay(-0.02)).depthAtTeeth == Length{});
        QVERIFY(std::abs(with(alongWay(-0.02)).pastTeeth.si + 0.02) < kDrawn);
    }

    void tubeIsInTheMouthWhereTheWayTurnsBackThroughThePlaneOfTheTeeth()
    {
        const PatientWays ways = turnedFurther();
        const Vec3 carina = ways.p_A_carina();
        QVERIFY(ways.inward_A().dot(carina - ways.p_A_incisors()) < 0.0);
        for (const double depth : {0.02, 0.10, 0.18, 0.24}) {
            const std::vector<Vec3> tube = alongWay(depth, ways);
            const AirwayMoment moment =
                airwayMoment(SessionTime{}, ways, {Validity::Tracked, tube, {}}, {});
            QVERIFY(moment.pastTeeth > Length{});
            QVERIFY2(std::abs(moment.depthAtTeeth.si - depth) < kDrawn,
                     qPrintable(QString::number(moment.depthAtTeeth.si)));
        }
    }

    void shapesAreComparedAtTheTip()
    {
        const Vec3 tip{0.0, 0.0, 0.06};
        const Vec3 beside = tip + Vec3{0.0, 0.003, 0.004};
        const AirwayMoment moment = with({Vec3{0.0, 0.0, 0.2}, tip}, {Vec3{0.0, 0.0, 0.2}, beside});
        QVERIFY(std::abs(moment.besides.si - 0.005) < kExact);
        QVERIFY(std::abs(moment.pastCords.si - 0.065) < kExact);
        QVERIFY(std::abs(moment.measuredPastCords.si - 0.061) < kExact);
        QVERIFY(at(tip).besides == Length{});
    }

    void nothingIsSaidOfWhatIsLost()
    {
        const BladeSeen blade{.validity = Validity::Tracked,
                              .p_A_tip = test::drawnWays().p_A_incisors()
                                         + 0.01 * test::drawnWays().inward_A(),
                              .glottis = 0.4};
        const AirwayMoment moment = airwayMoment(SessionTime{}, test::drawnWays(), {}, blade, true);
        QVERIFY(moment.tube == Validity::Lost && moment.depthAtTeeth == Length{});
        QVERIFY(moment.glottis == 0.4 && moment.areCordsShut);
        QVERIFY(std::abs(moment.bladePastTeeth.si - 0.01) < kDrawn);
        QVERIFY(!airwayMoment(SessionTime{}, test::drawnWays(), {}, {}).glottis);
    }
};

CARINA_TEST(TestAirwayMoment)

} // namespace carina::airway_moment_test

#include "tst_airway_moment.moc"
