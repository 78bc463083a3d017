#include "apps/lab/fit_command.h"

#include "apps/lab/csv_table.h"
#include "apps/lab/plus_config.h"
#include "apps/lab/recorded_stylus.h"
#include "engine/io/json_fields.h"
#include "engine/registration/dwell_detector.h"
#include "engine/registration/rigid_fit.h"

#include <algorithm>

namespace carina::lab
{
namespace
{

constexpr std::string_view kFitHelp =
    R"(fit PAIRS.csv | --recording SEQ.igs.mha --plus-config CONFIG.xml
    Finds the pose of the manikin in the anatomy that brings touched landmarks nearest to their
    places: least squares, always a proper rotation.
    PAIRS.csv           a line of column names in any order, then one line for each landmark:
      name              of the landmark
      ax,ay,az          its place in the anatomy, mm
      mx,my,mz          where it was touched on the manikin, mm
    --recording FILE    a recording of a stylus that was held at the landmarks one after another, a
                        second each within a millimetre; the tool Reference, where there is one, is
                        fixed to what is touched
    --plus-config FILE  of Plus: the stylus tip (transform StylusTip to Stylus), and the landmarks
                        in the order in which they were touched
    schema              "carina.fit/1"
    rms_mm              root of the mean squared residual
    residuals_mm        "name" and "mm", the distance left, of each landmark
    X_AM_mm             the pose: four rows of four numbers, its translation in mm
    dwells              with a recording: how often the stylus was held still. Of more dwells than
                        landmarks those are taken that fit best in their order.
)";

/// More dwells than landmarks are tried up to this many, in every order-keeping choice.
constexpr std::size_t kMostDwellsTooMany = 4;

struct NamedPairs {
    std::vector<std::string> names;
    std::vector<LandmarkPair> pairs;
};

/// A fit's error as a sentence about the file.
tl::unexpected<Error> cannotFit(const QString& file, const Error& error)
{
    return fail(error.code, file.toStdString() + " cannot be fitted: " + error.detail + ".");
}

QJsonObject describeFit(const std::vector<std::string>& names, const RigidFit& fit)
{
    QJsonArray residuals;
    for (std::size_t i = 0; i < names.size(); ++i)
        residuals.append(
            QJsonObject{{QStringLiteral("name"), QString::fromStdString(names[i])},
                        {QStringLiteral("mm"), inMillimetres(metres(fit.residuals[i]))}});
    return {{QStringLiteral("schema"), QStringLiteral("carina.fit/1")},
            {QStringLiteral("rms_mm"), inMillimetres(metres(fit.rms))},
            {QStringLiteral("residuals_mm"), residuals},
            {QStringLiteral("X_AM_mm"), jsonPose(fit.X_AM)}};
}

Result<NamedPairs> readPairs(const QString& file)
{
    const auto table = CsvTable::read(file, {"name", "ax", "ay", "az", "mx", "my", "mz"});
    if (!table)
        return tl::unexpected(table.error());
    NamedPairs named;
    for (std::size_t row = 0; row < table->rows(); ++row) {
        Eigen::Matrix<double, 6, 1> p_mm;
        for (int i = 0; i < 6; ++i) {
            const Result<double> number = table->number(row, static_cast<std::size_t>(i) + 1);
            if (!number)
                return tl::unexpected(number.error());
            p_mm[i] = *number;
        }
        named.names.push_back(table->text(row, 0).toStdString());
        named.pairs.push_back(
            {millimetres(1.0).si * p_mm.head<3>(), millimetres(1.0).si * p_mm.tail<3>()});
    }
    return named;
}

Result<QJsonObject> fitPairs(const QString& file)
{
    const Result<NamedPairs> named = readPairs(file);
    if (!named)
        return tl::unexpected(named.error());
    const Result<RigidFit> fit = fitRigid(named->pairs);
    if (!fit)
        return cannotFit(file, fit.error());
    return describeFit(named->names, *fit);
}

/// The points that the tip was held at, in the frame of the stylus's poses.
std::vector<Vec3> dwellsOf(const RecordedStylus& stylus, const Vec3& p_SQ)
{
    DwellDetector detector;
    std::vector<Vec3> points;
    for (const PoseSample& sample : stylus.samples)
        if (const auto point = detector.push(sample.time, sample.X_FO * p_SQ, sample.validity))
            points.push_back(point->p_FQ);
    return points;
}

/// The fit of the landmarks to as many of the points, in their order, that leaves least.
Result<RigidFit> fitInOrder(const std::vector<Landmark>& landmarks, const std::vector<Vec3>& points)
{
    if (points.size() < landmarks.size() || points.size() > landmarks.size() + kMostDwellsTooMany)
        return fail(Errc::TooFewLandmarks, "the stylus was held still "
                                               + std::to_string(points.size()) + " times for "
                                               + std::to_string(landmarks.size()) + " landmarks");
    std::vector<bool> taken(points.size(), false);
    std::fill_n(taken.begin(), landmarks.size(), true);
    Result<RigidFit> best = fail(Errc::TooFewLandmarks);
    do {
        std::vector<LandmarkPair> pairs;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (taken[i])
                pairs.push_back({landmarks[pairs.size()].p_AQ, points[i]});
        auto fit = fitRigid(pairs);
        if (!best || (fit && fit->rms < best->rms))
            best = std::move(fit);
    } while (std::prev_permutation(taken.begin(), taken.end()));
    return best;
}

Result<QJsonObject> fitRecording(const QString& recording, const QString& plusConfig)
{
    const Result<PlusConfig> config = readPlusConfig(plusConfig);
    if (!config)
        return tl::unexpected(config.error());
    const Result<RecordedStylus> stylus = readRecordedStylus(recording);
    if (!stylus)
        return tl::unexpected(stylus.error());
    const std::vector<Vec3> points = dwellsOf(*stylus, config->p_SQ);
    const Result<RigidFit> fit = fitInOrder(config->landmarks, points);
    if (!fit)
        return cannotFit(recording, fit.error());
    std::vector<std::string> names;
    for (const Landmark& landmark : config->landmarks)
        names.push_back(landmark.name);
    QJsonObject object = describeFit(names, *fit);
    object.insert(QStringLiteral("dwells"), static_cast<qint64>(points.size()));
    return object;
}

Result<QJsonObject> runFit(const QStringList& arguments)
{
    if (arguments.size() == 1 && !arguments[0].startsWith(QStringLiteral("--")))
        return fitPairs(arguments[0]);
    const auto recording = arguments.indexOf(QStringLiteral("--recording"));
    const auto config = arguments.indexOf(QStringLiteral("--plus-config"));
    if (arguments.size() == 4 && std::min(recording, config) == 0
        && std::max(recording, config) == 2)
        return fitRecording(arguments[recording + 1], arguments[config + 1]);
    return fail(Errc::OutOfRange,
                "fit needs PAIRS.csv, or --recording SEQ.igs.mha --plus-config CONFIG.xml.");
}

} // namespace

Command fitCommand() { return {"fit", kFitHelp, runFit}; }

} // namespace carina::lab
