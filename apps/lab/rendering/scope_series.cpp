#include "apps/lab/rendering/scope_series.h"

#include "apps/lab/rendering/drawing_rate.h"
#include "apps/lab/rendering/picture_series.h"
#include "apps/lab/rendering/reference_picture.h"
#include "engine/anatomy/events/neck_motion.h"
#include "ui/scene/scene_parts.h"
#include "ui/scene/scope_scene.h"

namespace carina::lab
{
namespace
{

/// One patient, one blade and one eye.
class ScopeSeries
{
public:
    ScopeSeries(const PatientModel& patient, Laryngoscopy laryngoscopy, const ScopeWay& way,
                std::span<const ScopeShot> shots)
        : m_patient{patient},
          m_laryngoscopy{std::move(laryngoscopy)},
          m_way{way},
          m_shots{shots},
          m_scene{scopeScene(patient, m_laryngoscopy.blade(), m_colors)}
    {
    }

    Result<void> draw(const std::function<Result<void>(const DrawnShot&)>& take)
    {
        return drawSeries({.count = m_shots.size(),
                           .size = m_way.size,
                           .prepare = [this](SceneView& view) { prepare(view); },
                           .frame =
                               [this](SceneView& view, std::size_t i) {
                                   view.setFixedQuality(m_shots[i].quality);
                                   view.setFixedLook(m_shots[i].look);
                                   return frameOf(i);
                               },
                           .take = [this, &take](SceneView& view, std::size_t i,
                                                 const QImage& picture) -> Result<void> {
                               return measured(view, i, picture).and_then(take);
                           }});
    }

    /// Of the first shot.
    Result<double> rate()
    {
        return drawingRate({.size = m_way.size,
                            .prepare =
                                [this](SceneView& view) {
                                    showScope(view, m_scene, m_way.eye);
                                    view.setFixedQuality(m_shots.front().quality);
                                    view.setFixedLook(m_shots.front().look);
                                },
                            .frame = [this] { return frameOf(0); }});
    }

private:
    void prepare(SceneView& view) const
    {
        showScope(view, m_scene, m_way.eye);
        view.setFixedLevel(0);
    }

    /// The airway is changed first, as the pose is that in the changed one.
    LaryngoscopyPose poseOf(std::size_t i)
    {
        const ScopeShot& shot = m_shots[i];
        m_laryngoscopy.changeAirway(shot.events);
        m_laryngoscopy.layHead(withinMotion(shot.head, shot.events));
        return shot.levering ? m_laryngoscopy.leveredPose(shot.step, *shot.levering)
                             : m_laryngoscopy.pose(shot.step, shot.lift);
    }

    [[nodiscard]] EyePicture eyeOf(const LaryngoscopyPose& pose) const
    {
        return scopePicture(m_laryngoscopy.eyeAt(pose, m_way.eye),
                            Laryngoscopy::fieldOfView(m_way.eye),
                            double(m_way.size.width()) / m_way.size.height());
    }

    SceneFrame frameOf(std::size_t i)
    {
        const LaryngoscopyPose pose = poseOf(i);
        SceneFrame frame = sceneFrame({}, m_patient.lungs().field(),
                                      m_patient.throat(pose.X_AJ, m_laryngoscopy.headPosition()));
        frame.airway = m_laryngoscopy.changes();
        frame.blade = pose.field;
        frame.bodies[kScopeBody] = pose.X_AL;
        addContents(frame, m_laryngoscopy.contentsAt(pose));
        const EyePicture eye = eyeOf(pose);
        const std::optional<int> sample = m_shots[i].sample;
        frame.eyes = {sample ? sampledEye(eye, m_way.size, *sample) : eye};
        return frame;
    }

    Result<DrawnShot> measured(SceneView& view, std::size_t i, const QImage& picture)
    {
        const IdPicture ids = view.opaqueIds();
        if (ids.ids.empty())
            return fail(Errc::NoGraphics, "render got no picture of the parts back from the view");
        const LaryngoscopyPose pose = poseOf(i);
        return DrawnShot{i, m_laryngoscopy, pose,
                         measuredView(ids, m_scene, eyeOf(pose), m_laryngoscopy.glottisAt(pose)),
                         picture};
    }

    const PatientModel& m_patient;
    Laryngoscopy m_laryngoscopy;
    const ScopeWay& m_way;
    std::span<const ScopeShot> m_shots;
    TissueColors m_colors;
    ScopeScene m_scene;
};

} // namespace

QString eyeName(ScopeEye eye)
{
    return eye == ScopeEye::Direct ? QStringLiteral("direct") : QStringLiteral("video");
}

QString bladeName(BladeKind blade)
{
    const std::string_view name = bladeOf(blade).name;
    return QString::fromUtf8(name.data(), qsizetype(name.size()));
}

BladeEffort effortOf(const DrawnShot& drawn, const ScopeShot& shot)
{
    return shot.levering ? drawn.laryngoscopy.effortLevered(shot.step, *shot.levering)
                         : drawn.laryngoscopy.effortIn(shot.step, shot.lift);
}

Result<void> drawShots(const PatientModel& patient, const Laryngoscopy& laryngoscopy,
                       const ScopeWay& way, std::span<const ScopeShot> shots,
                       const std::function<Result<void>(const DrawnShot&)>& take)
{
    ScopeSeries series{patient, laryngoscopy, way, shots};
    return series.draw(take);
}

Result<double> shotRate(const PatientModel& patient, const Laryngoscopy& laryngoscopy,
                        const ScopeWay& way, const ScopeShot& shot)
{
    return ScopeSeries{patient, laryngoscopy, way, {&shot, 1}}.rate();
}

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

QJsonObject pixelsOf(const GlotticView& seen)
{
    QJsonObject pixels;
    for (std::size_t n = 0; n < kSeenStructures; ++n)
        if (seen.visiblePixels[n] > 0)
            pixels[QString::fromLatin1(structureName(static_cast<SeenStructure>(n)))] =
                qint64(seen.visiblePixels[n]);
    return pixels;
}

} // namespace carina::lab
