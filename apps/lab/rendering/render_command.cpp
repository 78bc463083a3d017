#include "apps/lab/commands.h"
#include "apps/lab/rendering/error_pictures.h"
#include "apps/lab/rendering/event_pairs.h"
#include "apps/lab/rendering/geometry_check.h"
#include "apps/lab/rendering/laryngoscopy_pictures.h"
#include "apps/lab/rendering/patient_pictures.h"
#include "apps/lab/rendering/preset_grades.h"
#include "apps/lab/rendering/render_page.h"
#include "apps/program/program.h"
#include "engine/anatomy/patient/builtin_patient.h"

#include <span>

namespace carina::lab
{
namespace
{

constexpr double kSevere = 0.9; ///< the severest of the conditions that have published figures

Result<QJsonObject> checkedGeometry(const Words& words)
{
    GeometryTrial trial;
    const auto seed = words.whole(render_option::kSeed, 0, 4294967295, trial.seed);
    if (!seed)
        return tl::unexpected(seed.error());
    trial.seed = static_cast<std::uint32_t>(*seed);
    const auto patient = builtinPatient(BuiltinPatient::TwelveYears);
    if (!patient)
        return tl::unexpected(patient.error());
    const auto errors = checkGeometry(patient->landmarks, trial);
    if (!errors)
        return tl::unexpected(errors.error());
    return QJsonObject{
        {render_geometry_key::kSchema, QLatin1StringView{render_geometry_key::kSchema.help}},
        {render_geometry_key::kPoses, trial.poses},
        {render_geometry_key::kGeometries, trial.geometries},
        {render_geometry_key::kSeed, qint64(trial.seed)},
        {render_geometry_key::kMeasured, errors->measured},
        {render_geometry_key::kLeftOutAtEdge, errors->outside},
        {render_geometry_key::kLeftOutTouching, errors->touching},
        {render_geometry_key::kNotVisible, errors->notDrawn},
        {render_geometry_key::kSmallestSphere, errors->smallestBall_px},
        {render_geometry_key::kLargestError, errors->largest_px},
        {render_geometry_key::kMeanError, errors->mean_px}};
}

/// The condition asked for, or what everyone wants to see of a patient.
Result<std::vector<LungCondition>> conditionsOf(const Words& words)
{
    return conditionOption(words).map([&words](const LungCondition& condition) {
        if (words.has(kCondition))
            return std::vector{condition};
        return std::vector<LungCondition>{
            {},
            {ConditionKind::SimplePneumothorax, kSevere, ConditionSide::Right},
            {ConditionKind::Copd, kSevere, ConditionSide::Both}};
    });
}

/// How the jaw is drawn: as the surfaces have it unless the options say something else.
Result<std::optional<PictureOrder::Jaw>> jawOption(const Words& words)
{
    if (!words.has(render_option::kJawOpening) && !words.has(render_option::kJawForward))
        return std::nullopt;
    const auto opening_deg = words.number(render_option::kJawOpening, 0.0, 30.0, 0.0);
    if (!opening_deg)
        return tl::unexpected(opening_deg.error());
    const auto forward_mm = words.number(render_option::kJawForward, 0.0, 15.0, 0.0);
    if (!forward_mm)
        return tl::unexpected(forward_mm.error());
    return PictureOrder::Jaw{degrees(*opening_deg), millimetres(*forward_mm)};
}

/// How head and neck are drawn: each angle within its limits, and both together as withinReach
/// says.
Result<HeadPosition> headOption(const Words& words)
{
    const auto flexion_deg = words.number(render_option::kNeckFlexion, -25.0, 35.0, 0.0);
    if (!flexion_deg)
        return tl::unexpected(flexion_deg.error());
    const auto extension_deg = words.number(render_option::kHeadExtension, -10.0, 30.0, 0.0);
    if (!extension_deg)
        return tl::unexpected(extension_deg.error());
    return HeadPosition{degrees(*flexion_deg), degrees(*extension_deg)};
}

Result<QJsonObject> drawnPictures(const Words& words)
{
    PictureOrder order;
    order.folder.setPath(words.text(render_option::kPictures));
    const auto size = program::sizeOption(words.parser());
    if (!size)
        return tl::unexpected(size.error());
    order.size = *size;
    const auto conditions = conditionsOf(words);
    if (!conditions)
        return tl::unexpected(conditions.error());
    order.conditions = *conditions;
    const auto ventilator = ventilatorOption(words);
    if (!ventilator)
        return tl::unexpected(ventilator.error());
    order.ventilator = *ventilator;
    const auto jaw = jawOption(words);
    if (!jaw)
        return tl::unexpected(jaw.error());
    order.jaw = *jaw;
    const auto head = headOption(words);
    if (!head)
        return tl::unexpected(head.error());
    order.head = *head;
    return subjectOption(words).and_then(
        [&order](Subject subject) { return drawPictures(std::move(subject), order); });
}

Result<QJsonObject> drawnError(const Words& words)
{
    ErrorPictureOrder order;
    order.folder.setPath(words.text(render_option::kErrorMap));
    const auto size = program::sizeOption(words.parser());
    if (!size)
        return tl::unexpected(size.error());
    order.size = *size;
    const auto landmarks =
        words.whole(render_option::kLandmarks, 3, 8, std::int64_t(order.landmarks));
    if (!landmarks)
        return tl::unexpected(landmarks.error());
    order.landmarks = static_cast<std::size_t>(*landmarks);
    const auto fle_mm =
        words.number(render_option::kTouchError, 0.01, 100.0, inMillimetres(order.fle));
    if (!fle_mm)
        return tl::unexpected(fle_mm.error());
    order.fle = millimetres(*fle_mm);
    return subjectOption(words).and_then(
        [&order](Subject subject) { return drawErrorPictures(std::move(subject), order); });
}

/// The eye that kFrom says.
struct NamedEye {
    std::string_view name;
    ScopeEye eye = ScopeEye::Video;
};
constexpr std::array kEyes{NamedEye{"video", ScopeEye::Video},
                           NamedEye{"direct", ScopeEye::Direct}};

Result<BladeKind> bladeOption(const Words& words)
{
    if (!words.has(render_option::kBlade))
        return BladeKind::Macintosh3;
    if (const auto kind = bladeFromName(words.text(render_option::kBlade).toStdString()))
        return *kind;
    QStringList names;
    for (const BladeKind kind : kBladeKinds)
        names += bladeName(kind);
    return words.unknownWord(render_option::kBlade, names);
}

/// Blade, eye and size of the pictures that kBlade, kFrom and kScopeSize say.
Result<ScopeWay> scopeOption(const Words& words)
{
    ScopeWay way;
    if (words.has(render_option::kScopeSize)) {
        const auto size = program::sizeOption(words.parser());
        if (!size)
            return tl::unexpected(size.error());
        way.size = *size;
    }
    const auto blade = bladeOption(words);
    if (!blade)
        return tl::unexpected(blade.error());
    way.blade = *blade;
    const auto eye = words.word(render_option::kFrom, kEyes, &NamedEye::eye);
    if (!eye)
        return tl::unexpected(eye.error());
    way.eye = *eye;
    return way;
}

Result<QJsonObject> countedGrades(const Words& words)
{
    GradeOrder order;
    const auto way = scopeOption(words);
    if (!way)
        return tl::unexpected(way.error());
    order.way = *way;
    const auto draws = words.whole(render_option::kDraws, 1, 1000, order.draws);
    if (!draws)
        return tl::unexpected(draws.error());
    order.draws = static_cast<int>(*draws);
    const auto seed = words.whole(render_option::kDrawSeed, 0, 4294967295, order.seed);
    if (!seed)
        return tl::unexpected(seed.error());
    order.seed = static_cast<std::uint32_t>(*seed);
    return restingOption(words).and_then(
        [&order](Anatomy anatomy) { return countGrades(std::move(anatomy), order); });
}

Result<QJsonObject> drawnPairs(const Words& words)
{
    PairOrder order;
    order.folder.setPath(words.text(render_option::kEventPairs));
    const auto way = scopeOption(words);
    if (!way)
        return tl::unexpected(way.error());
    order.way = *way;
    const auto events = eachEventOption(words);
    if (!events)
        return tl::unexpected(events.error());
    order.events = *events;
    order.leavesOut = !words.has(render_option::kPairEvent);
    return restingOption(words).and_then(
        [&order](Anatomy anatomy) { return drawEventPairs(std::move(anatomy), order); });
}

Result<QJsonObject> drawnLaryngoscopy(const Words& words)
{
    LaryngoscopyOrder order;
    order.folder.setPath(words.text(render_option::kLaryngoscopy));
    const auto way = scopeOption(words);
    if (!way)
        return tl::unexpected(way.error());
    order.way = *way;
    const auto lift_mm = words.number(render_option::kLift, 0.0, 30.0, inMillimetres(kUsualLift));
    if (!lift_mm)
        return tl::unexpected(lift_mm.error());
    order.lift = millimetres(*lift_mm);
    if (words.has(render_option::kLevering)) {
        if (words.has(render_option::kLift))
            return words.refuse(QStringLiteral("takes --lift-mm or --levering-deg, not both."));
        const auto levering_deg = words.number(render_option::kLevering, 0.0, 30.0, 0.0);
        if (!levering_deg)
            return tl::unexpected(levering_deg.error());
        order.levering = degrees(*levering_deg);
    }
    order.isCompared = words.has(render_option::kCompared);
    const auto events = eventsOption(words);
    if (!events)
        return tl::unexpected(events.error());
    order.events = *events;
    const auto head = headOption(words);
    if (!head)
        return tl::unexpected(head.error());
    order.head = *head;
    return restingOption(words).and_then(
        [&order](Anatomy anatomy) { return drawLaryngoscopy(std::move(anatomy), order); });
}

/// Whether the first of these options is given, and none that is not of them.
bool asksFor(const Words& words, std::span<const Option> way)
{
    const auto isOfIt = [way](const QString& given) {
        return std::ranges::any_of(way, [&given](const Option& option) {
            return given == QLatin1StringView{option.name};
        });
    };
    return words.has(way.front()) && std::ranges::all_of(words.parser().optionNames(), isOfIt);
}

Result<QJsonObject> render(const Words& words)
{
    if (asksFor(words, render_option::kOfGeometry))
        return checkedGeometry(words);
    if (asksFor(words, render_option::kOfPictures))
        return drawnPictures(words);
    if (asksFor(words, render_option::kOfErrorMap))
        return drawnError(words);
    if (asksFor(words, render_option::kOfLaryngoscopy))
        return drawnLaryngoscopy(words);
    if (asksFor(words, render_option::kOfPresetGrades))
        return countedGrades(words);
    if (asksFor(words, render_option::kOfEventPairs))
        return drawnPairs(words);
    return words.refuse(
        QStringLiteral("takes --check-geometry [--seed K], --pictures DIR, --error-map DIR, "
                       "--laryngoscopy DIR, --preset-grades or --event-pairs DIR, and what "
                       "'carina-lab help render' says of them."));
}

Use renderedGeometry()
{
    return {.lines = {"--check-geometry [--seed K]"},
            .text =
                "Draws small spheres at the carina, the glottis, the incisors, both bases of the "
                "lungs and to either side of the built-in child's head as a headset shows them, "
                "side by side, for 50 poses of the head with each of 20 geometries of eyes and "
                "screen. Reads the picture back, and compares the middle of each sphere's pixels "
                "in each eye with where the line from the eye to the sphere meets the screen. "
                "Needs a display.",
            .options = {render_option::kOfGeometry.begin(), render_option::kOfGeometry.end()},
            .schema = render_geometry_key::kSchema,
            .keys = {render_geometry_key::kPoses, render_geometry_key::kGeometries,
                     render_geometry_key::kSeed, render_geometry_key::kMeasured,
                     render_geometry_key::kLeftOutAtEdge, render_geometry_key::kLeftOutTouching,
                     render_geometry_key::kNotVisible, render_geometry_key::kSmallestSphere,
                     render_geometry_key::kLargestError, render_geometry_key::kMeanError}};
}

Use renderedPictures()
{
    return {.lines = {"--pictures DIR [OPTION...]"},
            .text =
                "Draws a built-in patient (the child unless another is asked for) or an anatomy "
                "set as the programs do, in full detail, at the end of expiration and of "
                "inspiration of a quiet breath after a minute of them: from the front, from the "
                "right side, and as a trainee who stands behind the head sees the patient. In "
                "health, with a simple pneumothorax of the right lung and with COPD, both of "
                "severity 0.9; or with the one condition that is asked for. Writes PNG. Needs a "
                "display.",
            .options = {render_option::kOfPictures.begin(), render_option::kOfPictures.end()},
            .schema = render_pictures_key::kSchema,
            .keys = {render_pictures_key::kAnatomy, render_pictures_key::kWidth,
                     render_pictures_key::kHeight, render_pictures_key::kJawOpening,
                     render_pictures_key::kJawForward, render_pictures_key::kNeckFlexion,
                     render_pictures_key::kHeadExtension, render_pictures_key::kPictures,
                     render_pictures_key::kFile, render_pictures_key::kView,
                     render_pictures_key::kPhase, render_pictures_key::kCondition,
                     render_pictures_key::kSeverity, render_pictures_key::kSide,
                     render_pictures_key::kVentilator, render_pictures_key::kVolume,
                     render_pictures_key::kDomeDescent, render_pictures_key::kDiaphragmExcursion}};
}

Use renderedError()
{
    return {.lines = {"--error-map DIR [OPTION...]"},
            .text = "Draws on a patient at rest the expected error of a registration on some "
                    "landmarks (target registration error): from the front, from the right side, "
                    "as a trainee stands, and cut open in the middle, with the scale in the "
                    "corner. Writes PNG. Needs a display.",
            .options = {render_option::kOfErrorMap.begin(), render_option::kOfErrorMap.end()},
            .schema = render_error_key::kSchema,
            .keys = {render_error_key::kAnatomy, render_error_key::kLandmarks,
                     render_error_key::kTouchError, render_error_key::kLeastError,
                     render_error_key::kMostError, render_error_key::kBand,
                     render_error_key::kPictures, render_error_key::kFile,
                     render_error_key::kView}};
}

Use renderedLaryngoscopy()
{
    return {
        .lines = {"--laryngoscopy DIR [OPTION...]"},
        .text = "Draws what a laryngoscope shows of a patient (the adult unless another is "
                "asked for) on the way in: the teeth, the uvula, the epiglottis, then the "
                "larynx with the blade lifted not wholly and wholly. Measures in each picture "
                "what is seen of the glottis, and estimates the forces of the blade. Events make "
                "the airway difficult, several at once "
                "if they are asked for. Writes PNG. Needs a display.",
        .options = {render_option::kOfLaryngoscopy.begin(), render_option::kOfLaryngoscopy.end()},
        .schema = render_laryngoscopy_key::kSchema,
        .keys = {
            render_laryngoscopy_key::kAnatomy,       render_laryngoscopy_key::kWidth,
            render_laryngoscopy_key::kHeight,        render_laryngoscopy_key::kBlade,
            render_laryngoscopy_key::kFrom,          render_laryngoscopy_key::kNeckFlexion,
            render_laryngoscopy_key::kHeadExtension, render_laryngoscopy_key::kMouthToSight,
            render_laryngoscopy_key::kSightToLarynx, render_laryngoscopy_key::kTeethToCarina,
            render_laryngoscopy_key::kEvents,        render_laryngoscopy_key::kEventName,
            render_laryngoscopy_key::kSeverity,      render_laryngoscopy_key::kRates,
            render_laryngoscopy_key::kPictures,      render_laryngoscopy_key::kFile,
            render_laryngoscopy_key::kStep,          render_laryngoscopy_key::kLift,
            render_laryngoscopy_key::kOpening,       render_laryngoscopy_key::kGrade,
            render_laryngoscopy_key::kTongueForce,   render_laryngoscopy_key::kEpiglottisForce,
            render_laryngoscopy_key::kIncisorForce,  render_laryngoscopy_key::kIncisorClearance,
            render_laryngoscopy_key::kLeveringShare, render_laryngoscopy_key::kHandling,
            render_laryngoscopy_key::kReference,     render_laryngoscopy_key::kSimilarity,
            render_laryngoscopy_key::kPixels}};
}

Use countedPresets()
{
    return {
        .lines = {"--preset-grades [OPTION...]"},
        .text =
            "Counts the grades of Cormack and Lehane that the console's presets named for one give "
            "(Cormack-Lehane 1 to 4 of the panel Airway): draws patients of each, the severity of "
            "each event evenly from its range, looks at each as --laryngoscopy does with the blade "
            "lifted wholly, by the eye and in the position of the head that the preset is named "
            "for, and grades the picture as the programs do. Writes nothing. Needs a "
            "display.",
        .options = {render_option::kOfPresetGrades.begin(), render_option::kOfPresetGrades.end()},
        .schema = render_grades_key::kSchema,
        .keys = {render_grades_key::kAnatomy,
                 render_grades_key::kBlade,
                 render_grades_key::kWidth,
                 render_grades_key::kHeight,
                 render_grades_key::kLift,
                 render_grades_key::kSeed,
                 render_grades_key::kPresets,
                 render_grades_key::kPreset,
                 render_grades_key::kNamedGrade,
                 render_grades_key::kFrom,
                 render_grades_key::kNeckFlexion,
                 render_grades_key::kHeadExtension,
                 render_grades_key::kDraws,
                 render_grades_key::kGrades,
                 render_grades_key::kShareRight,
                 render_grades_key::kRanges,
                 render_grades_key::kEvent,
                 render_grades_key::kLeast,
                 render_grades_key::kMost,
                 render_grades_key::kSource,
                 kAcceptable}};
}

Use renderedPairs()
{
    return {.lines = {"--event-pairs DIR [OPTION...]"},
            .text =
                "Draws a pair of pictures of a laryngoscopy for each event of the airway, or for "
                "those that are asked for: before it and after, both in the step of --laryngoscopy "
                "in which the event changes most of the picture, and says what it changes. The "
                "head lies in neutral position, but for stiff_neck in the sniffing one. Writes "
                "PNG. Needs a display.",
            .options = {render_option::kOfEventPairs.begin(), render_option::kOfEventPairs.end()},
            .schema = render_pairs_key::kSchema,
            .keys = {render_pairs_key::kAnatomy,     render_pairs_key::kBlade,
                     render_pairs_key::kFrom,        render_pairs_key::kWidth,
                     render_pairs_key::kHeight,      render_pairs_key::kLeftOut,
                     render_pairs_key::kPairs,       render_pairs_key::kEvent,
                     render_pairs_key::kSeverity,    render_pairs_key::kStep,
                     render_pairs_key::kChanged,     render_pairs_key::kPixelsMore,
                     render_pairs_key::kBefore,      render_pairs_key::kFile,
                     render_pairs_key::kOpening,     render_pairs_key::kGrade,
                     render_pairs_key::kNeckFlexion, render_pairs_key::kHeadExtension,
                     render_pairs_key::kTeeth,       render_pairs_key::kPixels,
                     render_pairs_key::kAfter}};
}

} // namespace

Command renderCommand()
{
    return {.name = "render",
            .theme = "the patient",
            .summary =
                "draws pictures of a patient, grades laryngoscopies, checks a headset's geometry",
            .uses = {renderedGeometry(), renderedPictures(), renderedError(),
                     renderedLaryngoscopy(), countedPresets(), renderedPairs()},
            .reminder = "It takes --check-geometry [--seed K], --pictures DIR, --error-map DIR, "
                        "--laryngoscopy DIR, --preset-grades or --event-pairs DIR, and what "
                        "'carina-lab help render' says of them.",
            .draws = true,
            .experiment = render};
}

} // namespace carina::lab
