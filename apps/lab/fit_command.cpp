#include "apps/lab/fit_command.h"

#include "apps/lab/fit_report.h"
#include "apps/lab/landmark_table.h"
#include "apps/lab/plus_config.h"
#include "apps/lab/recorded_stylus.h"
#include "engine/registration/dwell_detector.h"
#include "engine/registration/leave_one_out.h"

#include <algorithm>

namespace carina::lab
{
namespace
{

constexpr std::string_view kFitHelp =
    R"(fit PAIRS.csv [--covariance] [--fle MM] | --recording SEQ.igs.mha --plus-config CONFIG.xml
    Finds the pose of the manikin in the anatomy that brings touched landmarks nearest to their
    places: least squares, always a proper rotation.
    PAIRS.csv           a line of column names in any order, then one line for each landmark:
      name              of the landmark
      ax,ay,az          its place in the anatomy, mm
      mx,my,mz          where it was touched on the manikin, mm
    --covariance        weighs each landmark by how far it strays: cxx,cyy,czz,cxy,cxz,cyz in mm^2
                        along the axes of the anatomy
    --fle MM            how far touches stray, root mean square (2): a landmark is taken for
                        touched in another's place only where that does not explain it
    --recording FILE    a recording of a stylus that was held at the landmarks one after another, a
                        second each within a millimetre; the tool Reference, where there is one, is
                        fixed to what is touched
    --plus-config FILE  of Plus: the stylus tip (transform StylusTip to Stylus), and the landmarks
                        in the order in which they were touched
    schema              "carina.fit/1"
    rms_mm              root of the mean squared residual
    residuals_mm        "name" and "mm", the distance left, of each landmark
    X_AM_mm             the pose: four rows of four numbers, its translation in mm
    order               of PAIRS.csv: "found" is "as given", "exchanged", "mirror image" or
                        "unexplained"; "touch_of" names for each landmark the one whose touch it is;
                        "rms_mm" of that; "explanations" counts the orders that would do
    fle_mm              how far touches stray by these residuals: "rms", "limit95", which it is below
                        with 95 %, and "degrees" of freedom; without --covariance
    leave_one_out_mm    "name" and "mm", how far each landmark is from the fit of all others; null
                        where these do not suffice; without --covariance
    chi_squared         of the weighed residuals, with "degrees" of freedom, and "scale", by which
                        the covariances would agree with them; with --covariance
    dwells              with a recording: how often the stylus was held still. Of more dwells than
                        landmarks those are taken that fit best in their order.
)";

/// More dwells than landmarks are tried up to this many, in every order-keeping choice.
constexpr std::size_t kMostDwellsTooMany = 4;

/// A fit's error as a sentence about the file.
tl::unexpected<Error> cannotFit(const QString& file, const Error& error)
{
    return fail(error.code, file.toStdString() + " cannot be fitted: " + error.detail + ".");
}

struct PairOptions {
    bool withCovariances = false;
    Length fle = millimetres(2.0);
};

Result<PairOptions> pairOptionsOf(const QStringList& words)
{
    PairOptions options;
    for (qsizetype i = 0; i < words.size(); ++i) {
        if (words[i] == QStringLiteral("--covariance")) {
            options.withCovariances = true;
            continue;
        }
        if (words[i] != QStringLiteral("--fle") || i + 1 == words.size())
            return fail(Errc::OutOfRange, "fit knows no " + words[i].toStdString() + " here.");
        const Result<Length> fle = positiveMillimetres(words[i], words[i + 1]);
        if (!fle)
            return tl::unexpected(fle.error());
        options.fle = *fle;
        ++i;
    }
    return options;
}

Result<QJsonObject> fitPairs(const QString& file, const PairOptions& options)
{
    const Result<NamedPairs> named = readPairs(file, options.withCovariances);
    if (!named)
        return tl::unexpected(named.error());
    const std::vector<LandmarkPair> pairs = named->unweighted();
    const auto order = recogniseOrder(pairs, options.fle);
    if (!order)
        return cannotFit(file, order.error());
    if (options.withCovariances) {
        const Result<WeightedFit> fit = fitWeighted(named->pairs);
        if (!fit)
            return cannotFit(file, fit.error());
        QJsonObject object = describeFit(named->names, fit->fit);
        describeWeights(object, *fit);
        describeOrder(object, named->names, *order);
        return object;
    }
    const Result<RigidFit> fit = fitRigid(pairs);
    if (!fit)
        return cannotFit(file, fit.error());
    QJsonObject object = describeFit(named->names, *fit);
    describeErrors(object, named->names, *fit, *leaveOneOut(pairs));
    describeOrder(object, named->names, *order);
    return object;
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
    if (!arguments.isEmpty() && !arguments[0].startsWith(QStringLiteral("--"))) {
        const Result<PairOptions> options = pairOptionsOf(arguments.mid(1));
        if (!options)
            return tl::unexpected(options.error());
        return fitPairs(arguments[0], *options);
    }
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
