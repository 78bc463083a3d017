#include "engine/tracking/measurement_volume.h"

#include "engine/tracking/working_volume.h"
#include "tests/support/test_class.h"

#include <random>

namespace carina::measurement_volume_test
{
namespace
{

constexpr double kRounding = 1e-12;

/// The nearest point of the surface of a cone or frustum, by looking at many of them.
double searchedDistance(const VolumeSection& near, const VolumeSection& far, const Vec3& p_T)
{
    double least = 1e9;
    for (int i = 0; i <= 20'000; ++i) {
        const double share = i / 20'000.0;
        const double depth = near.depth + share * (far.depth - near.depth);
        const double half = near.halfX + share * (far.halfX - near.halfX);
        least = std::min(least, std::hypot(depth + p_T.z(), half - std::hypot(p_T.x(), p_T.y())));
    }
    return least;
}

} // namespace

class MeasurementVolumeTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isWhereNdiStatesIt_data()
    {
        QTest::addColumn<Vec3>("p_T");
        QTest::addColumn<bool>("isInPyramid");
        QTest::addColumn<bool>("isInExtended");
        QTest::newRow("in the middle") << Vec3{0, 0, -1.6} << true << true;
        QTest::newRow("too near") << Vec3{0, 0, -0.94} << false << false;
        QTest::newRow("a far corner") << Vec3{0.655, 0.782, -2.399} << true << true;
        QTest::newRow("beside a far corner") << Vec3{0.657, 0.782, -2.399} << false << false;
        QTest::newRow("behind the pyramid") << Vec3{0, 0, -2.41} << false << true;
        QTest::newRow("the farthest corner") << Vec3{-0.734, -0.927, -2.999} << false << true;
        QTest::newRow("a bend") << Vec3{0.395, -0.571, -1.532} << true << true;
        QTest::newRow("behind the tracker") << Vec3{0, 0, 1.0} << false << false;
    }

    void isWhereNdiStatesIt()
    {
        QFETCH(const Vec3, p_T);
        QFETCH(const bool, isInPyramid);
        QFETCH(const bool, isInExtended);
        QCOMPARE(polarisPyramid().insideBy(p_T) > 0.0, isInPyramid);
        QCOMPARE(polarisExtendedPyramid().insideBy(p_T) > 0.0, isInExtended);
    }

    void tellsTheDistanceToTheEnds()
    {
        QVERIFY(std::abs(polarisPyramid().insideBy({0, 0, -1.05}) - 0.1) < kRounding);
        QVERIFY(std::abs(polarisPyramid().insideBy({0, 0, -2.3}) - 0.1) < kRounding);
        QVERIFY(std::abs(polarisPyramid().insideBy({0, 0, -0.85}) + 0.1) < kRounding);
    }

    void tellsTheDistanceToTheSlope()
    {
        std::mt19937 random{7};
        std::uniform_real_distribution<double> aside{-0.25, 0.25};
        std::uniform_real_distribution<double> depth{0.8, 1.2};
        const MeasurementVolume cone = simulatedCone();
        for (int i = 0; i < 50; ++i) {
            const Vec3 p_T{aside(random), aside(random), -depth(random)};
            const double inside = cone.insideBy(p_T);
            QCOMPARE(inside > 0.0, WorkingVolume{}.contains(p_T));
            if (inside < 0.1) // else the base may be nearer
                QVERIFY(std::abs(std::abs(inside)
                                 - searchedDistance(cone.sections[0], cone.sections[1], p_T))
                        < 1e-4);
        }
    }
};

CARINA_TEST(MeasurementVolumeTest)

} // namespace carina::measurement_volume_test

#include "tst_measurement_volume.moc"
