#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "apps/lab/deformation/fissures.h"
#include "apps/lab/deformation/landmark_motion.h"
#include "engine/io/anatomy_set/anatomy_set.h"

#include <QDir>
#include <QJsonArray>

#include <algorithm>

namespace carina::lab
{
namespace
{

namespace deform_option
{
constexpr Option kLandmarks{"landmarks", "FILE", "the landmarks of one person"};
constexpr Option kFit{"fit", "DIR",
                      "folder with landmark files, to which the three constants of a breath are "
                      "fitted; with --landmarks, to those that hold other landmarks than FILE"};
constexpr Option kFissures{"fissures", "DIR", "folder of an anatomy set"};
constexpr Option kInspired{"inspired-ml", "V", "inspired volume, 0 to 10000; 500 unless given"};
} // namespace deform_option

namespace deform_key
{
constexpr Key kSchema{"schema", "carina.deform/1"};
constexpr Key kLandmarks{"landmarks", "how many there are"};
constexpr Key kAmplitude{
    "amplitude", "of the breath; at 1 the base is lowered by 7.5 % of the height of the lungs"};
constexpr Key kMeanMotion{"mean_motion_mm", "mean length of the motion of the landmarks"};
constexpr Key kMeanResidual{"mean_residual_mm",
                            "mean distance of where they were from where the field takes them"};
constexpr Key kMaxResidual{"max_residual_mm", "greatest such distance"};
constexpr Key kRatio{"ratio", "mean_residual_mm / mean_motion_mm"};
constexpr Key kRatioOfShift{
    "ratio_shift", "the same ratio for a shift to the feet that grows with the distance from the "
                   "apex, fitted to these landmarks"};
constexpr Key kRatioOfAffine{"ratio_affine",
                             "the same for an affine map fitted to these landmarks"};
constexpr Key kConstants{"constants", "the constants of a breath:"};
constexpr Key kFrontShare{"front_share", "descent of the front as a share of that of the back", 1};
constexpr Key kRibs{"ribs", "how far the ribs move with the diaphragm", 1};
constexpr Key kGravity{"gravity", "how far the interior sinks with the diaphragm", 1};
constexpr Key kFittedTo{
    "fitted_to", "names of the files to which they were fitted; empty for the built-in constants",
    1};
constexpr Key kLeftOut{"left_out", "with --fit: files of DIR that hold no landmarks"};
constexpr Key kCases{"cases", "one object per file: \"file\", and what --landmarks FILE --fit DIR "
                              "prints, except \"left_out\""};
constexpr Key kFile{"file", "its name", 1};
constexpr Key kFissures{"fissures",
                        "one object for each lower lobe and each other lobe of its lung:"};
constexpr Key kLower{"lower", "name of the lower lobe", 1};
constexpr Key kUpper{"upper", "name of the other lobe", 1};
constexpr Key kPoints{"points", "vertices of the lower lobe at the fissure", 1};
constexpr Key kMeanSlide{"mean_slide_mm", "mean distance that they slide along the other lobe", 1};
constexpr Key kMaxGap{"max_gap_mm", "greatest gap that opens between them", 1};
constexpr Key kMaxOverlap{"max_overlap_mm", "greatest depth by which they enter it", 1};
constexpr Key kInspired{"inspired_ml", "V"};
} // namespace deform_key

constexpr double kUsualInspired_ml = 500.0;

/// The landmark files of a folder.
struct LandmarkFolder {
    std::vector<LandmarkCase> cases;
    QJsonArray leftOut;
};

Result<LandmarkFolder> readFolder(const QString& path)
{
    LandmarkFolder folder;
    const QDir dir{path};
    if (!dir.exists())
        return fail(Errc::FileNotFound, "There is no folder " + path.toStdString() + ".");
    for (const QString& name : dir.entryList({QStringLiteral("*.csv")}, QDir::Files, QDir::Name)) {
        auto landmarks = readLandmarkCase(dir.filePath(name));
        if (landmarks)
            folder.cases.push_back(std::move(*landmarks));
        else
            folder.leftOut.append(name);
    }
    if (folder.cases.empty())
        return fail(Errc::FileNotFound, path.toStdString() + " holds no file with landmarks.");
    return folder;
}

QJsonObject describe(const BreathingConstants& constants, const std::vector<LandmarkCase>& fittedTo)
{
    QJsonArray files;
    for (const LandmarkCase& landmarks : fittedTo)
        files.append(landmarks.name);
    return {{deform_key::kFrontShare, constants.frontShare},
            {deform_key::kRibs, constants.breath.ribs},
            {deform_key::kGravity, constants.breath.gravity},
            {deform_key::kFittedTo, files}};
}

QJsonObject describe(const LandmarkCase& landmarks, const BreathingConstants& constants)
{
    const LandmarkResiduals residuals = residualsOf(landmarks, constants);
    return {
        {deform_key::kLandmarks, qint64(landmarks.p_A_exhaled.size())},
        {deform_key::kAmplitude, residuals.amplitude},
        {deform_key::kMeanMotion, residuals.meanMotion_mm},
        {deform_key::kMeanResidual, residuals.meanResidual_mm},
        {deform_key::kMaxResidual, residuals.maxResidual_mm},
        {deform_key::kRatio, residuals.ratio()},
        {deform_key::kRatioOfShift, residuals.meanResidualOfShift_mm / residuals.meanMotion_mm},
        {deform_key::kRatioOfAffine, residuals.meanResidualOfAffine_mm / residuals.meanMotion_mm}};
}

/// How the field does on landmarks when its constants know only the others.
Result<QJsonObject> describeLeftOut(const LandmarkCase& landmarks, std::vector<LandmarkCase> others)
{
    std::erase(others, landmarks);
    if (others.empty())
        return fail(Errc::TooFewLandmarks, "deform needs landmarks of another person to fit to.");
    const BreathingConstants constants = fitConstants(others);
    QJsonObject object = describe(landmarks, constants);
    object.insert(deform_key::kConstants, describe(constants, others));
    return object;
}

Result<QJsonObject> deformOne(const QString& file, const QString& folder)
{
    const auto landmarks = readLandmarkCase(file);
    if (!landmarks)
        return tl::unexpected(landmarks.error());
    if (folder.isEmpty()) {
        QJsonObject object = describe(*landmarks, BreathingConstants{});
        object.insert(deform_key::kConstants, describe(BreathingConstants{}, {}));
        return object;
    }
    const auto others = readFolder(folder);
    if (!others)
        return tl::unexpected(others.error());
    return describeLeftOut(*landmarks, others->cases).map([&](QJsonObject object) {
        object.insert(deform_key::kLeftOut, others->leftOut);
        return object;
    });
}

Result<QJsonObject> deformEach(const QString& path)
{
    const auto folder = readFolder(path);
    if (!folder)
        return tl::unexpected(folder.error());
    QJsonArray cases;
    for (const LandmarkCase& landmarks : folder->cases) {
        auto object = describeLeftOut(landmarks, folder->cases);
        if (!object)
            return object;
        object->insert(deform_key::kFile, landmarks.name);
        cases.append(*object);
    }
    return QJsonObject{
        {deform_key::kCases, cases},
        {deform_key::kConstants, describe(fitConstants(folder->cases), folder->cases)},
        {deform_key::kLeftOut, folder->leftOut}};
}

Result<QJsonObject> deformLobes(const QString& folder, double inspired_ml)
{
    const auto loaded = loadAnatomySet(folder.toStdString(), AnatomyCache::defaultFolder());
    if (!loaded)
        return tl::unexpected(loaded.error());
    const Anatomy& anatomy = loaded->set.anatomy;
    const auto lungs = LungPair::of(anatomy);
    if (!lungs)
        return tl::unexpected(lungs.error());
    const auto pose = lungs->pose(millilitres(inspired_ml), 0);
    if (!pose)
        return tl::unexpected(pose.error());
    QJsonArray fissures;
    for (const FissureFit& fit : fissuresOf(anatomy, *lungs, *pose))
        fissures.append(QJsonObject{{deform_key::kLower, QString::fromStdString(fit.lower)},
                                    {deform_key::kUpper, QString::fromStdString(fit.upper)},
                                    {deform_key::kPoints, qint64(fit.points)},
                                    {deform_key::kMeanSlide, fit.meanSlide_mm},
                                    {deform_key::kMaxGap, fit.gap_mm},
                                    {deform_key::kMaxOverlap, fit.overlap_mm}});
    return QJsonObject{{deform_key::kFissures, fissures}, {deform_key::kInspired, inspired_ml}};
}

/// What is wrong with the options given, in a sentence; empty where nothing is.
std::string faultOf(bool hasLandmarks, bool hasAnatomy, bool hasVolume)
{
    if (hasLandmarks && hasAnatomy)
        return "--fissures does not go with --landmarks or --fit.";
    if (hasLandmarks && hasVolume)
        return "--inspired-ml goes with --fissures only.";
    return hasLandmarks || hasAnatomy ? "" : "No file and no folder is named.";
}

Result<QJsonObject> runDeform(const Words& words)
{
    const QString file = words.text(deform_option::kLandmarks);
    const QString folder = words.text(deform_option::kFit);
    const QString anatomy = words.text(deform_option::kFissures);
    const bool hasLandmarks = !file.isEmpty() || !folder.isEmpty();
    const bool hasVolume = words.has(deform_option::kInspired);
    if (const std::string wrong = faultOf(hasLandmarks, !anatomy.isEmpty(), hasVolume);
        !wrong.empty())
        return fail(Errc::WrongOption,
                    wrong
                        + " deform needs --landmarks FILE, --fit DIR or both, or "
                          "--fissures DIR and perhaps --inspired-ml.");
    const auto inspired_ml =
        words.number(deform_option::kInspired, 0.0, 10'000.0, kUsualInspired_ml);
    if (!inspired_ml)
        return tl::unexpected(inspired_ml.error());
    auto object = !hasLandmarks    ? deformLobes(anatomy, *inspired_ml)
                  : file.isEmpty() ? deformEach(folder)
                                   : deformOne(file, folder);
    if (object)
        object->insert(deform_key::kSchema, QLatin1StringView{deform_key::kSchema.help});
    return object;
}

Use oneCaseUse()
{
    return {.lines = {"--landmarks FILE [--fit DIR]"},
            .text = "Moves landmarks in the lungs of a person from the end of expiration by the "
                    "displacement field with which all lungs are drawn, and compares them with "
                    "where they were at the end of inspiration. The field is scaled to the "
                    "bounding box of the landmarks; its one amplitude is fitted. Its three "
                    "constants are the built-in ones unless --fit is given.",
            .notes = {{"FILE", "CSV with the columns ee_x_mm, ee_y_mm, ee_z_mm (end of expiration) "
                               "and ei_x_mm, ei_y_mm, ei_z_mm (end of inspiration); z points "
                               "towards the feet, as in DIR-Lab's data"}},
            .options = {deform_option::kLandmarks, deform_option::kFit},
            .schema = deform_key::kSchema,
            .keys = {deform_key::kLandmarks, deform_key::kAmplitude, deform_key::kMeanMotion,
                     deform_key::kMeanResidual, deform_key::kMaxResidual, deform_key::kRatio,
                     deform_key::kRatioOfShift, deform_key::kRatioOfAffine, deform_key::kConstants,
                     deform_key::kFrontShare, deform_key::kRibs, deform_key::kGravity,
                     deform_key::kFittedTo, deform_key::kLeftOut}};
}

Use eachCaseUse()
{
    return {.lines = {"--fit DIR"},
            .text =
                "Does the same for each landmark file of DIR in turn, with constants fitted to the "
                "other files; and fits the constants to all of them together.",
            .options = {deform_option::kFit},
            .schema = deform_key::kSchema,
            .keys = {deform_key::kCases, deform_key::kFile, deform_key::kConstants,
                     deform_key::kFrontShare, deform_key::kRibs, deform_key::kGravity,
                     deform_key::kFittedTo, deform_key::kLeftOut}};
}

Use fissuresUse()
{
    return {.lines = {"--fissures DIR [--inspired-ml V]"},
            .text = "Measures gaps and overlaps of the lobes of an anatomy set along their "
                    "fissures after V ml were inspired.",
            .options = {deform_option::kFissures, deform_option::kInspired},
            .schema = deform_key::kSchema,
            .keys = {deform_key::kInspired, deform_key::kFissures, deform_key::kLower,
                     deform_key::kUpper, deform_key::kPoints, deform_key::kMeanSlide,
                     deform_key::kMaxGap, deform_key::kMaxOverlap}};
}

} // namespace

Command deformCommand()
{
    return {.name = "deform",
            .theme = "the patient",
            .summary = "compares the deformation of the lungs with landmarks of real ones",
            .uses = {oneCaseUse(), eachCaseUse(), fissuresUse()},
            .experiment = runDeform};
}

} // namespace carina::lab
