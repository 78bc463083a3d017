#include "apps/lab/breathing/condition_sweep.h"

#include "apps/lab/breathing/breathe_page.h"
#include "apps/lab/breathing/drawn_breathing.h"
#include "apps/lab/command/patient_words.h"

#include <QJsonArray>

#include <algorithm>

namespace carina::lab
{
namespace
{

constexpr std::array kSeverities{0.3, 0.6, 0.9, 1.0};
constexpr std::array kRates_perMin{12.0, 20.0, 40.0};
constexpr std::array kModes{VentilationMode::Spontaneous, VentilationMode::VolumeControl,
                            VentilationMode::PressureControl};
constexpr double kFramesPerBreath = 5.0;

/// A condition on a side, and the trials that are of it.
struct SweptCondition {
    NamedCondition named;
    ConditionSide side = ConditionSide::Both;
    std::size_t first = 0;
    std::size_t end = 0;
};

struct Sweep {
    PatientBuild build;
    BodyPosition position;
    std::vector<SweptCondition> conditions;
    std::vector<BreathingTrial> trials;
};

BreathingTrial trialOf(const Sweep& sweep, const LungCondition& condition, VentilationMode mode,
                       double rate_perMin)
{
    BreathingTrial trial =
        settledBreath(sweep.build, condition, perMinute(rate_perMin), kFramesPerBreath);
    trial.settings.position = sweep.position;
    trial.settings.ventilator.mode = mode;
    return trial;
}

void add(const NamedCondition& named, ConditionSide side, Sweep& sweep)
{
    const std::size_t first = sweep.trials.size();
    const bool isHealthy = named.kind == ConditionKind::Normal;
    for (const double severity : kSeverities)
        for (const VentilationMode mode : kModes)
            for (const double rate : kRates_perMin)
                if (!isHealthy || severity == kSeverities.front())
                    sweep.trials.push_back(
                        trialOf(sweep, {named.kind, isHealthy ? 0.0 : severity, side}, mode, rate));
    sweep.conditions.push_back({named, side, first, sweep.trials.size()});
}

Sweep sweepOf(const PatientBuild& build, BodyPosition position)
{
    Sweep sweep{build, position, {}, {}};
    for (const NamedCondition& named : kNamedConditions) {
        if (named.bothSides)
            add(named, ConditionSide::Both, sweep);
        if (!named.oneSide)
            continue;
        add(named, ConditionSide::Right, sweep);
        add(named, ConditionSide::Left, sweep);
    }
    return sweep;
}

double largest_ml(const DrawnLevel& level, std::size_t first, std::size_t end)
{
    double largest = 0.0;
    for (std::size_t trial = first; trial < end; ++trial)
        largest = std::max(largest, inMillilitres(level.trials[trial].errors.largest()));
    return largest;
}

QJsonArray describeConditions(const Sweep& sweep, const DrawnBreathing& drawn)
{
    QJsonArray described;
    for (const SweptCondition& swept : sweep.conditions) {
        double largest = 0.0;
        for (const DrawnLevel& level : drawn.levels)
            largest = std::max(largest, largest_ml(level, swept.first, swept.end));
        described.append(QJsonObject{
            {breathe_sweep_key::kCondition, QString::fromStdString(std::string{swept.named.name})},
            {breathe_sweep_key::kSide, QString::fromStdString(std::string{sideName(swept.side)})},
            {breathe_sweep_key::kErrorOfCondition, largest}});
    }
    return described;
}

QJsonObject describeSweep(const Anatomy& anatomy, const Sweep& sweep, const DrawnBreathing& drawn)
{
    QJsonArray levels;
    double largest = 0.0;
    qint64 frames = 0;
    for (const DrawnLevel& level : drawn.levels) {
        const double ofLevel = largest_ml(level, 0, level.trials.size());
        largest = std::max(largest, ofLevel);
        for (const DrawnTrial& trial : level.trials)
            frames += qint64(trial.frames);
        levels.append(QJsonObject{{breathe_sweep_key::kLevel, qint64(level.level)},
                                  {breathe_sweep_key::kErrorOfLevel, ofLevel}});
    }
    return {{breathe_sweep_key::kSchema, QLatin1StringView{breathe_sweep_key::kSchema.help}},
            {breathe_sweep_key::kAnatomy, QString::fromStdString(anatomy.name)},
            {breathe_sweep_key::kPosition,
             QString::fromStdString(std::string{positionName(sweep.position)})},
            {breathe_sweep_key::kTrials, qint64(sweep.trials.size())},
            {breathe_sweep_key::kFrames, frames},
            {breathe_sweep_key::kLargestError, largest},
            {breathe_sweep_key::kLevels, levels},
            {breathe_sweep_key::kConditions, describeConditions(sweep, drawn)}};
}

} // namespace

Result<QJsonObject> sweepConditions(const Anatomy& anatomy, const PatientBuild& build,
                                    BodyPosition position, std::optional<std::size_t> level)
{
    const Sweep sweep = sweepOf(build, position);
    return drawBreathing(anatomy, sweep.trials, level).map([&](const DrawnBreathing& drawn) {
        return describeSweep(anatomy, sweep, drawn);
    });
}

} // namespace carina::lab
