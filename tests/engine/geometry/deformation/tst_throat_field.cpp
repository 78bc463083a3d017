#include "engine/core/units.h"
#include "engine/geometry/deformation/throat_field.h"
#include "engine/geometry/rotation.h"
#include "tests/engine/geometry/mesh/mesh_of_places.h"
#include "tests/support/test_class.h"
#include "tests/support/throat_motion.h"

#include <Eigen/LU>

#include <random>

namespace carina::throat_field_test
{
namespace
{

/// Of the man whose surfaces are published (BodyParts3D), in A.
const Vec3 kGlottis{-0.0015, -0.029, 0.119};
const Vec3 kIncisors{-0.001, -0.101, 0.167};
const Vec3 kHyoid{0.0, -0.047, 0.145}; ///< the middle of its body in front
const Vec3 kCondyles = kIncisors + Vec3{0.0, 0.087, 0.045};

constexpr double kStep_m = 1e-5;
/// Central differences err by the step at the seams, where the second derivative jumps.
constexpr double kSlopeTolerance = 2e-3;
constexpr double kNormalTolerance_deg = 0.5;
constexpr double kPositionTolerance_m = 5e-8; ///< single precision within a quarter metre
constexpr double kLeastDeterminant = 0.2;

const std::array kTissues{ThroatTissue::Airway, ThroatTissue::Pharynx};

ThroatField throat() { return {Vec3::Zero(), kGlottis, kIncisors}; }

/// The mouth opened about both condyles, which slide.
RigidTransform opened(double angle_deg, const Vec3& slide_mm)
{
    return RigidTransform::translation(kCondyles + 1e-3 * slide_mm)
           * RigidTransform{rotationFromVector(degrees(angle_deg).si * Vec3::UnitX()), Vec3::Zero()}
           * RigidTransform::translation(-kCondyles);
}

/// What jaws do: they open the incisors by 45 mm (27 degrees) on a fixed hinge, by 30 degrees with
/// condyles that slide, are brought forward, lifted, moved aside or shut a little further.
std::vector<RigidTransform> humanMotions()
{
    std::vector<RigidTransform> motions;
    for (const double angle : {0.0, 10.0, 20.0, 30.0})
        for (const Vec3& slide :
             {Vec3{0, -8, 0}, Vec3{0, -15, 0}, Vec3{0, -15, -5}, Vec3{0, -10, 10}, Vec3{5, -8, 0}})
            motions.push_back(opened(angle, slide));
    for (const double angle : {9.0, 18.0, 27.0})
        motions.push_back(opened(angle, {0.0, 0.0, 0.0}));
    motions.push_back(opened(0.0, {0.0, 5.0, 0.0}));
    motions.push_back(opened(-2.0, {0.0, 0.0, 3.0}));
    return motions;
}

/// Whether a tissue lies there: within the jaw or beside the larynx, and not in the air in front of
/// the neck below the chin.
bool isInThroat(const Vec3& p_A, ThroatTissue tissue)
{
    const bool isAirway = tissue == ThroatTissue::Airway;
    const bool inMouth = p_A.z() > (isAirway ? 0.134 : 0.139);
    const double front = inMouth ? -0.1 : isAirway ? -0.062 : -0.05;
    return p_A.y() > front && std::abs(p_A.x()) < (isAirway ? 0.06 : 0.035);
}

std::vector<Vec3> gridThrough(ThroatTissue tissue, double spacing)
{
    std::vector<Vec3> grid;
    for (double x = -0.06; x <= 0.06; x += spacing)
        for (double y = -0.10; y <= 0.04; y += spacing)
            for (double z = 0.06; z <= 0.24; z += spacing)
                if (isInThroat({x, y, z}, tissue))
                    grid.emplace_back(x, y, z);
    return grid;
}

std::vector<Vec3> places()
{
    std::mt19937 random{5};
    std::uniform_real_distribution<double> x{-0.06, 0.06};
    std::uniform_real_distribution<double> y{-0.11, 0.03};
    std::uniform_real_distribution<double> z{0.05, 0.24};
    std::vector<Vec3> made;
    for (int n = 0; n < 3000; ++n)
        made.emplace_back(x(random), y(random), z(random));
    return made;
}

Vec3 movedTo(const Vec3& p_A, const RigidTransform& X_AJ, ThroatTissue tissue)
{
    return p_A + test::throatAt(throat(), p_A, X_AJ, tissue).d_A;
}

/// The trachea's axis, from the carina to a share of the way to the glottis.
double lengthUpTo(double share, const RigidTransform& X_AJ)
{
    constexpr int kPieces = 500;
    double length = 0.0;
    Vec3 last = movedTo(Vec3::Zero(), X_AJ, ThroatTissue::Airway);
    for (int n = 1; n <= kPieces; ++n) {
        const Vec3 next = movedTo(share * n / kPieces * kGlottis, X_AJ, ThroatTissue::Airway);
        length += (next - last).norm();
        last = next;
    }
    return length;
}

} // namespace

class TestThroatField : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void movesNothingWhileTheMouthIsClosed();
    void movesNothingAtAndBelowTheCarina();
    void goesWithTheJawWhereItIsFixedToIt();
    void leavesSkullAndSpine();
    void takesTheHyoidHalfOfTheWayForward();
    void takesTheHyoidDownAndBackAsTheMouthOpens();
    void stretchesTheUpperTracheaOnly();
    void hasTheSlopesOfItsDisplacement();
    void deformsMeshesAsTheFieldSays();
    void keepsItsOrientationWhereverJawsGo();
    void followsNothingWithoutLandmarks();
};

void TestThroatField::movesNothingWhileTheMouthIsClosed()
{
    TriangleMesh mesh;
    for (const Vec3& p_A : places()) {
        mesh.positions.emplace_back(p_A.cast<float>());
        mesh.normals.emplace_back(Vec3f{1.0F, 2.0F, 3.0F});
        for (const ThroatTissue tissue : kTissues) {
            QCOMPARE(test::throatAt(throat(), p_A, {}, tissue).d_A.norm(), 0.0);
            QCOMPARE(test::throatAt(throat(), p_A, {}, tissue).gradient.norm(), 0.0);
        }
    }
    const TriangleMesh closed = deformed(mesh, {throat(), {}}, ThroatTissue::Airway);
    QVERIFY(closed.positions == mesh.positions && closed.normals == mesh.normals);
}

void TestThroatField::movesNothingAtAndBelowTheCarina()
{
    const RigidTransform X_AJ = opened(30.0, {0.0, -15.0, 0.0});
    for (Vec3 p_A : places()) {
        p_A.z() -= 0.24; // at most at the carina's height
        for (const ThroatTissue tissue : kTissues)
            QCOMPARE(test::throatAt(throat(), p_A, X_AJ, tissue).d_A.norm(), 0.0);
    }
    QCOMPARE(test::throatShare(throat(), 0.6 * kGlottis, ThroatTissue::Airway), 0.0);
    QVERIFY(test::throatShare(throat(), 0.9 * kGlottis, ThroatTissue::Airway)
            > 0.03); // the trachea's upper end
}

void TestThroatField::goesWithTheJawWhereItIsFixedToIt()
{
    for (const Vec3& p_A :
         {Vec3{0.0, -0.097, 0.160}, Vec3{0.010, -0.090, 0.168}, Vec3{-0.020, -0.080, 0.165}})
        for (const RigidTransform& X_AJ : humanMotions())
            QVERIFY((movedTo(p_A, X_AJ, ThroatTissue::Airway) - X_AJ * p_A).norm() < 1e-12);
    // What lies along the inner face of the jaw, as far back as its last molars.
    constexpr double kGap_mm = 4.0;
    for (const Vec3& p_A : {Vec3{0.0, -0.084, 0.152}, Vec3{0.020, -0.066, 0.165},
                            Vec3{-0.022, -0.055, 0.165}, Vec3{0.026, -0.047, 0.168}})
        for (const RigidTransform& X_AJ :
             {opened(20.0, {0, 0, 0}), opened(0.0, {0, -15, 0}), opened(20.0, {0, -10, -3})})
            QVERIFY(1e3 * (movedTo(p_A, X_AJ, ThroatTissue::Airway) - X_AJ * p_A).norm() < kGap_mm);
}

void TestThroatField::leavesSkullAndSpine()
{
    for (const Vec3& p_A :
         {Vec3{0.0, -0.008, 0.150}, Vec3{0.0, -0.007, 0.200}, Vec3{0.01, 0.0, 0.1},
          Vec3{0.0, -0.06, 0.185}, Vec3{0.0, -0.09, 0.175}, kCondyles})
        QVERIFY(test::throatShare(throat(), p_A, ThroatTissue::Pharynx) < 1e-3);
    for (const Vec3& p_A :
         {Vec3{0.0, 0.021, 0.15}, Vec3{0.05, -0.01, 0.23}, Vec3{0.0, -0.09, 0.23}})
        QVERIFY(test::throatShare(throat(), p_A, ThroatTissue::Airway) < 0.01);
}

// Kuna et al 2008: 5.1 mm of 10.0.
void TestThroatField::takesTheHyoidHalfOfTheWayForward()
{
    constexpr double kTolerance_mm = 0.7;
    const RigidTransform X_AJ = RigidTransform::translation({0.0, -0.010, 0.0});
    const Vec3 moved_mm = 1e3 * test::throatAt(throat(), kHyoid, X_AJ, ThroatTissue::Airway).d_A;
    QVERIFY(std::abs(moved_mm.y() + 5.1) < kTolerance_mm);
    QVERIFY(std::abs(moved_mm.x()) + std::abs(moved_mm.z()) < 1e-9);
}

// Muto and Kanazawa 1994. It stays in front of the spine, which is 38 mm behind.
void TestThroatField::takesTheHyoidDownAndBackAsTheMouthOpens()
{
    for (const double angle : {10.0, 20.0, 30.0}) {
        const RigidTransform X_AJ = opened(angle, {0.0, 0.0, 0.0});
        const Vec3 moved_mm =
            1e3 * test::throatAt(throat(), kHyoid, X_AJ, ThroatTissue::Airway).d_A;
        QVERIFY(moved_mm.z() < -0.25 * angle && moved_mm.y() > 0.0);
        QVERIFY(moved_mm.y() < 0.7 * angle && moved_mm.z() > -0.7 * angle);
    }
}

// Wong et al 2008: 82 of 136 mm from carina to cords keep their length.
void TestThroatField::stretchesTheUpperTracheaOnly()
{
    constexpr double kTolerance_mm = 0.3;
    const Vec3 up = kGlottis.normalized();
    for (const RigidTransform& X_AJ :
         {RigidTransform::translation(0.015 * up), opened(10.0, {0, 0, 0}),
          opened(20.0, {0, -10, -3}), opened(0.0, {0, -10, 10})}) {
        QVERIFY(1e3 * std::abs(lengthUpTo(82.0 / 136.0, X_AJ) - lengthUpTo(82.0 / 136.0, {}))
                < 0.01);
        const double longer_mm = 1e3 * (lengthUpTo(1.0, X_AJ) - lengthUpTo(1.0, {}));
        const Vec3 moved_mm =
            1e3 * test::throatAt(throat(), kGlottis, X_AJ, ThroatTissue::Airway).d_A;
        QVERIFY(std::abs(longer_mm - moved_mm.dot(up)) < kTolerance_mm);
    }
    QVERIFY(lengthUpTo(1.0, RigidTransform::translation(0.015 * up)) > lengthUpTo(1.0, {}) + 0.002);
}

void TestThroatField::hasTheSlopesOfItsDisplacement()
{
    const RigidTransform X_AJ = opened(25.0, {4.0, -8.0, 3.0});
    for (const ThroatTissue tissue : kTissues) {
        for (const Vec3& p_A : places()) {
            const Mat3 gradient = test::throatAt(throat(), p_A, X_AJ, tissue).gradient;
            for (int axis = 0; axis < 3; ++axis) {
                const Vec3 step = kStep_m * Vec3::Unit(axis);
                const Vec3 slope = (test::throatAt(throat(), p_A + step, X_AJ, tissue).d_A
                                    - test::throatAt(throat(), p_A - step, X_AJ, tissue).d_A)
                                   / (2.0 * kStep_m);
                QVERIFY((slope - gradient.col(axis)).cwiseAbs().maxCoeff() < kSlopeTolerance);
            }
        }
    }
}

void TestThroatField::deformsMeshesAsTheFieldSays()
{
    const TriangleMesh mesh = test::meshOf(places());
    const RigidTransform X_AJ = opened(20.0, {2.0, -6.0, 0.0});
    for (const ThroatTissue tissue : kTissues) {
        const TriangleMesh moved = deformed(mesh, {throat(), X_AJ}, tissue);
        QCOMPARE(moved.triangles, mesh.triangles);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const Vec3 p_A = mesh.positions[i].cast<double>();
            if (!isInThroat(p_A, tissue))
                continue;
            const Vec3 n = mesh.normals[i].cast<double>();
            const Vec3 s = n.unitOrthogonal();
            const Vec3 t = n.cross(s);
            const auto along = [&](const Vec3& d) {
                return Vec3{movedTo(p_A + kStep_m * d, X_AJ, tissue)
                            - movedTo(p_A - kStep_m * d, X_AJ, tissue)};
            };
            const Vec3 expected = along(s).cross(along(t)).normalized();
            const Vec3 drawn = moved.normals[i].cast<double>();
            QVERIFY((moved.positions[i].cast<double>() - movedTo(p_A, X_AJ, tissue)).norm()
                    < kPositionTolerance_m);
            QVERIFY(
                inDegrees(radians(std::atan2(drawn.cross(expected).norm(), drawn.dot(expected))))
                < kNormalTolerance_deg);
        }
    }
}

// On a grid of 2 mm.
void TestThroatField::keepsItsOrientationWhereverJawsGo()
{
    const std::vector<RigidTransform> motions = humanMotions();
    double least = 1.0;
    for (const ThroatTissue tissue : kTissues)
        for (const Vec3& p_A : gridThrough(tissue, 2e-3))
            for (const RigidTransform& X_AJ : motions) {
                const Mat3 j =
                    Mat3::Identity() + test::throatAt(throat(), p_A, X_AJ, tissue).gradient;
                least = std::min(least, j.determinant());
            }
    qInfo("least determinant %.3f", least);
    QVERIFY(least > kLeastDeterminant);
}

void TestThroatField::followsNothingWithoutLandmarks()
{
    for (const ThroatField& none :
         {ThroatField{}, ThroatField{Vec3::Zero(), Vec3::Zero(), kIncisors},
          ThroatField{Vec3::Zero(), kGlottis, kGlottis}})
        for (const Vec3& p_A : places())
            QCOMPARE(
                test::throatAt(none, p_A, opened(20.0, {0, 0, 0}), ThroatTissue::Airway).d_A.norm(),
                0.0);
}

CARINA_TEST(TestThroatField)

} // namespace carina::throat_field_test

#include "tst_throat_field.moc"
