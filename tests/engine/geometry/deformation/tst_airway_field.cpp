#include "engine/geometry/deformation/airway_field.h"
#include "engine/geometry/rotation.h"
#include "tests/engine/geometry/mesh/mesh_of_places.h"
#include "tests/support/deformed_tissue.h"
#include "tests/support/test_class.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace carina::airway_field_test
{
namespace
{

using test::deformed;

constexpr double kStep_m = 1e-8;
/// Of central differences, in shares of 1 + the gradient: second derivatives jump at the seams.
constexpr double kSlopeTolerance = 5e-3;
constexpr double kDeterminantTolerance = 1e-9;
constexpr double kPositionTolerance_m = 2e-7; ///< a few roundings in single precision
constexpr double kLeastOfSwelling = 0.07;
constexpr double kLeastOfOpening = 0.1;

constexpr std::array kTissues{AirwayTissue::LooseTooth, AirwayTissue::Teeth,  AirwayTissue::Skin,
                              AirwayTissue::Windpipe,   AirwayTissue::Throat, AirwayTissue::Pharynx,
                              AirwayTissue::Larynx};

std::vector<Vec3> places()
{
    std::mt19937 random{5};
    std::uniform_real_distribution<double> along{-0.04, 0.04};
    std::vector<Vec3> made;
    for (int n = 0; n < 400; ++n)
        made.emplace_back(along(random), along(random), along(random));
    return made;
}

/// Any swelling near the places that is as large as may be.
Swelling anySwelling(std::mt19937& random)
{
    std::uniform_real_distribution<double> share{0.0, 1.0};
    std::normal_distribution<double> number;
    const auto any = [&] { return Vec3{number(random), number(random), number(random)}; };
    Swelling made{.p_A_centre = 0.01 * any(),
                  .axis_A = any().normalized(),
                  .across = metres(0.01 + 0.03 * share(random)),
                  .along = metres(0.01 + 0.03 * share(random)),
                  .depth = metres(0.0005 + 0.005 * share(random)),
                  .isFlat = share(random) < 0.5,
                  .tissues = AirwayTissues(1.0 + double(kAllAirwayTissues) * share(random))};
    const double most = 0.999 * AirwayField::kMostOfReach * std::min(made.across.si, made.along.si);
    made.outward = metres(share(random) * most);
    made.shift_A = (most - made.outward.si) * any().normalized();
    return made;
}

Lumen anyLumen(std::mt19937& random)
{
    std::uniform_real_distribution<double> share{0.0, 1.0};
    std::normal_distribution<double> number;
    const Mat3 turned =
        rotationFromVector(Vec3{number(random), number(random), number(random)}).toRotationMatrix();
    const double front = 0.0005 + 0.003 * share(random);
    return {.p_A_front = 0.01 * Vec3{number(random), number(random), number(random)},
            .right_A = turned.col(0),
            .back_A = turned.col(1),
            .up_A = turned.col(2),
            .toWidest = metres(0.008 + 0.02 * share(random)),
            .halfInFront = metres(front),
            .halfAtWidest = metres(front + 0.005 * share(random)),
            .outer = 2.0 + share(random)};
}

/// Everything at once.
AirwayField anyField(std::mt19937& random)
{
    std::uniform_real_distribution<double> share{0.0, 1.0};
    AirwayField field;
    for (std::size_t n = 0; n < kMostSwellings; ++n)
        field.swell(anySwelling(random));
    field.closeCords(anyLumen(random), -0.3 + 1.2 * share(random));
    field.joinCords(anyLumen(random), 0.9 * share(random));
    field.narrowVestibule(anyLumen(random), 0.6 * share(random));
    field.narrowPharynx(anyLumen(random), 0.6 * share(random));
    field.narrowWindpipe(anyLumen(random), 0.8 * share(random));
    field.flattenWindpipe(anyLumen(random), 0.8 * share(random));
    return field;
}

double determinantOf(const Mat3& gradient) { return (Mat3::Identity() + gradient).determinant(); }

/// A man's glottis: from 0.5 to 4.5 mm to either side.
Lumen glottis()
{
    return {.p_A_front = {0.001, -0.0145, 0.0},
            .toWidest = millimetres(14.7),
            .halfInFront = millimetres(0.45),
            .halfAtWidest = millimetres(5.15)};
}

} // namespace

class TestAirwayField : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void movesNothingWithoutAChange();
    void swellsOutwardWithinItsReach();
    void swellsAFlatPartToBothSides();
    void swellsOnlyTheTissueAskedFor();
    void shutsTheCordsFromFrontToBack();
    void leavesTheMidplaneAndTheCommissure();
    void leavesWhatIsBeyondTheLumen();
    void opensTheCordsAlike();
    void joinsWhatTheBreathLeavesOpen();
    void movesTheLarynxAloneWithTheCords();
    void narrowsTheWindpipeToBothSidesAndFrontToBack();
    void movesTheWindpipeAloneWithItsNarrowing();
    void foldsNowhereInAnySwelling();
    void foldsNowhereInAnyNarrowing();
    void foldsNowhereWithAllAtOnce();
    void hasTheSlopesOfItsDisplacement();
    void deformsMeshesAsTheFieldSays();
    void colorsWithinItsReach();
    void mixesColorsOneOverTheOther();
    void colorsOnlyTheTissueAskedFor();
};

void TestAirwayField::movesNothingWithoutAChange()
{
    const TriangleMesh mesh = test::meshOf(places());
    AirwayField open;
    open.closeCords(glottis(), 0.0);
    for (const AirwayField& field : {AirwayField{}, open}) {
        QVERIFY(!field.isThere());
        for (const AirwayTissue tissue : kTissues) {
            for (const Vec3& p_A : places()) {
                const DisplacementAt<double> pull = airwayPull<double>(field.frame(), tissue, p_A);
                QCOMPARE(pull.d.norm(), 0.0);
                QCOMPARE(pull.gradient.norm(), 0.0);
            }
            QVERIFY(deformed(mesh, field, tissue).positions == mesh.positions);
        }
    }
}

// Away from the centre, nowhere farther than asked for, and not at all on the spheroid.
void TestAirwayField::swellsOutwardWithinItsReach()
{
    AirwayField field;
    field.swell(
        {.across = millimetres(20.0), .along = millimetres(30.0), .outward = millimetres(6.0)});
    const SwellingFrame<double>& frame = field.frame().swellings.front();
    for (const Vec3& p_A : places()) {
        const Vec3 d = swellingPull<double>(frame, p_A).d;
        QVERIFY(d.norm() <= 0.006 && d.dot(p_A) >= 0.0);
        QVERIFY(d.cross(p_A).norm() < 1e-15);
    }
    QCOMPARE(swellingPull<double>(frame, {0.0, 0.0201, 0.0}).d.norm(), 0.0);
    QCOMPARE(swellingPull<double>(frame, {0.0, 0.0, -0.0301}).d.norm(), 0.0);
    // Depth 2 mm: at 2 mm from the centre by 1 / sqrt 2 of it, but for the profile.
    const double profile = (1.0 - 1.0 / 100.0) * (1.0 - 1.0 / 100.0);
    const double there = swellingPull<double>(frame, {0.002, 0.0, 0.0}).d.x();
    QVERIFY(std::abs(there - 0.006 * profile / std::sqrt(2.0)) < 1e-12);
}

void TestAirwayField::swellsAFlatPartToBothSides()
{
    AirwayField field;
    field.swell({.axis_A = Vec3::UnitY(),
                 .across = millimetres(20.0),
                 .along = millimetres(15.0),
                 .outward = millimetres(6.0),
                 .depth = millimetres(1.0),
                 .isFlat = true});
    const auto moved = [&](const Vec3& p_A) {
        return swellingPull<double>(field.frame().swellings.front(), p_A).d;
    };
    for (const double x : {0.0, 0.005, -0.01}) {
        const Vec3 behind = moved({x, 0.002, 0.004});
        const Vec3 before = moved({x, -0.002, 0.004});
        QVERIFY(behind.y() > 0.002 && (behind + before).norm() < 1e-15);
        QCOMPARE(behind.x(), 0.0);
        QCOMPARE(behind.z(), 0.0);
        QCOMPARE(moved({x, 0.0, 0.004}).norm(), 0.0);
    }
}

void TestAirwayField::swellsOnlyTheTissueAskedFor()
{
    AirwayField field;
    field.swell(
        {.across = millimetres(20.0),
         .along = millimetres(20.0),
         .shift_A = {0.0, 0.0, 0.005},
         .tissues = AirwayTissues(only(AirwayTissue::Throat) | only(AirwayTissue::Larynx))});
    const auto moved = [&](AirwayTissue tissue) {
        return airwayPull<double>(field.frame(), tissue, Vec3::Zero()).d.z();
    };
    QCOMPARE(moved(AirwayTissue::Throat), 0.005);
    QCOMPARE(moved(AirwayTissue::Larynx), 0.005);
    QCOMPARE(moved(AirwayTissue::Pharynx), 0.0);
}

// A V from 0.5 to 4.5 mm at the vocal processes, and as wide from there to the notch: what is left
// is 2 % of it, where the narrowing is whole.
void TestAirwayField::shutsTheCordsFromFrontToBack()
{
    AirwayField field;
    field.closeCords(glottis(), AirwayField::kMostClosing);
    for (double share = 0.15; share < 1.65; share += 0.05) {
        const double half = 0.0005 + 0.004 * std::min(share, 1.0);
        for (const double side : {-1.0, 1.0})
            for (const double height : {-0.002, 0.0, 0.002}) {
                const Vec3 cord{0.001 + side * half, -0.0145 + 0.0147 * share, height};
                const Vec3 shut =
                    cord + airwayPull<double>(field.frame(), AirwayTissue::Larynx, cord).d;
                QVERIFY(std::abs(shut.x() - 0.001) < 0.021 * half);
                QVERIFY((shut.x() - 0.001) * side > 0.0);
            }
    }
}

void TestAirwayField::leavesTheMidplaneAndTheCommissure()
{
    for (const double closing : {-0.3, 0.3, AirwayField::kMostClosing}) {
        AirwayField field;
        field.closeCords(glottis(), closing);
        const auto moved = [&](const Vec3& p_A) {
            return airwayPull<double>(field.frame(), AirwayTissue::Larynx, p_A).d.norm();
        };
        for (const Vec3& p_A : places())
            QCOMPARE(moved({0.001, p_A.y(), p_A.z()}), 0.0);
        for (const double x : {-0.004, -0.0005, 0.0015, 0.006})
            QCOMPARE(moved({x, -0.0146, 0.0}), 0.0);
    }
}

void TestAirwayField::leavesWhatIsBeyondTheLumen()
{
    AirwayField field;
    field.closeCords(glottis(), AirwayField::kMostClosing);
    const auto moved = [&](const Vec3& p_A) {
        return airwayPull<double>(field.frame(), AirwayTissue::Larynx, p_A).d.norm();
    };
    QVERIFY(moved({0.005, 0.0, 0.0}) > 0.0);
    QCOMPARE(moved({0.001 + 2.401 * 0.00515, 0.01, 0.0}), 0.0);
    QCOMPARE(moved({0.005, -0.0145 + 2.21 * 0.0147, 0.0}), 0.0);
    QCOMPARE(moved({0.005, 0.0, 1.16 * 0.0147}), 0.0);
    QCOMPARE(moved({0.005, 0.0, -0.81 * 0.0147}), 0.0);
}

void TestAirwayField::opensTheCordsAlike()
{
    AirwayField field;
    field.closeCords(glottis(), -0.2);
    for (const double x : {-0.003, 0.004}) {
        const Vec3 cord{0.001 + x, 0.0, 0.001};
        const double d = airwayPull<double>(field.frame(), AirwayTissue::Larynx, cord).d.x();
        QVERIFY(std::abs(d - 0.2 * x) < 1e-12);
    }
}

// A web over the front third of cords that are half shut: 2 % of that half in front, behind it all.
void TestAirwayField::joinsWhatTheBreathLeavesOpen()
{
    Lumen front = glottis();
    front.toWidest = millimetres(24.5 / 6.0);
    AirwayField field;
    field.closeCords(glottis(), 0.5);
    field.joinCords(front, AirwayField::kMostClosing);
    const auto left = [&](double behind) {
        const double half = 0.0005 + 0.004 * behind / 0.0147;
        const Vec3 cord{0.001 + half, -0.0145 + behind, 0.0};
        const double d = airwayPull<double>(field.frame(), AirwayTissue::Larynx, cord).d.x();
        return (half + d) / half;
    };
    for (const double behind : {0.003, 0.005, 0.0065})
        QVERIFY(std::abs(left(behind) - 0.5 * 0.02) < 1e-3);
    for (const double behind : {0.0095, 0.012, 0.014})
        QVERIFY(std::abs(left(behind) - 0.5) < 1e-3);
}

void TestAirwayField::movesTheLarynxAloneWithTheCords()
{
    AirwayField field;
    field.closeCords(glottis(), 0.5);
    field.joinCords(glottis(), 0.5);
    for (const Vec3& p_A : places())
        for (const AirwayTissue tissue : kTissues)
            if (tissue != AirwayTissue::Larynx)
                QCOMPARE(airwayPull<double>(field.frame(), tissue, p_A).d.norm(), 0.0);
}

// A round windpipe about the z axis: by 60 % in both directions, within its whole part.
void TestAirwayField::narrowsTheWindpipeToBothSidesAndFrontToBack()
{
    AirwayField field;
    field.narrowWindpipe({.p_A_front = {0.0, -0.013, 0.0},
                          .toWidest = millimetres(15.0),
                          .halfInFront = millimetres(10.0),
                          .halfAtWidest = millimetres(10.0)},
                         0.6);
    field.flattenWindpipe({.p_A_front = {0.013, 0.0, 0.0},
                           .right_A = -Vec3::UnitY(),
                           .back_A = -Vec3::UnitX(),
                           .toWidest = millimetres(15.0),
                           .halfInFront = millimetres(10.0),
                           .halfAtWidest = millimetres(10.0)},
                          0.6);
    for (double turn = 0.0; turn < 6.28; turn += 0.3)
        for (const double height : {-0.002, 0.0, 0.002}) {
            const Vec3 wall{0.0095 * std::cos(turn), 0.0095 * std::sin(turn), height};
            const Vec3 moved =
                wall + airwayPull<double>(field.frame(), AirwayTissue::Windpipe, wall).d;
            QVERIFY((moved - Vec3{0.4 * wall.x(), 0.4 * wall.y(), height}).norm() < 1e-12);
        }
    const Vec3 above{0.0095, 0.0, 1.16 * 0.015};
    QCOMPARE(airwayPull<double>(field.frame(), AirwayTissue::Windpipe, above).d.norm(), 0.0);
}

void TestAirwayField::movesTheWindpipeAloneWithItsNarrowing()
{
    AirwayField field;
    field.narrowWindpipe(glottis(), 0.5);
    field.flattenWindpipe(glottis(), 0.5);
    AirwayField throat;
    throat.narrowVestibule(glottis(), 0.5);
    throat.narrowPharynx(glottis(), 0.5);
    for (const Vec3& p_A : places())
        for (const AirwayTissue tissue : kTissues) {
            const bool isOfThroat = (kThroatTissues & only(tissue)) != 0;
            if (tissue != AirwayTissue::Windpipe)
                QCOMPARE(airwayPull<double>(field.frame(), tissue, p_A).d.norm(), 0.0);
            if (!isOfThroat)
                QCOMPARE(airwayPull<double>(throat.frame(), tissue, p_A).d.norm(), 0.0);
        }
}

void TestAirwayField::foldsNowhereInAnySwelling()
{
    std::mt19937 random{7};
    for (int n = 0; n < 400; ++n) {
        AirwayField field;
        field.swell(anySwelling(random));
        for (const Vec3& p_A : places()) {
            const auto& frame = field.frame().swellings.front();
            QVERIFY(determinantOf(swellingPull<double>(frame, p_A).gradient) > kLeastOfSwelling);
        }
    }
}

void TestAirwayField::foldsNowhereInAnyNarrowing()
{
    std::mt19937 random{17};
    std::uniform_real_distribution<double> any{-AirwayField::kMostOpening,
                                               AirwayField::kMostClosing};
    for (int n = 0; n < 400; ++n) {
        const double closing = any(random);
        AirwayField field;
        field.closeCords(anyLumen(random), closing);
        const double least = closing > 0.0 ? 1.0 - closing : kLeastOfOpening;
        for (const Vec3& p_A : places())
            QVERIFY(determinantOf(narrowingPull<double>(field.frame().cords, p_A).gradient)
                    >= least - kDeterminantTolerance);
    }
}

void TestAirwayField::foldsNowhereWithAllAtOnce()
{
    std::mt19937 random{19};
    for (int n = 0; n < 200; ++n) {
        const AirwayFrame<double> frame = anyField(random).frame();
        for (const AirwayTissue tissue : kTissues)
            for (const Vec3& p_A : places())
                QVERIFY(determinantOf(airwayPull<double>(frame, tissue, p_A).gradient) > 0.0);
    }
}

void TestAirwayField::hasTheSlopesOfItsDisplacement()
{
    std::mt19937 random{9};
    for (int n = 0; n < 20; ++n) {
        const AirwayFrame<double> frame = anyField(random).frame();
        for (const AirwayTissue tissue : kTissues)
            for (const Vec3& p_A : places()) {
                const Mat3 gradient = airwayPull<double>(frame, tissue, p_A).gradient;
                const double tolerance = kSlopeTolerance * (1.0 + gradient.cwiseAbs().maxCoeff());
                for (int axis = 0; axis < 3; ++axis) {
                    const Vec3 step = kStep_m * Vec3::Unit(axis);
                    const Vec3 slope = (airwayPull<double>(frame, tissue, p_A + step).d
                                        - airwayPull<double>(frame, tissue, p_A - step).d)
                                       / (2.0 * kStep_m);
                    QVERIFY((slope - gradient.col(axis)).cwiseAbs().maxCoeff() < tolerance);
                }
            }
    }
}

// Normals are turned by the gradient, which is held against differences above.
void TestAirwayField::deformsMeshesAsTheFieldSays()
{
    AirwayField field;
    field.swell({.p_A_centre = {0.0, 0.02, 0.01},
                 .across = millimetres(20.0),
                 .along = millimetres(25.0),
                 .outward = millimetres(4.0),
                 .shift_A = {0.002, 0.0, 0.003}});
    field.closeCords(glottis(), 0.7);
    const TriangleMesh mesh = test::meshOf(places());
    for (const AirwayTissue tissue : kTissues) {
        const TriangleMesh moved = deformed(mesh, field, tissue);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const Vec3 p_A = mesh.positions[i].cast<double>();
            const DisplacementAt<double> pull = airwayPull<double>(field.frame(), tissue, p_A);
            QVERIFY((moved.positions[i].cast<double>() - p_A - pull.d).norm()
                    < kPositionTolerance_m);
            const Mat3 j = Mat3::Identity() + pull.gradient;
            const Vec3 normal =
                (j.inverse().transpose() * mesh.normals[i].cast<double>()).normalized();
            const double cosine = normal.dot(moved.normals[i].cast<double>());
            QVERIFY(cosine > std::cos(degrees(0.5).si));
        }
    }
}

// Whole up to the root of a half of the reach, a half where u^2 is three quarters, nothing from the
// reach on; the spheroid is longer along its axis.
void TestAirwayField::colorsWithinItsReach()
{
    AirwayField field;
    field.tint({.p_A_centre = {0.0, 0.01, 0.0},
                .axis_A = Vec3::UnitX(),
                .across = millimetres(20.0),
                .along = millimetres(40.0),
                .color = {255, 0, 0},
                .share = 0.6});
    QVERIFY(field.isThere());
    const TintFrame<double>& frame = field.frame().tints.front();
    for (const auto& [dir_A, reach_m] :
         {std::pair{Vec3{Vec3::UnitX()}, 0.04}, std::pair{Vec3{Vec3::UnitZ()}, 0.02}})
        for (const auto& [u2, share] :
             {std::pair{0.0, 0.6}, std::pair{0.49, 0.6}, std::pair{0.75, 0.3}, std::pair{1.0, 0.0},
              std::pair{4.0, 0.0}}) {
            const Vec3 p_A = Vec3{0.0, 0.01, 0.0} + std::sqrt(u2) * reach_m * dir_A;
            QVERIFY(std::abs(tintShare(frame, p_A) - share) < 1e-9);
        }
    for (const AirwayTissue tissue : kTissues)
        for (const Vec3& p_A : places())
            QCOMPARE(airwayPull<double>(field.frame(), tissue, p_A).d.norm(), 0.0);
}

void TestAirwayField::mixesColorsOneOverTheOther()
{
    AirwayField field;
    for (const Rgb& color : {Rgb{255, 0, 0}, Rgb{0, 0, 255}})
        field.tint({.across = millimetres(20.0),
                    .along = millimetres(20.0),
                    .color = color,
                    .share = 0.5});
    const Vec3 own{0.2, 0.4, 0.6};
    const Vec3 light = airwayLight<double>(field.frame(), AirwayTissue::Throat, Vec3::Zero(), own);
    QVERIFY((light - Vec3{0.25 * 0.2 + 0.25, 0.25 * 0.4, 0.25 * 0.6 + 0.5}).norm() < 1e-12);
    const Vec3 beyond =
        airwayLight<double>(field.frame(), AirwayTissue::Throat, {0.0, 0.03, 0.0}, own);
    QCOMPARE((beyond - own).norm(), 0.0);
}

void TestAirwayField::colorsOnlyTheTissueAskedFor()
{
    const Vec3 own{0.2, 0.4, 0.6};
    for (const AirwayTissue asked : kTissues) {
        AirwayField field;
        field.tint({.across = millimetres(20.0),
                    .along = millimetres(20.0),
                    .color = {0, 0, 0},
                    .tissues = only(asked)});
        for (const AirwayTissue tissue : kTissues) {
            const Vec3 light = airwayLight<double>(field.frame(), tissue, Vec3::Zero(), own);
            QCOMPARE(light.norm(), tissue == asked ? 0.0 : own.norm());
        }
    }
}

CARINA_TEST(TestAirwayField)

} // namespace carina::airway_field_test

#include "tst_airway_field.moc"
