#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "apps/lab/registration/landmark_table.h"
#include "engine/io/files/json_fields.h"
#include "engine/registration/landmarks/landmark_catalogue.h"
#include "engine/registration/landmarks/layout_check.h"

#include <cmath>

namespace carina::lab
{
namespace
{

namespace tre_option
{
constexpr Option kHeight{"height", "M",
                         "body height in metres, 1 to 2.1; takes the place of the files"};
constexpr Option kLandmarks{
    "landmarks", "N",
    "how many landmarks of that body are touched, 3 to 8, and 8 unless given: the first 4 are on "
    "the rib cage, 6 include the angles of the jaw, 8 include the tenth ribs"};
constexpr Option kFle{"fle", "MM", "root mean square error of each touch; 1 unless given"};
constexpr Option kCovariance{"covariance", "",
                             "takes the covariance of each touch from LANDMARKS.csv instead, and "
                             "weights the touch by it in the fit"};
constexpr Option kDegrees{
    "degrees", "N",
    "degrees of freedom from which the size of these errors was estimated, 1 to 1e6, such as "
    "3 N - 6 for the residuals of N landmarks; unless given, the size is taken as known"};
constexpr Option kLimit{"limit", "MM",
                        "greatest rms_mm that the worst target may have; it is not compared with "
                        "bound95_mm"};
constexpr Option kCandidates{"candidates", "FILE",
                             "further landmarks, in the columns of LANDMARKS.csv, from which the "
                             "one that helps most is chosen"};
} // namespace tre_option

namespace tre_key
{
constexpr Key kSchema{"schema", "carina.tre/1"};
constexpr Key kLandmarks{"landmarks", "how many there are"};
constexpr Key kTargets{"targets", "one object per target, in their order:"};
constexpr Key kName{"name", "of the target", 1};
constexpr Key kRms{"rms_mm", "root mean square error", 1};
constexpr Key kBound{"bound95_mm", "95 % of registrations have a smaller error", 1};
constexpr Key kWeakest{
    "weakest", "\"left-right\", \"front-back\" or \"head-feet\": the axis nearest to weakest_A", 1};
constexpr Key kWeakestDirection{"weakest_A", "[x, y, z], the direction of the largest error", 1};
constexpr Key kWorst{"worst", "name of the target with the largest error"};
constexpr Key kWithinLimit{"within_limit",
                           "with --limit: whether rms_mm of the worst target is no more than that"};
constexpr Key kNext{"next",
                    "with --candidates: the landmark that helps most; null where none helps:"};
constexpr Key kNextName{"name", "of the landmark", 1};
constexpr Key kNextRms{"worst_rms_mm", "rms_mm of the worst target with it", 1};
} // namespace tre_key

/// What a command line needs.
constexpr const char* kTreReminder = "tre needs LANDMARKS.csv TARGETS.csv, or --height M; and "
                                     "--fle MM, or --covariance with files.";
constexpr Length kUsualTreFle = millimetres(1.0);

struct Task {
    NamedPlaces landmarks;
    NamedPlaces targets;
    NamedPlaces candidates;
    Weighting weighting = Weighting::Alike;
    double degrees = kKnownExactly;
    Length limit;
};

/// Places by which an intubation is judged, as shares of the height of the built-in man.
NamedPlaces targetsOfHeight(double height)
{
    const std::vector<std::pair<std::string, Vec3>> shares{
        {"glottis", {0.0, -0.0151, 0.0710}},
        {"carina", {0.0, 0.0, 0.0}},
        {"incisors", {0.0, -0.0588, 0.1001}},
        {"left lung base", {0.051, 0.011, -0.097}},
        {"right lung base", {-0.051, 0.011, -0.097}}};
    NamedPlaces targets;
    for (const auto& [name, share] : shares) {
        targets.names.push_back(name);
        targets.places.push_back({height * share, Mat3::Zero()});
    }
    return targets;
}

NamedPlaces landmarksOfHeight(Length height, std::size_t count)
{
    const LandmarkCatalogue eight =
        ribCageAndJawCatalogue(ribCageCatalogue(height, {}), furtherPlaces(height));
    NamedPlaces landmarks;
    for (std::size_t i = 0; i < count; ++i) {
        landmarks.names.push_back(eight.landmarks[i].name);
        landmarks.places.push_back({eight.landmarks[i].p_AQ, Mat3::Zero()});
    }
    return landmarks;
}

Result<void> readPlacesInto(Task& task, const Words& words)
{
    const bool withCovariances = words.has(tre_option::kCovariance);
    if (words.has(tre_option::kHeight)) {
        const Result<double> height = words.number(tre_option::kHeight, 1.0, 2.1);
        const Result<std::int64_t> count = words.whole(tre_option::kLandmarks, 3, 8, 8);
        if (!height)
            return tl::unexpected(height.error());
        if (!count)
            return tl::unexpected(count.error());
        task.landmarks = landmarksOfHeight(metres(*height), static_cast<std::size_t>(*count));
        task.targets = targetsOfHeight(*height);
    } else {
        auto landmarks = readPlaces(words.files()[0], withCovariances);
        auto targets = readPlaces(words.files()[1], false);
        if (!landmarks || !targets)
            return tl::unexpected((landmarks ? targets : landmarks).error());
        task.landmarks = std::move(*landmarks);
        task.targets = std::move(*targets);
    }
    if (!words.has(tre_option::kCandidates))
        return {};
    auto candidates = readPlaces(words.text(tre_option::kCandidates), withCovariances);
    if (!candidates)
        return tl::unexpected(candidates.error());
    task.candidates = std::move(*candidates);
    return {};
}

Result<Task> taskOf(const Words& words)
{
    Task task;
    if (const auto read = readPlacesInto(task, words); !read)
        return tl::unexpected(read.error());
    const Result<Length> fle = positiveMillimetres(words, tre_option::kFle, kUsualTreFle);
    const Result<Length> limit =
        positiveMillimetres(words, tre_option::kLimit, metres(kKnownExactly));
    const Result<double> degrees = words.number(tre_option::kDegrees, 1.0, 1e6, kKnownExactly);
    if (!fle || !limit)
        return tl::unexpected((fle ? limit : fle).error());
    if (!degrees)
        return tl::unexpected(degrees.error());
    task.limit = *limit;
    task.degrees = *degrees;
    if (words.has(tre_option::kCovariance)) {
        task.weighting = Weighting::ByCovariance;
        return task;
    }
    for (NamedPlaces* places : {&task.landmarks, &task.candidates})
        for (LandmarkError& place : places->places)
            place.covariance_A = (fle->si * fle->si / 3.0) * Mat3::Identity();
    return task;
}

QJsonObject describeTarget(const std::string& name, const TargetError& error)
{
    static const std::array kAxes{QStringLiteral("left-right"), QStringLiteral("front-back"),
                                  QStringLiteral("head-feet")};
    return {{tre_key::kName, QString::fromStdString(name)},
            {tre_key::kRms, inMillimetres(error.rms)},
            {tre_key::kBound, inMillimetres(error.bound)},
            {tre_key::kWeakest, kAxes[static_cast<std::size_t>(error.weakestAxis)]},
            {tre_key::kWeakestDirection,
             QJsonArray{error.weakest_A.x(), error.weakest_A.y(), error.weakest_A.z()}}};
}

std::vector<Vec3> pointsOf(const NamedPlaces& places)
{
    std::vector<Vec3> points;
    for (const LandmarkError& place : places.places)
        points.push_back(place.p_AQ);
    return points;
}

QJsonValue describeNext(const std::optional<NextLandmark>& next,
                        const std::vector<std::string>& names)
{
    if (!next)
        return QJsonValue::Null;
    return QJsonObject{{tre_key::kNextName, QString::fromStdString(names[next->candidate])},
                       {tre_key::kNextRms, inMillimetres(next->worstRms)}};
}

Result<QJsonObject> predict(const Task& task, const Words& words)
{
    const std::vector<Vec3> targets = pointsOf(task.targets);
    const auto report = checkLayout(task.landmarks.places, targets, task.limit, task.weighting);
    const auto covariance = fitCovariance(task.landmarks.places, task.weighting);
    if (!report || !covariance)
        return fail(report.error().code,
                    "The error cannot be predicted: " + report.error().detail + ".");
    QJsonArray described;
    for (std::size_t t = 0; t < targets.size(); ++t)
        described.append(describeTarget(task.targets.names[t],
                                        targetError(*covariance, targets[t], task.degrees)));
    QJsonObject object{
        {tre_key::kSchema, QLatin1StringView{tre_key::kSchema.help}},
        {tre_key::kLandmarks, static_cast<qint64>(task.landmarks.names.size())},
        {tre_key::kTargets, described},
        {tre_key::kWorst, QString::fromStdString(task.targets.names[report->worst])}};
    if (words.has(tre_option::kLimit))
        object.insert(tre_key::kWithinLimit, report->withinLimit);
    if (!words.has(tre_option::kCandidates))
        return object;
    const auto next =
        nextLandmark(task.landmarks.places, task.candidates.places, targets, task.weighting);
    if (!next)
        return fail(next.error().code, "A candidate cannot be used: " + next.error().detail + ".");
    object.insert(tre_key::kNext, describeNext(*next, task.candidates.names));
    return object;
}

/// What does not go together, in a sentence; empty where all does.
std::string faultOf(const Words& words)
{
    const bool byHeight = words.has(tre_option::kHeight);
    const QStringList files = words.files();
    if (byHeight && !files.isEmpty())
        return "--height takes the place of files, such as '" + files[0].toStdString() + "'.";
    if (!byHeight && files.isEmpty())
        return "No file and no --height is given.";
    if (!byHeight && files.size() == 1)
        return "The file of targets is missing beside '" + files[0].toStdString() + "'.";
    if (words.has(tre_option::kLandmarks) && !byHeight)
        return "--landmarks goes with --height, not with files.";
    if (words.has(tre_option::kCovariance) && byHeight)
        return "--covariance goes with files, not with --height.";
    if (words.has(tre_option::kCovariance) && words.has(tre_option::kFle))
        return "--covariance and --fle exclude each other.";
    return {};
}

Result<QJsonObject> runTre(const Words& words)
{
    if (const std::string wrong = faultOf(words); !wrong.empty())
        return fail(Errc::WrongOption, wrong + ' ' + kTreReminder);
    const Result<Task> task = taskOf(words);
    if (!task)
        return tl::unexpected(task.error());
    return predict(*task, words);
}

std::vector<Note> treNotes()
{
    return {{"LANDMARKS.csv", "a line of column names in any order, then one line for each "
                              "landmark:"},
            {"  name", "of the landmark"},
            {"  ax,ay,az", "its place in the anatomy, mm"},
            {"  cxx,cyy,czz,cxy,cxz,cyz",
             "with --covariance: the covariance of the touch in mm^2, along the axes of the "
             "anatomy"},
            {"TARGETS.csv", "name,ax,ay,az of the targets"},
            {"example", "name,ax,ay,az"},
            {"", "Sternal notch,0,-60.4,36.1"},
            {"", "... ; carina-lab tre landmarks.csv targets.csv --fle 1.5 --limit 2"},
            {"", "carina-lab tre --height 1.75 --landmarks 4 --degrees 6"}};
}

Use treUse()
{
    return {.lines = {"LANDMARKS.csv TARGETS.csv [--fle MM | --covariance] [OPTIONS]",
                      "--height M [--landmarks N] [--fle MM] [OPTIONS]"},
            .text = "Predicts the error at targets (the target registration error) of a "
                    "registration that uses these landmarks, to first order. With --height the "
                    "landmarks are places on rib cage and jaw of a body of that height, and the "
                    "targets are glottis, carina, incisors and lung bases.",
            .notes = treNotes(),
            .options = {tre_option::kHeight, tre_option::kLandmarks, tre_option::kFle,
                        tre_option::kCovariance, tre_option::kDegrees, tre_option::kLimit,
                        tre_option::kCandidates},
            .schema = tre_key::kSchema,
            .keys = {tre_key::kLandmarks, tre_key::kTargets, tre_key::kName, tre_key::kRms,
                     tre_key::kBound, tre_key::kWeakest, tre_key::kWeakestDirection,
                     tre_key::kWorst, tre_key::kWithinLimit, tre_key::kNext, tre_key::kNextName,
                     tre_key::kNextRms}};
}

} // namespace

Command treCommand()
{
    return {.name = "tre",
            .theme = "registration",
            .summary = "predicts the error of a registration at targets",
            .uses = {treUse()},
            .mostFiles = 2,
            .reminder = kTreReminder,
            .experiment = runTre};
}

} // namespace carina::lab
