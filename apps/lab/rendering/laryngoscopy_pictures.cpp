#include "apps/lab/rendering/laryngoscopy_pictures.h"

#include "apps/lab/rendering/picture_series.h"
#include "apps/lab/rendering/render_page.h"
#include "engine/anatomy/airway/airway_measure.h"
#include "engine/anatomy/events/neck_motion.h"
#include "models/patient/patient_source.h"
#include "ui/scene/scene_parts.h"
#include "ui/scene/scope_scene.h"

#include <QJsonArray>

namespace carina::lab
{
namespace
{

QString asText(std::string_view words)
{
    return QString::fromUtf8(words.data(), qsizetype(words.size()));
}

/// One patient, one blade and one eye.
class ScopeSeries
{
public:
    ScopeSeries(const PatientModel& patient, Laryngoscopy laryngoscopy,
                const LaryngoscopyOrder& order)
        : m_patient{patient},
          m_laryngoscopy{std::move(laryngoscopy)},
          m_order{order},
          m_eye{order.isDirect ? ScopeEye::Direct : ScopeEye::Video},
          m_scene{scopeScene(patient, m_laryngoscopy.blade())}
    {
    }

    /// Draws all; their descriptions.
    Result<QJsonArray> draw()
    {
        const PictureSeries series{
            .count = kLaryngoscopySteps.size(),
            .size = m_order.size,
            .prepare = [this](SceneView& view) { prepare(view); },
            .frame = [this](SceneView&, std::size_t i) { return frameOf(poseOf(i)); },
            .take = [this](SceneView& view, std::size_t i,
                           const QImage& picture) { return take(view, i, picture); }};
        return drawSeries(series).map([this] { return m_pictures; });
    }

private:
    void prepare(SceneView& view) const
    {
        showScope(view, m_scene, m_eye);
        view.setFixedLevel(0);
    }

    [[nodiscard]] LaryngoscopyPose poseOf(std::size_t i) const
    {
        const LaryngoscopyStep step = kLaryngoscopySteps.at(i);
        return m_order.levering ? m_laryngoscopy.leveredPose(step, *m_order.levering)
                                : m_laryngoscopy.pose(step, m_order.lift);
    }

    [[nodiscard]] BladeEffort effortOf(std::size_t i) const
    {
        const LaryngoscopyStep step = kLaryngoscopySteps.at(i);
        return m_order.levering ? m_laryngoscopy.effortLevered(step, *m_order.levering)
                                : m_laryngoscopy.effortIn(step, m_order.lift);
    }

    [[nodiscard]] EyePicture eyeOf(const LaryngoscopyPose& pose) const
    {
        return scopePicture(m_laryngoscopy.eyeAt(pose, m_eye), Laryngoscopy::fieldOfView(m_eye),
                            double(m_order.size.width()) / m_order.size.height());
    }

    [[nodiscard]] SceneFrame frameOf(const LaryngoscopyPose& pose) const
    {
        SceneFrame frame = sceneFrame({}, m_patient.lungs().field(),
                                      m_patient.throat(pose.X_AJ, m_laryngoscopy.headPosition()));
        frame.airway = m_laryngoscopy.changes();
        frame.blade = pose.field;
        frame.bodies[kScopeBody] = pose.X_AL;
        addContents(frame, m_laryngoscopy.contentsAt(pose));
        frame.eyes = {eyeOf(pose)};
        return frame;
    }

    Result<void> take(SceneView& view, std::size_t i, const QImage& picture)
    {
        const LaryngoscopyPose pose = poseOf(i);
        const IdPicture ids = view.opaqueIds();
        if (ids.ids.empty())
            return fail(Errc::NoGraphics, "render got no picture of the parts back from the view");
        const QString step = QString::fromLatin1(stepName(kLaryngoscopySteps.at(i)));
        const QString file = QStringLiteral("laryngoscopy-%1-%2-%3.png")
                                 .arg(asText(m_laryngoscopy.blade().name), eyeName(), step);
        const QString path = m_order.folder.filePath(file);
        if (!picture.save(path))
            return fail(Errc::FileUnwritable, path.toStdString() + " cannot be written.");
        const GlotticView seen =
            measuredView(ids, m_scene, eyeOf(pose), m_laryngoscopy.glottisAt(pose));
        QJsonObject described = describe(file, step, pose, seen);
        addEffort(described, effortOf(i));
        m_pictures.append(described);
        return {};
    }

    [[nodiscard]] static QJsonObject describe(const QString& file, const QString& step,
                                              const LaryngoscopyPose& pose, const GlotticView& seen)
    {
        QJsonObject pixels;
        for (std::size_t n = 0; n < kSeenStructures; ++n)
            if (seen.visiblePixels[n] > 0)
                pixels[QString::fromLatin1(structureName(static_cast<SeenStructure>(n)))] =
                    qint64(seen.visiblePixels[n]);
        return {{render_laryngoscopy_key::kFile, file},
                {render_laryngoscopy_key::kStep, step},
                {render_laryngoscopy_key::kLift, inMillimetres(pose.lift)},
                {render_laryngoscopy_key::kOpening, 100.0 * seen.opening},
                {render_laryngoscopy_key::kGrade, QString::fromLatin1(gradeName(seen.grade))},
                {render_laryngoscopy_key::kPixels, pixels}};
    }

    static void addEffort(QJsonObject& picture, const BladeEffort& effort)
    {
        const std::optional<Length>& clearance = effort.contact.teethClearance;
        picture[render_laryngoscopy_key::kTongueForce] = inNewtons(effort.contact.tongue);
        picture[render_laryngoscopy_key::kEpiglottisForce] = inNewtons(effort.contact.epiglottis);
        picture[render_laryngoscopy_key::kIncisorForce] = inNewtons(effort.teeth);
        picture[render_laryngoscopy_key::kIncisorClearance] =
            clearance ? QJsonValue{inMillimetres(*clearance)} : QJsonValue{};
        picture[render_laryngoscopy_key::kLeveringShare] = 100.0 * effort.leveringShare;
        picture[render_laryngoscopy_key::kHandling] =
            QString::fromLatin1(handlingName(effort.handling));
    }

    [[nodiscard]] QString eyeName() const
    {
        return m_order.isDirect ? QStringLiteral("direct") : QStringLiteral("video");
    }

    const PatientModel& m_patient;
    Laryngoscopy m_laryngoscopy;
    const LaryngoscopyOrder& m_order;
    ScopeEye m_eye;
    ScopeScene m_scene;
    QJsonArray m_pictures;
};

/// Nothing is drawn as if it were difficult that is not.
Result<void> canShowAll(const Laryngoscopy& laryngoscopy, const AirwayEvents& events)
{
    for (const AirwayEvent& event : events)
        if (!laryngoscopy.canShow(event.kind)) {
            const std::string part{partNeeded(event.kind)};
            return fail(Errc::NoAirway,
                        std::string{eventName(event.kind)}
                            + (part.empty()
                                   ? " needs larger places of the airway than were found"
                                   : " needs " + part + ", which this patient does not have"));
        }
    return {};
}

QJsonArray describe(const AirwayEvents& events)
{
    QJsonArray all;
    for (const AirwayEvent& event : events)
        all.append(QJsonObject{
            {render_laryngoscopy_key::kEventName, QString::fromLatin1(eventName(event.kind))},
            {render_laryngoscopy_key::kSeverity, event.severity}});
    return all;
}

} // namespace

Result<QJsonObject> drawLaryngoscopy(Anatomy anatomy, const LaryngoscopyOrder& order)
{
    if (!order.folder.mkpath(QStringLiteral(".")))
        return fail(Errc::FileUnwritable, order.folder.path().toStdString() + " cannot be made.");
    const auto patient = patientOf(std::move(anatomy));
    if (!patient)
        return tl::unexpected(patient.error());
    auto laryngoscopy = Laryngoscopy::of(**patient, bladeOf(order.blade));
    if (!laryngoscopy)
        return tl::unexpected(laryngoscopy.error());
    if (const auto shown = canShowAll(*laryngoscopy, order.events); !shown)
        return tl::unexpected(shown.error());
    laryngoscopy->changeAirway(order.events);
    laryngoscopy->layHead(withinMotion(order.head, order.events));
    const HeadPosition head = laryngoscopy->headPosition();
    const AirwayAxes axes = laryngoscopy->axes();
    const Length toCarina = teethToCarina(bent((*patient)->landmarks(), (*patient)->neck(head)));
    ScopeSeries series{**patient, std::move(*laryngoscopy), order};
    return series.draw().map([&](const QJsonArray& pictures) {
        return QJsonObject{
            {render_laryngoscopy_key::kSchema,
             QLatin1StringView{render_laryngoscopy_key::kSchema.help}},
            {render_laryngoscopy_key::kAnatomy, QString::fromStdString((*patient)->name())},
            {render_laryngoscopy_key::kWidth, order.size.width()},
            {render_laryngoscopy_key::kHeight, order.size.height()},
            {render_laryngoscopy_key::kBlade, asText(bladeOf(order.blade).name)},
            {render_laryngoscopy_key::kFrom,
             order.isDirect ? QStringLiteral("direct") : QStringLiteral("video")},
            {render_laryngoscopy_key::kNeckFlexion, inDegrees(head.flexion)},
            {render_laryngoscopy_key::kHeadExtension, inDegrees(head.extension)},
            {render_laryngoscopy_key::kMouthToSight, inDegrees(axes.mouthToSight)},
            {render_laryngoscopy_key::kSightToLarynx, inDegrees(axes.sightToLarynx)},
            {render_laryngoscopy_key::kTeethToCarina, inMillimetres(toCarina)},
            {render_laryngoscopy_key::kEvents, describe(order.events)},
            {render_laryngoscopy_key::kPictures, pictures}};
    });
}

} // namespace carina::lab
