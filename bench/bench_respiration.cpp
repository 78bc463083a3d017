// How much faster than real time the respiratory mechanics are: a step of quiet breathing, and one
// under a ventilator with a tension pneumothorax. Beside them the least that such a step can cost,
// its logarithms and cosines alone; and what a frame of a viewer costs, 60 of them a second: the
// steps up to it, and the pose of the chest that shows them. Prints one JSON object.

#include "bench/interleaved.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/lungs/drawing/chest_drawing.h"
#include "engine/session/respiration/respiration_follower.h"

#include <cmath>
#include <cstdio>

namespace
{

constexpr const char* kQuiet = "quiet";
constexpr const char* kTense = "tense";
constexpr const char* kLeast = "least";
constexpr const char* kFrame = "frame";

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
    settings.conditions = {
        {carina::ConditionKind::TensionPneumothorax, 1.0, carina::ConditionSide::Right}};
    breathe(state, settings);
}

void frame(benchmark::State& state)
{
    using carina::BuiltinPatient;
    static const auto lungs =
        carina::LungPair::of(carina::builtinPatient(BuiltinPatient::Adult).value()).value();
    carina::RespirationTimeline timeline;
    carina::SessionTime t{};
    timeline.setBuild(t, carina::buildOf(carina::dimensionsOf(BuiltinPatient::Adult)));
    timeline.setRunning(t, true);
    carina::RespirationFollower follower;
    for (auto _ : state) {
        t += carina::fromSeconds(1.0 / 60.0);
        benchmark::DoNotOptimize(carina::drawnPose(lungs, follower.at(timeline, t).shape(), 0));
    }
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
    const auto times = carina::medianTimes_ns(
        {{kQuiet, quiet}, {kTense, tense}, {kLeast, least}, {kFrame, frame}});
    const double step_ns = 1e9 * carina::kRespiratoryStep;
    std::printf("{\n  \"schema\": \"carina.bench.respiration/1\",\n  \"repetitions\": %d,\n"
                "  \"step_s\": %.4f,\n"
                "  \"quiet_median_ns\": %.1f,\n  \"quiet_times_real_time\": %.0f,\n"
                "  \"tension_median_ns\": %.1f,\n  \"tension_times_real_time\": %.0f,\n"
                "  \"least_median_ns\": %.1f,\n  \"frame_median_ns\": %.0f\n}\n",
                carina::kRepetitions, carina::kRespiratoryStep, times.at(kQuiet),
                step_ns / times.at(kQuiet), times.at(kTense), step_ns / times.at(kTense),
                times.at(kLeast), times.at(kFrame));
    return 0;
}
