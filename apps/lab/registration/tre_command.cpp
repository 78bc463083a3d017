#include "apps/lab/registration/tre_command.h"

#include "apps/lab/command/command_options.h"
#include "apps/lab/registration/landmark_table.h"
#include "engine/io/files/json_fields.h"
#include "engine/registration/landmarks/landmark_catalogue.h"
#include "engine/registration/landmarks/layout_check.h"

#include <cmath>

namespace carina::lab
{
namespace
{

constexpr std::string_view kTreHelp =
    R"(tre LANDMARKS.csv TARGETS.csv [--fle MM | --covariance] [OPTIONS]
tre --height M [--landmarks N] [--fle MM] [OPTIONS]
    Predicts how far a registration on these landmarks is off at targets (the target registration
    error), to first order.
    LANDMARKS.csv      name,ax,ay,az: places in the anatomy, mm, in any order of columns
    TARGETS.csv        the same of the targets
    example            name,ax,ay,az
                       Sternal notch,0,-60.4,36.1
                       ... ; carina-lab tre landmarks.csv targets.csv --fle 1.5 --limit 2
                       carina-lab tre --height 1.75 --landmarks 4 --degrees 6
    --height M         instead: the places on rib cage and jaw of a body of M metres, and glottis,
                       carina, incisors and lung bases as targets
    --landmarks N      of these the first N: 4 on the rib cage, 6 with the angles of the jaw, 8 with
                       the tenth ribs (8)
    --fle MM           how far each touch strays, root mean square (1)
    --covariance       instead: LANDMARKS.csv says it for each by cxx,cyy,czz,cxy,cxz,cyz in mm^2,
                       and the fit weighs each by it
    --degrees N        of freedom from which the size of these errors was estimated, as 3 N - 6 for
                       the residuals of N landmarks; without it they are taken for known
    --limit MM         that rms_mm at the worst target may have; not compared with bound95_mm
    --candidates FILE  further landmarks, of which the one is sought that helps most; with
                       --covariance, with theirs
    schema             "carina.tre/1"
    landmarks          how many
    targets            one object per target, in their order:
      name             of the target
      rms_mm           root of the mean squared error
      bound95_mm       95 % of registrations are off by less
      weakest          "left-right", "front-back" or "head-feet": nearest to weakest_A
      weakest_A        [x, y, z], the direction in which the error is largest
    worst              name of the target with the largest error
    within_limit       with --limit: whether rms_mm of the worst target is no more than that
    next               with --candidates: "name" and "worst_rms_mm" with it; null where none helps
)";

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

/// The words of the command line, read on demand.
class Words
{
public:
    Words()
    {
        for (const char* option : {"height", "landmarks", "fle", "degrees", "limit", "candidates"})
            m_parser.addOption({QString::fromLatin1(option), QString{}, QStringLiteral("value")});
        m_parser.addOption(QCommandLineOption{QStringLiteral("covariance")});
    }

    Result<void> parse(const QStringList& arguments)
    {
        return parseOptions(m_parser, "tre", arguments, 2);
    }
    [[nodiscard]] bool has(const char* option) const
    {
        return m_parser.isSet(QString::fromLatin1(option));
    }
    [[nodiscard]] QString value(const char* option) const
    {
        return m_parser.value(QString::fromLatin1(option));
    }
    [[nodiscard]] QStringList files() const { return m_parser.positionalArguments(); }
    /// A number within limits, or a sentence that names them.
    [[nodiscard]] Result<double> number(const char* option, double least, double most) const
    {
        bool isNumber = false;
        const double number = value(option).toDouble(&isNumber);
        if (isNumber && number >= least && number <= most)
            return number;
        return fail(Errc::OutOfRange, "--" + std::string{option} + " needs a number from "
                                          + QString::number(least).toStdString() + " to "
                                          + QString::number(most).toStdString() + ".");
    }
    /// The same in millimetres; a fallback where it is not given.
    [[nodiscard]] Result<Length> length(const char* option, Length fallback) const
    {
        if (!has(option))
            return fallback;
        return positiveMillimetres(QStringLiteral("--") + QString::fromLatin1(option),
                                   value(option));
    }

private:
    QCommandLineParser m_parser;
};

Result<void> readPlacesInto(Task& task, const Words& words)
{
    if (words.has("height")) {
        const Result<double> height = words.number("height", 1.0, 2.1);
        const Result<double> count =
            words.has("landmarks") ? words.number("landmarks", 3.0, 8.0) : 8.0;
        if (!height || !count)
            return tl::unexpected((height ? count : height).error());
        task.landmarks = landmarksOfHeight(metres(*height), static_cast<std::size_t>(*count));
        task.targets = targetsOfHeight(*height);
    } else {
        auto landmarks = readPlaces(words.files()[0], words.has("covariance"));
        auto targets = readPlaces(words.files()[1], false);
        if (!landmarks || !targets)
            return tl::unexpected((landmarks ? targets : landmarks).error());
        task.landmarks = std::move(*landmarks);
        task.targets = std::move(*targets);
    }
    if (!words.has("candidates"))
        return {};
    auto candidates = readPlaces(words.value("candidates"), words.has("covariance"));
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
    const Result<Length> fle = words.length("fle", millimetres(1.0));
    const Result<Length> limit = words.length("limit", metres(kKnownExactly));
    const Result<double> degrees =
        words.has("degrees") ? words.number("degrees", 1.0, 1e6) : kKnownExactly;
    if (!fle || !limit)
        return tl::unexpected((fle ? limit : fle).error());
    if (!degrees)
        return tl::unexpected(degrees.error());
    task.limit = *limit;
    task.degrees = *degrees;
    if (words.has("covariance")) {
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
    return {{QStringLiteral("name"), QString::fromStdString(name)},
            {QStringLiteral("rms_mm"), inMillimetres(error.rms)},
            {QStringLiteral("bound95_mm"), inMillimetres(error.bound)},
            {QStringLiteral("weakest"), kAxes[static_cast<std::size_t>(error.weakestAxis)]},
            {QStringLiteral("weakest_A"),
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
    return QJsonObject{{QStringLiteral("name"), QString::fromStdString(names[next->candidate])},
                       {QStringLiteral("worst_rms_mm"), inMillimetres(next->worstRms)}};
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
        {QStringLiteral("schema"), QStringLiteral("carina.tre/1")},
        {QStringLiteral("landmarks"), static_cast<qint64>(task.landmarks.names.size())},
        {QStringLiteral("targets"), described},
        {QStringLiteral("worst"), QString::fromStdString(task.targets.names[report->worst])}};
    if (words.has("limit"))
        object.insert(QStringLiteral("within_limit"), report->withinLimit);
    if (!words.has("candidates"))
        return object;
    const auto next =
        nextLandmark(task.landmarks.places, task.candidates.places, targets, task.weighting);
    if (!next)
        return fail(next.error().code, "A candidate cannot be used: " + next.error().detail + ".");
    object.insert(QStringLiteral("next"), describeNext(*next, task.candidates.names));
    return object;
}

/// What does not go together, in a sentence; empty where all does.
std::string faultOf(const Words& words)
{
    const bool byHeight = words.has("height");
    const QStringList files = words.files();
    if (byHeight && !files.isEmpty())
        return "--height takes the place of files, such as '" + files[0].toStdString() + "'.";
    if (!byHeight && files.isEmpty())
        return "No file and no --height is given.";
    if (!byHeight && files.size() == 1)
        return "The file of targets is missing beside '" + files[0].toStdString() + "'.";
    if (words.has("landmarks") && !byHeight)
        return "--landmarks goes with --height, not with files.";
    if (words.has("covariance") && byHeight)
        return "--covariance goes with files, not with --height.";
    if (words.has("covariance") && words.has("fle"))
        return "--covariance and --fle exclude each other.";
    return {};
}

Result<QJsonObject> runTre(const QStringList& arguments)
{
    Words words;
    const Result<void> parsed = words.parse(arguments);
    if (const std::string wrong = parsed ? faultOf(words) : parsed.error().detail; !wrong.empty())
        return fail(Errc::OutOfRange, wrong
                                          + " tre needs LANDMARKS.csv TARGETS.csv, or --height M; "
                                            "and --fle MM, or --covariance with files.");
    const Result<Task> task = taskOf(words);
    if (!task)
        return tl::unexpected(task.error());
    return predict(*task, words);
}

} // namespace

Command treCommand() { return {"tre", kTreHelp, runTre}; }

} // namespace carina::lab
