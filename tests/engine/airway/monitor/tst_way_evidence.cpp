#include "engine/airway/monitor/way_evidence.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::way_evidence_test
{

namespace
{

constexpr double kExact = 1e-9;
constexpr Length kRegistration = millimetres(2.0);
constexpr Length kApart = millimetres(14.0);

constexpr double kLumen = 7.84;         // (0.2 * 14)^2, mm^2
constexpr double kKnown = 4.0 + kLumen; // with the registration, mm^2

double oddsOf(const WayEvidence& evidence) { return evidence.logOdds(kRegistration); }

/// At two depths, behind each other, as a tube lies in an unbent or a bent piece of its way.
WayEvidence at(Length first, Length firstShape, Length second, Length secondShape)
{
    WayEvidence evidence;
    evidence.take(millimetres(1.0), first, kApart, firstShape);
    evidence.take(millimetres(6.0), second, kApart, secondShape);
    return evidence;
}

} // namespace

class TestWayEvidence : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingSeenIsNoEvidence() { QVERIFY(oddsOf({}) == 0.0); }

    /// 14 * 7 / (2^2 + (0.2 * 14)^2).
    void oneDepthIsTheRatioOfTwoNormalDistributions()
    {
        WayEvidence evidence;
        evidence.take(millimetres(1.0), millimetres(7.0), kApart, {});
        QVERIFY(std::abs(oddsOf(evidence) - 98.0 / 11.84) < kExact);
    }

    void otherSideIsTheOtherWay()
    {
        WayEvidence evidence;
        evidence.take(millimetres(1.0), millimetres(-7.0), kApart, {});
        QVERIFY(std::abs(oddsOf(evidence) + 98.0 / 11.84) < kExact);
    }

    /// Of more depths the lumens count less, the registration does not.
    void depthsAddButTheRegistrationStays()
    {
        WayEvidence evidence;
        for (int i = 0; i < 4; ++i)
            evidence.take(millimetres(1.0 + 5.0 * i), millimetres(7.0), kApart, {});
        QVERIFY(std::abs(oddsOf(evidence) - 98.0 / (4.0 + 7.84 / 4.0)) < kExact);
    }

    void waitingBringsNone()
    {
        WayEvidence evidence;
        evidence.take(millimetres(1.0), millimetres(7.0), kApart, {});
        const double first = oddsOf(evidence);
        for (int i = 0; i < 1000; ++i)
            evidence.take(millimetres(1.0), millimetres(7.0), kApart, {});
        QVERIFY(std::abs(oddsOf(evidence) - first) < kExact);
    }

    void doubtAboutTheShapeCounts()
    {
        WayEvidence evidence;
        evidence.take(millimetres(1.0), millimetres(7.0), kApart, millimetres(3.0));
        QVERIFY(std::abs(oddsOf(evidence) - 98.0 / 20.84) < kExact);
    }

    /// Of two depths that say the same the doubt stays: its cause is the same at both.
    void bendIsNoErrorThatMoreDepthsMakeSmaller()
    {
        const Length bent = millimetres(10.0);
        const double odds = oddsOf(at(millimetres(7.0), bent, millimetres(7.0), bent));
        QVERIFY(std::abs(odds - 98.0 / (4.0 + 100.0 + 0.5 * kLumen)) < kExact);
    }

    void bentTubeCountsByItsOwnDoubt()
    {
        const double odds = oddsOf(at(millimetres(7.0), {}, millimetres(-7.0), millimetres(30.0)));
        const double second = kKnown / (kKnown + 900.0); // its weight, of that of the first
        const double mean = 7.0 * (1.0 - second) / (1.0 + second);
        const double shape = 30.0 * second / (1.0 + second);
        const double lumens = kLumen * (1.0 + second * second) / std::pow(1.0 + second, 2);
        QVERIFY(std::abs(odds - 14.0 * mean / (4.0 + shape * shape + lumens)) < kExact);
        QVERIFY(odds > 7.0);
    }

    /// Its tip passes the rod's; it is as bent as before.
    void shapesThatHappenToAgreeAreNoEvidence()
    {
        const Length bent = millimetres(40.0);
        QVERIFY(oddsOf(at(millimetres(7.0), bent, millimetres(7.0), {})) < 0.5);
    }

    void bendCountsFromTheErrorOfTheRegistrationOn()
    {
        const auto isBent = [](Length shape) {
            return at({}, shape, {}, shape).isBent(kRegistration);
        };
        QVERIFY(!WayEvidence{}.isBent(kRegistration));
        QVERIFY(!isBent(0.9 * kRegistration));
        QVERIFY(isBent(1.1 * kRegistration));
        QVERIFY(!at({}, {}, {}, millimetres(30.0)).isBent(kRegistration));
    }

    /// m = (10 * 5 - 20 * 2) / 30, D = (10^2 + 20^2) / 30.
    void depthsCountByTheDistanceOfTheWays()
    {
        WayEvidence evidence;
        evidence.take(millimetres(1.0), millimetres(5.0), millimetres(10.0), {});
        evidence.take(millimetres(6.0), millimetres(-2.0), millimetres(20.0), {});
        const double lumens = (100.0 * 4.0 + 400.0 * 16.0) / 900.0;
        QVERIFY(std::abs(oddsOf(evidence) - 500.0 / 30.0 * 10.0 / 30.0 / (4.0 + lumens)) < kExact);
    }

    void depthsBeyondTheDeepestCountAsThat()
    {
        WayEvidence evidence;
        evidence.take(metres(1.0), millimetres(7.0), kApart, {});
        QVERIFY(evidence.depths.back().isSeen);
    }
};

CARINA_TEST(TestWayEvidence)

} // namespace carina::way_evidence_test

#include "tst_way_evidence.moc"
