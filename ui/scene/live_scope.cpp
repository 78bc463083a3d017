#include "ui/scene/live_scope.h"

#include "ui/scene/scene_parts.h"
#include "ui/scene/station_scene.h"

namespace carina
{
namespace
{

constexpr double kWidthOverHeight = 4.0 / 3.0;
/// Nearer than for a blade's camera, as an endoscope is close to walls: of ours.
constexpr Length kTrueColorFlown = millimetres(25.0);

} // namespace

LiveScope::LiveScope(SceneView& view, StationScene& station, FlownEndoscope& endoscope)
    : m_view{view}, m_station{station}, m_endoscope{endoscope}
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
bool LiveScope::Shown::is(const PatientModel& other, const Blade& otherBlade,
                          bool isOtherFlown) const
{
    return patient == &other && contentHash == other.contentHash() && blade.name == otherBlade.name
           && blade.form == otherBlade.form && isFlown == isOtherFlown;
}

/// One that is chosen in a patient without an airway shows what the blade does.
bool LiveScope::isFlown() const
{
    return m_endoscope.isFlown() && FlownEndoscope::hasAirway(m_station.patient());
}

/// That which is drawn: of a laryngoscope that is not seen the usual one, without a place.
Blade LiveScope::blade() const
{
    return m_sight.state == LaryngoscopeState::Live ? m_sight.blade : bladeOf(kUsualBlade);
}

void LiveScope::addBlade(SceneFrame& frame) const
{
    if (m_sight.state == LaryngoscopeState::Live)
        frame.bodies[kScopeBody] = m_sight.X_AL;
}

void LiveScope::addEye(SceneFrame& frame, const RigidTransform& X_AD) const
{
    frame.eyes->push_back(
        scopePicture(X_AD, Laryngoscopy::fieldOfView(ScopeEye::Video), kWidthOverHeight));
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
    if (!isGraded())
        m_seen.reset();
    const bool isShown = isFlown() || m_sight.state == LaryngoscopeState::Live;
    if (!isShown || !m_shown.is(patient, blade(), isFlown()))
        return frame;
    frame.blade = m_sight.tissue;
    addBlade(frame);
    m_station.bendTubeAtWork(frame, moment);
    addContents(frame, m_station.laryngoscope().contentsIn(moment, throat, m_sight.tissue));
    if (isFlown()) {
        m_endoscope.follow(patient, frame.airway, throat, m_sight.tissue);
        if (const auto lies = placeOf(frame, kPatientBody, {}))
            addEye(frame, (*lies * PlacedBody{*m_endoscope.pose()}).X_AF);
    } else {
        addEye(frame, m_sight.X_AL * cameraOnBlade(m_sight.blade));
    }
    return frame;
}

/// The scene of what the next frame shows.
void LiveScope::prepare()
{
    m_view.setNearest(isFlown() ? m_endoscope.nearest() : std::nullopt);
    const PatientModel& patient = m_station.patient();
    const bool isShown = isFlown() || m_sight.state == LaryngoscopeState::Live;
    if (!isShown || m_shown.is(patient, blade(), isFlown()))
        return;
    m_shown = {&patient, patient.contentHash(), blade(), isFlown()};
    m_scene = scopeScene(patient, m_shown.blade, m_colors);
    m_seen.reset();
    showScope(m_view, m_scene, ScopeEye::Video);
    if (isFlown())
        m_view.setSpotlight(kTrueColorFlown);
}

void LiveScope::ask(SessionTime now)
{
    const bool isDue = !m_asked || now - *m_asked >= kRead || now < *m_asked;
    if (!isGraded() || !isDue)
        return;
    m_asked = now;
    m_view.askForIds();
}

void LiveScope::measure(const IdPicture& ids, const SceneFrame& frame)
{
    if (!isGraded() || !frame.eyes || frame.eyes->empty())
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
