#include "apps/lab/breathing/breathing_trial.h"

#include <cmath>

namespace carina::lab
{
namespace
{

constexpr double kSettled_s = 60.0;

} // namespace

BreathingTrial settledBreath(const PatientBuild& build, const LungCondition& condition,
                             Frequency rate, double frames)
{
    BreathingTrial trial;
    trial.settings.build = build;
    if (condition.kind != ConditionKind::Normal)
        trial.settings.conditions = {condition};
    trial.settings.pattern = restingPattern(build);
    trial.settings.pattern.rate = rate;
    trial.settle = kSettled_s;
    trial.seconds = 1.0 / rate.si;
    trial.framesPerSecond = frames / trial.seconds;
    return trial;
}

std::vector<ChestShape> shapesOf(const BreathingTrial& trial)
{
    RespiratoryFold fold{trial.settings};
    std::vector<ChestShape> shapes;
    const auto frames = static_cast<std::size_t>(trial.seconds * trial.framesPerSecond);
    std::int64_t step = 0;
    for (std::size_t frame = 0; frame <= frames; ++frame) {
        const double time = trial.settle + static_cast<double>(frame) / trial.framesPerSecond;
        for (; step < std::llround(time / kRespiratoryStep); ++step)
            fold.step();
        shapes.push_back(
            chestShape(trial.settings.build, fold.system(), fold.content(), fold.moment()));
    }
    return shapes;
}

Volume gasOf(const ChestShape& shape) { return shape.lungs[0].gas + shape.lungs[1].gas; }

} // namespace carina::lab
