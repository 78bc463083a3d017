#include "tests/support/test_class.h"
#include "widgets/scene/view/orbit_camera.h"

#include <cmath>
#include <numbers>

namespace carina::orbit_camera_test
{

namespace
{

constexpr double kTolerance = 1e-12; ///< metres and directions
constexpr double kAspect = 1.6;
constexpr double kTangent = 0.255341921221036; ///< of half the field of view, 0.25 rad

/// Where a point is in the picture: -1 to 1 from left to right and from bottom to top.
struct Seen {
    double right;
    double up;
};
Seen seen(const CameraPose& pose, const Vec3& p_A)
{
    const Vec3 forward = (pose.p_A_target - pose.p_A_eye).normalized();
    const Vec3 offset = p_A - pose.p_A_eye;
    const double depth = offset.dot(forward) * kTangent;
    return {offset.dot(forward.cross(pose.up_A)) / (depth * kAspect),
            offset.dot(pose.up_A) / depth};
}

OrbitCamera chestCamera(ViewPreset preset)
{
    OrbitCamera camera;
    Box chest;
    chest.include(Vec3(-0.15, -0.10, -0.20));
    chest.include(Vec3(0.15, 0.12, 0.30));
    camera.setBounds(chest);
    camera.setAspect(kAspect);
    camera.showFrom(preset);
    return camera;
}

} // namespace

class TestOrbitCamera : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void looksFromWhereThePresetSays_data();
    void looksFromWhereThePresetSays();
    void showsThePatientAsHeLies_data();
    void showsThePatientAsHeLies();
    void framesTheBoundsFromEachPreset_data() { looksFromWhereThePresetSays_data(); }
    void framesTheBoundsFromEachPreset();
    void keepsTheBoundsFramedWhenTheWindowNarrows();
    void keepsWhatThePersonSetWhenTheWindowNarrows();
    void turnsWhatIsSeenAlongWithTheDrag_data() { looksFromWhereThePresetSays_data(); }
    void turnsWhatIsSeenAlongWithTheDrag();
    void stopsShortOfThePole();
    void movesWhatIsSeenByThePartOfTheHeightDragged();
    void comesNearerByTheFactor();
    void staysAwayFromTheTargetAndWithinReach();
    void keepsTheBoundsBetweenItsPlanes();
    void looksAtTheOriginWhereThereIsNothing();
    void looksOutOfAnEyeAlongItsMinusZ();
    void looksAgainAsAPoseSays_data() { showsThePatientAsHeLies_data(); }
    void looksAgainAsAPoseSays();
};

void TestOrbitCamera::looksFromWhereThePresetSays_data()
{
    QTest::addColumn<ViewPreset>("preset");
    QTest::addColumn<Vec3>("right_A");
    QTest::addColumn<Vec3>("up_A");
    // The anatomy frame: +x patient's left, +y posterior, +z superior.
    QTest::newRow("front: patient's left is right, head up")
        << ViewPreset::Front << Vec3(1, 0, 0) << Vec3(0, 0, 1);
    QTest::newRow("right side: front is right")
        << ViewPreset::Right << Vec3(0, -1, 0) << Vec3(0, 0, 1);
    QTest::newRow("left side: back is right") << ViewPreset::Left << Vec3(0, 1, 0) << Vec3(0, 0, 1);
    QTest::newRow("back: patient's right is right")
        << ViewPreset::Back << Vec3(-1, 0, 0) << Vec3(0, 0, 1);
    // From behind the head down at the chest: 0.9 rad away from looking along the floor.
    QTest::newRow("trainee: patient's right is right, chest up")
        << ViewPreset::Trainee << Vec3(-1, 0, 0) << Vec3(0, -std::sin(0.9), -std::cos(0.9));
}

void TestOrbitCamera::looksFromWhereThePresetSays()
{
    QFETCH(ViewPreset, preset);
    QFETCH(Vec3, right_A);
    QFETCH(Vec3, up_A);
    const CameraPose pose = chestCamera(preset).pose();
    const Vec3 forward = (pose.p_A_target - pose.p_A_eye).normalized();
    QVERIFY((pose.up_A - up_A).norm() < kTolerance);
    QVERIFY((forward.cross(pose.up_A) - right_A).norm() < kTolerance);
    QVERIFY((pose.p_A_target - Vec3(0.0, 0.01, 0.05)).norm() < kTolerance);
}

void TestOrbitCamera::showsThePatientAsHeLies_data()
{
    QTest::addColumn<Lie>("lie");
    QTest::addColumn<ViewPreset>("preset");
    QTest::addColumn<Vec3>("forward_A");
    QTest::addColumn<Vec3>("up_A");
    const Vec3 left = Vec3::UnitX();
    const Vec3 back = Vec3::UnitY();
    const Vec3 head = Vec3::UnitZ();
    using enum ViewPreset;
    const auto row = [](const char* name, Lie lie, ViewPreset preset, const Vec3& forward,
                        const Vec3& up) { QTest::newRow(name) << lie << preset << forward << up; };
    row("on the back, from the side: the front is up", Lie::OnBack, Right, left, -back);
    row("on the back, from the left: the front is up", Lie::OnBack, Left, -left, -back);
    row("on the back, from the front: from above, head up", Lie::OnBack, Front, back, head);
    row("on the back, from behind: from below, head up", Lie::OnBack, Back, -back, head);
    row("on the front, from the side: the back is up", Lie::OnFront, Right, left, back);
    row("on the front, from behind: from above, head up", Lie::OnFront, Back, -back, head);
    row("on the front, from the front: from below", Lie::OnFront, Front, back, head);
    row("on the right side, from the front: the left is up", Lie::OnRightSide, Front, back, left);
    row("on the right side, from the left: from above", Lie::OnRightSide, Left, -left, head);
    row("on the left side, from the front: the right is up", Lie::OnLeftSide, Front, back, -left);
    row("on the left side, from behind: the right is up", Lie::OnLeftSide, Back, -back, -left);
    row("upright again", Lie::Upright, Right, left, head);
    // The same view as while upright.
    row("on the back, from the head end", Lie::OnBack, Trainee,
        {0.0, std::cos(0.9), -std::sin(0.9)}, {0.0, -std::sin(0.9), -std::cos(0.9)});
}

void TestOrbitCamera::showsThePatientAsHeLies()
{
    QFETCH(Lie, lie);
    QFETCH(ViewPreset, preset);
    QFETCH(Vec3, forward_A);
    QFETCH(Vec3, up_A);
    OrbitCamera camera = chestCamera(preset);
    camera.setLie(Lie::OnFront);
    camera.setLie(lie);
    const CameraPose pose = camera.pose();
    QVERIFY(((pose.p_A_target - pose.p_A_eye).normalized() - forward_A).norm() < kTolerance);
    QVERIFY((pose.up_A - up_A).norm() < kTolerance);
}

/// As before, and turns from there as it did.
void TestOrbitCamera::looksAgainAsAPoseSays()
{
    QFETCH(Lie, lie);
    QFETCH(ViewPreset, preset);
    constexpr double kSame_m = 1e-9;
    for (const double turned : {0.0, 0.2}) {
        OrbitCamera camera = chestCamera(preset);
        camera.setLie(lie);
        camera.showFrom(preset);
        if (turned != 0.0)
            camera.orbit(turned, -turned);
        CameraPose pose = camera.pose();
        OrbitCamera again = chestCamera(ViewPreset::Left);
        again.setLie(lie);
        again.look(pose);
        for (int step = 0; step < 2; ++step) {
            QVERIFY((again.pose().p_A_eye - pose.p_A_eye).norm() < kSame_m);
            QVERIFY((again.pose().p_A_target - pose.p_A_target).norm() < kSame_m);
            QVERIFY((again.pose().up_A - pose.up_A).norm() < kSame_m);
            camera.orbit(0.05, 0.02);
            again.orbit(0.05, 0.02);
            pose = camera.pose();
        }
    }
}

void TestOrbitCamera::framesTheBoundsFromEachPreset()
{
    QFETCH(ViewPreset, preset);
    const CameraPose pose = chestCamera(preset).pose();
    double outermost = 0.0;
    for (const double x : {-0.15, 0.15})
        for (const double y : {-0.10, 0.12})
            for (const double z : {-0.20, 0.30}) {
                const Seen corner = seen(pose, {x, y, z});
                outermost = std::max({outermost, std::abs(corner.right), std::abs(corner.up)});
            }
    QVERIFY2(outermost <= 1.0, qPrintable(QString::number(outermost)));
    QVERIFY2(outermost > 0.9, qPrintable(QString::number(outermost)));
}

void TestOrbitCamera::keepsTheBoundsFramedWhenTheWindowNarrows()
{
    OrbitCamera camera = chestCamera(ViewPreset::Front);
    camera.setAspect(0.25);
    const CameraPose pose = camera.pose();
    const double right = seen(pose, {0.15, -0.10, 0.05}).right * kAspect / 0.25;
    QVERIFY(right <= 1.0 && right > 0.9);
}

void TestOrbitCamera::keepsWhatThePersonSetWhenTheWindowNarrows()
{
    OrbitCamera camera = chestCamera(ViewPreset::Front);
    camera.orbit(0.1, 0.1);
    const CameraPose before = camera.pose();
    camera.setAspect(0.25);
    QVERIFY((camera.pose().p_A_eye - before.p_A_eye).norm() < kTolerance);
}

void TestOrbitCamera::turnsWhatIsSeenAlongWithTheDrag()
{
    QFETCH(ViewPreset, preset);
    OrbitCamera camera = chestCamera(preset);
    const CameraPose before = camera.pose();
    // A point in front of the target, towards the eye, follows the pointer.
    const Vec3 p_A = before.p_A_target + 0.05 * (before.p_A_eye - before.p_A_target).normalized();
    camera.orbit(0.05, 0.0);
    QVERIFY(seen(camera.pose(), p_A).right > 0.001);
    camera = chestCamera(preset);
    camera.orbit(0.0, 0.05);
    QVERIFY(seen(camera.pose(), p_A).up < -0.001);
}

void TestOrbitCamera::stopsShortOfThePole()
{
    OrbitCamera camera = chestCamera(ViewPreset::Front);
    camera.orbit(0.0, 10.0);
    QVERIFY(camera.pose().up_A.z() > 0.0);
    camera.orbit(0.0, -20.0);
    QVERIFY(camera.pose().up_A.z() > 0.0);
    QVERIFY(camera.pose().p_A_eye.z() < -0.5);
}

void TestOrbitCamera::movesWhatIsSeenByThePartOfTheHeightDragged()
{
    OrbitCamera camera = chestCamera(ViewPreset::Front);
    const Vec3 p_A = camera.pose().p_A_target;
    camera.pan(0.25, 0.5);
    const Seen moved = seen(camera.pose(), p_A);
    QVERIFY(std::abs(moved.right * kAspect - 0.5) < kTolerance); // the height is 2
    QVERIFY(std::abs(moved.up + 1.0) < kTolerance);
}

void TestOrbitCamera::comesNearerByTheFactor()
{
    OrbitCamera camera = chestCamera(ViewPreset::Front);
    const CameraPose before = camera.pose();
    camera.zoom(2.0);
    const CameraPose after = camera.pose();
    QVERIFY(std::abs((before.p_A_eye - before.p_A_target).norm()
                     - 2.0 * (after.p_A_eye - after.p_A_target).norm())
            < kTolerance);
}

void TestOrbitCamera::staysAwayFromTheTargetAndWithinReach()
{
    OrbitCamera camera = chestCamera(ViewPreset::Front);
    camera.zoom(1e6);
    QVERIFY(std::abs((camera.pose().p_A_eye - camera.pose().p_A_target).norm() - 0.02)
            < kTolerance);
    camera.zoom(1e-9);
    QVERIFY(std::abs((camera.pose().p_A_eye - camera.pose().p_A_target).norm() - 20.0) < 1e-9);
}

void TestOrbitCamera::keepsTheBoundsBetweenItsPlanes()
{
    OrbitCamera camera = chestCamera(ViewPreset::Front);
    camera.pan(0.4, -0.3);
    camera.orbit(0.3, 0.2);
    const CameraPose pose = camera.pose();
    const Vec3 forward = (pose.p_A_target - pose.p_A_eye).normalized();
    for (const double x : {-0.15, 0.15})
        for (const double z : {-0.20, 0.30}) {
            const double depth = (Vec3(x, 0.12, z) - pose.p_A_eye).dot(forward);
            QVERIFY(depth > pose.nearPlane && depth < pose.farPlane);
        }
}

void TestOrbitCamera::looksAtTheOriginWhereThereIsNothing()
{
    OrbitCamera camera;
    camera.showFrom(ViewPreset::Front);
    const CameraPose pose = camera.pose();
    QVERIFY(pose.p_A_target.isZero());
    QVERIFY((pose.p_A_eye - Vec3(0.0, -1.0, 0.0)).norm() < kTolerance);
    QVERIFY(pose.nearPlane > 0.0 && pose.nearPlane < pose.farPlane);
}

void TestOrbitCamera::looksOutOfAnEyeAlongItsMinusZ()
{
    // A quarter turn about x takes -z to +y and +y to +z: in front, looking back, head up.
    const double half = std::sqrt(0.5);
    const RigidTransform X_AD(Quat(half, half, 0.0, 0.0), Vec3(0.1, -5.0, 0.2));
    const CameraPose pose = chestCamera(ViewPreset::Front).poseOf(X_AD);
    QVERIFY((pose.p_A_eye - Vec3(0.1, -5.0, 0.2)).norm() < kTolerance);
    QVERIFY((pose.p_A_target - Vec3(0.1, -4.0, 0.2)).norm() < kTolerance);
    QVERIFY((pose.up_A - Vec3(0, 0, 1)).norm() < kTolerance);
    QVERIFY(pose.farPlane > 5.12 && pose.nearPlane < 4.9);
}

CARINA_TEST(TestOrbitCamera)

} // namespace carina::orbit_camera_test

#include "tst_orbit_camera.moc"
