#include "apps/lab/anatomy/anatomy_dimensions.h"
#include "apps/lab/anatomy/anatomy_page.h"
#include "apps/lab/anatomy/anatomy_sweep.h"
#include "apps/lab/anatomy/comparison_report.h"
#include "apps/lab/command/patient_options.h"
#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/anatomy/patient/patient_landmarks.h"
#include "engine/core/monotonic_clock.h"
#include "engine/io/anatomy_set/anatomy_set.h"
#include "engine/io/anatomy_set/set_description.h"

namespace carina::lab
{
namespace
{

/// What the first word asks for.
constexpr const char* kImport = "import";
constexpr const char* kList = "list";
constexpr const char* kCompare = "compare";
constexpr const char* kSweep = "sweep";
constexpr const char* kDimensions = "dimensions";

/// What a command line needs.
constexpr const char* kAnatomyReminder =
    "anatomy needs \"import DIR\", \"list DIR\", \"compare\", \"sweep\" or \"dimensions\".";

bool asksFor(const Words& words, const char* verb)
{
    return words.files().value(0) == QLatin1StringView{verb};
}

bool hasOptionOfSweep(const Words& words)
{
    return words.has(anatomy_option::kSeeds) || words.has(anatomy_option::kLevel)
           || words.has(anatomy_option::kWithoutLimits);
}

Result<QJsonObject> describeSetOf(const Words& words)
{
    const bool isImport = asksFor(words, kImport);
    if (words.files().size() != 2 || (!isImport && !asksFor(words, kList))
        || words.has(anatomy_option::kSet) || words.has(kPatient) || hasOptionOfSweep(words))
        return fail(Errc::WrongOption, kAnatomyReminder);
    const auto begin = monotonicNow();
    const auto loaded =
        loadAnatomySet(words.files()[1].toStdString(), AnatomyCache::defaultFolder(), {},
                       isImport ? CacheUse::Renewed : CacheUse::Allowed);
    if (!loaded)
        return tl::unexpected(loaded.error());
    const Duration time = monotonicNow() - begin;
    QJsonObject object = describeSet(loaded->set);
    object.insert(anatomy_key::kImportTime, toSeconds(time));
    object.insert(anatomy_key::kFromCache, loaded->fromCache);
    object.insert(anatomy_key::kCache, loaded->cacheFault
                                           ? QJsonValue{QJsonValue::Null}
                                           : QString::fromStdString(loaded->cacheFile.string()));
    return object;
}

Result<QJsonObject> reportOn(const Anatomy& patient, const QString& set)
{
    if (set.isEmpty())
        return QJsonObject{
            {anatomy_compare_key::kSelfIntersections, listOf(selfIntersectionsOf(patient))}};
    const auto loaded = loadAnatomySet(set.toStdString(), AnatomyCache::defaultFolder());
    if (!loaded)
        return tl::unexpected(loaded.error());
    return compareAnatomy(patient, loaded->set.anatomy)
        .map([](const AnatomyComparison& comparison) { return reportOf(comparison); });
}

Result<QJsonObject> comparePatient(const Words& words)
{
    if (words.files().size() != 1 || hasOptionOfSweep(words))
        return words.refuse(QStringLiteral("compare takes [--set DIR] [--patient WHO]."));
    const auto figures = patientOption(words, BuiltinPatient::Adult);
    if (!figures)
        return tl::unexpected(figures.error());
    const QString set = words.text(anatomy_option::kSet);
    const auto begin = monotonicNow();
    const Posture posture = set.isEmpty() ? Posture::Laryngoscopy : Posture::Rest;
    const auto patient = patientFor(*figures, posture);
    if (!patient)
        return tl::unexpected(patient.error());
    const Duration time = monotonicNow() - begin;
    auto report = reportOn(*patient, set);
    if (!report)
        return report;
    qint64 triangles = 0;
    for (const AnatomyPart& part : patient->parts)
        triangles += qint64(part.levels.front().triangles.size());
    report->insert(anatomy_compare_key::kSchema,
                   QLatin1StringView{anatomy_compare_key::kSchema.help});
    report->insert(anatomy_compare_key::kPatient,
                   words.has(kPatient) ? words.text(kPatient) : QStringLiteral("adult"));
    report->insert(anatomy_compare_key::kGenerateTime, toSeconds(time));
    report->insert(anatomy_compare_key::kTriangles, triangles);
    report->insert(anatomy_compare_key::kLandmarks,
                   reportOf(landmarksOf(bodyPlanOf(dimensionsFor(*figures).value(), posture))));
    return report;
}

Result<QJsonObject> runAnatomy(const Words& words)
{
    if (asksFor(words, kCompare))
        return comparePatient(words);
    if (asksFor(words, kSweep))
        return sweepPatient(words);
    if (!asksFor(words, kDimensions))
        return describeSetOf(words);
    if (words.files().size() != 1 || words.has(anatomy_option::kSet) || hasOptionOfSweep(words))
        return words.refuse(QStringLiteral("dimensions takes [--patient WHO]."));
    return measurePatients(words);
}

std::vector<Key> setKeys()
{
    return {anatomy_key::kName,      anatomy_key::kContentHash, anatomy_key::kUnit,
            anatomy_key::kAxes,      anatomy_key::kParts,       anatomy_key::kPartName,
            anatomy_key::kRole,      anatomy_key::kConceptId,   anatomy_key::kPartTriangles,
            anatomy_key::kLevels,    anatomy_key::kClosed,      anatomy_key::kVolume,
            anatomy_key::kLungs,     anatomy_key::kRightLung,   anatomy_key::kLeftLung,
            anatomy_key::kTriangles, anatomy_key::kLandmarks,   anatomy_key::kAttributions,
            anatomy_key::kFaults,    anatomy_key::kFaultyFile,  anatomy_key::kFault,
            anatomy_key::kLeftOut,   anatomy_key::kImportTime,  anatomy_key::kFromCache,
            anatomy_key::kCache};
}

std::vector<Key> comparisonKeys()
{
    return {anatomy_compare_key::kPatient,
            anatomy_compare_key::kGenerateTime,
            anatomy_compare_key::kTriangles,
            anatomy_compare_key::kLandmarks,
            anatomy_compare_key::kIncisors,
            anatomy_compare_key::kGlottis,
            anatomy_compare_key::kSternalNotch,
            anatomy_compare_key::kXiphoidTip,
            anatomy_compare_key::kRightRibEnds,
            anatomy_compare_key::kLeftRibEnds,
            anatomy_compare_key::kIncisorPlane,
            anatomy_compare_key::kTracheaAxis,
            anatomy_compare_key::kSelfIntersections,
            anatomy_compare_key::kPart,
            anatomy_compare_key::kLevel,
            anatomy_compare_key::kPairs,
            anatomy_compare_key::kAirwayScale,
            anatomy_compare_key::kChestScale,
            anatomy_compare_key::kFigures,
            anatomy_compare_key::kFigure,
            anatomy_compare_key::kGenerated,
            anatomy_compare_key::kReal,
            anatomy_compare_key::kDeviation,
            anatomy_compare_key::kLimit,
            anatomy_compare_key::kRelative,
            anatomy_compare_key::kFigureMet,
            anatomy_compare_key::kOrgans,
            anatomy_compare_key::kOrgan,
            anatomy_compare_key::kToSet,
            anatomy_compare_key::kFromSet,
            anatomy_compare_key::kMean,
            anatomy_compare_key::kOneWay,
            anatomy_compare_key::kOrganMet,
            anatomy_compare_key::kNotInSet,
            anatomy_compare_key::kNotInPatient,
            anatomy_compare_key::kMet,
            anatomy_compare_key::kUnmet};
}

Use describeUse()
{
    return {.lines = {"import DIR", "list DIR"},
            .text = "Reads a folder of surfaces (OBJ, PLY, STL, glTF, GLB) as a patient, and "
                    "describes it. `import` reads the files in any case; `list` takes the patient "
                    "from the cache where the files have not changed. Nothing is written into DIR.",
            .schema = anatomy_key::kSchema,
            .keys = setKeys()};
}

Use compareUse()
{
    return {.lines = {"compare [--set DIR] [--patient WHO]"},
            .text = "Makes a patient, an adult unless another is asked for, and checks for "
                    "surfaces that intersect themselves. With --set the patient is made with its "
                    "mouth shut and compared with the set in DIR: both are measured, and the "
                    "distances between their surfaces are taken. Before, the set is scaled about "
                    "its carina: head and airway by the distance from the vocal cords to the "
                    "carina, the chest by the cube root of the volume of the lungs.",
            .options = {anatomy_option::kSet, kPatient},
            .schema = anatomy_compare_key::kSchema,
            .keys = comparisonKeys()};
}

} // namespace

Command anatomyCommand()
{
    return {.name = "anatomy",
            .theme = "the patient",
            .summary = "describes a folder of surfaces; compares, deforms and measures a patient",
            .uses = {describeUse(), compareUse(), sweepUse(), dimensionsUse()},
            .mostFiles = 2,
            .reminder = kAnatomyReminder,
            .experiment = runAnatomy};
}

} // namespace carina::lab
