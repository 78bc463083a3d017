#include "ui/scene/live_scope.h"

#include "ui/scene/scene_parts.h"
#include "ui/scene/station_scene.h"

namespace carina
{
namespace
{

constexpr double kWidthOverHeight = 4.0 / 3.0;

} // namespace

LiveScope::LiveScope(SceneView& view, StationScene& station) : m_view{view}, m_station{station}
{
    m_view.drawEvery(kDrawn);
    m_view.setFrameSource([this](int level, LocalTime lit) { return frameOf(level, lit); });
    m_view.onFrameDrawn([this](const DrawnFrame& drawn) {
        m_drawn = drawn.frame.time;
        prepare();
        ask(drawn.frame.time);
    });
    m_view.onIdsRead(
        [this](const IdPicture& ids, const SceneFrame& frame) { measure(ids, frame); });
}

/// Another patient can be where one was before.
bool LiveScope::Shown::is(const PatientModel& other, const Blade& otherBlade) const
{
    return patient == &other && contentHash == other.contentHash() && blade.name == otherBlade.name
           && blade.form == otherBlade.form;
}

/// Of the throat of another patient, or before another blade, nothing is drawn.
SceneFrame LiveScope::frameOf(int level, LocalTime lit)
{
    const PatientModel& patient = m_station.patient();
    const StationMoment moment = m_station.momentAt(lit, level);
    const FollowingThroat throat = throatAt(moment, patient);
    m_sight = m_station.laryngoscope().at(moment, throat);
    SceneFrame frame = sceneFrame(moment, patient.lungs().field(), throat);
    bendTube(frame, patient);
    frame.airway = m_station.laryngoscope().changesAt(moment);
    frame.eyes.emplace();
    if (!m_sight.isGraded())
        m_seen.reset();
    if (m_sight.state != LaryngoscopeState::Live || !m_shown.is(patient, m_sight.blade))
        return frame;
    frame.blade = m_sight.tissue;
    frame.bodies[kScopeBody] = m_sight.X_AL;
    m_station.bendTubeAtWork(frame, moment);
    addContents(frame, m_station.laryngoscope().contentsAt(throat, m_sight.tissue));
    frame.eyes->push_back(scopePicture(m_sight.X_AL * cameraOnBlade(m_sight.blade),
                                       Laryngoscopy::fieldOfView(ScopeEye::Video),
                                       kWidthOverHeight));
    return frame;
}

/// The scene of what the next frame shows.
void LiveScope::prepare()
{
    const PatientModel& patient = m_station.patient();
    if (m_sight.state != LaryngoscopeState::Live || m_shown.is(patient, m_sight.blade))
        return;
    m_shown = {&patient, patient.contentHash(), m_sight.blade};
    m_scene = scopeScene(patient, m_sight.blade, m_colors);
    m_seen.reset();
    showScope(m_view, m_scene, ScopeEye::Video);
}

void LiveScope::ask(SessionTime now)
{
    const bool isDue = !m_asked || now - *m_asked >= kRead || now < *m_asked;
    if (!m_sight.isGraded() || !isDue)
        return;
    m_asked = now;
    m_view.askForIds();
}

void LiveScope::measure(const IdPicture& ids, const SceneFrame& frame)
{
    if (!m_sight.isGraded() || !frame.eyes || frame.eyes->empty())
        return;
    const GlotticView view =
        measuredView(ids, m_scene, frame.eyes->front(),
                     m_station.laryngoscope().glottisAt(frame.throat, frame.blade));
    m_seen = view.isTelling() ? std::optional{Measured{view, frame.time}} : std::nullopt;
}

/// A session that begins anew has earlier times.
std::optional<GlotticView> LiveScope::seen() const
{
    const bool isRecent = m_seen && m_seen->time <= m_drawn && m_drawn - m_seen->time <= kMostAge;
    return isRecent ? std::optional{m_seen->view} : std::nullopt;
}

} // namespace carina
