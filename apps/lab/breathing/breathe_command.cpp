#include "apps/lab/breathing/breathe_command.h"

#include "apps/lab/breathing/condition_sweep.h"
#include "apps/lab/breathing/drawn_breathing.h"
#include "apps/lab/command/patient_options.h"
#include "apps/lab/command/patient_words.h"

#include <QCommandLineParser>
#include <QJsonArray>

#include <algorithm>
#include <cmath>

namespace carina::lab
{
namespace
{

constexpr std::array<const char*, 2> kLungNames{"right", "left"};
const QString kEveryCondition = QStringLiteral("every-condition");

constexpr const char* kBreathe = "breathe";

void addFlags(QCommandLineParser& parser)
{
    addPatientOptions(parser);
    addPositionOption(parser);
    addValueOptions(parser, {"rate-per-min", "tidal-volume-ml", "seconds", "level"});
    parser.addOption(QCommandLineOption{kEveryCondition});
}

Result<std::optional<std::size_t>> levelOption(const QCommandLineParser& parser)
{
    if (!parser.isSet(QStringLiteral("level")))
        return std::nullopt;
    return numberOption(parser, kBreathe, "level", 0.0, 99.0)
        .and_then([](double level) -> Result<std::optional<std::size_t>> {
            if (level != std::floor(level))
                return fail(Errc::OutOfRange, "breathe needs --level with a whole number.");
            return static_cast<std::size_t>(level);
        });
}

Result<BreathingTrial> trialOf(const QCommandLineParser& parser, const PatientBuild& build)
{
    const auto rate = numberOption(parser, kBreathe, "rate-per-min", 4.0, 60.0);
    if (!rate)
        return tl::unexpected(rate.error());
    const auto tidalVolume_ml = numberOption(parser, kBreathe, "tidal-volume-ml", 20.0, 2000.0);
    if (!tidalVolume_ml)
        return tl::unexpected(tidalVolume_ml.error());
    const auto seconds = numberOption(parser, kBreathe, "seconds", 0.1, 3600.0);
    if (!seconds)
        return tl::unexpected(seconds.error());
    const auto condition = conditionOption(parser, kBreathe);
    if (!condition)
        return tl::unexpected(condition.error());
    const auto mode = ventilatorOption(parser, kBreathe);
    if (!mode)
        return tl::unexpected(mode.error());
    BreathingTrial trial;
    trial.settings.build = build;
    trial.settings.condition = *condition;
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
            QJsonObject{{QStringLiteral("level"), qint64(level.level)},
                        {QStringLiteral("vertices"), qint64(drawn.vertices)},
                        {QStringLiteral("triangles"), qint64(drawn.triangles)},
                        {QStringLiteral("rest_volume_ml"), inMillilitres(drawn.restVolume)},
                        {QStringLiteral("max_volume_error_ml"), error_ml}});
    }
    return {
        {QStringLiteral("max_volume_error_ml"), largest_ml},
        {QStringLiteral("rest_volume_ml"), inMillilitres(levels.front().lungs[lung].restVolume)},
        {QStringLiteral("levels"), described}};
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
            QJsonObject{{QStringLiteral("level"), qint64(level.level)},
                        {QStringLiteral("frames"), qint64(of.frames)},
                        {QStringLiteral("tidal_volume_drawn_ml"), inMillilitres(of.tidalVolume)},
                        {QStringLiteral("max_volume_error_ml"), inMillilitres(of.errors.both)}});
    }
    for (std::size_t lung = 0; lung < kLungNames.size(); ++lung)
        lungs[QLatin1StringView{kLungNames[lung]}] = describeLung(drawn.levels, lung);
    const BreathingPattern& pattern = trial.settings.pattern;
    return {{QStringLiteral("schema"), QStringLiteral("carina.breathe/1")},
            {QStringLiteral("anatomy"), QString::fromStdString(anatomy.name)},
            {QStringLiteral("position"),
             QString::fromStdString(std::string{positionName(trial.settings.position)})},
            {QStringLiteral("rate_per_min"), inPerMinute(pattern.rate)},
            {QStringLiteral("tidal_volume_ml"), inMillilitres(pattern.tidalVolume)},
            {QStringLiteral("seconds"), trial.seconds},
            {QStringLiteral("frames_per_second"), trial.framesPerSecond},
            {QStringLiteral("frc_ml"), inMillilitres(drawn.functionalResidualCapacity)},
            {QStringLiteral("max_volume_error_ml"), largest_ml},
            {QStringLiteral("levels"), described},
            {QStringLiteral("lungs"), lungs}};
}

/// Whether anything is said of how to breathe.
bool isAskedForOneWay(const QCommandLineParser& parser)
{
    constexpr std::array kWays{"rate-per-min", "tidal-volume-ml", "seconds",
                               "condition",    "severity",        "side",
                               "ventilator"};
    return std::ranges::any_of(
        kWays, [&parser](const char* way) { return parser.isSet(QString::fromLatin1(way)); });
}

Result<QJsonObject> breathe(const QCommandLineParser& parser)
{
    const auto level = levelOption(parser);
    if (!level)
        return tl::unexpected(level.error());
    const auto position = positionOption(parser, kBreathe);
    if (!position)
        return tl::unexpected(position.error());
    const bool sweeps = parser.isSet(kEveryCondition);
    if (sweeps && isAskedForOneWay(parser))
        return fail(Errc::OutOfRange, "breathe takes --every-condition with --anatomy, --patient "
                                      "and --level, and nothing else.");
    // What is wrong with the rest is to be told before a set is read.
    const auto trial = sweeps ? Result<BreathingTrial>{} : trialOf(parser, {});
    if (!trial)
        return tl::unexpected(trial.error());
    auto subject = subjectOption(parser, kBreathe);
    if (!subject)
        return tl::unexpected(subject.error());
    if (sweeps)
        return sweepConditions(subject->anatomy, subject->build, *position, *level);
    BreathingTrial of = *trial;
    of.settings.build = subject->build;
    of.settings.position = *position;
    return drawBreathing(subject->anatomy, {&of, 1}, *level).map([&](const DrawnBreathing& drawn) {
        return describeBreathing(subject->anatomy, of, drawn);
    });
}

Result<QJsonObject> run(const QStringList& arguments)
{
    QCommandLineParser parser;
    addFlags(parser);
    if (const auto parsed = parseOptions(parser, kBreathe, arguments); !parsed)
        return tl::unexpected(parsed.error());
    auto result = breathe(parser);
    if (!result && result.error().code == Errc::NoGraphics)
        return fail(Errc::NoGraphics, "breathe draws, and there is no OpenGL 3.3 here ("
                                          + result.error().detail
                                          + "). Run it as ./carina lab breathe ...");
    return result;
}

constexpr std::string_view kHelp =
    R"(breathe --rate-per-min R --tidal-volume-ml V --seconds S
        [--condition NAME [--severity 0..1] [--side both|right|left]]
        [--ventilator none|volume|pressure] [--position NAME]
        [--anatomy DIR] [--patient WHO] [--level N]
    Draws the lungs of an anatomy set, or of a made patient (child), breathing for S seconds at
    60 frames per second as the respiratory mechanics have it, reads back where the shader put their
    vertices, and compares the volume these enclose with the mechanics. Every level of detail, or
    level N (0 is the finest). Conditions and positions are those of `mechanics`; a severity is 0.6
    unless given. WHO is adult, child, or figures with commas between them, as in "45 years, 182 cm,
    man, obese"; beside --anatomy it says whose breathing the set gets (an adult's). Needs a
    display. schema carina.breathe/1
      anatomy, position      name of the anatomy drawn, and how the patient lies
      rate_per_min, tidal_volume_ml, seconds, frames_per_second
                             what was asked for
      max_volume_error_ml    largest error of either lung and of both together, in any level
      frc_ml                 volume of both lungs at rest in the finest level
      levels                 per level of detail, both lungs together: level, frames,
                             max_volume_error_ml, and tidal_volume_drawn_ml, the greatest less the
                             least volume drawn in all the seconds: more than a breath's while
                             breathing settles
      lungs                  right and left: max_volume_error_ml, rest_volume_ml (in the finest
                             level drawn), levels (per level: level, vertices, triangles,
                             rest_volume_ml, max_volume_error_ml)
breathe --every-condition [--position NAME] [--anatomy DIR] [--patient WHO] [--level N]
    The same for every condition, on each side where it has one, at the severities 0.3, 0.6, 0.9 and
    1, breathed spontaneously and by volume and pressure control at 12, 20 and 40 breaths per
    minute: frames of one breath after a minute. schema carina.breathe.conditions/1
      anatomy, position      name of the anatomy drawn, and how the patient lies
      trials, frames         how many ways to breathe were drawn, and frames in all levels
      max_volume_error_ml    as above, of all
      levels                 level, max_volume_error_ml
      conditions             condition, side, max_volume_error_ml
)";

} // namespace

Command breatheCommand() { return {"breathe", kHelp, run}; }

} // namespace carina::lab
