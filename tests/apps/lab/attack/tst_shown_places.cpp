#include "apps/lab/attack/shown_places.h"
#include "engine/tracking/simulated/scripted_hands.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::shown_places_test
{
namespace
{

using namespace std::chrono_literals;
using carina::lab::ShownPlaces;

constexpr Duration kTick = 16ms;
constexpr double kSpeed = 0.1; ///< m/s of the tube
constexpr double kTolerance_mm = 1e-6;

/// A tube that moves steadily along x, from somewhere else after a jump.
struct Tube {
    SessionTime jump = SessionTime::max();
    double jump_m = 0.0;

    [[nodiscard]] Vec3 at(SessionTime t) const
    {
        const double x = kSpeed * toSeconds(t.time_since_epoch());
        return {t >= jump ? x + jump_m : x, 0.0, 0.0};
    }
    [[nodiscard]] PoseSample sample(SessionTime t) const
    {
        PoseSample sample;
        sample.time = t;
        sample.X_FO = RigidTransform::translation(at(t));
        return sample;
    }
};

/// An observer of it for five seconds. Until a sample arrives, the tube is shown this much behind.
ShownPlaces seen(const Tube& tube, Duration behind)
{
    ShownPlaces places;
    SessionTime newest{};
    for (SessionTime now{}; now < SessionTime{5s}; now += 1ms) {
        if ((now.time_since_epoch() % kTick) == Duration{}) {
            newest = now;
            places.heard(tube.sample(now), now);
        }
        Vec3 p_A = tube.at(newest);
        p_A.x() += kSpeed * toSeconds(now - newest - behind);
        places.shown(now, p_A, [&](SessionTime t) { return std::optional{tube.at(t)}; });
    }
    return places;
}

/// An observer who looks seldom, and then shows it where it is.
ShownPlaces seenRarely(const Tube& tube)
{
    ShownPlaces places;
    for (SessionTime now{}; now < SessionTime{5s}; now += 130ms) {
        places.heard(tube.sample(now), now);
        places.shown(now, tube.at(now), [&](SessionTime t) { return std::optional{tube.at(t)}; });
    }
    return places;
}

} // namespace

class TestShownPlaces : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void driftIsTheDistanceAtTheSameSessionTime()
    {
        const ShownPlaces right = seen({}, 0ms);
        QVERIFY(right.drift_mm() < kTolerance_mm);
        QCOMPARE(right.places(), (5s - ShownPlaces::kArrived) / ShownPlaces::kShownInterval);
        const ShownPlaces late = seen({}, 10ms);
        QVERIFY(std::abs(late.drift_mm() - 1e3 * kSpeed * 0.010) < kTolerance_mm);
        QCOMPARE(late.jumps(), 0);
    }

    /// A busy program that looks rarely sees the same drift.
    void lateLookIsNoDrift()
    {
        const ShownPlaces places = seenRarely({});
        QVERIFY(places.places() > 30);
        QVERIFY(places.drift_mm() < kTolerance_mm);
    }

    void anotherPatientIsNoDrift()
    {
        const Tube tube{.jump = SessionTime{2s + 5ms}, .jump_m = 0.08};
        const ShownPlaces places = seen(tube, 0ms);
        QCOMPARE(places.jumps(), 1);
        QVERIFY(places.drift_mm() < kTolerance_mm);
        // No more is left out than from the sample before until it is blended in.
        const auto all = seen({}, 0ms).places();
        QVERIFY(all - places.places()
                <= (2 * kTick + ShownPlaces::kBlended) / ShownPlaces::kShownInterval + 1);
    }

    void quickHandIsNoJump()
    {
        const Tube tube{.jump = SessionTime{2s}, .jump_m = 0.4 * ShownPlaces::kFastestHand * 0.016};
        const ShownPlaces places = seen(tube, 0ms);
        QCOMPARE(places.jumps(), 0);
    }

    /// A tube that is held and moves in turn drifts only while it moves.
    void comparesWithTheSamePhasesOfTheMotion()
    {
        QCOMPARE(ShownPlaces::kPeriod, HandScript{}.period);
        constexpr double kMoving_mm = 0.4;
        const auto seenIn = [](Duration begin, Duration end) {
            ShownPlaces places;
            for (SessionTime t{begin}; t < SessionTime{end}; t += ShownPlaces::kShownInterval) {
                const bool moves = t.time_since_epoch() % ShownPlaces::kPeriod >= 10s;
                places.shown(t, Vec3{moves ? 1e-3 * kMoving_mm : 0.0, 0.0, 0.0},
                             [](SessionTime) { return std::optional<Vec3>{Vec3::Zero()}; });
            }
            return places;
        };
        const ShownPlaces usual = seenIn(0s, 21s);
        QVERIFY(usual.driftAtPhasesOf_mm(seenIn(42s, 47s)) < kTolerance_mm);
        const double moving_mm = usual.driftAtPhasesOf_mm(seenIn(52s, 57s));
        QVERIFY(std::abs(moving_mm - kMoving_mm) < kTolerance_mm);
        QCOMPARE(seenIn(0s, 5s).driftAtPhasesOf_mm(seenIn(52s, 57s)), 0.0);
    }

    void whatWasNotTrackedIsNotCompared()
    {
        ShownPlaces places;
        for (SessionTime now{}; now < SessionTime{1s}; now += 1ms)
            places.shown(now, Vec3::Zero(), [](SessionTime) { return std::nullopt; });
        QCOMPARE(places.places(), std::int64_t{0});
        QCOMPARE(places.drift_mm(), 0.0);
    }
};

CARINA_TEST(TestShownPlaces)

} // namespace carina::shown_places_test

#include "tst_shown_places.moc"
