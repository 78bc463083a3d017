#include "apps/lab/breathe_command.h"

#include "apps/lab/drawn_breathing.h"
#include "engine/anatomy/builtin_patient.h"
#include "engine/io/anatomy_set.h"

#include <QCommandLineParser>
#include <QJsonArray>

#include <algorithm>
#include <cmath>

namespace carina::lab
{
namespace
{

constexpr std::array<const char*, 2> kLungNames{"right", "left"};

void addFlags(QCommandLineParser& parser)
{
    for (const char* flag :
         {"rate-per-min", "tidal-volume-ml", "seconds", "anatomy", "patient", "level"}) {
        const QString name = QString::fromLatin1(flag);
        parser.addOption(QCommandLineOption{name, {}, name});
    }
}

/// The number given for a flag, between two bounds.
Result<double> numberOf(const QCommandLineParser& parser, const char* flag, double least,
                        double greatest)
{
    bool isNumber = false;
    const double number = parser.value(QString::fromLatin1(flag)).toDouble(&isNumber);
    if (!isNumber || !(number >= least && number <= greatest)) {
        return fail(Errc::OutOfRange,
                    QStringLiteral("breathe needs --%1 with a number from %2 to %3.")
                        .arg(QString::fromLatin1(flag))
                        .arg(least)
                        .arg(greatest)
                        .toStdString());
    }
    return number;
}

Result<BreathingTrial> trialOf(const QCommandLineParser& parser)
{
    const auto rate = numberOf(parser, "rate-per-min", 1.0, 120.0);
    if (!rate)
        return tl::unexpected(rate.error());
    const auto tidalVolume_ml = numberOf(parser, "tidal-volume-ml", 1.0, 5000.0);
    if (!tidalVolume_ml)
        return tl::unexpected(tidalVolume_ml.error());
    const auto seconds = numberOf(parser, "seconds", 0.1, 3600.0);
    if (!seconds)
        return tl::unexpected(seconds.error());
    BreathingTrial trial;
    trial.pattern.rate = perMinute(*rate);
    trial.pattern.tidalVolume = millilitres(*tidalVolume_ml);
    trial.seconds = *seconds;
    if (parser.isSet(QStringLiteral("level"))) {
        const auto level = numberOf(parser, "level", 0.0, 99.0);
        if (!level)
            return tl::unexpected(level.error());
        if (*level != std::floor(*level))
            return fail(Errc::OutOfRange, "breathe needs --level with a whole number.");
        trial.level = static_cast<std::size_t>(*level);
    }
    return trial;
}

Result<Anatomy> anatomyOf(const QCommandLineParser& parser)
{
    const QString patient = parser.value(QStringLiteral("patient"));
    if (parser.isSet(QStringLiteral("anatomy"))) {
        if (!patient.isEmpty())
            return fail(Errc::OutOfRange, "breathe takes --anatomy or --patient, not both.");
        return loadAnatomySet(parser.value(QStringLiteral("anatomy")).toStdString(),
                              AnatomyCache::defaultFolder())
            .map([](LoadedSet&& loaded) { return std::move(loaded.set.anatomy); });
    }
    if (patient == QStringLiteral("adult"))
        return builtinPatient(BuiltinPatient::Adult);
    if (patient.isEmpty() || patient == QStringLiteral("child"))
        return builtinPatient(BuiltinPatient::TwelveYears);
    return fail(Errc::OutOfRange, "breathe knows --patient adult and --patient child.");
}

double largestError_ml(const DrawnLevel& level)
{
    return inMillilitres(
        std::max({level.largestError, level.lungs[0].largestError, level.lungs[1].largestError}));
}

QJsonObject describeLung(const std::vector<DrawnLevel>& levels, std::size_t lung)
{
    QJsonArray described;
    double largest_ml = 0.0;
    for (const DrawnLevel& level : levels) {
        const DrawnLung& drawn = level.lungs[lung];
        largest_ml = std::max(largest_ml, inMillilitres(drawn.largestError));
        described.append(QJsonObject{
            {QStringLiteral("level"), qint64(level.level)},
            {QStringLiteral("vertices"), qint64(drawn.vertices)},
            {QStringLiteral("triangles"), qint64(drawn.triangles)},
            {QStringLiteral("rest_volume_ml"), inMillilitres(drawn.restVolume)},
            {QStringLiteral("max_volume_error_ml"), inMillilitres(drawn.largestError)}});
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
        largest_ml = std::max(largest_ml, largestError_ml(level));
        described.append(QJsonObject{
            {QStringLiteral("level"), qint64(level.level)},
            {QStringLiteral("frames"), qint64(level.frames)},
            {QStringLiteral("tidal_volume_drawn_ml"), inMillilitres(level.tidalVolume)},
            {QStringLiteral("max_volume_error_ml"), inMillilitres(level.largestError)}});
    }
    for (std::size_t lung = 0; lung < kLungNames.size(); ++lung)
        lungs[QLatin1StringView{kLungNames[lung]}] = describeLung(drawn.levels, lung);
    return {{QStringLiteral("schema"), QStringLiteral("carina.breathe/1")},
            {QStringLiteral("anatomy"), QString::fromStdString(anatomy.name)},
            {QStringLiteral("rate_per_min"), inPerMinute(trial.pattern.rate)},
            {QStringLiteral("tidal_volume_ml"), inMillilitres(trial.pattern.tidalVolume)},
            {QStringLiteral("seconds"), trial.seconds},
            {QStringLiteral("frames_per_second"), kFramesPerSecond},
            {QStringLiteral("frc_ml"), inMillilitres(drawn.functionalResidualCapacity)},
            {QStringLiteral("max_volume_error_ml"), largest_ml},
            {QStringLiteral("levels"), described},
            {QStringLiteral("lungs"), lungs}};
}

Result<QJsonObject> run(const QStringList& arguments)
{
    QCommandLineParser parser;
    addFlags(parser);
    if (!parser.parse(QStringList{QStringLiteral("breathe")} + arguments)
        || !parser.positionalArguments().isEmpty())
        return fail(Errc::OutOfRange, "breathe does not know what to do with its arguments: "
                                          + arguments.join(QLatin1Char(' ')).toStdString() + ".");
    const auto trial = trialOf(parser);
    if (!trial)
        return tl::unexpected(trial.error());
    const auto anatomy = anatomyOf(parser);
    if (!anatomy)
        return tl::unexpected(anatomy.error());
    const auto drawn = drawBreathing(*anatomy, *trial);
    if (drawn)
        return describeBreathing(*anatomy, *trial, *drawn);
    if (drawn.error().code == Errc::NoGraphics)
        return fail(Errc::NoGraphics, "breathe draws, and there is no OpenGL 3.3 here ("
                                          + drawn.error().detail
                                          + "). Run it as ./carina lab breathe ...");
    return tl::unexpected(drawn.error());
}

constexpr std::string_view kHelp =
    R"(breathe --rate-per-min R --tidal-volume-ml V --seconds S
        [--anatomy DIR | --patient adult|child] [--level N]
    Draws the lungs of an anatomy set, or of a built-in patient (child), breathing for S seconds at
    60 frames per second, reads back where the shader put their vertices, and compares the volume
    these enclose with the volume commanded. Every level of detail, or level N (0 is the finest).
    Needs a display. schema carina.breathe/1
      anatomy                name of the anatomy drawn
      rate_per_min, tidal_volume_ml, seconds, frames_per_second
                             what was asked for
      max_volume_error_ml    largest error of either lung and of both together, in any level
      frc_ml                 volume of both lungs at rest in the finest level
      levels                 per level of detail, both lungs together: level, frames,
                             max_volume_error_ml, and tidal_volume_drawn_ml, the greatest less the
                             least volume drawn
      lungs                  right and left: max_volume_error_ml, rest_volume_ml (in the finest
                             level drawn), levels (per level: level, vertices, triangles,
                             rest_volume_ml, max_volume_error_ml)
)";

} // namespace

Command breatheCommand() { return {"breathe", kHelp, run}; }

} // namespace carina::lab
