#include "apps/lab/deformation/deform_command.h"

#include "apps/lab/command/command_options.h"
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

constexpr const char* kDeform = "deform";
constexpr double kInspired_ml = 500.0; ///< unless given

constexpr std::string_view kDeformHelp =
    R"(deform --landmarks FILE [--fit DIR] | --fit DIR | --fissures DIR [--inspired-ml V]
    Moves landmarks of a person's lungs at the end of expiration by the field that moves every lung
    here, and compares them with where they were at the end of inspiration. The field is told their
    bounding box, and one amplitude, which is fitted.
    --landmarks FILE    CSV with columns ee_x_mm, ee_y_mm, ee_z_mm (end of expiration) and ei_x_mm,
                        ei_y_mm, ei_z_mm (end of inspiration), z towards the feet, as of DIR-Lab
    --fit DIR           with FILE: fits the three constants of a breath to the landmark files of DIR
                        that hold other landmarks than FILE, instead of using the built-in ones;
                        alone: does so for each file in turn, and for all together
    --fissures DIR      instead: how the lobes of the anatomy set in DIR keep together once V ml
                        (500) were inspired
    schema              "carina.deform/1"
    landmarks           how many
    amplitude           of the breath; 1 lowers the base by 7.5 % of the lungs' height
    mean_motion_mm      mean length of the landmarks' motion
    mean_residual_mm    mean distance of where they were from where the field takes them
    max_residual_mm     the greatest
    ratio               mean_residual_mm / mean_motion_mm
    constants           "front_share", "ribs", "gravity", and "fitted_to", the files, empty for the
                        built-in ones
    cases               with --fit alone: the above for each file, fitted to the others, and "file"
    left_out            with --fit: files of DIR that hold no landmarks
    fissures            with --fissures: for each lower lobe and another one of its lung "lower" and
                        "upper", their names, "points" of the lower lobe at the fissure, and by how
                        much they move along the other lobe ("mean_slide_mm"), come away from it
                        ("max_gap_mm") and enter it ("max_overlap_mm")
    inspired_ml         with --fissures: V
)";

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
    return {{QStringLiteral("front_share"), constants.frontShare},
            {QStringLiteral("ribs"), constants.breath.ribs},
            {QStringLiteral("gravity"), constants.breath.gravity},
            {QStringLiteral("fitted_to"), files}};
}

QJsonObject describe(const LandmarkCase& landmarks, const BreathingConstants& constants)
{
    const LandmarkResiduals residuals = residualsOf(landmarks, constants);
    return {{QStringLiteral("landmarks"), qint64(landmarks.p_A_exhaled.size())},
            {QStringLiteral("amplitude"), residuals.amplitude},
            {QStringLiteral("mean_motion_mm"), residuals.meanMotion_mm},
            {QStringLiteral("mean_residual_mm"), residuals.meanResidual_mm},
            {QStringLiteral("max_residual_mm"), residuals.maxResidual_mm},
            {QStringLiteral("ratio"), residuals.ratio()}};
}

/// How the field does on landmarks when its constants know only the others.
Result<QJsonObject> describeLeftOut(const LandmarkCase& landmarks, std::vector<LandmarkCase> others)
{
    std::erase(others, landmarks);
    if (others.empty())
        return fail(Errc::TooFewLandmarks, "deform needs landmarks of somebody else to fit to.");
    const BreathingConstants constants = fitConstants(others);
    QJsonObject object = describe(landmarks, constants);
    object.insert(QStringLiteral("constants"), describe(constants, others));
    return object;
}

Result<QJsonObject> deformOne(const QString& file, const QString& folder)
{
    const auto landmarks = readLandmarkCase(file);
    if (!landmarks)
        return tl::unexpected(landmarks.error());
    if (folder.isEmpty()) {
        QJsonObject object = describe(*landmarks, BreathingConstants{});
        object.insert(QStringLiteral("constants"), describe(BreathingConstants{}, {}));
        return object;
    }
    const auto others = readFolder(folder);
    if (!others)
        return tl::unexpected(others.error());
    return describeLeftOut(*landmarks, others->cases).map([&](QJsonObject object) {
        object.insert(QStringLiteral("left_out"), others->leftOut);
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
        object->insert(QStringLiteral("file"), landmarks.name);
        cases.append(*object);
    }
    return QJsonObject{
        {QStringLiteral("cases"), cases},
        {QStringLiteral("constants"), describe(fitConstants(folder->cases), folder->cases)},
        {QStringLiteral("left_out"), folder->leftOut}};
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
        fissures.append(QJsonObject{{QStringLiteral("lower"), QString::fromStdString(fit.lower)},
                                    {QStringLiteral("upper"), QString::fromStdString(fit.upper)},
                                    {QStringLiteral("points"), qint64(fit.points)},
                                    {QStringLiteral("mean_slide_mm"), fit.meanSlide_mm},
                                    {QStringLiteral("max_gap_mm"), fit.gap_mm},
                                    {QStringLiteral("max_overlap_mm"), fit.overlap_mm}});
    return QJsonObject{{QStringLiteral("fissures"), fissures},
                       {QStringLiteral("inspired_ml"), inspired_ml}};
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

Result<QJsonObject> runDeform(const QStringList& arguments)
{
    QCommandLineParser parser;
    addValueOptions(parser, {"landmarks", "fit", "fissures", "inspired-ml"});
    if (const auto parsed = parseOptions(parser, kDeform, arguments); !parsed)
        return tl::unexpected(parsed.error());
    const QString file = parser.value(QStringLiteral("landmarks"));
    const QString folder = parser.value(QStringLiteral("fit"));
    const QString anatomy = parser.value(QStringLiteral("fissures"));
    const bool hasLandmarks = !file.isEmpty() || !folder.isEmpty();
    const bool hasVolume = parser.isSet(QStringLiteral("inspired-ml"));
    if (const std::string wrong = faultOf(hasLandmarks, !anatomy.isEmpty(), hasVolume);
        !wrong.empty())
        return fail(Errc::OutOfRange, wrong
                                          + " deform needs --landmarks FILE, --fit DIR or both, or "
                                            "--fissures DIR and perhaps --inspired-ml.");
    const auto inspired_ml = hasVolume ? numberOption(parser, kDeform, "inspired-ml", 0.0, 10'000.0)
                                       : Result<double>{kInspired_ml};
    if (!inspired_ml)
        return tl::unexpected(inspired_ml.error());
    auto object = !hasLandmarks    ? deformLobes(anatomy, *inspired_ml)
                  : file.isEmpty() ? deformEach(folder)
                                   : deformOne(file, folder);
    if (object)
        object->insert(QStringLiteral("schema"), QStringLiteral("carina.deform/1"));
    return object;
}

} // namespace

Command deformCommand() { return {"deform", kDeformHelp, runDeform}; }

} // namespace carina::lab
