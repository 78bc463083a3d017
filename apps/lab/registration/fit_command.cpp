#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "apps/lab/registration/fit_doubts.h"
#include "apps/lab/registration/fit_page.h"
#include "apps/lab/registration/fit_report.h"
#include "apps/lab/registration/plus_config.h"
#include "apps/lab/registration/recorded_stylus.h"
#include "engine/registration/error/leave_one_out.h"
#include "engine/registration/landmarks/dwell_detector.h"

#include <QJsonArray>

#include <algorithm>
#include <limits>

namespace carina::lab
{
namespace
{

/// More dwells than landmarks are tried up to this many, in every order-keeping choice.
constexpr std::size_t kMostDwellsTooMany = 4;

/// Root mean square of a touch's error, unless given.
constexpr Length kUsualTouchError = millimetres(2.0);

/// A fit's error as a sentence about the file.
tl::unexpected<Error> cannotFit(const QString& file, const Error& error)
{
    return fail(error.code, file.toStdString() + " cannot be fitted: " + error.detail + ".");
}

struct FitOptions {
    bool withCovariances = false;
    bool repairsOrder = false;
    Length fle;
};

/// What is wrong with the touches' order, or the landmarks with their own.
Result<void> putInOrder(const QString& file, NamedPairs& named, const OrderFinding& order,
                        bool repairs)
{
    const std::vector<LandmarkPair> repaired = order.repaired(named.unweighted());
    const bool isRepaired = repairs && order.order == TouchOrder::Exchanged;
    if (const auto why = whyNotAsGiven(named.names, order); why && !isRepaired)
        return fail(Errc::DegenerateLandmarks,
                    file.toStdString() + " cannot be fitted as it is: " + *why);
    for (std::size_t i = 0; i < repaired.size(); ++i)
        named.pairs[i].pair = repaired[i];
    return {};
}

/// The fit, and what its residuals tell.
Result<QJsonObject> fitInOrder(const NamedPairs& named, bool withCovariances)
{
    if (withCovariances) {
        const Result<WeightedFit> fit = fitWeighted(named.pairs);
        if (!fit)
            return tl::unexpected(fit.error());
        QJsonObject object = describeFit(named.names, fit->fit);
        describeWeights(object, *fit);
        return object;
    }
    const std::vector<LandmarkPair> pairs = named.unweighted();
    const Result<RigidFit> fit = fitRigid(pairs);
    if (!fit)
        return tl::unexpected(fit.error());
    QJsonObject object = describeFit(named.names, *fit);
    describeErrors(object, named.names, *fit, *leaveOneOut(pairs));
    return object;
}

/// @param file that the sentences name
Result<QJsonObject> fitNamed(const QString& file, NamedPairs named, const FitOptions& options)
{
    const auto order = recogniseOrder(named.unweighted(), options.fle);
    if (!order)
        return cannotFit(file, order.error());
    if (const auto inOrder = putInOrder(file, named, *order, options.repairsOrder); !inOrder)
        return tl::unexpected(inOrder.error());
    auto object = fitInOrder(named, options.withCovariances);
    if (!object)
        return cannotFit(file, object.error());
    describeOrder(*object, named.names, *order);
    if (const QStringList warnings = fitWarnings(named, *order, options.fle); !warnings.isEmpty())
        object->insert(fit_key::kWarnings, QJsonArray::fromStringList(warnings));
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

/// The landmarks with as many of the points, in their order, as leave least.
Result<NamedPairs> pairsInOrder(const std::vector<Landmark>& landmarks,
                                const std::vector<Vec3>& points)
{
    if (points.size() < landmarks.size() || points.size() > landmarks.size() + kMostDwellsTooMany)
        return fail(Errc::TooFewLandmarks, "the stylus was held still "
                                               + std::to_string(points.size()) + " times for "
                                               + std::to_string(landmarks.size()) + " landmarks");
    std::vector<bool> taken(points.size(), false);
    std::fill_n(taken.begin(), landmarks.size(), true);
    NamedPairs best;
    double least = std::numeric_limits<double>::infinity();
    do {
        NamedPairs named;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!taken[i])
                continue;
            const Landmark& landmark = landmarks[named.pairs.size()];
            named.names.push_back(landmark.name);
            named.pairs.push_back({.pair = {landmark.p_AQ, points[i]}});
        }
        const Result<RigidFit> fit = fitRigid(named.unweighted());
        if (best.pairs.empty() || (fit && fit->rms < least))
            best = std::move(named);
        least = std::min(least, fit ? fit->rms : least);
    } while (std::prev_permutation(taken.begin(), taken.end()));
    return best;
}

Result<QJsonObject> fitRecording(const QString& recording, const QString& plusConfig,
                                 const FitOptions& options)
{
    const Result<PlusConfig> config = readPlusConfig(plusConfig);
    if (!config)
        return tl::unexpected(config.error());
    const Result<RecordedStylus> stylus = readRecordedStylus(recording);
    if (!stylus)
        return tl::unexpected(stylus.error());
    const std::vector<Vec3> points = dwellsOf(*stylus, config->p_SQ);
    auto named = pairsInOrder(config->landmarks, points);
    if (!named)
        return cannotFit(recording, named.error());
    auto object = fitNamed(recording, std::move(*named), options);
    if (object)
        object->insert(fit_key::kDwells, static_cast<qint64>(points.size()));
    return object;
}

Result<QJsonObject> runFit(const Words& words)
{
    const Result<Length> fle = positiveMillimetres(words, fit_option::kFle, kUsualTouchError);
    if (!fle)
        return tl::unexpected(fle.error());
    const FitOptions options{.withCovariances = words.has(fit_option::kCovariance),
                             .repairsOrder = words.has(fit_option::kRepairOrder),
                             .fle = *fle};
    const bool hasRecording = words.has(fit_option::kRecording);
    const bool hasConfig = words.has(fit_option::kPlusConfig);
    if (const QStringList files = words.files(); files.size() == 1 && !hasRecording && !hasConfig)
        return readPairs(files[0], options.withCovariances).and_then([&](const NamedPairs& named) {
            return fitNamed(files[0], named, options);
        });
    if (words.files().isEmpty() && hasRecording && hasConfig && !options.withCovariances)
        return fitRecording(words.text(fit_option::kRecording), words.text(fit_option::kPlusConfig),
                            options);
    return words.refuse(
        QStringLiteral("needs PAIRS.csv, or --recording SEQ.igs.mha --plus-config CONFIG.xml."));
}

std::vector<Note> fitNotes()
{
    return {{"PAIRS.csv", "a line of column names in any order, then one line for each landmark, "
                          "of which there are three or more:"},
            {"  name", "of the landmark"},
            {"  ax,ay,az", "its place in the anatomy, mm"},
            {"  mx,my,mz", "where it was touched on the manikin, mm"},
            {"  cxx,cyy,czz,cxy,cxz,cyz",
             "with --covariance: the covariance of the touch in mm^2, along the axes of the "
             "anatomy"},
            {"example", "name,ax,ay,az,mx,my,mz"},
            {"", "Sternal notch,0,-60.4,36.1,112.2,40.5,-1210.9"},
            {"", "... ; carina-lab fit pairs.csv > fit.json"}};
}

std::vector<Key> fitKeys()
{
    return {fit_key::kPose,     fit_key::kRms,          fit_key::kResiduals,  fit_key::kName,
            fit_key::kResidual, fit_key::kOrder,        fit_key::kFound,      fit_key::kTouchOf,
            fit_key::kOrderRms, fit_key::kExplanations, fit_key::kWarnings,   fit_key::kFle,
            fit_key::kFleRms,   fit_key::kFleLimit,     fit_key::kFleDegrees, fit_key::kLeaveOneOut,
            fit_key::kName,     fit_key::kLeftOut,      fit_key::kChiSquared, fit_key::kDegrees,
            fit_key::kScale,    fit_key::kDwells};
}

} // namespace

Command fitCommand()
{
    return {
        .name = "fit",
        .theme = "registration",
        .summary = "finds the pose of the manikin in the anatomy by touched landmarks",
        .uses = {{.lines = {"PAIRS.csv [--covariance] [--fle MM] [--repair-order]",
                            "--recording FILE --plus-config FILE [--fle MM] [--repair-order]"},
                  .text = "Finds the pose of the manikin in the anatomy that brings the touched "
                          "landmarks nearest to their places, by least squares; it is always a "
                          "proper rotation. The touches are those of a table, or those of a "
                          "recording in which a stylus was held still at one landmark after "
                          "another, for a second each and within a millimetre.",
                  .notes = fitNotes(),
                  .options = {fit_option::kCovariance, fit_option::kFle, fit_option::kRepairOrder,
                              fit_option::kRecording, fit_option::kPlusConfig},
                  .schema = fit_key::kSchema,
                  .keys = fitKeys()}},
        .mostFiles = 1,
        .experiment = runFit};
}

} // namespace carina::lab
