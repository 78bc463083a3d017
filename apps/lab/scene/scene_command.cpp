#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "apps/lab/scene/scene_experiment.h"
#include "engine/core/units.h"
#include "engine/io/files/whole_file.h"

#include <QDir>
#include <QJsonArray>

namespace carina::lab
{
namespace
{

namespace scene_option
{
constexpr Option kScenario{"scenario", "NAME", "of the long path, as in drift; wan unless given"};
constexpr Option kSeconds{"seconds", "T", "that are compared, 1 to 600; 60 unless given"};
constexpr Option kOut{"out", "DIR", "folder for a picture of each window; none unless given"};
constexpr Option kSize{"size", "WxH", "of the windows, pixels; 1280x800 unless given"};
constexpr Option kNetlab{"netlab", "PROGRAM",
                         "as root: each program in a network namespace of its own, see drift"};
constexpr Option kSeed{"seed", "N", "of the paths; 1 unless given"};
constexpr Option kPrograms{"programs", "DIR",
                           "folder with instructor/carina-instructor and trainee/carina-trainee; "
                           "those built with this program unless given"};
} // namespace scene_option

namespace scene_key
{
constexpr Key kSchema{"schema", "carina.scene/1"};
constexpr Key kScenario{"scenario", "of the long path"};
constexpr Key kNetwork{"network", "relay or netlab"};
constexpr Key kSeconds{"seconds", "that were compared"};
constexpr Key kPlayers{"programs", "one object each, the console first:"};
constexpr Key kName{"name", "of who sits there; of the picture, too", 1};
constexpr Key kStation{"station", "that it shows", 1};
constexpr Key kIsRemote{"remote", "whether it is at the end of the long path", 1};
constexpr Key kFrames{"frames_per_s", "that it drew", 1};
constexpr Key kNear{"near", "objects drawn where owner and viewer are on the spot:"};
constexpr Key kFar{"far", "where one of the two, or both, are remote, likewise:"};
constexpr Key kCompared{"compared", "an object in a frame with where its owner's program had it",
                        1};
constexpr Key kMedian_mm{"median_mm", "distance between the two, at the same session time", 1};
constexpr Key kMost_mm{"p95_mm", "95 % are not further apart", 1};
constexpr Key kMedian_deg{"median_deg", "angle between the two", 1};
constexpr Key kMost_deg{"p95_deg", "likewise", 1};
constexpr Key kWithin{"within_bound",
                      "share of them that are no further apart than speed and delay allow", 1};
constexpr Key kMistaken{"mistaken",
                        "objects in frames that were where another person's is, of recognisable"};
constexpr Key kRecognisable{"recognisable", "those of which it could be told whose they are"};
constexpr Key kChanges{"owner_changes", "frames in which an object had another owner than before"};
constexpr Key kPairs{"seen", "heads, hands and tubes of others that each program has to draw"};
constexpr Key kShare{
    "least_share",
    "of a program's frames at whose time the owner's had one of these: those that have it, the "
    "least of all"};
constexpr Key kLeast{"least_drawn", "which that is: the program, whose object, and what"};
} // namespace scene_key

/// Of the comparisons, and of the frames of a program. The rest is for what a program that shares
/// its processor with eight others does late.
constexpr double kLeastWithin = 0.99;
constexpr double kLeastDrawn = 0.95;

Result<QSize> sceneSize(const Words& words)
{
    if (!words.has(scene_option::kSize))
        return QSize{1280, 800};
    const QStringList parts = words.text(scene_option::kSize).split(QLatin1Char{'x'});
    const QSize size = parts.size() == 2 ? QSize{parts[0].toInt(), parts[1].toInt()} : QSize{};
    if (size.width() < 100 || size.height() < 100)
        return words.refuse(QStringLiteral("takes --size WIDTHxHEIGHT, as in 1280x800."));
    return size;
}

Result<SceneSettings> sceneSettings(const Words& words)
{
    const auto seconds = words.number(scene_option::kSeconds, 1.0, 600.0, 60.0);
    if (!seconds)
        return tl::unexpected(seconds.error());
    const auto seed = words.whole(scene_option::kSeed, 0, 4294967295, 1);
    if (!seed)
        return tl::unexpected(seed.error());
    const auto size = sceneSize(words);
    if (!size)
        return tl::unexpected(size.error());
    const QString name = words.text(scene_option::kScenario);
    const auto scenario = findScenario(name.isEmpty() ? "wan" : name.toStdString());
    if (!scenario)
        return tl::unexpected(scenario.error());
    const bool hasTrace = scenario->forward.trace || scenario->backward.trace;
    if (hasTrace && words.has(scene_option::kNetlab))
        return words.refuse(QStringLiteral("takes no trace with --netlab."));
    const QString folder = words.text(scene_option::kOut);
    if (!folder.isEmpty())
        if (const auto opened = openFolder(folder.toStdString()); !opened)
            return words.refuse(QStringLiteral("cannot write into --out %1.").arg(folder));
    return SceneSettings{.programs = SessionPrograms::in(words.text(scene_option::kPrograms)),
                         .scenario = *scenario,
                         .netlab = words.text(scene_option::kNetlab),
                         .seed = static_cast<std::uint32_t>(*seed),
                         .watched = fromSeconds(*seconds),
                         .size = *size,
                         .folder = folder};
}

double sceneMm(double distance) { return inMillimetres(metres(distance)); }
double sceneDeg(double angle) { return inDegrees(radians(angle)); }

double shareWithin(const SceneDifference& difference)
{
    return difference.distances.empty()
               ? 0.0
               : 1.0 - double(difference.beyond) / double(difference.distances.size());
}

QJsonObject sceneDifference(const SceneDifference& difference)
{
    QJsonObject object{{scene_key::kCompared, qint64(difference.distances.size())}};
    if (difference.distances.empty())
        return object;
    object[scene_key::kWithin] = shareWithin(difference);
    object[scene_key::kMedian_mm] = sceneMm(quantileOf(difference.distances, 0.5));
    object[scene_key::kMost_mm] = sceneMm(quantileOf(difference.distances, 0.95));
    object[scene_key::kMedian_deg] = sceneDeg(quantileOf(difference.angles, 0.5));
    object[scene_key::kMost_deg] = sceneDeg(quantileOf(difference.angles, 0.95));
    return object;
}

bool isAcceptable(const SceneComparison& compared)
{
    return shareWithin(compared.near) >= kLeastWithin && shareWithin(compared.far) >= kLeastWithin
           && isWithin(compared.near, kBoundsOnTheSpot) && compared.ownerChanges == 0
           && compared.mistaken == 0 && compared.recognisable > 0
           && compared.leastShare >= kLeastDrawn;
}

QString leastDrawn(const SceneFigures& figures)
{
    const auto nameOf = [&](int participant) { // they are in the order of their numbers
        return figures.players[std::size_t(participant)].name;
    };
    const DrawnPair& pair = figures.compared.leastDrawn;
    const char* what = pair.kind == ObjectKind::Head   ? "head"
                       : pair.kind == ObjectKind::Hand ? "hand"
                                                       : "tube";
    return QStringLiteral("%1: %2, %3")
        .arg(nameOf(pair.viewer), nameOf(pair.owner), QLatin1StringView{what});
}

QJsonObject sceneReport(const SceneFigures& figures, const SceneSettings& settings)
{
    QJsonArray programs;
    for (const ScenePlayer& player : figures.players)
        programs.append(QJsonObject{{scene_key::kName, player.name},
                                    {scene_key::kStation, player.drawn.station},
                                    {scene_key::kIsRemote, player.drawn.isRemote},
                                    {scene_key::kFrames, player.framesPerSecond}});
    const SceneComparison& compared = figures.compared;
    return {{scene_key::kSchema, QLatin1StringView{scene_key::kSchema.help}},
            {scene_key::kScenario, QString::fromStdString(settings.scenario.name)},
            {scene_key::kNetwork, figures.network},
            {scene_key::kSeconds, toSeconds(settings.watched)},
            {scene_key::kPlayers, programs},
            {scene_key::kNear, sceneDifference(compared.near)},
            {scene_key::kFar, sceneDifference(compared.far)},
            {scene_key::kChanges, compared.ownerChanges},
            {scene_key::kMistaken, qint64(compared.mistaken)},
            {scene_key::kRecognisable, qint64(compared.recognisable)},
            {scene_key::kPairs, compared.pairs},
            {scene_key::kShare, compared.leastShare},
            {scene_key::kLeast, leastDrawn(figures)},
            {kAcceptable, isAcceptable(compared)}};
}

Result<QJsonObject> scene(const Words& words)
{
    return sceneSettings(words).and_then([](const SceneSettings& settings) {
        return runScene(settings).map(
            [&](const SceneFigures& figures) { return sceneReport(figures, settings); });
    });
}

} // namespace

Command sceneCommand()
{
    return {
        .name = "scene",
        .theme = "drift and network",
        .summary = "two stations with three people each: do all draw all where they are?",
        .uses =
            {{.lines = {"[--scenario NAME] [--seconds T] [--out DIR] [--size WxH] [--seed N]",
                        "[--netlab PROGRAM] [--programs DIR]"},
              .text =
                  "Starts a console with two stations, a child's and an adult's, and three "
                  "trainees with simulated trackers at each. One of each three is at the end of "
                  "a long path, and has chosen a place at the patient's left. Each program has "
                  "a display of its own (Xvfb). Compares from their journals each head, hand "
                  "and tube that a program drew with where its owner's program had it at that "
                  "session time, between two of the owner's frames, and takes a picture of each "
                  "window. Acceptable are 99 % of the comparisons within their bound, which is "
                  "that of the tracker, the object's own speed and the delay; on the spot, 1 mm "
                  "and 1 degree in the median and 2.5 of both in 95 %; no object that "
                  "changes its owner, or is where another's is; and everybody drawn in 95 % of "
                  "the frames at whose time their own program had them.",
              .options = {scene_option::kScenario, scene_option::kSeconds, scene_option::kOut,
                          scene_option::kSize, scene_option::kSeed, scene_option::kNetlab,
                          scene_option::kPrograms},
              .schema = scene_key::kSchema,
              .keys = {scene_key::kScenario,     scene_key::kNetwork,  scene_key::kSeconds,
                       scene_key::kPlayers,      scene_key::kName,     scene_key::kStation,
                       scene_key::kIsRemote,     scene_key::kFrames,   scene_key::kNear,
                       scene_key::kFar,          scene_key::kCompared, scene_key::kWithin,
                       scene_key::kMedian_mm,    scene_key::kMost_mm,  scene_key::kMedian_deg,
                       scene_key::kMost_deg,     scene_key::kChanges,  scene_key::kMistaken,
                       scene_key::kRecognisable, scene_key::kPairs,    scene_key::kShare,
                       scene_key::kLeast,        kAcceptable}}},
        .experiment = scene};
}

} // namespace carina::lab
