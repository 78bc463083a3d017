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

double oddsOf(const WayEvidence& evidence, Length shape = {})
{
    return evidence.logOdds(kRegistration, shape);
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
        evidence.take(millimetres(1.0), millimetres(7.0), kApart);
        QVERIFY(std::abs(oddsOf(evidence) - 98.0 / 11.84) < kExact);
    }

    void otherSideIsTheOtherWay()
    {
        WayEvidence evidence;
        evidence.take(millimetres(1.0), millimetres(-7.0), kApart);
        QVERIFY(std::abs(oddsOf(evidence) + 98.0 / 11.84) < kExact);
    }

    /// Of more depths the lumens count less, the registration does not.
    void depthsAddButTheRegistrationStays()
    {
        WayEvidence evidence;
        for (int i = 0; i < 4; ++i)
            evidence.take(millimetres(1.0 + 5.0 * i), millimetres(7.0), kApart);
        QVERIFY(std::abs(oddsOf(evidence) - 98.0 / (4.0 + 7.84 / 4.0)) < kExact);
    }

    void waitingBringsNone()
    {
        WayEvidence evidence;
        evidence.take(millimetres(1.0), millimetres(7.0), kApart);
        const double first = oddsOf(evidence);
        for (int i = 0; i < 1000; ++i)
            evidence.take(millimetres(1.0), millimetres(7.0), kApart);
        QVERIFY(std::abs(oddsOf(evidence) - first) < kExact);
    }

    void doubtAboutTheShapeCounts()
    {
        WayEvidence evidence;
        evidence.take(millimetres(1.0), millimetres(7.0), kApart);
        QVERIFY(std::abs(oddsOf(evidence, millimetres(3.0)) - 98.0 / 20.84) < kExact);
    }

    /// m = (10 * 5 - 20 * 2) / 30, D = (10^2 + 20^2) / 30.
    void depthsCountByTheDistanceOfTheWays()
    {
        WayEvidence evidence;
        evidence.take(millimetres(1.0), millimetres(5.0), millimetres(10.0));
        evidence.take(millimetres(6.0), millimetres(-2.0), millimetres(20.0));
        const double lumens = (100.0 * 4.0 + 400.0 * 16.0) / 900.0;
        QVERIFY(std::abs(oddsOf(evidence) - 500.0 / 30.0 * 10.0 / 30.0 / (4.0 + lumens)) < kExact);
    }

    void depthsBeyondTheDeepestCountAsThat()
    {
        WayEvidence evidence;
        evidence.take(metres(1.0), millimetres(7.0), kApart);
        QVERIFY(evidence.depths.back().isSeen);
    }
};

CARINA_TEST(TestWayEvidence)

} // namespace carina::way_evidence_test

#include "tst_way_evidence.moc"
