#include "models/station/head_by_mouse.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <numbers>

namespace carina::head_by_mouse_test
{
namespace
{

constexpr double kTolerance = 1e-9; ///< metres, and of unit vectors
const Vec3 kMouth{0.0, -0.09, 0.27};
const double kAlong = std::cos(70.0 * std::numbers::pi / 180.0); ///< level part of the way up
const double kUp = std::sin(70.0 * std::numbers::pi / 180.0);

PlaceBeside beside(BodyPosition position, double turn_deg = 0.0)
{
    return {.p_A_mouth = kMouth, .position = position, .turn = degrees(turn_deg)};
}

const PlaceBeside kSupine = beside(BodyPosition::Supine);

bool isNear(const Vec3& a, const Vec3& b) { return (a - b).norm() < kTolerance; }

Vec3 column(const RigidTransform& X_AH, int which)
{
    return X_AH.rotation().toRotationMatrix().col(which);
}

Vec3 looks(const RigidTransform& X_AH) { return -column(X_AH, 2); }

/// Whether the line of sight goes ahead through the mouth, from so far away.
bool seesTheMouth(const RigidTransform& X_AH, double distance)
{
    return isNear(X_AH.translation() + distance * looks(X_AH), kMouth);
}

} // namespace

class TestHeadByMouse : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Whose left is then on the left.
    void standsAtTheHeadEndOfWhoLiesOnTheBack()
    {
        const RigidTransform X_AH = HeadByMouse{}.poseAt(kSupine);
        QVERIFY(isNear(X_AH.translation(), kMouth + 0.6 * Vec3{0.0, -kUp, kAlong}));
        QVERIFY(isNear(column(X_AH, 0), {-1.0, 0.0, 0.0}));
        QVERIFY(isNear(column(X_AH, 1), {0.0, -kAlong, -kUp}));
        QVERIFY(isNear(column(X_AH, 2), {0.0, -kUp, kAlong}));
    }

    /// Who looks into the face has the patient's left on the right.
    void standsInFrontOfWhoSits()
    {
        const RigidTransform X_AH = HeadByMouse{}.poseAt(beside(BodyPosition::Sitting));
        QVERIFY(isNear(X_AH.translation(), kMouth + 0.6 * Vec3{0.0, -kAlong, kUp}));
        QVERIFY(isNear(column(X_AH, 0), {1.0, 0.0, 0.0}));
        QVERIFY(isNear(column(X_AH, 1), {0.0, kUp, kAlong}));
    }

    void standsAtTheChosenSide_data()
    {
        QTest::addColumn<BodyPosition>("position");
        QTest::addColumn<double>("turn_deg");
        QTest::addColumn<Vec3>("toHead_A");
        const auto row = [](const char* name, BodyPosition position, double turn_deg,
                            const Vec3& toHead_A) {
            QTest::newRow(name) << position << turn_deg << toHead_A;
        };
        using enum BodyPosition;
        row("supine, left", Supine, 90.0, {kAlong, -kUp, 0.0});
        row("supine, right", Supine, -90.0, {-kAlong, -kUp, 0.0});
        row("supine, feet", Supine, 180.0, {0.0, -kUp, -kAlong});
        row("prone, as tracked", Prone, 0.0, {0.0, kUp, kAlong});
        row("prone, left", Prone, 90.0, {kAlong, kUp, 0.0});
        row("sitting, left", Sitting, 90.0, {kAlong, 0.0, kUp});
        row("sitting, right", Sitting, -90.0, {-kAlong, 0.0, kUp});
        row("sitting, the feet are below", Sitting, 180.0, {0.0, -kAlong, kUp});
        row("on the right side, the left is above", RightLateral, 90.0, {kUp, 0.0, kAlong});
        row("on the right side, feet", RightLateral, 180.0, {kUp, 0.0, -kAlong});
        row("on the left side, the left is below", LeftLateral, 90.0, {-kUp, 0.0, kAlong});
    }
    void standsAtTheChosenSide()
    {
        QFETCH(const BodyPosition, position);
        QFETCH(const double, turn_deg);
        QFETCH(const Vec3, toHead_A);
        const RigidTransform X_AH = HeadByMouse{}.poseAt(beside(position, turn_deg));
        QVERIFY(isNear(X_AH.translation(), kMouth + 0.6 * toHead_A));
        QVERIFY(seesTheMouth(X_AH, 0.6));
    }

    /// 1.2 rad for the picture's height. What is seen moves right: the head turns left, which is
    /// +x from the head end; and down: it looks up.
    void turnsAboutItsOwnPlace()
    {
        HeadByMouse head;
        const RigidTransform before = head.poseAt(kSupine);
        head.turn(0.25, 0.5);
        const RigidTransform X_AH = head.poseAt(kSupine);
        QVERIFY(isNear(X_AH.translation(), before.translation()));
        const double yaw = 0.3;
        const double pitch = 0.6 - 70.0 * std::numbers::pi / 180.0;
        QVERIFY(isNear(looks(X_AH), {std::cos(pitch) * std::sin(yaw), -std::sin(pitch),
                                     -std::cos(pitch) * std::cos(yaw)}));
        QVERIFY(std::abs(column(X_AH, 0).y()) < kTolerance); // no roll
        QVERIFY(column(X_AH, 1).y() < 0.0);
    }

    void comesRoundInACircle()
    {
        HeadByMouse head;
        for (int quarter = 0; quarter < 4; ++quarter)
            head.turn(0.5 * std::numbers::pi / 1.2, 0.0);
        QVERIFY(seesTheMouth(head.poseAt(kSupine), 0.6));
    }

    void looksNeitherStraightUpNorDown()
    {
        const double steepest = std::sin(85.0 * std::numbers::pi / 180.0);
        HeadByMouse head;
        head.turn(0.0, 100.0);
        QVERIFY(std::abs(-looks(head.poseAt(kSupine)).y() - steepest) < kTolerance);
        head.turn(0.0, -100.0);
        QVERIFY(std::abs(-looks(head.poseAt(kSupine)).y() + steepest) < kTolerance);
    }

    void movesAlongTheLineToTheMouth()
    {
        HeadByMouse head;
        head.comeNearer(2.0);
        QVERIFY(seesTheMouth(head.poseAt(kSupine), 0.3));
        head.comeNearer(0.25);
        QVERIFY(seesTheMouth(head.poseAt(kSupine), 1.2));
        head.comeNearer(1e6);
        QVERIFY(seesTheMouth(head.poseAt(kSupine), 0.15));
        head.comeNearer(1e-6);
        QVERIFY(seesTheMouth(head.poseAt(kSupine), 2.5));
    }

    void goesBackToItsPlace()
    {
        HeadByMouse head;
        head.turn(0.7, 0.3);
        head.comeNearer(1.5);
        QVERIFY(!seesTheMouth(head.poseAt(kSupine), 0.4));
        head.standAgain();
        QVERIFY(seesTheMouth(head.poseAt(kSupine), 0.6));
    }

    void isThereWhereNoHeadCanBeTracked()
    {
        StationMoment moment;
        QVERIFY(!looksByMouse(moment, ViewOutput::Mono)); // before the clock is set
        moment.time = SessionTime{std::chrono::seconds{1}};
        QVERIFY(looksByMouse(moment, ViewOutput::Mono));
        QVERIFY(looksByMouse(moment, ViewOutput::SideBySide));
        QVERIFY(!looksByMouse(moment, ViewOutput::Screen));
        moment.headIsAwaited = true;
        QVERIFY(!looksByMouse(moment, ViewOutput::Mono));
        moment.headIsAwaited = false;
        moment.head = PoseSample{};
        QVERIFY(!looksByMouse(moment, ViewOutput::Mono));
        moment.head->validity = Validity::Lost;
        QVERIFY(!looksByMouse(moment, ViewOutput::Mono));
    }
};

CARINA_TEST(TestHeadByMouse)

} // namespace carina::head_by_mouse_test

#include "tst_head_by_mouse.moc"
