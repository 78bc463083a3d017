// How long a step of the deformable tube takes: 64 segments that are pushed through a bent airway,
// in the mean and where it takes longest, also against a stop; the same at rest in it; and how long
// it takes to move the lumen with the tissue around it. Prints one JSON object.

#include "bench/interleaved.h"
#include "engine/airway/tube/tube_in_lumen.h"
#include "tests/engine/airway/lumen/still_lumen.h"
#include "tests/engine/airway/tube/bent_lumen.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <vector>

namespace
{

using carina::Vec3;

constexpr const char* kPushed = "pushed";
constexpr const char* kResting = "resting";
constexpr const char* kMoved = "moved";
constexpr int kSteps = 140; ///< in which it is pushed in, 15 cm a second
constexpr double kEach = 0.0015;
constexpr double kBegin = -0.01;

const carina::TubeSize& size()
{
    static const auto it = carina::tubeOfSize(carina::millimetres(7.0)).value();
    return it;
}

/// 7 cm straight, a quarter of a circle of 5 cm, and 14 cm down.
carina::AirwayLumen airway() { return carina::test::BentLumen{}.lumenFor(size().outerRadius()); }

/// A hand that feeds the tube along its own curve.
carina::RigidTransform fed(double inside) { return carina::test::fed(size(), inside); }

carina::TubeInLumen tubeAtRest() { return {size(), carina::test::restCurve(size())}; }

/// In and out again and again.
void pushed(benchmark::State& state)
{
    const carina::MovedLumen lumen = carina::test::unmoved(airway());
    carina::TubeInLumen tube = tubeAtRest();
    int step = 0;
    for (auto _ : state) {
        const int there = step < kSteps ? step : 2 * kSteps - step;
        tube.step(fed(kBegin + kEach * there), lumen);
        step = (step + 1) % (2 * kSteps);
        benchmark::DoNotOptimize(tube.tip());
    }
}

void resting(benchmark::State& state)
{
    const carina::MovedLumen lumen = carina::test::unmoved(airway());
    carina::TubeInLumen tube = tubeAtRest();
    for (double inside = kBegin; inside < 0.2; inside += kEach)
        tube.step(fed(inside), lumen);
    for (auto _ : state) {
        tube.step(fed(0.2), lumen);
        benchmark::DoNotOptimize(tube.tip());
    }
}

void lumenMoved(benchmark::State& state)
{
    const carina::AirwayLumen still = airway();
    const carina::AirwayField changes;
    const carina::BladeField blade;
    const carina::FollowingThroat throat{
        {Vec3{0.0, 0.12, -0.2}, Vec3{0.0, 0.12, -0.07}, Vec3::Zero()},
        carina::RigidTransform::translation({0.0, -0.005, -0.01})};
    for (auto _ : state)
        benchmark::DoNotOptimize(
            carina::moved(still, carina::tissueMotion(changes, throat), carina::bladePushing(blade))
                .teeth);
}

/// The same airway with a ring that the tube does not pass.
carina::AirwayLumen ringed()
{
    constexpr double kTooNarrow = 0.0006;
    carina::AirwayLumen lumen = airway();
    carina::LumenSection& ring = lumen.ways.front()[lumen.glottis + 6];
    for (carina::LumenLimit& limit : ring.limits) {
        const Vec3 out = (limit.p_A_wall - ring.p_A_centre).normalized();
        limit.p_A_wall = ring.p_A_centre + (size().outerRadius().si - kTooNarrow) * out;
    }
    return lumen;
}

/// How long the slowest step takes while the tube is pushed in. Of each step the least time of
/// several passes counts, which no other load of the processor has disturbed.
double slowestStep_us(const carina::AirwayLumen& airwayLumen)
{
    using Clock = std::chrono::steady_clock;
    const carina::MovedLumen lumen = carina::test::unmoved(airwayLumen);
    std::vector<double> least(kSteps, std::numeric_limits<double>::infinity());
    for (int pass = 0; pass < carina::kRepetitions; ++pass) {
        carina::TubeInLumen tube = tubeAtRest();
        tube.step(fed(kBegin - kEach), lumen);
        for (int i = 0; i < kSteps; ++i) {
            const Clock::time_point before = Clock::now();
            tube.step(fed(kBegin + kEach * i), lumen);
            const std::chrono::duration<double, std::micro> taken = Clock::now() - before;
            least[std::size_t(i)] = std::min(least[std::size_t(i)], taken.count());
        }
    }
    return *std::ranges::max_element(least);
}

} // namespace

int main()
{
    const auto times =
        carina::repeatedTimes({{kPushed, pushed}, {kResting, resting}, {kMoved, lumenMoved}});
    std::printf("{\n  \"schema\": \"carina.bench.tube/2\",\n  \"repetitions\": %d,\n"
                "  \"segments\": %d,\n  \"pushed_mean_us\": %.1f,\n  \"pushed_median_us\": %.1f,\n"
                "  \"pushed_slowest_us\": %.1f,\n  \"stopped_slowest_us\": %.1f,\n"
                "  \"resting_median_us\": %.1f,\n  \"lumen_moved_median_us\": %.1f\n}\n",
                carina::kRepetitions, carina::TubeInLumen::kPieces,
                1e-3 * times.at(kPushed).mean_ns, 1e-3 * times.at(kPushed).median_ns,
                slowestStep_us(airway()), slowestStep_us(ringed()),
                1e-3 * times.at(kResting).median_ns, 1e-3 * times.at(kMoved).median_ns);
    return 0;
}
