#include "engine/lungs/displacement_mode.h"
#include "tests/engine/lungs/lung_like_mesh.h"

#include <Eigen/LU>
#include <QTest>

#include <algorithm>
#include <random>

using namespace carina;

namespace
{

constexpr double kStill_mm = 0.1;
constexpr double kLeastDeterminant = 0.2;

/// A box of the size of an adult lung, mirrored for the other side.
Box lungBox(Side side)
{
    Box box_A;
    const double sign = side == Side::Left ? 1.0 : -1.0;
    box_A.include(Vec3{sign * 0.01, -0.10, -0.15});
    box_A.include(Vec3{sign * 0.13, 0.10, 0.10});
    return box_A;
}

Vec3 hilum(Side side) { return {side == Side::Left ? 0.035 : -0.035, 0.01, -0.01}; }

DisplacementMode modeOn(Side side) { return {lungBox(side), side, hilum(side)}; }

/// The point at these shares of the lung's width (from medial), depth (from the back) and height
/// (from the base).
Vec3 pointAt(Side side, double lateral, double front, double up)
{
    const Box box_A = lungBox(side);
    const Vec3 size = box_A.size();
    const double x = side == Side::Left ? box_A.min.x() + lateral * size.x()
                                        : box_A.max.x() - lateral * size.x();
    return {x, box_A.max.y() - front * size.y(), box_A.min.z() + up * size.z()};
}

double inMm(double metres) { return 1e3 * metres; }

} // namespace

class TestDisplacementMode : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasTheGradientOfItsDisplacement_data() { sides(); }
    void hasTheGradientOfItsDisplacement();
    void foldsNowhereAtAnyAmplitude_data() { sides(); }
    void foldsNowhereAtAnyAmplitude();
    void holdsStillAtTheHilumTheApexAndTheMediastinum_data() { sides(); }
    void holdsStillAtTheHilumTheApexAndTheMediastinum();
    void lowersTheBaseMostAtTheBack_data() { sides(); }
    void lowersTheBaseMostAtTheBack();
    void movesTheRibsForwardUpwardAndOutward_data() { sides(); }
    void movesTheRibsForwardUpwardAndOutward();
    void movesLeftAndRightAsMirrorImages();
    void lowersTheDomesByAQuietBreathAtAmplitudeOne();
    void holdsThreeQuietBreathsWithinTheRange();
    void storesTheExactNormal();

private:
    static void sides();
};

void TestDisplacementMode::sides()
{
    QTest::addColumn<Side>("side");
    QTest::newRow("right") << Side::Right;
    QTest::newRow("left") << Side::Left;
}

void TestDisplacementMode::hasTheGradientOfItsDisplacement()
{
    QFETCH(Side, side);
    const DisplacementMode mode = modeOn(side);
    constexpr double kStep_m = 1e-5;
    constexpr double kTolerance = 1e-7; // metres per metre; central differences err by step^2
    std::mt19937 random{7};
    std::uniform_real_distribution<double> share{0.0, 1.0};
    for (int n = 0; n < 500; ++n) {
        const Vec3 p_A = pointAt(side, share(random), share(random), share(random));
        const Displacement there = mode.at(p_A);
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 step = kStep_m * Vec3::Unit(axis);
            const Vec3 slope = (mode.at(p_A + step).d_A - mode.at(p_A - step).d_A) / (2 * kStep_m);
            QVERIFY((slope - there.gradient.col(axis)).cwiseAbs().maxCoeff() < kTolerance);
        }
    }
}

void TestDisplacementMode::foldsNowhereAtAnyAmplitude()
{
    QFETCH(Side, side);
    const DisplacementMode mode = modeOn(side);
    constexpr int kPoints = 12;
    double least = 1.0;
    for (int i = 0; i <= kPoints * kPoints * kPoints; ++i) {
        const Vec3 p_A = pointAt(side, double(i % kPoints) / (kPoints - 1),
                                 double(i / kPoints % kPoints) / (kPoints - 1),
                                 double(i / (kPoints * kPoints) % kPoints) / (kPoints - 1));
        const Mat3 gradient = mode.at(p_A).gradient;
        for (double s = kLeastAmplitude; s <= kGreatestAmplitude; s += 0.5)
            least = std::min(least, (Mat3::Identity() + s * gradient).determinant());
    }
    QVERIFY2(least > kLeastDeterminant, qPrintable(QString::number(least)));
}

void TestDisplacementMode::holdsStillAtTheHilumTheApexAndTheMediastinum()
{
    QFETCH(Side, side);
    const DisplacementMode mode = modeOn(side);
    QVERIFY(mode.at(hilum(side)).d_A.norm() == 0.0);
    QVERIFY(mode.at(hilum(side)).gradient.norm() == 0.0);
    for (const double share : {0.0, 0.3, 0.6, 1.0}) {
        QVERIFY(inMm(mode.at(pointAt(side, 0.0, share, 0.3)).d_A.norm()) < kStill_mm);
        QVERIFY(inMm(mode.at(pointAt(side, 0.7, share, 1.0)).d_A.norm()) < kStill_mm);
    }
}

void TestDisplacementMode::lowersTheBaseMostAtTheBack()
{
    QFETCH(Side, side);
    const DisplacementMode mode = modeOn(side);
    for (const double lateral : {0.3, 0.5, 0.8, 1.0}) {
        const double back = mode.at(pointAt(side, lateral, 0.1, 0.0)).d_A.z();
        const double front = mode.at(pointAt(side, lateral, 0.9, 0.0)).d_A.z();
        QVERIFY(back < front && front < 0.0);
    }
    for (const double up : {0.3, 0.5, 0.7}) {
        const double lower = mode.at(pointAt(side, 0.8, 0.2, up)).d_A.z();
        const double upper = mode.at(pointAt(side, 0.8, 0.2, up + 0.2)).d_A.z();
        QVERIFY(lower < upper);
    }
}

// Ribs of an adult in quiet breathing: 3 to 5 mm forward and upward, 1 to 2 mm outward.
void TestDisplacementMode::movesTheRibsForwardUpwardAndOutward()
{
    QFETCH(Side, side);
    const DisplacementMode mode = modeOn(side);
    const Vec3 sternal = mode.at(pointAt(side, 0.6, 1.0, 0.3)).d_A;
    QVERIFY(inMm(-sternal.y()) > 3.0 && inMm(-sternal.y()) < 5.0);
    const Vec3 pectoral = mode.at(pointAt(side, 0.6, 1.0, 0.7)).d_A;
    QVERIFY(pectoral.y() < 0.0 && pectoral.z() > 0.0);
    const double outward = side == Side::Left ? 1.0 : -1.0;
    const Vec3 axillary = mode.at(pointAt(side, 1.0, 0.5, 0.4)).d_A;
    QVERIFY(inMm(outward * axillary.x()) > 1.0 && inMm(outward * axillary.x()) <= 2.0);
}

void TestDisplacementMode::movesLeftAndRightAsMirrorImages()
{
    const DisplacementMode right = modeOn(Side::Right);
    const DisplacementMode left = modeOn(Side::Left);
    const Vec3 mirror{-1.0, 1.0, 1.0};
    for (const double share : {0.1, 0.4, 0.9}) {
        const Vec3 p_A = pointAt(Side::Left, share, 1.0 - share, share);
        const Vec3 mirrored = right.at(mirror.cwiseProduct(p_A)).d_A;
        QVERIFY((left.at(p_A).d_A - mirror.cwiseProduct(mirrored)).norm() < 1e-12);
    }
}

// The dome's excursion in quiet breathing is 18 +- 3 mm by ultrasound.
void TestDisplacementMode::lowersTheDomesByAQuietBreathAtAmplitudeOne()
{
    double greatest_mm = 0.0;
    for (const double lateral : {0.4, 0.6, 0.8}) {
        for (const double front : {0.1, 0.4, 0.7}) {
            const Vec3 p_A = pointAt(Side::Right, lateral, front, 0.2);
            greatest_mm = std::max(greatest_mm, inMm(-modeOn(Side::Right).at(p_A).d_A.z()));
        }
    }
    QVERIFY2(greatest_mm > 15.0 && greatest_mm < 21.0, qPrintable(QString::number(greatest_mm)));
}

// A quiet breath is 7 ml/kg of an FRC of 30 ml/kg; three of them must lie within the range.
void TestDisplacementMode::holdsThreeQuietBreathsWithinTheRange()
{
    const Box box_A = lungBox(Side::Left);
    const TriangleMesh rest = test::lungLikeMesh(box_A.centre(), 0.5 * box_A.size(), 24, 32);
    const DisplacementMode mode{boundsOf(rest), Side::Left, hilum(Side::Left)};
    const DeformableMesh mesh = makeDeformable(rest, mode);
    const double frc = test::volumeByColumns(rest);
    const auto gainAt = [&](double s) {
        return (test::volumeByColumns(deformed(mesh, float(s))) - frc) / frc;
    };
    QVERIFY(gainAt(1.0) > 0.25 * 7.0 / 30.0 && gainAt(1.0) < 1.5 * 7.0 / 30.0);
    QVERIFY(gainAt(kGreatestAmplitude) > 3.0 * 7.0 / 30.0);
}

// A normal goes with the cofactor of the deformation gradient, det(J) J^-T n0.
void TestDisplacementMode::storesTheExactNormal()
{
    const Box box_A = lungBox(Side::Right);
    const TriangleMesh rest = test::lungLikeMesh(box_A.centre(), 0.5 * box_A.size(), 12, 16);
    const DisplacementMode mode = modeOn(Side::Right);
    const DeformableMesh mesh = makeDeformable(rest, mode);
    QCOMPARE(mesh.displacement.size(), rest.positions.size());
    constexpr double kTolerance = 1e-6; // single precision
    for (const double s : {-1.0, 0.5, 3.0}) {
        for (std::size_t i = 0; i < rest.positions.size(); ++i) {
            const Displacement there = mode.at(rest.positions[i].cast<double>());
            const Mat3 jacobian = Mat3::Identity() + s * there.gradient;
            const Vec3 n = jacobian.determinant() * jacobian.inverse().transpose()
                           * rest.normals[i].cast<double>();
            const Vec3 stored = (mesh.rest.normals[i] + float(s) * mesh.normalLinear[i]
                                 + float(s * s) * mesh.normalQuadratic[i])
                                    .cast<double>();
            QVERIFY((stored - n).norm() < kTolerance);
            QVERIFY((mesh.displacement[i].cast<double>() - there.d_A).norm() < 1e-8);
        }
    }
}

QTEST_APPLESS_MAIN(TestDisplacementMode)
#include "tst_displacement_mode.moc"
