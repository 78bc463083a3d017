#include "engine/tracking/time_shift.h"

#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <random>

namespace carina::time_shift_test
{
namespace
{

using namespace std::chrono_literals;

/// A body that a hand turns to and fro.
RigidTransform bodyAt(double t)
{
    return {rotationFromVector({0.5 * std::sin(3.1 * t), 0.3 * std::sin(4.7 * t + 1.0),
                                0.4 * std::sin(2.3 * t + 0.4)}),
            Vec3{0.1 * std::sin(2.0 * t), 0.05 * std::cos(1.4 * t), 0.0}};
}

struct Device {
    double rate_Hz = 60.0;
    double late_s = 0.0; ///< its stamps
    RigidTransform X_FT{};
    RigidTransform X_OP{}; ///< of its probe on the body
    double noise_rad = 0.0;
};

std::vector<PoseSample> seenBy(const Device& device, unsigned seed, double seconds = 20.0)
{
    std::mt19937 random{seed};
    std::normal_distribution<double> noise{0.0, device.noise_rad};
    std::vector<PoseSample> samples;
    for (int i = 0; i < seconds * device.rate_Hz; ++i) {
        const double t = 0.0031 * seed + i / device.rate_Hz;
        const Quat jitter = rotationFromVector({noise(random), noise(random), noise(random)});
        const RigidTransform X_FP = device.X_FT * bodyAt(t) * device.X_OP;
        samples.push_back({.time = SessionTime{fromSeconds(t + device.late_s)},
                           .X_FO = {jitter * X_FP.rotation(), X_FP.translation()}});
    }
    return samples;
}

const Device kOther{.rate_Hz = 33.0,
                    .X_FT = {rotationFromVector({1.0, -2.0, 0.3}), Vec3{1.0, 2.0, 3.0}},
                    .X_OP = {rotationFromVector({-0.3, 0.8, 1.3}), Vec3{0.1, 0.0, -0.2}},
                    .noise_rad = 5e-4};

} // namespace

class TestTimeShift : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheDelayOfAnotherTracker_data()
    {
        QTest::addColumn<double>("late_ms");
        for (const double late : {0.0, 14.2, 47.0, -133.0, 400.0})
            QTest::addRow("%g ms", late) << late;
    }

    void findsTheDelayOfAnotherTracker()
    {
        QFETCH(double, late_ms);
        Device other = kOther;
        other.late_s = 1e-3 * late_ms;
        const auto shift = timeShift(seenBy({.noise_rad = 5e-4}, 1), seenBy(other, 2));
        QVERIFY(shift.has_value());
        constexpr double kWithin_ms = 1.0;
        QVERIFY2(std::abs(1e3 * toSeconds(shift->late) - late_ms) < kWithin_ms,
                 QByteArray::number(1e3 * toSeconds(shift->late)).constData());
        QVERIFY(shift->correlation > 0.95);
        const auto back = timeShift(seenBy(other, 2), seenBy({.noise_rad = 5e-4}, 1));
        QVERIFY(std::abs(1e3 * toSeconds(back->late) + late_ms) < kWithin_ms);
    }

    void refusesWhatDoesNotTellIt()
    {
        const auto moved = seenBy({}, 1);
        auto still = moved;
        for (PoseSample& sample : still)
            sample.X_FO = {};
        QCOMPARE(timeShift(still, still).error().code, Errc::NotEnoughMotion);
        QCOMPARE(timeShift(moved, {}).error().code, Errc::TooFewPoses);
        QCOMPARE(timeShift(seenBy({}, 1, 1.0), moved).error().code, Errc::TooFewPoses);
        Device late = kOther;
        late.late_s = 0.7; // more than is searched
        const auto wrong = timeShift(moved, seenBy(late, 2));
        QVERIFY(!wrong || std::abs(toSeconds(wrong->late)) < 0.5);
    }
};

CARINA_TEST(TestTimeShift)

} // namespace carina::time_shift_test

#include "tst_time_shift.moc"
