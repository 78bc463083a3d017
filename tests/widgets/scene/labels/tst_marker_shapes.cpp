#include "tests/support/test_class.h"
#include "widgets/scene/labels/marker_shapes.h"

#include <cmath>
#include <numbers>

namespace carina::marker_shapes_test
{

namespace
{

// A regular polygon of 24 corners covers this share of its circle; the bands of the ball and the
// blunt tips take the rest.
constexpr double kVolumeTolerance = 0.03;
constexpr double kSize = 1e-6; ///< metres, of a coordinate
constexpr double kRadius = 0.006;

bool isNear(double value, double expected)
{
    return std::abs(value / expected - 1.0) < kVolumeTolerance;
}

} // namespace

class TestMarkerShapes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void makesABall();
    void makesADiamond();
    void makesAPointer();
    void givesEveryVertexANormal();
};

void TestMarkerShapes::makesABall()
{
    const auto ball = ballMarker(metres(kRadius));
    QVERIFY(isNear(signedVolume(*ball), 4.0 / 3.0 * std::numbers::pi * std::pow(kRadius, 3)));
    const Box bounds = boundsOf(*ball);
    QVERIFY((bounds.max - Vec3::Constant(kRadius)).norm() < kSize);
    QVERIFY((bounds.min + Vec3::Constant(kRadius)).norm() < kSize);
}

void TestMarkerShapes::makesADiamond()
{
    const auto diamond = diamondMarker(metres(kRadius));
    QVERIFY(isNear(signedVolume(*diamond), 2.0 / 3.0 * std::numbers::pi * std::pow(kRadius, 3)));
    for (const Vec3f& p : diamond->positions)
        QVERIFY(std::hypot(p.x(), p.y()) + std::abs(p.z()) < kRadius * (1.0 + kVolumeTolerance));
    const Box bounds = boundsOf(*diamond);
    QVERIFY((bounds.max - Vec3::Constant(kRadius)).norm() < kSize);
    QVERIFY((bounds.min + Vec3::Constant(kRadius)).norm() < kSize);
}

void TestMarkerShapes::makesAPointer()
{
    constexpr double kLength = 0.1;
    const auto pointer = pointerMarker(metres(kLength), metres(kRadius));
    QVERIFY(isNear(signedVolume(*pointer), std::numbers::pi / 3.0 * kRadius * kRadius * kLength));
    const Box bounds = boundsOf(*pointer);
    QVERIFY(std::abs(bounds.min.z()) < kSize); // the tip
    QVERIFY(std::abs(bounds.max.z() - kLength) < kSize);
}

void TestMarkerShapes::givesEveryVertexANormal()
{
    for (const auto& marker : {ballMarker(metres(kRadius)), diamondMarker(metres(kRadius)),
                               pointerMarker(metres(0.1), metres(kRadius))})
        QCOMPARE(marker->normals.size(), marker->positions.size());
}

CARINA_TEST(TestMarkerShapes)

} // namespace carina::marker_shapes_test

#include "tst_marker_shapes.moc"
