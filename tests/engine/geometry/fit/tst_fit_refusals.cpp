#include "engine/geometry/fit/rigid_fit.h"

#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <limits>

namespace carina::fit_refusals_test
{
namespace
{

const RigidTransform kX_MA{rotationFromVector({0.3, -1.1, 0.7}), {0.4, -0.2, 1.5}};
const std::vector<Vec3> kSound{
    {0.0, -0.06, 0.04}, {0.0, -0.13, -0.13}, {0.08, -0.12, -0.11}, {-0.08, -0.12, -0.11}};

/// Four points along a line, the second pushed off it.
std::vector<Vec3> nearlyOnALine(double off)
{
    return {{0.0, 0.0, 0.0}, {0.1, off, 0.0}, {0.2, 0.0, 0.0}, {0.3, 0.0, 0.0}};
}

std::vector<Vec3> times(double factor, std::vector<Vec3> points)
{
    for (Vec3& p : points)
        p *= factor;
    return points;
}

} // namespace

/// Landmarks that determine no registration, on either side.
class TestFitRefusals : public QObject
{
    Q_OBJECT

private:
    /// The code with which fitRigid refuses: nothing where it fits.
    static std::optional<Errc> refusal(const std::vector<Vec3>& p_AQ, const std::vector<Vec3>& p_MQ)
    {
        std::vector<LandmarkPair> pairs;
        for (std::size_t i = 0; i < p_AQ.size(); ++i)
            pairs.push_back({p_AQ[i], kX_MA * p_MQ[i]});
        const auto fit = fitRigid(pairs);
        return fit ? std::nullopt : std::optional{fit.error().code};
    }

private Q_SLOTS:
    void refusesFewerThanThree_data()
    {
        QTest::addColumn<int>("count");
        QTest::newRow("none") << 0;
        QTest::newRow("one") << 1;
        QTest::newRow("two") << 2;
    }

    void refusesFewerThanThree()
    {
        QFETCH(int, count);
        const std::vector<Vec3> few{kSound.begin(), kSound.begin() + count};
        QCOMPARE(refusal(few, few), Errc::TooFewLandmarks);
    }

    void takesThree()
    {
        const std::vector<Vec3> three{kSound.begin(), kSound.begin() + 3};
        QVERIFY(!refusal(three, three));
    }

    void refusesBadPointsOnEitherSide_data()
    {
        QTest::addColumn<std::vector<Vec3>>("bad");
        QTest::addColumn<Errc>("expected");
        const double nan = std::numeric_limits<double>::quiet_NaN();
        const double inf = std::numeric_limits<double>::infinity();
        auto with = [](double value) {
            auto points = kSound;
            points[3].y() = value;
            return points;
        };
        QTest::newRow("no number") << with(nan) << Errc::NotFinite;
        QTest::newRow("infinite") << with(-inf) << Errc::NotFinite;
        QTest::newRow("a kilometre away") << with(-5e3) << Errc::OutOfRange;
        QTest::newRow("as far as numbers go")
            << with(std::numeric_limits<double>::max()) << Errc::OutOfRange;
        QTest::newRow("coincident at the origin")
            << std::vector<Vec3>(4, Vec3::Zero()) << Errc::DegenerateLandmarks;
        QTest::newRow("coincident") << std::vector<Vec3>(4, kSound[0]) << Errc::DegenerateLandmarks;
        QTest::newRow("within half a millimetre")
            << times(0.003, kSound) << Errc::DegenerateLandmarks;
        QTest::newRow("on one line") << nearlyOnALine(0.0) << Errc::DegenerateLandmarks;
        QTest::newRow("on one line but for a tracker's noise")
            << nearlyOnALine(0.8e-3) << Errc::DegenerateLandmarks;
        QTest::newRow("two pairs of coincident ones")
            << std::vector<Vec3>{kSound[0], kSound[0], kSound[1], kSound[1]}
            << Errc::DegenerateLandmarks;
    }

    void refusesBadPointsOnEitherSide()
    {
        QFETCH(std::vector<Vec3>, bad);
        QFETCH(Errc, expected);
        QCOMPARE(refusal(bad, kSound), expected);
        QCOMPARE(refusal(kSound, bad), expected);
        QCOMPARE(refusal(bad, bad), expected);
    }

    /// Extents of four points along 0.3 m, the second off by d: RMS 0.1118 m along the line and
    /// nearly 0.4 d across it. A hundredth of the one is the other at d = 2.7 mm.
    void drawsTheLineAtAHundredth()
    {
        QCOMPARE(refusal(nearlyOnALine(2.6e-3), nearlyOnALine(2.6e-3)), Errc::DegenerateLandmarks);
        QVERIFY(!refusal(nearlyOnALine(2.8e-3), nearlyOnALine(2.8e-3)));
    }

    /// A cross of half a metre by five millimetres: squared, its arms are the limit exactly.
    void takesPointsAtAHundredth()
    {
        const std::vector<Vec3> cross{{.5, 0, 0}, {-.5, 0, 0}, {0, .005, 0}, {0, -.005, 0}};
        QVERIFY(!refusal(cross, cross));
    }

    /// Crosses of a long arm and two nearly alike, seen in a mirror: whichever of the two is turned
    /// over, they fit. Choosing the right one gains, as a share of what the long arm gives,
    /// 0.02^2 times twice the share by which they differ: a billionth at 1.25 millionths.
    void refusesAMirrorImageWithHardlyABestTurn()
    {
        const auto cross = [](double less, double z) {
            const double b = 0.02;
            const double c = b * (1.0 - less);
            return std::vector<Vec3>{{1, 0, 0},  {-1, 0, 0},    {0, b, 0},
                                     {0, -b, 0}, {0, 0, z * c}, {0, 0, -z * c}};
        };
        QCOMPARE(refusal(cross(1.2e-6, 1.0), cross(1.2e-6, -1.0)), Errc::DegenerateLandmarks);
        QVERIFY(!refusal(cross(1.3e-6, 1.0), cross(1.3e-6, -1.0)));
    }

    /// Three points at the ends of unit axes times s: the largest RMS extent is s / sqrt(3).
    void takesLandmarksAMillimetreAcross()
    {
        const std::vector<Vec3> unit{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
        const double s = std::sqrt(3.0) * kSmallestExtent.si;
        QCOMPARE(refusal(times(0.99 * s, unit), times(0.99 * s, unit)), Errc::DegenerateLandmarks);
        QVERIFY(!refusal(times(1.01 * s, unit), times(1.01 * s, unit)));
    }

    /// The corners of a square touched crosswise: any turn about one of its sides fits alike.
    void refusesAnOrderThatLeavesTheTurnOpen()
    {
        const std::vector<Vec3> around{{.1, .1, 0}, {-.1, .1, 0}, {-.1, -.1, 0}, {.1, -.1, 0}};
        const std::vector<Vec3> across{{.1, .1, 0}, {-.1, -.1, 0}, {-.1, .1, 0}, {.1, -.1, 0}};
        QCOMPARE(refusal(around, across), Errc::DegenerateLandmarks);
        QVERIFY(!refusal(around, around));
    }

    /// A regular tetrahedron and its mirror image: by symmetry no turn is the best.
    void refusesAMirrorImageWithoutABestTurn()
    {
        const std::vector<Vec3> points{
            {.1, .1, .1}, {.1, -.1, -.1}, {-.1, .1, -.1}, {-.1, -.1, .1}};
        QCOMPARE(refusal(points, times(-1.0, points)), Errc::DegenerateLandmarks);
    }

    void saysWhatIsWrong()
    {
        const std::vector<LandmarkPair> one{{Vec3::Zero(), Vec3::Zero()}};
        QCOMPARE(fitRigid(one).error().detail, std::string{"1 landmarks, and 3 are the fewest"});
    }
};

CARINA_TEST(TestFitRefusals)

} // namespace carina::fit_refusals_test

#include "tst_fit_refusals.moc"
