#include "engine/anatomy/airway/centreline.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/anatomy/shapes/tube.h"
#include "engine/geometry/rotation.h"
#include "tests/engine/anatomy/shapes/section.h"
#include "tests/engine/anatomy/shapes/surface_checks.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace carina::tube_test
{

class TestTube : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void outerDiameterFollowsTheMakersList_data();
    void outerDiameterFollowsTheMakersList();
    void findsTheSizeThatIsSoldWithAnOuterDiameter_data();
    void findsTheSizeThatIsSoldWithAnOuterDiameter();
    void liesInTheAirwayWithItsTipAboveTheCarina();
    void connectorFrameLooksOutOfThePatient();
    void everyPieceIsClosedAndFacesOutward();
    void tipIsCutToTheLeft();
    void wallHasTheOuterDiameter();
    void connectorHasFifteenMillimetres();
    void depthMarksStandAtWholeCentimetresFromTheTip();
    void tubeAndCuffStayInsideTheTrachea_data();
    void tubeAndCuffStayInsideTheTrachea();
    void liesInPlaceWhereTheNeckTakesTheAirway();
    void keepsItsLengthInABentNeck();
    void liesInPlaceAsItWasTouched();
    void refusesWhatCannotLieInAnAirway_data();
    void refusesWhatCannotLieInAnAirway();
};

namespace
{

constexpr double kMillimetre = 1e-3;
constexpr double kSame_m = 1e-9;
constexpr double kStretched_m = 0.5e-3; ///< by which a bent neck changes a way, at least
constexpr double kStraight_m = 0.1e-3;  ///< by which a tip that goes straight on may be aside
const Vec3 kIncisors{0.0, -0.14, 0.22};

/// Straight in to the incisors, a quarter circle of 8 cm, straight down to the origin.
std::vector<Vec3> bentPath()
{
    constexpr double kRadius = 0.08;
    constexpr int kArc = 180;
    std::vector<Vec3> path;
    for (double y = -0.24; y < -kRadius - 1e-9; y += 0.002)
        path.emplace_back(0.0, y, 0.22);
    for (int i = 0; i <= kArc; ++i) {
        const double angle = degrees(90.0 * i / kArc).si;
        path.emplace_back(0.0, -kRadius + kRadius * std::sin(angle),
                          0.22 - kRadius + kRadius * std::cos(angle));
    }
    for (double z = 0.138; z > 1e-9; z -= 0.002)
        path.emplace_back(0.0, 0.0, z);
    path.emplace_back(Vec3::Zero());
    return path;
}

/// With a glottis above the middle of that path.
NeckField bentNeck() { return {{0.0, -0.05, 0.16}, kIncisors, kSniffing}; }

TubeShape bentTube() { return makeTube(millimetres(7.0), bentPath(), kIncisors).value(); }

const TriangleMesh& pieceOf(const TubeShape& tube, const std::string& name)
{
    return std::find_if(tube.pieces.begin(), tube.pieces.end(),
                        [&name](const TubePiece& piece) { return piece.name == name; })
        ->mesh;
}

/// How far from the tip along the centreline the nearest place to p lies.
double fromTip(const TubeShape& tube, const Vec3& p_E)
{
    double best = 1.0;
    double along = 0.0;
    double result = 0.0;
    for (std::size_t i = tube.p_E_centre.size() - 1; i > 0; --i) {
        const Vec3 step = tube.p_E_centre[i - 1] - tube.p_E_centre[i];
        const double length = step.norm();
        const double t = std::clamp((p_E - tube.p_E_centre[i]).dot(step) / length, 0.0, length);
        const double off = (p_E - tube.p_E_centre[i] - t / length * step).norm();
        if (off < best) {
            best = off;
            result = along + t;
        }
        along += length;
    }
    return result;
}

} // namespace

void TestTube::outerDiameterFollowsTheMakersList_data()
{
    QTest::addColumn<double>("inner");
    QTest::addColumn<double>("outer");
    QTest::newRow("6.0") << 6.0 << 8.2;
    QTest::newRow("6.5") << 6.5 << 8.9;
    QTest::newRow("7.0") << 7.0 << 9.6;
    QTest::newRow("7.5") << 7.5 << 10.2;
    QTest::newRow("8.0") << 8.0 << 10.9;
    QTest::newRow("between two") << 7.25 << 9.9;
}

void TestTube::outerDiameterFollowsTheMakersList()
{
    QFETCH(double, inner);
    QFETCH(double, outer);
    QVERIFY(std::abs(inMillimetres(outerDiameterOf(millimetres(inner))) - outer) < 1e-9);
}

void TestTube::findsTheSizeThatIsSoldWithAnOuterDiameter_data()
{
    QTest::addColumn<double>("outer");
    QTest::addColumn<double>("inner");
    QTest::newRow("6.0") << 8.2 << 6.0;
    QTest::newRow("7.0") << 9.6 << 7.0;
    QTest::newRow("8.0") << 10.9 << 8.0;
    QTest::newRow("a little thicker than 7.0") << 9.85 << 7.0;
    QTest::newRow("a little thinner than 7.5") << 9.95 << 7.5;
    QTest::newRow("thinner than any") << 1.0 << 2.0;
    QTest::newRow("thicker than any") << 20.0 << 12.0;
}

void TestTube::findsTheSizeThatIsSoldWithAnOuterDiameter()
{
    QFETCH(const double, outer);
    QFETCH(const double, inner);
    QCOMPARE(inMillimetres(soldInnerDiameterOf(millimetres(outer))), inner);
}

void TestTube::liesInTheAirwayWithItsTipAboveTheCarina()
{
    constexpr double kTolerance = 0.1 * kMillimetre;
    const TubeShape tube = bentTube();
    QVERIFY((tube.X_AE * tube.p_E_tip - Vec3{0.0, 0.0, 0.03}).norm() < kTolerance);
    const Vec3 dir_E_tip = (tube.p_E_tip - tube.p_E_centre.end()[-2]).normalized();
    QVERIFY((tube.X_AE.rotation() * dir_E_tip + Vec3::UnitZ()).norm() < 1e-3);
    for (const Vec3& p_E : tube.p_E_centre) {
        const Vec3 p_A = tube.X_AE * p_E;
        const bool straight = p_A.y() < -0.08 || p_A.z() < 0.14;
        const double off = p_A.y() < -0.08 ? std::abs(p_A.z() - 0.22)
                           : p_A.z() < 0.14
                               ? std::abs(p_A.y())
                               : std::abs(std::hypot(p_A.y() + 0.08, p_A.z() - 0.14) - 0.08);
        QVERIFY2(off < kTolerance, straight ? "straight" : "in the bend");
        QVERIFY(std::abs(p_A.x()) < kTolerance);
    }
}

void TestTube::connectorFrameLooksOutOfThePatient()
{
    const TubeShape tube = bentTube();
    const Mat3 R_AE = tube.X_AE.rotation().toRotationMatrix();
    QVERIFY((R_AE.col(0) - Vec3::UnitX()).norm() < 1e-6);
    QVERIFY((R_AE.col(2) + Vec3::UnitY()).norm() < 1e-6);
    // Five centimetres of tube in front of the incisors.
    QVERIFY((tube.X_AE.translation() - kIncisors - Vec3{0.0, -0.05, 0.0}).norm()
            < 1.1 * kMillimetre);
    QVERIFY(tube.p_E_centre.front().norm() < 1e-9);
}

void TestTube::everyPieceIsClosedAndFacesOutward()
{
    const TubeShape tube = bentTube();
    QCOMPARE(tube.pieces.size(), std::size_t{5});
    for (const TubePiece& piece : tube.pieces) {
        QVERIFY2(test::edgesWithoutPartner(piece.mesh) == 0, piece.name.c_str());
        QVERIFY2(signedVolume(piece.mesh) > 0.0, piece.name.c_str());
        QVERIFY2(test::worstNormalLength(piece.mesh) < 1e-5, piece.name.c_str());
    }
}

/// The wall on the right reaches the tip, and that on the left ends 0.8 of a diameter before it, as
/// wide as the rim; its normals are those of the cut.
void TestTube::tipIsCutToTheLeft()
{
    const TubeShape tube = bentTube();
    const TriangleMesh wall = pieceOf(tube, "Tube");
    const Vec3 along = (tube.p_E_tip - tube.p_E_centre.end()[-2]).normalized();
    double right = -1.0;
    double left = -1.0;
    for (const Vec3f& vertex : wall.positions) {
        const Vec3 p = vertex.cast<double>() - tube.p_E_tip;
        if (p.norm() > 0.03)
            continue;
        if (p.x() > 0.7 * 0.5 * tube.outerDiameter.si)
            left = std::max(left, p.dot(along));
        if (p.x() < -0.7 * 0.5 * tube.outerDiameter.si)
            right = std::max(right, p.dot(along));
    }
    // The rim is drawn in to 0.8 of the radius.
    QVERIFY(std::abs(right) < 0.3 * kMillimetre);
    QVERIFY(std::abs(left + 0.8 * tube.outerDiameter.si) < 0.3 * kMillimetre);
    for (const auto& triangle : wall.triangles) {
        const auto corner = [&](int k) -> Vec3 {
            return wall.positions[triangle[k]].cast<double>();
        };
        const Vec3 face = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
        if ((corner(0) - tube.p_E_tip).norm() < 0.012)
            QVERIFY(face.dot(wall.normals[triangle[0]].cast<double>()) > 0.9);
    }
}

void TestTube::wallHasTheOuterDiameter()
{
    constexpr double kTolerance = 0.15 * kMillimetre; // chords of the round wall
    const TubeShape tube = bentTube();
    // Across the straight part in front of the teeth, square to z of E.
    const test::Section wall =
        test::sectionOf(pieceOf(tube, "Tube"), {Vec3{0.0, 0.0, -0.02}, Vec3::UnitZ()});
    double widest = 0.0;
    for (const Vec3& p : wall.points)
        widest = std::max(widest, 2.0 * std::hypot(p.x(), p.y()));
    QVERIFY(std::abs(widest - 9.6 * kMillimetre) < kTolerance);
    QCOMPARE(inMillimetres(tube.outerDiameter), 9.6);
    QCOMPARE(inMillimetres(tube.innerDiameter), 7.0);
}

void TestTube::connectorHasFifteenMillimetres()
{
    const TubeShape tube = bentTube();
    const test::Section outer =
        test::sectionOf(pieceOf(tube, "Connector"), {Vec3{0.0, 0.0, 0.015}, Vec3::UnitZ()});
    double widest = 0.0;
    for (const Vec3& p : outer.points)
        widest = std::max(widest, 2.0 * std::hypot(p.x(), p.y()));
    QVERIFY(std::abs(widest - 15.0 * kMillimetre) < 0.1 * kMillimetre);
}

void TestTube::depthMarksStandAtWholeCentimetresFromTheTip()
{
    constexpr double kTolerance = 0.2 * kMillimetre;
    const TubeShape tube = bentTube();
    struct Band {
        double nearest = 1.0;
        double furthest = 0.0;
    };
    std::map<int, Band> bands; // by centimetre
    for (const Vec3f& p : pieceOf(tube, "Depth marks").positions) {
        const double along = fromTip(tube, p.cast<double>());
        Band& band = bands[static_cast<int>(std::lround(100.0 * along))];
        band.nearest = std::min(band.nearest, along);
        band.furthest = std::max(band.furthest, along);
    }
    QVERIFY(bands.size() > 18);
    for (const auto& [centimetre, band] : bands) {
        QVERIFY(std::abs(0.5 * (band.nearest + band.furthest) - 0.01 * centimetre) < kTolerance);
        const double width = band.furthest - band.nearest;
        QVERIFY2(centimetre % 5 == 0 ? width > 2.0 * kMillimetre : width < 1.3 * kMillimetre,
                 qPrintable(QString::number(centimetre)));
    }
}

void TestTube::tubeAndCuffStayInsideTheTrachea_data()
{
    QTest::addColumn<bool>("adult");
    QTest::newRow("adult") << true;
    QTest::newRow("twelve years") << false;
}

/// Whether a point is in a hollow trachea or its wall: there is wall to either side.
static bool isInTrachea(const TriangleMesh& trachea, const Vec3& p_A)
{
    constexpr double kStep = 0.5e-3;
    constexpr int kSteps = 50; // wider than any trachea
    return std::ranges::all_of(std::array{-1.0, 1.0}, [&](double side) {
        for (int i = 0; i <= kSteps; ++i)
            if (test::windingNumber(trachea, p_A + i * side * kStep * Vec3::UnitX()) > 0.5)
                return true;
        return false;
    });
}

void TestTube::tubeAndCuffStayInsideTheTrachea()
{
    QFETCH(bool, adult);
    const BuiltinPatient which = adult ? BuiltinPatient::Adult : BuiltinPatient::TwelveYears;
    const Anatomy patient = builtinPatient(which).value();
    const TriangleMesh& trachea = patient.parts.front().levels[1];
    const TubeShape tube = makeTube(dimensionsOf(which).tubeInnerDiameter, patient.landmarks.path_A,
                                    patient.landmarks.p_A_incisors)
                               .value();
    constexpr int kEach = 40; // of the vertices is looked at: each takes many windings
    const double top = dimensionsOf(which).tracheaLength.si - 3.0 * kMillimetre;
    for (const char* name : {"Tube", "Cuff", kInflatedCuff}) {
        int inside = 0;
        for (const Vec3f& p_E : pieceOf(tube, name).positions) {
            const Vec3 p_A = tube.X_AE * p_E.cast<double>();
            if (p_A.norm() > top)
                continue;
            if (++inside % kEach == 1)
                QVERIFY2(isInTrachea(trachea, p_A), name);
        }
        QVERIFY(inside > 100);
    }
}

/// Its tip is in the trunk, which stays; its connector in front of the teeth goes with the head.
void TestTube::liesInPlaceWhereTheNeckTakesTheAirway()
{
    const NeckField neck = bentNeck();
    const TubeShape tube = bentTube();
    QVERIFY((neck.placed(tube.X_AE * tube.p_E_tip) - tube.X_AE * tube.p_E_tip).norm() < kSame_m);
    QVERIFY(tipFromPlace(tube, {}, tube.X_AE).si < kSame_m);
    const RigidTransform X_AE = neck.X_AU() * tube.X_AE;
    QVERIFY(tipFromPlace(tube, neck, X_AE).si < kSame_m);
    const RigidTransform moved = RigidTransform::translation({0.0, 0.003, 0.004}) * X_AE;
    QVERIFY(std::abs(inMillimetres(tipFromPlace(tube, neck, moved)) - 5.0) < 1e-6);
    const TubeShape drawn = bent(tube, neck);
    QVERIFY((drawn.X_AE.matrix() - X_AE.matrix()).norm() < kSame_m);
    QVERIFY((drawn.X_AE * drawn.p_E_tip - tube.X_AE * tube.p_E_tip).norm() < kSame_m);
}

/// Its tip goes so much deeper as the way from the teeth becomes shorter, and stays on that.
void TestTube::keepsItsLengthInABentNeck()
{
    const TubeShape tube = bentTube();
    QVERIFY(centreIn({}, tube) == tube.p_E_centre);
    for (const HeadPosition& position : {kNeckFlexed, kHeadExtended}) {
        const NeckField neck{{0.0, -0.05, 0.16}, kIncisors, position};
        const std::vector<Vec3> line = centreIn(neck, tube);
        const TubeShape drawn = bent(tube, neck);
        const double shorter = (lengthOf(tube.p_E_centre) - lengthOf(drawn.p_E_centre)).si;
        QVERIFY(std::abs(shorter) > kStretched_m);
        QVERIFY(std::abs((lengthOf(line) - lengthOf(tube.p_E_centre)).si) < kSame_m);
        QVERIFY((line.front() - drawn.p_E_centre.front()).norm() < kSame_m);
        const std::size_t beforeTip = std::min(line.size(), drawn.p_E_centre.size()) - 4;
        QVERIFY((line[beforeTip] - drawn.p_E_centre[beforeTip]).norm() < kSame_m);
        const Vec3 deeper = line.back() - drawn.p_E_tip;
        QVERIFY(std::abs(deeper.norm() - std::abs(shorter)) < kStraight_m);
    }
    const std::array straight{Vec3{0.0, 0.0, 0.0}, Vec3{0.0, 0.0, -0.3}};
    const TubeShape touched = tubeAlong(tube, straight, millimetres(9.6));
    QVERIFY(centreIn(bentNeck(), touched) == touched.p_E_centre);
}

/// A tube that was touched stays rigid in a bent neck, with its tip at the same place.
void TestTube::liesInPlaceAsItWasTouched()
{
    const NeckField neck = bentNeck();
    const std::array straight{Vec3{0.0, 0.0, 0.0}, Vec3{0.0, 0.0, -0.3}};
    const TubeShape touched = tubeAlong(bentTube(), straight, millimetres(9.6));
    QCOMPARE(inMillimetres(tubeAlong(bentTube(), straight, millimetres(8.9)).innerDiameter), 6.5);
    const Vec3 p_A_tip = bentTube().X_AE * bentTube().p_E_tip;
    const RigidTransform turned{rotationFromVector({0.2, -0.3, 0.1}), Vec3::Zero()};
    const RigidTransform X_AE = RigidTransform::translation(p_A_tip) * turned
                                * RigidTransform::translation(-touched.p_E_tip);
    QVERIFY(tipFromPlace(touched, {}, X_AE).si < kSame_m);
    QVERIFY(tipFromPlace(touched, neck, X_AE).si < kSame_m);
    // Where it would be if it went with the head it is not in place.
    QVERIFY(tipFromPlace(touched, neck, neck.X_AU() * X_AE) > millimetres(6.0));
}

void TestTube::refusesWhatCannotLieInAnAirway_data()
{
    QTest::addColumn<double>("innerMillimetres");
    QTest::addColumn<std::vector<Vec3>>("path");
    QTest::addColumn<double>("tipMillimetres");
    QTest::addColumn<Errc>("code");
    QTest::newRow("no airway") << 7.0 << std::vector<Vec3>{} << 30.0 << Errc::NoAirway;
    QTest::newRow("hair thin") << 1.9 << bentPath() << 30.0 << Errc::OutOfRange;
    QTest::newRow("as wide as a trachea") << 12.1 << bentPath() << 30.0 << Errc::OutOfRange;
    QTest::newRow("not a number") << std::nan("") << bentPath() << 30.0 << Errc::OutOfRange;
    QTest::newRow("tip beyond the carina") << 7.0 << bentPath() << -0.1 << Errc::OutOfRange;
    QTest::newRow("tip at no number") << 7.0 << bentPath() << std::nan("") << Errc::OutOfRange;
    QTest::newRow("tip outside the mouth") << 7.0 << bentPath() << 400.0 << Errc::NoAirway;
}

void TestTube::refusesWhatCannotLieInAnAirway()
{
    QFETCH(double, innerMillimetres);
    QFETCH(std::vector<Vec3>, path);
    QFETCH(double, tipMillimetres);
    QFETCH(Errc, code);
    const auto tube =
        makeTube(millimetres(innerMillimetres), path, kIncisors, millimetres(tipMillimetres));
    QVERIFY(!tube.has_value());
    QCOMPARE(tube.error().code, code);
}

CARINA_TEST(TestTube)

} // namespace carina::tube_test

#include "tst_tube.moc"
