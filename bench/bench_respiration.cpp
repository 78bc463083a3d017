// How much faster than real time the respiratory mechanics are: a step of quiet breathing, and one
// under a ventilator with a tension pneumothorax. Beside them the least that such a step can cost,
// its logarithms and cosines alone. Prints one JSON object.

#include "bench/interleaved.h"
#include "engine/lungs/respiratory_fold.h"

#include <cmath>
#include <cstdio>

namespace
{

constexpr const char* kQuiet = "quiet";
constexpr const char* kTense = "tense";
constexpr const char* kLeast = "least";

void breathe(benchmark::State& state, const carina::RespiratorySettings& settings)
{
    carina::RespiratoryFold fold{settings};
    for (auto _ : state) {
        fold.step();
        benchmark::DoNotOptimize(fold.content());
    }
}

void quiet(benchmark::State& state) { breathe(state, {}); }

void tense(benchmark::State& state)
{
    carina::RespiratorySettings settings;
    settings.ventilator.mode = carina::VentilationMode::VolumeControl;
    settings.tube = carina::millimetres(8.0);
    settings.condition = {carina::ConditionKind::TensionPneumothorax, 1.0,
                          carina::ConditionSide::Right};
    breathe(state, settings);
}

/// Two lungs in each of four stages and at the end, and the muscle in the middle and at the end.
void least(benchmark::State& state)
{
    double x = 0.3;
    for (auto _ : state) {
        double sum = 0.0;
        for (int i = 0; i < 10; ++i)
            sum += std::log(x + 0.01 * i);
        for (int i = 0; i < 2; ++i)
            sum += std::cos(x + 0.01 * i);
        benchmark::DoNotOptimize(sum);
        benchmark::DoNotOptimize(x);
    }
}

} // namespace

int main()
{
    const auto times = carina::medianTimes_ns({{kQuiet, quiet}, {kTense, tense}, {kLeast, least}});
    const double step_ns = 1e9 * carina::kRespiratoryStep;
    std::printf("{\n  \"schema\": \"carina.bench.respiration/1\",\n  \"repetitions\": %d,\n"
                "  \"step_s\": %.4f,\n"
                "  \"quiet_median_ns\": %.1f,\n  \"quiet_times_real_time\": %.0f,\n"
                "  \"tension_median_ns\": %.1f,\n  \"tension_times_real_time\": %.0f,\n"
                "  \"least_median_ns\": %.1f\n}\n",
                carina::kRepetitions, carina::kRespiratoryStep, times.at(kQuiet),
                step_ns / times.at(kQuiet), times.at(kTense), step_ns / times.at(kTense),
                times.at(kLeast));
    return 0;
}
