#include "apps/lab/registration/fit_command.h"

#include "apps/lab/command/command_options.h"
#include "apps/lab/registration/fit_doubts.h"
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

constexpr std::string_view kFitHelp =
    R"(fit PAIRS.csv [--covariance] [--fle MM] [--repair-order]
fit --recording SEQ.igs.mha --plus-config CONFIG.xml [--fle MM] [--repair-order]
    Finds the pose of the manikin in the anatomy that brings touched landmarks nearest to their
    places: least squares, always a proper rotation.
    PAIRS.csv           a line of column names in any order, then one line for each landmark, of
                        which there are three or more:
      name              of the landmark
      ax,ay,az          its place in the anatomy, mm
      mx,my,mz          where it was touched on the manikin, mm
    example             name,ax,ay,az,mx,my,mz
                        Sternal notch,0,-60.4,36.1,112.2,40.5,-1210.9
                        ... ; carina-lab fit pairs.csv > fit.json
    --covariance        weighs each landmark by how far it strays: cxx,cyy,czz,cxy,cxz,cyz in mm^2
                        along the axes of the anatomy
    --fle MM            how far touches stray, root mean square (2): a landmark is taken for
                        touched in another's place only where that does not explain it
    --repair-order      fits landmarks that were exchanged by their own touches; without it they
                        are named and refused, as is a mirror image
    --recording FILE    a recording of a stylus that was held at the landmarks one after another, a
                        second each within a millimetre; the tool Reference, where there is one, is
                        fixed to what is touched
    --plus-config FILE  of Plus: the stylus tip (transform StylusTip to Stylus), and the landmarks
                        in the order in which they were touched
    schema              "carina.fit/1"
    rms_mm              root of the mean squared residual
    residuals_mm        "name" and "mm", the distance left, of each landmark
    X_AM_mm             the pose: four rows of four numbers, its translation in mm
    order               of the touches: "found" is "as given", "exchanged" or "unexplained";
                        "touch_of" names for each landmark the one whose touch it is; "rms_mm" of
                        that; "explanations" counts the orders that would do
    warnings            sentences, also on stderr, where there are any: landmarks nearly on one
                        line, touches that no order explains
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

struct FitOptions {
    bool withCovariances = false;
    bool repairsOrder = false;
    Length fle = millimetres(2.0);
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
        object->insert(kWarnings, QJsonArray::fromStringList(warnings));
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
        object->insert(QStringLiteral("dwells"), static_cast<qint64>(points.size()));
    return object;
}

Result<FitOptions> fitOptionsOf(const QCommandLineParser& parser)
{
    FitOptions options{.withCovariances = parser.isSet(QStringLiteral("covariance")),
                       .repairsOrder = parser.isSet(QStringLiteral("repair-order"))};
    if (!parser.isSet(QStringLiteral("fle")))
        return options;
    const auto fle =
        positiveMillimetres(QStringLiteral("--fle"), parser.value(QStringLiteral("fle")));
    if (!fle)
        return tl::unexpected(fle.error());
    options.fle = *fle;
    return options;
}

Result<QJsonObject> runFit(const QStringList& arguments)
{
    const QString recording = QStringLiteral("recording");
    const QString config = QStringLiteral("plus-config");
    QCommandLineParser parser;
    addValueOptions(parser, {"fle", "recording", "plus-config"});
    parser.addOptions({QCommandLineOption{QStringLiteral("covariance")},
                       QCommandLineOption{QStringLiteral("repair-order")}});
    if (const auto parsed = parseOptions(parser, "fit", arguments, 1); !parsed)
        return tl::unexpected(parsed.error());
    const auto options = fitOptionsOf(parser);
    if (!options)
        return tl::unexpected(options.error());
    const QStringList files = parser.positionalArguments();
    const bool isRecorded = parser.isSet(recording) && parser.isSet(config);
    if (files.size() == 1 && !parser.isSet(recording) && !parser.isSet(config)) {
        auto named = readPairs(files[0], options->withCovariances);
        return named ? fitNamed(files[0], std::move(*named), *options)
                     : Result<QJsonObject>{tl::unexpected(named.error())};
    }
    if (files.isEmpty() && isRecorded && !options->withCovariances)
        return fitRecording(parser.value(recording), parser.value(config), *options);
    return fail(Errc::OutOfRange,
                "fit needs PAIRS.csv, or --recording SEQ.igs.mha --plus-config CONFIG.xml.");
}

} // namespace

Command fitCommand() { return {"fit", kFitHelp, runFit}; }

} // namespace carina::lab
