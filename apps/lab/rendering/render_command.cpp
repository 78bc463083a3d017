#include "apps/lab/rendering/render_command.h"

#include "apps/lab/rendering/error_pictures.h"
#include "apps/lab/rendering/geometry_check.h"
#include "apps/lab/rendering/patient_pictures.h"
#include "apps/program/program.h"
#include "engine/anatomy/patient/builtin_patient.h"

namespace carina::lab
{
namespace
{

constexpr const char* kRender = "render";
const QString kCheckGeometry = QStringLiteral("check-geometry");
const QString kJawDegrees = QStringLiteral("jaw-deg");
const QString kJawForward = QStringLiteral("jaw-forward-mm");
constexpr double kSevere = 0.9; ///< the severest of the conditions that have published figures

Result<GeometryTrial> trialOf(const QCommandLineParser& parser)
{
    GeometryTrial trial;
    if (parser.isSet(QStringLiteral("seed"))) {
        bool isNumber = false;
        trial.seed = parser.value(QStringLiteral("seed")).toUInt(&isNumber);
        if (!isNumber)
            return fail(Errc::OutOfRange, "render needs --seed with a whole number from 0 on.");
    }
    return trial;
}

Result<QJsonObject> checkedGeometry(const QCommandLineParser& parser)
{
    const auto trial = trialOf(parser);
    if (!trial)
        return tl::unexpected(trial.error());
    const auto patient = builtinPatient(BuiltinPatient::TwelveYears);
    if (!patient)
        return tl::unexpected(patient.error());
    const auto errors = checkGeometry(patient->landmarks, *trial);
    if (!errors)
        return tl::unexpected(errors.error());
    return QJsonObject{{QStringLiteral("schema"), QStringLiteral("carina.render/1")},
                       {QStringLiteral("poses"), trial->poses},
                       {QStringLiteral("geometries"), trial->geometries},
                       {QStringLiteral("seed"), qint64(trial->seed)},
                       {QStringLiteral("spheres_measured"), errors->measured},
                       {QStringLiteral("left_out_at_edge"), errors->outside},
                       {QStringLiteral("left_out_touching"), errors->touching},
                       {QStringLiteral("not_visible"), errors->notDrawn},
                       {QStringLiteral("smallest_sphere_px"), errors->smallestBall_px},
                       {QStringLiteral("max_projection_error_px"), errors->largest_px},
                       {QStringLiteral("mean_projection_error_px"), errors->mean_px}};
}

/// The condition asked for, or what everyone wants to see of a patient.
Result<std::vector<LungCondition>> conditionsOf(const QCommandLineParser& parser)
{
    return conditionOption(parser, kRender).map([&parser](const LungCondition& condition) {
        if (parser.isSet(QStringLiteral("condition")))
            return std::vector{condition};
        return std::vector<LungCondition>{
            {},
            {ConditionKind::SimplePneumothorax, kSevere, ConditionSide::Right},
            {ConditionKind::Copd, kSevere, ConditionSide::Both}};
    });
}

/// How the jaw is drawn: as the surfaces have it unless the options say something else.
Result<void> readJaw(const QCommandLineParser& parser, PictureOrder& order)
{
    if (parser.isSet(kJawDegrees)) {
        const auto opening = numberOption(parser, kRender, "jaw-deg", 0.0, 30.0);
        if (!opening)
            return tl::unexpected(opening.error());
        order.jaw.emplace().opening = degrees(*opening);
    }
    if (parser.isSet(kJawForward)) {
        const auto forward = numberOption(parser, kRender, "jaw-forward-mm", 0.0, 15.0);
        if (!forward)
            return tl::unexpected(forward.error());
        order.jaw = {order.jaw.value_or(PictureOrder::Jaw{}).opening, millimetres(*forward)};
    }
    return {};
}

Result<QJsonObject> drawnPictures(const QCommandLineParser& parser)
{
    PictureOrder order;
    order.folder.setPath(parser.value(QStringLiteral("pictures")));
    const auto size = program::sizeOption(parser);
    if (!size)
        return tl::unexpected(size.error());
    order.size = *size;
    const auto conditions = conditionsOf(parser);
    if (!conditions)
        return tl::unexpected(conditions.error());
    order.conditions = *conditions;
    const auto ventilator = ventilatorOption(parser, kRender);
    if (!ventilator)
        return tl::unexpected(ventilator.error());
    order.ventilator = *ventilator;
    if (const auto jaw = readJaw(parser, order); !jaw)
        return tl::unexpected(jaw.error());
    return subjectOption(parser, kRender).and_then([&order](Subject subject) {
        return drawPictures(std::move(subject), order);
    });
}

Result<QJsonObject> drawnError(const QCommandLineParser& parser)
{
    ErrorPictureOrder order;
    order.folder.setPath(parser.value(QStringLiteral("error-map")));
    const auto size = program::sizeOption(parser);
    if (!size)
        return tl::unexpected(size.error());
    order.size = *size;
    if (parser.isSet(QStringLiteral("landmarks"))) {
        const auto count = numberOption(parser, kRender, "landmarks", 3.0, 8.0);
        if (!count)
            return tl::unexpected(count.error());
        order.landmarks = static_cast<std::size_t>(*count);
    }
    if (parser.isSet(QStringLiteral("fle"))) {
        const auto fle_mm = numberOption(parser, kRender, "fle", 0.01, 100.0);
        if (!fle_mm)
            return tl::unexpected(fle_mm.error());
        order.fle = millimetres(*fle_mm);
    }
    return subjectOption(parser, kRender).and_then([&order](Subject subject) {
        return drawErrorPictures(std::move(subject), order);
    });
}

Result<QJsonObject> render(const QStringList& arguments)
{
    QCommandLineParser checking;
    checking.addOption(QCommandLineOption{kCheckGeometry});
    addValueOptions(checking, {"seed"});
    QCommandLineParser drawing;
    addPatientOptions(drawing);
    addValueOptions(drawing, {"pictures", "jaw-deg", "jaw-forward-mm"});
    program::addSizeOption(drawing);
    QCommandLineParser mapping;
    addValueOptions(mapping, {"anatomy", "patient", "error-map", "landmarks", "fle"});
    program::addSizeOption(mapping);
    const auto understands = [&arguments](QCommandLineParser& parser, const QString& need) {
        return parseOptions(parser, kRender, arguments) && parser.isSet(need);
    };
    if (understands(checking, kCheckGeometry))
        return checkedGeometry(checking);
    if (understands(drawing, QStringLiteral("pictures")))
        return drawnPictures(drawing);
    if (understands(mapping, QStringLiteral("error-map")))
        return drawnError(mapping);
    return fail(Errc::OutOfRange, "render takes --check-geometry [--seed K], --pictures DIR or "
                                  "--error-map DIR, and what 'carina-lab help' says of them.");
}

constexpr std::string_view kRenderHelp = R"(render --check-geometry [--seed K]
    Draws small spheres at the carina, the glottis, the incisors, both bases of the lungs and to
    either side of the built-in child's head as a headset shows them, side by side, for 50 poses of
    the head with each of 20 geometries of eyes and screen, reads the picture back, and compares the
    middle of each sphere's pixels in each eye with where the line from the eye to the sphere meets
    the screen. K picks other poses and geometries (1). Needs a display. schema carina.render/1
      poses, geometries, seed   what was drawn
      spheres_measured          once for each sphere, pose, geometry and eye
      left_out_at_edge          not measured: outside the picture or cut by its edge
      left_out_touching         not measured: touching another sphere in the picture
      not_visible               should have been seen, and no pixel shows them
      smallest_sphere_px        pixels of the smallest sphere measured
      max_projection_error_px, mean_projection_error_px
                                distance from where the sphere should be seen
render --pictures DIR [--anatomy DIR] [--patient WHO] [--size WxH]
        [--condition NAME [--severity 0..1] [--side both|right|left]]
        [--ventilator none|volume|pressure] [--jaw-deg 0..30] [--jaw-forward-mm 0..15]
    Draws an anatomy set, or a built-in patient (child), as the programs do, in full detail, at the
    end of expiration and of inspiration of a quiet breath after a minute of them: from the front,
    from the right side, and as a trainee sees it who stands behind the head. In health, with a
    simple pneumothorax of the right lung and with COPD, both of severity 0.9; or with one condition
    of those of `mechanics`, of severity 0.6 unless given. Breathed by the patient, or by a
    ventilator. The mouth is as the surfaces have it, held open in the built-in patients; or, from
    being shut, opened about the condyles and brought forward. Writes PNG of 1280x800 pixels or the
    size asked for. Needs a display. schema carina.render.pictures/1
      anatomy, width, height    what was drawn, and pixels
      jaw_deg, jaw_forward_mm   where one of them was asked for
      pictures                  per picture: file, view (front, side, trainee), phase (expired,
                                inspired), condition, severity, side, ventilator; right and left:
                                volume_ml (what the vertices drawn enclose), dome_descent_mm (how
                                far the top of the diaphragm is below where it rests in health) and
                                diaphragm_excursion_mm (how far it goes down in that breath where
                                it does so most); both 0 for a set without a diaphragm
render --error-map DIR [--anatomy DIR] [--patient WHO] [--size WxH]
        [--landmarks N] [--fle MM]
    Draws on a patient at rest how far a registration on the first N landmarks of `tre` (4) would be
    off, the error of a touch being MM (1) in the mean square: from the front, from the right side,
    as a trainee stands and cut open in the middle, with the scale in the corner. Needs a display.
    schema carina.render.error/1
      anatomy, landmarks, fle_mm   what was drawn
      least_rms_mm, most_rms_mm    of the expected error on head, airway and lungs
      band_mm                      from line to line
      pictures                     per picture: file, view (front, side, trainee, cut)
)";

} // namespace

Command renderCommand() { return {"render", kRenderHelp, render}; }

} // namespace carina::lab
