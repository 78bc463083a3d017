#include "engine/geometry/deformation/blade_field.h"
#include "engine/geometry/rotation.h"
#include "tests/engine/geometry/mesh/mesh_of_places.h"
#include "tests/support/test_class.h"

#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <random>

namespace carina::blade_field_test
{
namespace
{

constexpr double kStep_m = 1e-6;
constexpr double kSlopeTolerance = 1e-3; ///< of central differences, at the seams of the steps
constexpr double kDeterminantTolerance = 1e-9;
constexpr double kPositionTolerance_m = 5e-8; ///< single precision within a quarter metre
constexpr double kNormalTolerance_deg = 0.5;

const std::array kTissues{AirwayTissue::Throat, AirwayTissue::Larynx, AirwayTissue::Pharynx};

/// Any blade at any pose near the places, with a larynx tilted by up to 28 mm, the most.
BladeField anyBlade(std::mt19937& random)
{
    std::uniform_real_distribution<double> share{0.0, 1.0};
    std::normal_distribution<double> number;
    const BladeForm form{.reach = 0.08 + 0.1 * share(random),
                         .rise = 0.02 * share(random),
                         .sag = 0.04 * share(random),
                         .width = 0.01 + 0.015 * share(random)};
    const Vec3 turn{number(random), number(random), number(random)};
    BladeField field{form,
                     {rotationFromVector(turn),
                      {0.03 * number(random), 0.03 * number(random), 0.03 * number(random)}}};
    const Vec3 up = Vec3{number(random), number(random), number(random)}.normalized();
    field.tiltLarynx({.p_A = 0.01 * turn, .up_A = up, .forward_A = up.unitOrthogonal()},
                     metres(0.028 * share(random)));
    return field;
}

std::vector<Vec3> places()
{
    std::mt19937 random{5};
    std::uniform_real_distribution<double> along{-0.12, 0.12};
    std::vector<Vec3> made;
    for (int n = 0; n < 400; ++n)
        made.emplace_back(along(random), along(random), along(random));
    return made;
}

/// An adult's blade with its heel in the origin, ahead along -z, towards y.
BladeField plainBlade() { return {BladeForm{}, {}}; }

Vec3 pushed(const BladeField& blade, const Vec3& p_A)
{
    return p_A + bladePush<double>(blade.frame(), p_A).d;
}

/// The height of that blade's face.
double faceAt(double share) { return middleOfBlade(BladeForm{}, share).y() + kBladeHalfThickness; }

} // namespace

class TestBladeField : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasItsTipAndItsMiddleWhereTheFormSays();
    void movesNothingWithoutABlade();
    void leavesTeethSkinAndWindpipe();
    void leavesNothingInsideTheBlade();
    void pushesAlongTheHandleOnly();
    void leavesWhatIsFarAway();
    void pushesLessBesideANarrowBlade();
    void tiltsTheLarynxAboveItsHingeInProportion();
    void tiltsNoFartherThanNothingFolds();
    void tiltsNothingAboutNoHinge();
    void leavesTheBackOfTheLarynx();
    void takesThePharynxAlongWithTheLarynxBesideIt();
    void leavesTheBackOfThePharynx();
    void foldsNowhereWhereverABladeIs();
    void hasTheSlopesOfItsDisplacement();
    void deformsMeshesAsTheFieldSays();
};

void TestBladeField::hasItsTipAndItsMiddleWhereTheFormSays()
{
    const BladeForm form{.reach = 0.1, .rise = 0.02, .sag = 0.015, .width = 0.015};
    QVERIFY(middleOfBlade(form, 0.0).norm() < 1e-15);
    QVERIFY((middleOfBlade(form, 1.0) - Vec3(0.0, 0.02, -0.1)).norm() < 1e-15);
    QVERIFY((middleOfBlade(form, 0.5) - Vec3(0.0, 0.01 - 0.015, -0.05)).norm() < 1e-15);
}

void TestBladeField::movesNothingWithoutABlade()
{
    const TriangleMesh mesh = test::meshOf(places());
    for (const AirwayTissue tissue : kTissues) {
        for (const Vec3& p_A : places()) {
            QCOMPARE(bladePull<double>(BladeField{}.frame(), tissue, p_A).d.norm(), 0.0);
            QCOMPARE(bladePull<double>(BladeField{}.frame(), tissue, p_A).gradient.norm(), 0.0);
        }
        QVERIFY(deformed(mesh, BladeField{}, tissue).positions == mesh.positions);
    }
}

void TestBladeField::leavesTeethSkinAndWindpipe()
{
    const BladeField blade = plainBlade();
    for (const Vec3& p_A : places())
        for (const AirwayTissue tissue : {AirwayTissue::LooseTooth, AirwayTissue::Teeth,
                                          AirwayTissue::Skin, AirwayTissue::Windpipe}) {
            QCOMPARE(bladePull<double>(blade.frame(), tissue, p_A).d.norm(), 0.0);
            QCOMPARE(bladePull<double>(blade.frame(), tissue, p_A).gradient.norm(), 0.0);
        }
}

// From before its face to 28.8 mm deep; but for its last fifth before the heel the blade pushes
// wholly.
void TestBladeField::leavesNothingInsideTheBlade()
{
    const BladeField blade = plainBlade();
    for (const double share : {0.05, 0.3, 0.6, 1.0})
        for (const double depth : {0.0, 0.005, 0.02, 0.0288})
            for (const double x : {-0.007, 0.0, 0.007}) {
                const Vec3 p_A{x, faceAt(share) - depth, -share * BladeForm{}.reach};
                const double outside = pushed(blade, p_A).y() - faceAt(share);
                QVERIFY(outside > 0.0);
                // c(e) - e falls from 6.63 mm at the face to 0.20 mm at 28.8 mm.
                QVERIFY(outside < 0.00663 - 0.2 * depth);
            }
}

void TestBladeField::pushesAlongTheHandleOnly()
{
    std::mt19937 random{3};
    for (int n = 0; n < 20; ++n) {
        const BladeField blade = anyBlade(random);
        for (const Vec3& p_A : places()) {
            const Vec3 d = bladePush<double>(blade.frame(), p_A).d;
            QVERIFY(d.dot(blade.frame().out) >= 0.0);
            QVERIFY((d - d.dot(blade.frame().out) * blade.frame().out).norm() < 1e-12);
        }
    }
}

void TestBladeField::leavesWhatIsFarAway()
{
    const BladeField blade = plainBlade();
    const double reach = BladeForm{}.reach;
    for (const Vec3& p_A : {Vec3{0.0, -0.02, 0.16 * reach}, Vec3{0.0, -0.02, -1.31 * reach},
                            Vec3{0.029, -0.02, -0.5 * reach}, Vec3{-0.029, -0.02, -0.5 * reach}})
        QCOMPARE(bladePush<double>(blade.frame(), p_A).d.norm(), 0.0);
    // Above the blade tissue gives way less and less: by 0.8 k^2 / m.
    QVERIFY(bladePush<double>(blade.frame(), {0.0, 0.1, -0.5 * reach}).d.norm() < 9e-6 / 0.1);
}

// What is dented beside a stamp goes with the stamp's width: the field of a blade half as wide is
// that of the whole one, as large by half. Beyond an adult's width nothing grows.
void TestBladeField::pushesLessBesideANarrowBlade()
{
    const BladeForm wide{.reach = 0.12, .rise = 0.01, .sag = 0.01, .width = 0.016};
    const BladeForm narrow{.reach = 0.06, .rise = 0.005, .sag = 0.005, .width = 0.008};
    const Vec3 thickness = kBladeHalfThickness * Vec3::UnitY(); // of both the same
    for (const double across : {0.0, 0.004, 0.010, 0.020, 0.027})
        for (const double above : {-0.02, -0.005, 0.0, 0.01}) {
            const Vec3 p{across, above, -0.05};
            const double whole =
                bladePush<double>(BladeField{wide, {}}.frame(), p + thickness).d.y();
            const double half =
                bladePush<double>(BladeField{narrow, {}}.frame(), 0.5 * p + thickness).d.y();
            QVERIFY(std::abs(half - 0.5 * whole) < 1e-12);
        }
    const BladeForm wider{.reach = 0.12, .rise = 0.01, .sag = 0.01, .width = 0.024};
    const BladeField widest{wider, {}};
    QCOMPARE(bladePush<double>(widest.frame(), {0.0321, -0.02, -0.05}).d.norm(), 0.0);
    QVERIFY(bladePush<double>(widest.frame(), {0.0319, -0.02, -0.05}).d.norm() > 0.0);
}

void TestBladeField::tiltsTheLarynxAboveItsHingeInProportion()
{
    BladeField blade = plainBlade();
    const LarynxHinge hinge{.p_A = {0.0, 0.01, 0.1}, .height = millimetres(20.0)};
    blade.tiltLarynx(hinge, millimetres(6.0));
    const auto forward_mm = [&](double above) {
        const Vec3 d = larynxTilt<double>(blade.frame(), hinge.p_A + above * Vec3::UnitZ()).d;
        return d.x() == 0.0 && d.z() == 0.0 ? -1e3 * d.y() : -1.0;
    };
    QCOMPARE(forward_mm(-0.01), 0.0);
    QCOMPARE(forward_mm(0.0), 0.0);
    QVERIFY(std::abs(forward_mm(0.02) - 6.0) < 1e-9);
    const double perHeight = forward_mm(0.04) - forward_mm(0.03);
    QVERIFY(std::abs(forward_mm(0.06) - forward_mm(0.05) - perHeight) < 1e-9);
}

// Whatever is asked for: 0 to twice the length over which it fades.
void TestBladeField::tiltsNoFartherThanNothingFolds()
{
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const LarynxHinge hinge{.behind = millimetres(14.0)};
    BladeField blade = plainBlade();
    blade.tiltLarynx(hinge, millimetres(90.0));
    QVERIFY(std::abs(blade.frame().tilt.norm() - 0.028) < 1e-12);
    for (const double tilt : {-0.006, kNone}) {
        blade.tiltLarynx(hinge, metres(tilt));
        QCOMPARE(blade.frame().tilt.norm(), 0.0);
    }
}

// As where a jaw has turned the vallecula to below the larynx: the tongue gives way all the same.
void TestBladeField::tiltsNothingAboutNoHinge()
{
    for (const double length : {0.0, -0.02, std::numeric_limits<double>::quiet_NaN()})
        for (const LarynxHinge& hinge :
             {LarynxHinge{.height = metres(length)}, LarynxHinge{.behind = metres(length)}}) {
            BladeField blade = plainBlade();
            blade.tiltLarynx({}, millimetres(6.0));
            blade.tiltLarynx(hinge, millimetres(6.0));
            QVERIFY(blade.isThere());
            for (const Vec3& p_A : places()) {
                QCOMPARE(larynxTilt<double>(blade.frame(), p_A).d.norm(), 0.0);
                QCOMPARE(pharynxShift<double>(blade.frame(), p_A).d.norm(), 0.0);
            }
        }
}

void TestBladeField::leavesTheBackOfTheLarynx()
{
    BladeField blade = plainBlade();
    const LarynxHinge hinge{.behind = millimetres(14.0)};
    blade.tiltLarynx(hinge, millimetres(6.0));
    const Vec3 behind = hinge.p_A + 0.0141 * Vec3::UnitY() + 0.03 * Vec3::UnitZ();
    QCOMPARE(larynxTilt<double>(blade.frame(), behind).d.norm(), 0.0);
}

// In front, beside the larynx as far as the larynx; above the vallecula less and less, and the
// palate stays.
void TestBladeField::takesThePharynxAlongWithTheLarynxBesideIt()
{
    BladeField blade = plainBlade();
    const LarynxHinge hinge{.height = millimetres(20.0), .behind = millimetres(14.0), .slope = 0.2};
    blade.tiltLarynx(hinge, millimetres(6.0));
    double most = 0.0;
    for (double height = -0.5; height < 4.0; height += 0.05) {
        const Vec3 p_A = hinge.p_A + Vec3{0.01, -14e-3, 20e-3 * height};
        const double forward = -pharynxShift<double>(blade.frame(), p_A).d.y();
        most = std::max(most, forward);
        if (height <= 1.0)
            QVERIFY(std::abs(forward + larynxTilt<double>(blade.frame(), p_A).d.y()) < 1e-12);
        if (height > 1.5)
            QVERIFY(forward < most || forward == 0.0);
        if (height >= 2.4)
            QCOMPARE(forward, 0.0);
    }
    QVERIFY(most < 7.2e-3); // of the tongue's base
}

// As high as it may be, and however far an epiglottis leans back that is lifted: the wall in front
// of the spine stays.
void TestBladeField::leavesTheBackOfThePharynx()
{
    for (const double slope : {0.0, 0.4, 0.9}) {
        BladeField blade = plainBlade();
        const LarynxHinge hinge{.slope = slope};
        blade.tiltLarynx(hinge, millimetres(18.0));
        for (double height = -0.02; height < 0.08; height += 0.002) {
            const auto forward = [&](double behind) {
                const Vec3 p_A = hinge.p_A + Vec3{0.003, behind, height};
                return -pharynxShift<double>(blade.frame(), p_A).d.y();
            };
            for (const double behind : {0.0, 0.005, 0.02})
                QCOMPARE(forward(behind), 0.0);
            QVERIFY(forward(-0.007) > 0.0 || height <= 0.0 || height >= 0.048);
        }
    }
}

// det (I + grad d) is 1 - w c' before a blade, so at least 0.2, at least 1 for the larynx, and at
// least 0.2 for the base of the tongue and for the pharynx.
void TestBladeField::foldsNowhereWhereverABladeIs()
{
    std::mt19937 random{7};
    for (int n = 0; n < 200; ++n) {
        const BladeFrame<double> frame = anyBlade(random).frame();
        for (const Vec3& p_A : places()) {
            const Mat3 tongue = Mat3::Identity() + bladePush<double>(frame, p_A).gradient;
            const Mat3 larynx = Mat3::Identity() + larynxTilt<double>(frame, p_A).gradient;
            QVERIFY(tongue.determinant() >= 0.2 - kDeterminantTolerance);
            QVERIFY(tongue.determinant() <= 1.0 + kDeterminantTolerance);
            QVERIFY(larynx.determinant() >= 1.0 - kDeterminantTolerance);
            const Mat3 base = Mat3::Identity() + tongueBaseShift<double>(frame, p_A).gradient;
            QVERIFY(base.determinant() >= 0.2 - kDeterminantTolerance);
            const Mat3 pharynx = Mat3::Identity() + pharynxShift<double>(frame, p_A).gradient;
            QVERIFY(pharynx.determinant() >= 0.2 - kDeterminantTolerance);
            const Mat3 both =
                Mat3::Identity() + bladePull<double>(frame, AirwayTissue::Throat, p_A).gradient;
            QVERIFY(both.determinant() >= 0.04 - kDeterminantTolerance);
        }
    }
}

void TestBladeField::hasTheSlopesOfItsDisplacement()
{
    std::mt19937 random{9};
    for (int n = 0; n < 20; ++n) {
        const BladeFrame<double> frame = anyBlade(random).frame();
        for (const AirwayTissue tissue : kTissues)
            for (const Vec3& p_A : places()) {
                const Mat3 gradient = bladePull<double>(frame, tissue, p_A).gradient;
                for (int axis = 0; axis < 3; ++axis) {
                    const Vec3 step = kStep_m * Vec3::Unit(axis);
                    const Vec3 slope = (bladePull<double>(frame, tissue, p_A + step).d
                                        - bladePull<double>(frame, tissue, p_A - step).d)
                                       / (2.0 * kStep_m);
                    QVERIFY((slope - gradient.col(axis)).cwiseAbs().maxCoeff() < kSlopeTolerance);
                }
            }
    }
}

void TestBladeField::deformsMeshesAsTheFieldSays()
{
    std::mt19937 random{13};
    const TriangleMesh mesh = test::meshOf(places());
    const BladeField blade = anyBlade(random);
    for (const AirwayTissue tissue : kTissues) {
        const TriangleMesh moved = deformed(mesh, blade, tissue);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const Vec3 p_A = mesh.positions[i].cast<double>();
            const DisplacementAt<double> pull = bladePull<double>(blade.frame(), tissue, p_A);
            QVERIFY((moved.positions[i].cast<double>() - p_A - pull.d).norm()
                    < kPositionTolerance_m);
            // Normals go with the inverse transpose.
            const Mat3 j = Mat3::Identity() + pull.gradient;
            const Vec3 normal =
                (j.inverse().transpose() * mesh.normals[i].cast<double>()).normalized();
            const double cosine = normal.dot(moved.normals[i].cast<double>());
            QVERIFY(cosine > std::cos(degrees(kNormalTolerance_deg).si));
        }
    }
}

CARINA_TEST(TestBladeField)

} // namespace carina::blade_field_test

#include "tst_blade_field.moc"
