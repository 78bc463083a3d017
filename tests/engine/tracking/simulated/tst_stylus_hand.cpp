#include "engine/tracking/simulated/stylus_hand.h"

#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::stylus_hand_test
{
namespace
{

using namespace std::chrono_literals;

constexpr double kExact = 1e-12; // m
const Vec3 kTip_S{0.01, 0.0, -0.12};
const RigidTransform kParked{rotationFromVector({0.3, -0.2, 0.5}), {0.1, 0.2, -1.0}};
const Vec3 kPoint_T{-0.1, 0.05, -1.2};

SessionTime after(Duration d) { return SessionTime{100s + d}; }

} // namespace

class TestStylusHand : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void restsWhereItIsParked()
    {
        const StylusHand hand{kParked, kTip_S};
        for (const Duration d : {0s, 1s, 50s})
            QVERIFY((hand.at(after(d)).matrix() - kParked.matrix()).norm() < kExact);
    }

    void keepsTheTipOnThePointItHolds()
    {
        StylusHand hand{kParked, kTip_S};
        hand.hold(kPoint_T, after(0s));
        Angle most{};
        for (Duration d = StylusHand::kReach; d < 10s; d += 7ms) {
            const RigidTransform X_TS = hand.at(after(d));
            QVERIFY((X_TS * kTip_S - kPoint_T).norm() < kExact);
            most.si = std::max(most.si, angleBetween(X_TS.rotation(), kParked.rotation()).si);
        }
        QVERIFY(std::abs(inDegrees(most) - 3.0) < 1e-6);
    }

    void swingsToAllSidesAboutTheDivot()
    {
        StylusHand hand{kParked, kTip_S};
        hand.swing(kPoint_T, after(0s));
        std::array<bool, 4> quarter{};
        double least_deg = 90.0;
        double most_deg = 0.0;
        for (Duration d = StylusHand::kReach; d < 20s; d += 11ms) {
            const RigidTransform X_TS = hand.at(after(d));
            QVERIFY((X_TS * kTip_S - kPoint_T).norm() < kExact);
            const Vec3 z = kParked.rotation().inverse() * (X_TS.rotation() * Vec3::UnitZ());
            quarter[(z.x() > 0.0 ? 1U : 0U) + (z.y() > 0.0 ? 2U : 0U)] = true;
            const double tilt_deg = std::acos(z.z()) * 180.0 / M_PI;
            least_deg = std::min(least_deg, tilt_deg);
            most_deg = std::max(most_deg, tilt_deg);
        }
        QVERIFY(std::ranges::all_of(quarter, [](bool reached) { return reached; }));
        QVERIFY(least_deg > 14.9 && least_deg < 16.0);
        QVERIFY(most_deg > 29.0 && most_deg < 30.1);
    }

    void movesGentlyFromOneTaskToTheNext()
    {
        StylusHand hand{kParked, kTip_S};
        hand.hold(kPoint_T, after(0s));
        hand.hold(kPoint_T + Vec3{0.2, 0.0, 0.0}, after(3s));
        hand.swing(kPoint_T, after(3s + 300ms)); // on its way
        hand.park(after(8s));
        constexpr double kFastest = 1.0; // m/s
        Vec3 last = hand.at(after(8s)).translation();
        for (Duration d = 8s; d < 10s; d += 10ms) {
            const Vec3 here = hand.at(after(d)).translation();
            QVERIFY((here - last).norm() <= kFastest * 0.01);
            last = here;
        }
        QVERIFY((hand.at(after(10s)).matrix() - kParked.matrix()).norm() < kExact);
    }

    void startsWhereItWasWhenTold()
    {
        StylusHand hand{kParked, kTip_S};
        hand.hold(kPoint_T, after(0s));
        const RigidTransform onTheWay = hand.at(after(400ms));
        hand.swing(kPoint_T, after(400ms));
        QVERIFY((hand.at(after(400ms)).matrix() - onTheWay.matrix()).norm() < kExact);
        QVERIFY((hand.at(after(0s)).matrix() - onTheWay.matrix()).norm() < kExact);
        // Half of the reach is half of the way, as it starts and stops alike.
        StylusHand other{kParked, kTip_S};
        other.hold(kPoint_T, after(0s));
        other.park(after(20s));
        const Vec3 from = other.at(after(20s)).translation();
        const Vec3 half = other.at(after(20s + StylusHand::kReach / 2)).translation();
        QVERIFY((half - 0.5 * (from + kParked.translation())).norm() < kExact);
    }
};

CARINA_TEST(TestStylusHand)

} // namespace carina::stylus_hand_test

#include "tst_stylus_hand.moc"
