#include "apps/lab/breathing/breathe_page.h"
#include "apps/lab/breathing/condition_sweep.h"
#include "apps/lab/breathing/drawn_breathing.h"
#include "apps/lab/command/patient_options.h"
#include "apps/lab/command/patient_words.h"
#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "engine/session/facts/fact_rules.h"

#include <QJsonArray>

#include <algorithm>

namespace carina::lab
{
namespace
{

constexpr std::array<const char*, 2> kLungNames{"right", "left"};

// As the options say, and as a session has them.
constexpr double kLeastRate_perMin = 4.0;
constexpr double kMostRate_perMin = 60.0;
constexpr double kLeastTidalVolume_ml = 10.0;
constexpr double kMostTidalVolume_ml = 2000.0;
static_assert(perMinute(kLeastRate_perMin) == kSlowestBreathing);
static_assert(perMinute(kMostRate_perMin) == kFastestBreathing);
static_assert(millilitres(kLeastTidalVolume_ml) == kSmallestTidalVolume);
static_assert(millilitres(kMostTidalVolume_ml) == kLargestTidalVolume);

Result<std::optional<std::size_t>> levelOption(const Words& words)
{
    if (!words.has(breathe_option::kLevel))
        return std::nullopt;
    return words.whole(breathe_option::kLevel, 0, 99, 0).map([](std::int64_t level) {
        return std::optional{static_cast<std::size_t>(level)};
    });
}

/// What the options say, but who breathes and in which position. Rate and volume are those of a
/// quiet breath of this person unless given.
Result<BreathingTrial> trialOf(const Words& words, const PatientBuild& build)
{
    BreathingTrial trial;
    trial.settings.build = build;
    trial.settings.pattern = restingPattern(build);
    const BreathingPattern& quiet = trial.settings.pattern;
    const auto rate = words.number(breathe_option::kRate, kLeastRate_perMin, kMostRate_perMin,
                                   inPerMinute(quiet.rate));
    if (!rate)
        return tl::unexpected(rate.error());
    const auto tidalVolume_ml = words.number(breathe_option::kTidalVolume, kLeastTidalVolume_ml,
                                             kMostTidalVolume_ml, inMillilitres(quiet.tidalVolume));
    if (!tidalVolume_ml)
        return tl::unexpected(tidalVolume_ml.error());
    const auto seconds = words.number(breathe_option::kSeconds, 0.1, 3600.0);
    if (!seconds)
        return tl::unexpected(seconds.error());
    const auto condition = conditionOption(words);
    if (!condition)
        return tl::unexpected(condition.error());
    const auto mode = ventilatorOption(words);
    if (!mode)
        return tl::unexpected(mode.error());
    if (condition->kind != ConditionKind::Normal)
        trial.settings.conditions = {*condition};
    trial.settings.pattern.rate = perMinute(*rate);
    trial.settings.pattern.tidalVolume = millilitres(*tidalVolume_ml);
    trial.settings.ventilator.mode = *mode;
    trial.seconds = *seconds;
    return trial;
}

QJsonObject describeLung(const std::vector<DrawnLevel>& levels, std::size_t lung)
{
    QJsonArray described;
    double largest_ml = 0.0;
    for (const DrawnLevel& level : levels) {
        const DrawnLung& drawn = level.lungs[lung];
        const double error_ml = inMillilitres(level.trials.front().errors.lungs[lung]);
        largest_ml = std::max(largest_ml, error_ml);
        described.append(
            QJsonObject{{breathe_key::kLevelOfLung, qint64(level.level)},
                        {breathe_key::kVertices, qint64(drawn.vertices)},
                        {breathe_key::kTriangles, qint64(drawn.triangles)},
                        {breathe_key::kRestVolumeInLevel, inMillilitres(drawn.restVolume)},
                        {breathe_key::kErrorOfLungInLevel, error_ml}});
    }
    return {{breathe_key::kErrorOfLung, largest_ml},
            {breathe_key::kRestVolume, inMillilitres(levels.front().lungs[lung].restVolume)},
            {breathe_key::kLevelsOfLung, described}};
}

QJsonObject describeBreathing(const Anatomy& anatomy, const BreathingTrial& trial,
                              const DrawnBreathing& drawn)
{
    QJsonArray described;
    QJsonObject lungs;
    double largest_ml = 0.0;
    for (const DrawnLevel& level : drawn.levels) {
        const DrawnTrial& of = level.trials.front();
        largest_ml = std::max(largest_ml, inMillilitres(of.errors.largest()));
        described.append(
            QJsonObject{{breathe_key::kLevel, qint64(level.level)},
                        {breathe_key::kFrames, qint64(of.frames)},
                        {breathe_key::kDrawnTidalVolume, inMillilitres(of.tidalVolume)},
                        {breathe_key::kErrorOfLevel, inMillilitres(of.errors.both)}});
    }
    for (std::size_t lung = 0; lung < kLungNames.size(); ++lung)
        lungs[QLatin1StringView{kLungNames[lung]}] = describeLung(drawn.levels, lung);
    const BreathingPattern& pattern = trial.settings.pattern;
    return {
        {breathe_key::kSchema, QLatin1StringView{breathe_key::kSchema.help}},
        {breathe_key::kAnatomy, QString::fromStdString(anatomy.name)},
        {breathe_key::kPosition,
         QString::fromStdString(std::string{positionName(trial.settings.position)})},
        {breathe_key::kRate, inPerMinute(pattern.rate)},
        {breathe_key::kTidalVolume, inMillilitres(pattern.tidalVolume)},
        {breathe_key::kSeconds, trial.seconds},
        {breathe_key::kFramesPerSecond, trial.framesPerSecond},
        {breathe_key::kFunctionalResidualCapacity, inMillilitres(drawn.functionalResidualCapacity)},
        {breathe_key::kLargestError, largest_ml},
        {breathe_key::kLevels, described},
        {breathe_key::kLungs, lungs}};
}

/// Whether anything is said of how to breathe.
bool isAskedForOneWay(const Words& words)
{
    constexpr std::array kWays{breathe_option::kRate,
                               breathe_option::kTidalVolume,
                               breathe_option::kSeconds,
                               kCondition,
                               kSeverity,
                               kSide,
                               kVentilator};
    return std::ranges::any_of(kWays, [&words](const Option& way) { return words.has(way); });
}

Result<QJsonObject> drawnBreaths(const Words& words)
{
    const auto level = levelOption(words);
    if (!level)
        return tl::unexpected(level.error());
    const auto position = positionOption(words);
    if (!position)
        return tl::unexpected(position.error());
    const bool sweeps = words.has(breathe_option::kEveryCondition);
    if (sweeps && isAskedForOneWay(words))
        return words.refuse(QStringLiteral("takes --every-condition with --anatomy, --patient, "
                                           "--position and --level, and nothing else."));
    // What is wrong with the rest is to be told before a set is read.
    const auto build = buildOption(words);
    if (!build)
        return tl::unexpected(build.error());
    const auto trial = sweeps ? Result<BreathingTrial>{} : trialOf(words, *build);
    if (!trial)
        return tl::unexpected(trial.error());
    auto subject = subjectOption(words);
    if (!subject)
        return tl::unexpected(subject.error());
    if (sweeps)
        return sweepConditions(subject->anatomy, subject->build, *position, *level);
    BreathingTrial of = *trial;
    of.settings.position = *position;
    return drawBreathing(subject->anatomy, {&of, 1}, *level).map([&](const DrawnBreathing& drawn) {
        return describeBreathing(subject->anatomy, of, drawn);
    });
}

Result<QJsonObject> breathe(const Words& words)
{
    auto result = drawnBreaths(words);
    if (!result && result.error().code == Errc::NoGraphics)
        return fail(Errc::NoGraphics, "breathe needs OpenGL 3.3, which is not available ("
                                          + result.error().detail
                                          + "). Run it as ./carina lab breathe ...");
    return result;
}

Use breathOfOneWay()
{
    return {.lines = {"--seconds S [--rate-per-min R] [--tidal-volume-ml V] [OPTION...]"},
            .text =
                "Draws the lungs of a built-in patient (the child unless another is asked for) or "
                "of an anatomy set, breathing at 60 frames per second as calculated by the "
                "respiratory mechanics. Reads back where the shader put the vertices, and compares "
                "the volume that they enclose with the volume of the mechanics. Needs a display.",
            .options = {breathe_option::kRate, breathe_option::kTidalVolume,
                        breathe_option::kSeconds, kCondition, kSeverity, kSide, kVentilator,
                        kPosition, kAnatomy, kPatient, breathe_option::kLevel},
            .schema = breathe_key::kSchema,
            .keys = {breathe_key::kAnatomy,
                     breathe_key::kPosition,
                     breathe_key::kRate,
                     breathe_key::kTidalVolume,
                     breathe_key::kSeconds,
                     breathe_key::kFramesPerSecond,
                     breathe_key::kLargestError,
                     breathe_key::kFunctionalResidualCapacity,
                     breathe_key::kLevels,
                     breathe_key::kLevel,
                     breathe_key::kFrames,
                     breathe_key::kDrawnTidalVolume,
                     breathe_key::kErrorOfLevel,
                     breathe_key::kLungs,
                     breathe_key::kErrorOfLung,
                     breathe_key::kRestVolume,
                     breathe_key::kLevelsOfLung,
                     breathe_key::kLevelOfLung,
                     breathe_key::kVertices,
                     breathe_key::kTriangles,
                     breathe_key::kRestVolumeInLevel,
                     breathe_key::kErrorOfLungInLevel}};
}

Use breathsOfEveryCondition()
{
    return {.lines =
                {"--every-condition [--position NAME] [--anatomy DIR] [--patient WHO] [--level N]"},
            .text =
                "The same for every condition, on each side on which it can be, at the severities "
                "0.3, 0.6, 0.9 and 1, breathed spontaneously and by volume and pressure control at "
                "12, 20 and 40 breaths per minute. Draws the frames of one breath after a minute "
                "of breathing. Needs a display.",
            .options = {breathe_option::kEveryCondition, kPosition, kAnatomy, kPatient,
                        breathe_option::kLevel},
            .schema = breathe_sweep_key::kSchema,
            .keys = {breathe_sweep_key::kAnatomy, breathe_sweep_key::kPosition,
                     breathe_sweep_key::kTrials, breathe_sweep_key::kFrames,
                     breathe_sweep_key::kLargestError, breathe_sweep_key::kLevels,
                     breathe_sweep_key::kLevel, breathe_sweep_key::kErrorOfLevel,
                     breathe_sweep_key::kConditions, breathe_sweep_key::kCondition,
                     breathe_sweep_key::kSide, breathe_sweep_key::kErrorOfCondition}};
}

} // namespace

Command breatheCommand()
{
    return {.name = "breathe",
            .theme = "the patient",
            .summary = "draws breathing lungs and measures the volume that was drawn",
            .uses = {breathOfOneWay(), breathsOfEveryCondition()},
            .draws = true,
            .experiment = breathe};
}

} // namespace carina::lab
