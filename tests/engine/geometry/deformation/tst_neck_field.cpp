#include "engine/geometry/deformation/throat_field.h"
#include "engine/geometry/rotation.h"
#include "tests/engine/geometry/mesh/mesh_of_places.h"
#include "tests/support/test_class.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <random>

namespace carina::neck_field_test
{
namespace
{

constexpr double kSame_m = 1e-12;
constexpr double kStep_m = 1e-6;
constexpr double kSlopeTolerance = 1e-3; ///< of central differences, at the seams of the steps
constexpr double kDeterminantTolerance = 5e-4; ///< likewise
constexpr double kPositionTolerance_m = 3e-7;  ///< single precision within a quarter metre
constexpr double kNormalTolerance_deg = 0.5;

/// A patient, and a position of their head.
struct Person {
    Vec3 p_A_glottis{0.0, -0.026, 0.124};
    Vec3 p_A_incisors{0.0, -0.099, 0.173};
    HeadPosition position = kSniffing;

    [[nodiscard]] NeckField neck() const { return {p_A_glottis, p_A_incisors, position}; }
    [[nodiscard]] double length() const { return (p_A_incisors - p_A_glottis).norm(); }
};

Person anyPerson(std::mt19937& random)
{
    std::uniform_real_distribution<double> share{0.0, 1.0};
    const auto between = [&](double from, double to) { return from + (to - from) * share(random); };
    const double length = between(0.05, 0.11);
    const double rise = between(0.15, 0.6);
    Person person;
    person.p_A_glottis = {between(-0.01, 0.01), between(-0.05, 0.0), between(0.06, 0.16)};
    person.p_A_incisors = person.p_A_glottis + length * Vec3{0.0, -std::cos(rise), std::sin(rise)};
    const Angle flexion = radians(between(kLeastFlexion.si, kMostFlexion.si));
    person.position = withinReach(
        {flexion, radians(between(kLeastExtension.si, kMostExtension.si))}, metres(length));
    return person;
}

/// The sagittal plane as complex numbers, y + i z: a turn about +x is a factor.
using Sagittal = std::complex<double>;

Sagittal sagittal(const Vec3& p) { return {p.y(), p.z()}; }

double smoothStep(double t)
{
    const double within = std::clamp(t, 0.0, 1.0);
    return 3.0 * within * within - 2.0 * within * within * within;
}

/// The bends as the documentation has them, written out anew.
Sagittal plainHinge(const Person& person, bool isFlexion)
{
    return isFlexion ? sagittal(person.p_A_glottis) + person.length() * Sagittal{0.25, -0.30}
                     : sagittal(person.p_A_incisors) + person.length() * Sagittal{1.23, 0.31};
}

double plainShare(const Person& person, bool isFlexion, Sagittal p)
{
    const Sagittal from =
        (p - (isFlexion ? sagittal(person.p_A_glottis) : plainHinge(person, false)))
        / person.length();
    if (isFlexion) {
        const double lean = degrees(20.0).si;
        return smoothStep((from.imag() * std::cos(lean) - from.real() * std::sin(lean) + 0.84)
                          / 0.92);
    }
    const double y = from.real();
    const double roof = from.imag() - 0.35 * y + 0.75 * std::hypot(y, 0.17);
    return smoothStep((roof + 0.525) / 0.855);
}

Sagittal plainBend(const Person& person, bool isFlexion, Sagittal p)
{
    const double angle = isFlexion ? person.position.flexion.si : -person.position.extension.si;
    const Sagittal hinge = plainHinge(person, isFlexion);
    return hinge + std::polar(1.0, angle * plainShare(person, isFlexion, p)) * (p - hinge);
}

/// The area that a small square takes, by central differences.
double plainDeterminant(const Person& person, bool isFlexion, Sagittal p)
{
    const auto along = [&](Sagittal step) {
        return (plainBend(person, isFlexion, p + step) - plainBend(person, isFlexion, p - step))
               / (2.0 * kStep_m);
    };
    const Sagittal y = along({kStep_m, 0.0});
    const Sagittal z = along({0.0, kStep_m});
    return y.real() * z.imag() - y.imag() * z.real();
}

/// Whether a place is within the reach of a bend.
bool isReached(const Person& person, bool isFlexion, Sagittal p)
{
    const Sagittal from = (p - plainHinge(person, isFlexion)) / person.length();
    if (!isFlexion)
        return from.real() >= -1.0 && from.real() <= 0.75;
    const double lean = degrees(20.0).si;
    const double behind = from.real() * std::cos(lean) + from.imag() * std::sin(lean);
    return behind >= -0.8 && behind <= 1.0;
}

std::vector<Vec3> places(std::mt19937& random)
{
    std::uniform_real_distribution<double> along{-0.15, 0.15};
    std::vector<Vec3> made;
    for (int n = 0; n < 300; ++n)
        made.emplace_back(along(random), along(random), 0.11 + along(random));
    return made;
}

} // namespace

class TestNeckField : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void leavesTheNeutralPosition();
    void bendsAsIsDocumented();
    void turnsTheHeadRigidly();
    void leavesTheTrunk();
    void leavesTheLarynxWithTheNeck();
    void takesTheNearestPositionInReach();
    void extendsAFlexedNeckLess();
    void flexesAnInfantsNeckLess();
    void foldsNowhereWithinReach();
    void hasTheSlopesOfItsDisplacement();
    void hasTheJawFollowInTheHead();
    void bendsABodyThatGoesWithTheHead();
    void deformsMeshesAsTheFieldSays();
};

void TestNeckField::leavesTheNeutralPosition()
{
    std::mt19937 random{1};
    const Person person{.position = {}};
    const std::vector<Vec3> all = places(random);
    const TriangleMesh mesh = test::meshOf(all);
    // Landmarks that are not there move nothing either.
    for (const NeckField& neck :
         {NeckField{}, person.neck(), NeckField{Vec3::Zero(), Vec3::Zero(), kSniffing}}) {
        QVERIFY(!neck.isBent());
        QVERIFY(neck.position() == HeadPosition{});
        QVERIFY(neck.X_AU().matrix() == Mat4::Identity());
        for (const Vec3& p_A : all) {
            QVERIFY(neck.placed(p_A) == p_A);
            QCOMPARE(neck.turnAt(p_A).si, 0.0);
        }
        QVERIFY(deformed(mesh, neck).positions == mesh.positions);
    }
}

void TestNeckField::bendsAsIsDocumented()
{
    std::mt19937 random{2};
    for (int n = 0; n < 50; ++n) {
        const Person person = anyPerson(random);
        const NeckField neck = person.neck();
        for (const Vec3& p_A : places(random)) {
            const Sagittal plain = plainBend(person, true, plainBend(person, false, sagittal(p_A)));
            const Vec3 moved = neck.placed(p_A);
            QCOMPARE(moved.x(), p_A.x());
            QVERIFY(std::abs(sagittal(moved) - plain) < kSame_m);
        }
    }
}

// Incisors, chin, palate, occiput and crown.
void TestNeckField::turnsTheHeadRigidly()
{
    const Person person;
    const NeckField neck = person.neck();
    const double turn = kSniffing.flexion.si - kSniffing.extension.si;
    QVERIFY((rotationVector(neck.X_AU().rotation()) - turn * Vec3::UnitX()).norm() < 1e-12);
    for (const Vec3& from : {Vec3{0.0, 0.0, 0.0}, Vec3{0.01, 0.01, -0.035}, Vec3{0.0, 0.05, 0.01},
                             Vec3{0.05, 0.19, 0.035}, Vec3{0.0, 0.1, 0.15}}) {
        const Vec3 p_A = person.p_A_incisors + from;
        QVERIFY((neck.placed(p_A) - neck.X_AU() * p_A).norm() < kSame_m);
        QVERIFY(std::abs(neck.turnAt(p_A).si - turn) < 1e-12);
    }
}

void TestNeckField::leavesTheTrunk()
{
    const Person person;
    const NeckField neck = person.neck();
    for (const Vec3& p_A : {Vec3{0.0, 0.0, 0.0}, Vec3{0.0, -0.1, -0.02}, Vec3{0.15, 0.05, 0.03},
                            Vec3{0.02, -0.05, 0.02}, Vec3{0.0, 0.02, 0.04}})
        QVERIFY(neck.placed(p_A) == p_A);
}

// Which goes with the neck, and stays where only the head is extended.
void TestNeckField::leavesTheLarynxWithTheNeck()
{
    Person person{.position = {degrees(30.0), {}}};
    QVERIFY(inDegrees(person.neck().turnAt(person.p_A_glottis)) > 27.0);
    person.position = {{}, degrees(20.0)};
    const NeckField extended = person.neck();
    QVERIFY((extended.placed(person.p_A_glottis) - person.p_A_glottis).norm() < 5e-3);
    QVERIFY((extended.placed(person.p_A_incisors) - person.p_A_incisors).norm() > 30e-3);
}

void TestNeckField::takesTheNearestPositionInReach()
{
    QVERIFY(withinReach(kSniffing) == kSniffing);
    QVERIFY(withinReach(kHeadExtended) == kHeadExtended);
    const Person far{.position = {degrees(80.0), degrees(-70.0)}};
    const HeadPosition drawn = far.neck().position();
    QCOMPARE(drawn.flexion, kMostFlexion);
    QCOMPARE(drawn.extension, kLeastExtension);
}

// From 30 degrees evenly down to the 24.2 of the sniffing position at a flexion of 20, and no less
// beyond. Bent back a neck is not limited, and neither is a head that goes down.
void TestNeckField::extendsAFlexedNeckLess()
{
    constexpr double kSame_deg = 1e-9;
    const auto drawn_deg = [](double flexion_deg, double extension_deg) {
        return inDegrees(withinReach({degrees(flexion_deg), degrees(extension_deg)}).extension);
    };
    QVERIFY(withinReach({kMostFlexion, kMostExtension}) == kSniffing);
    QVERIFY(std::abs(drawn_deg(10.0, 30.0) - 27.1) < kSame_deg);
    QVERIFY(std::abs(drawn_deg(10.0, 27.0) - 27.0) < kSame_deg);
    QVERIFY(std::abs(drawn_deg(20.0, 30.0) - 24.2) < kSame_deg);
    QVERIFY(std::abs(drawn_deg(0.0, 30.0) - 30.0) < kSame_deg);
    QVERIFY(std::abs(drawn_deg(-25.0, 30.0) - 30.0) < kSame_deg);
    QVERIFY(std::abs(drawn_deg(35.0, -10.0) + 10.0) < kSame_deg);
    const Person beyond{.position = {kMostFlexion, kMostExtension}};
    QVERIFY(beyond.neck().X_AU().matrix() == Person{}.neck().X_AU().matrix());
}

// By 22 degrees in a newborn; the head is extended as far, and the neck bent back as far.
void TestNeckField::flexesAnInfantsNeckLess()
{
    constexpr double kSame_deg = 1e-9;
    const Length newborn = millimetres(49.7);
    const HeadPosition drawn = withinReach(kSniffing, newborn);
    QVERIFY(std::abs(inDegrees(drawn.flexion) - 35.0 * 49.7 / 79.0) < kSame_deg);
    QCOMPARE(drawn.extension, kSniffing.extension);
    const HeadPosition back{kLeastFlexion, kMostExtension};
    QVERIFY(withinReach(back, newborn) == back);
    QVERIFY(withinReach(kSniffing, kGrownWay) == kSniffing);
    Person infant;
    infant.p_A_incisors = infant.p_A_glottis + 0.0497 * Vec3{0.0, -0.8, 0.6};
    QVERIFY(std::abs(inDegrees(infant.neck().position().flexion) - inDegrees(drawn.flexion))
            < kSame_deg);
}

void TestNeckField::foldsNowhereWithinReach()
{
    std::mt19937 random{7};
    double least = 1.0;
    for (int n = 0; n < 300; ++n) {
        Person person = anyPerson(random);
        if (n % 3 == 0) // the corners of what is drawn
            person.position = withinReach({n % 2 == 0 ? kMostFlexion : kLeastFlexion,
                                           n % 4 == 0 ? kMostExtension : kLeastExtension},
                                          metres(person.length()));
        const NeckFrame<double> frame = person.neck().frame();
        for (const Vec3& p_A : places(random))
            for (const bool isFlexion : {false, true}) {
                if (!isReached(person, isFlexion, sagittal(p_A)))
                    continue;
                const double plain = plainDeterminant(person, isFlexion, sagittal(p_A));
                const auto& bend = isFlexion ? frame.flexion : frame.extension;
                const Mat3 j = Mat3::Identity() + bendPull<double>(bend, p_A).gradient;
                QVERIFY(std::abs(j.determinant() - plain) < kDeterminantTolerance);
                least = std::min(least, plain);
            }
    }
    qInfo("least determinant %.3f", least);
    QVERIFY(least > NeckField::kLeastDeterminant - kDeterminantTolerance);
    QVERIFY(least < 0.35); // the corners were met
}

void TestNeckField::hasTheSlopesOfItsDisplacement()
{
    std::mt19937 random{9};
    for (int n = 0; n < 20; ++n) {
        const NeckField neck = anyPerson(random).neck();
        for (const Vec3& p_A : places(random)) {
            const Mat3 gradient = neckPull<double>(neck.frame(), p_A).gradient;
            for (int axis = 0; axis < 3; ++axis) {
                const Vec3 step = kStep_m * Vec3::Unit(axis);
                const Vec3 slope =
                    (neck.placed(p_A + step) - neck.placed(p_A - step)) / (2.0 * kStep_m)
                    - Vec3::Unit(axis);
                QVERIFY((slope - gradient.col(axis)).cwiseAbs().maxCoeff() < kSlopeTolerance);
            }
        }
    }
}

// What is fixed to the jaw goes where the mandible goes, whose pose is that in the head.
void TestNeckField::hasTheJawFollowInTheHead()
{
    const Person person;
    const RigidTransform X_UJ{rotationFromVector(degrees(15.0).si * Vec3::UnitX()),
                              {0.0, -0.01, 0.004}};
    const FollowingThroat throat{
        {Vec3::Zero(), person.p_A_glottis, person.p_A_incisors}, X_UJ, person.neck()};
    const Vec3 p_A = person.p_A_incisors + Vec3{0.0, 0.004, -0.01};
    const Vec3 bent = throat.neck.placed(p_A);
    const DisplacementAt<double> pull = throatPull(throat, ThroatTissue::Airway, bent);
    QVERIFY((bent + pull.d - throat.neck.X_AU() * (X_UJ * p_A)).norm() < 1e-9);
    const Quat& R = throat.neck.X_AU().rotation();
    const Mat3 turned = (R * X_UJ.rotation() * R.inverse()).toRotationMatrix();
    QVERIFY((Mat3::Identity() + pull.gradient - turned).norm() < 1e-6);
}

/// What goes with the head is seen from there where the neck has taken it; in the head, which is
/// rigid, it stays as it was.
void TestNeckField::bendsABodyThatGoesWithTheHead()
{
    std::mt19937 random{14};
    const NeckField neck = Person{}.neck();
    const RigidTransform X_AF{rotationFromVector({0.4, -0.3, 0.9}), {0.02, -0.15, 0.17}};
    const RigidTransform X_AF_bent = neck.X_AU() * X_AF;
    for (const Vec3& p_A : places(random)) {
        const Vec3 p_F_bent = bentInBody(neck, X_AF, X_AF.inverse() * p_A);
        QVERIFY((X_AF_bent * p_F_bent - neck.placed(p_A)).norm() < kSame_m);
        QVERIFY((outOfNeck(neck, X_AF) * neck.placed(p_A) - p_F_bent).norm() < kSame_m);
        QVERIFY((bentInBody(NeckField{}, X_AF, p_A) - p_A).norm() < kSame_m);
    }
    const Vec3 p_A_inHead = Person{}.p_A_incisors + Vec3{0.0, -0.02, 0.05};
    const Vec3 p_F = X_AF.inverse() * p_A_inHead;
    QVERIFY((bentInBody(neck, X_AF, p_F) - p_F).norm() < kSame_m);
}

void TestNeckField::deformsMeshesAsTheFieldSays()
{
    std::mt19937 random{13};
    const NeckField neck = Person{}.neck();
    const TriangleMesh mesh = test::meshOf(places(random));
    const TriangleMesh moved = deformed(mesh, neck);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vec3 p_A = mesh.positions[i].cast<double>();
        if (!isReached(Person{}, true, sagittal(p_A)) || !isReached(Person{}, false, sagittal(p_A)))
            continue;
        QVERIFY((moved.positions[i].cast<double>() - neck.placed(p_A)).norm()
                < kPositionTolerance_m);
        // Normals go with the inverse transpose.
        const Mat3 j = Mat3::Identity() + neckPull<double>(neck.frame(), p_A).gradient;
        const Vec3 normal = (j.inverse().transpose() * mesh.normals[i].cast<double>()).normalized();
        const double cosine = normal.dot(moved.normals[i].cast<double>());
        QVERIFY(cosine > std::cos(degrees(kNormalTolerance_deg).si));
    }
}

CARINA_TEST(TestNeckField)

} // namespace carina::neck_field_test

#include "tst_neck_field.moc"
