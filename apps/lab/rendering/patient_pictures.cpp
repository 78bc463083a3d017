#include "apps/lab/rendering/patient_pictures.h"

#include "apps/lab/breathing/breathing_trial.h"
#include "apps/lab/breathing/drawn_lungs.h"
#include "apps/lab/command/patient_words.h"
#include "apps/lab/rendering/picture_series.h"
#include "apps/lab/rendering/render_page.h"
#include "engine/lungs/drawing/chest_drawing.h"
#include "engine/tracking/simulated/scripted_hands.h"
#include "models/patient/patient_source.h"
#include "ui/scene/scene_parts.h"

#include <QJsonArray>
#include <QRegularExpression>

#include <algorithm>

namespace carina::lab
{
namespace
{

constexpr double kFramesOfBreath = 200.0;
constexpr std::size_t kFinest = 0;

struct NamedView {
    const char* name;
    ViewPreset preset;
};
constexpr std::array kViews{NamedView{"front", ViewPreset::Front},
                            NamedView{"side", ViewPreset::Right},
                            NamedView{"trainee", ViewPreset::Trainee}};

QString inWords(std::string_view words) { return QString::fromUtf8(words.data(), words.size()); }

/// "12 years" as part of a file's name: "12-years".
QString inFileName(const QString& name)
{
    static const QRegularExpression kOther{QStringLiteral("[^a-z0-9]+")};
    return name.toLower().replace(kOther, QStringLiteral("-"));
}

using PerSide = std::array<double, 2>; // right, left

QJsonObject bothSides(const PerSide& figures)
{
    return {{QStringLiteral("right"), figures[0]}, {QStringLiteral("left"), figures[1]}};
}

/// A patient at one end of a breath.
struct PosedPatient {
    LungCondition condition;
    VentilationMode ventilator;
    const char* phase;
    ChestPose pose;
    PerSide volume_ml{};    ///< as drawn
    PerSide dome_mm{};      ///< below where it is at rest in health
    PerSide excursion_mm{}; ///< of the diaphragm in this breath
};

/// How high each vertex of the diaphragm stands in a pose, millimetres in A; right and left.
using DiaphragmHeights = std::array<std::vector<double>, 2>;
DiaphragmHeights diaphragmHeights(const PatientModel& patient, const ChestPose& pose)
{
    const ChestField& field = patient.lungs().field();
    const ChestMotion motion = motionOf(ChestRegion::Diaphragm, pose, field);
    DiaphragmHeights heights_mm;
    for (const PatientSurface& surface : patient.surfaces()) {
        if (surface.description.role != PartRole::Diaphragm)
            continue;
        for (const Vec3f& vertex : surface.levels[kFinest]->positions) {
            const Vec3 p_A = vertex.cast<double>();
            const Vec3 moved_A = p_A + field.at(p_A, motion).d_A;
            heights_mm[p_A.x() < 0.0 ? 0 : 1].push_back(1e3 * moved_A.z());
        }
    }
    return heights_mm;
}

/// How far the highest point of each dome has gone down. 0 where there is none.
PerSide domeDescent_mm(const DiaphragmHeights& from, const DiaphragmHeights& to)
{
    PerSide descent{};
    for (std::size_t side = 0; side < descent.size(); ++side)
        if (!from[side].empty())
            descent[side] = std::ranges::max(from[side]) - std::ranges::max(to[side]);
    return descent;
}

/// How far each side goes down where it does so most. 0 where there is none.
PerSide greatestDescent_mm(const DiaphragmHeights& from, const DiaphragmHeights& to)
{
    PerSide greatest{};
    for (std::size_t side = 0; side < greatest.size(); ++side)
        for (std::size_t i = 0; i < from[side].size(); ++i)
            greatest[side] = std::max(greatest[side], from[side][i] - to[side][i]);
    return greatest;
}

/// Both ends of a breath.
Result<std::array<PosedPatient, 2>> endsOfBreath(const PatientModel& patient, DrawnLungs& drawn,
                                                 const BreathingTrial& trial)
{
    const auto shapes = shapesOf(trial);
    const LungConditions& all = trial.settings.conditions;
    const LungCondition condition = all.empty() ? LungCondition{} : all.front();
    const VentilationMode ventilator = trial.settings.ventilator.mode;
    const auto [least, most] = std::ranges::minmax_element(shapes, {}, gasOf);
    std::array ends{
        PosedPatient{condition, ventilator, "expired", drawnPose(patient.lungs(), *least, kFinest)},
        PosedPatient{condition, ventilator, "inspired",
                     drawnPose(patient.lungs(), *most, kFinest)}};
    const DiaphragmHeights rest = diaphragmHeights(patient, {});
    const std::array heights{diaphragmHeights(patient, ends[0].pose),
                             diaphragmHeights(patient, ends[1].pose)};
    for (std::size_t end = 0; end < ends.size(); ++end) {
        const auto volumes = drawn.volumes(ends[end].pose);
        if (!volumes)
            return tl::unexpected(volumes.error());
        ends[end].volume_ml = {inMillilitres(volumes->at(0)), inMillilitres(volumes->at(1))};
        ends[end].dome_mm = domeDescent_mm(rest, heights[end]);
        ends[end].excursion_mm = greatestDescent_mm(heights[0], heights[1]);
    }
    return ends;
}

QString fileOf(const PatientModel& patient, const PosedPatient& posed, const NamedView& view)
{
    QStringList words{inFileName(inWords(patient.name())),
                      inWords(conditionName(posed.condition.kind))};
    if (posed.condition.side != ConditionSide::Both)
        words += inWords(sideName(posed.condition.side));
    if (posed.ventilator != VentilationMode::Spontaneous)
        words += {QStringLiteral("ventilator"), inWords(ventilatorName(posed.ventilator))};
    words += {inWords(view.name), inWords(posed.phase)};
    return words.join(QLatin1Char{'-'}) + QStringLiteral(".png");
}

QJsonObject describe(const QString& file, const PosedPatient& posed, const NamedView& view)
{
    return {{render_pictures_key::kFile, file},
            {render_pictures_key::kView, inWords(view.name)},
            {render_pictures_key::kPhase, inWords(posed.phase)},
            {render_pictures_key::kCondition, inWords(conditionName(posed.condition.kind))},
            {render_pictures_key::kSeverity, posed.condition.severity},
            {render_pictures_key::kSide, inWords(sideName(posed.condition.side))},
            {render_pictures_key::kVentilator, inWords(ventilatorName(posed.ventilator))},
            {render_pictures_key::kVolume, bothSides(posed.volume_ml)},
            {render_pictures_key::kDomeDescent, bothSides(posed.dome_mm)},
            {render_pictures_key::kDiaphragmExcursion, bothSides(posed.excursion_mm)}};
}

Result<std::vector<PosedPatient>> posed(const PatientModel& patient, const PatientBuild& build,
                                        const PictureOrder& order)
{
    auto drawn = DrawnLungs::of(patient.lungs(), kFinest);
    if (!drawn)
        return tl::unexpected(drawn.error());
    std::vector<PosedPatient> all;
    for (const LungCondition& condition : order.conditions) {
        BreathingTrial trial =
            settledBreath(build, condition, restingPattern(build).rate, kFramesOfBreath);
        trial.settings.ventilator.mode = order.ventilator;
        const auto ends = endsOfBreath(patient, *drawn, trial);
        if (!ends)
            return tl::unexpected(ends.error());
        all.insert(all.end(), ends->begin(), ends->end());
    }
    return all;
}

SceneFrame frameOf(const PatientModel& patient, const ChestPose& pose, const PictureOrder& order)
{
    StationMoment moment;
    moment.pose = pose;
    const auto X_AJ = [&](const PictureOrder::Jaw& jaw) {
        return movedJaw(patient.landmarks().p_A_incisors, jaw.opening, jaw.forward, patient.size());
    };
    return sceneFrame(
        moment, patient.lungs().field(),
        patient.throat(order.jaw ? std::optional{X_AJ(*order.jaw)} : std::nullopt, order.head));
}

/// Draws each of them from each side into the folder.
Result<QJsonArray> drawAll(const PatientModel& patient, const std::vector<PosedPatient>& all,
                           const PictureOrder& order)
{
    QJsonArray pictures;
    const auto shown = [&](std::size_t i) {
        return std::pair{all[i / kViews.size()], kViews[i % kViews.size()]};
    };
    const PictureSeries series{
        .count = all.size() * kViews.size(),
        .size = order.size,
        .prepare =
            [&](SceneView& view) {
                view.setParts(sceneParts(patient), patient.reach());
                view.setFixedLevel(int(kFinest));
            },
        .frame =
            [&](SceneView& view, std::size_t i) {
                const auto [posed, from] = shown(i);
                view.showFrom(from.preset);
                return frameOf(patient, posed.pose, order);
            },
        .take = [&](SceneView&, std::size_t i, const QImage& picture) -> Result<void> {
            const auto [posed, from] = shown(i);
            const QString file = fileOf(patient, posed, from);
            const QString path = order.folder.filePath(file);
            if (!picture.save(path))
                return fail(Errc::FileUnwritable, path.toStdString() + " cannot be written.");
            pictures.append(describe(file, posed, from));
            return {};
        }};
    return drawSeries(series).map([&] { return pictures; });
}

} // namespace

Result<QJsonObject> drawPictures(Subject subject, const PictureOrder& order)
{
    if (!order.folder.mkpath(QStringLiteral(".")))
        return fail(Errc::FileUnwritable, order.folder.path().toStdString() + " cannot be made.");
    const auto patient = patientOf(std::move(subject.anatomy));
    if (!patient)
        return tl::unexpected(patient.error());
    const auto all = posed(**patient, subject.build, order);
    if (!all)
        return tl::unexpected(all.error());
    return drawAll(**patient, *all, order).map([&](const QJsonArray& pictures) {
        QJsonObject drawn{
            {render_pictures_key::kSchema, QLatin1StringView{render_pictures_key::kSchema.help}},
            {render_pictures_key::kAnatomy, inWords((*patient)->name())},
            {render_pictures_key::kWidth, order.size.width()},
            {render_pictures_key::kHeight, order.size.height()},
            {render_pictures_key::kNeckFlexion, inDegrees(order.head.flexion)},
            {render_pictures_key::kHeadExtension, inDegrees(order.head.extension)},
            {render_pictures_key::kPictures, pictures}};
        if (order.jaw) {
            drawn[render_pictures_key::kJawOpening] = inDegrees(order.jaw->opening);
            drawn[render_pictures_key::kJawForward] = inMillimetres(order.jaw->forward);
        }
        return drawn;
    });
}

} // namespace carina::lab
