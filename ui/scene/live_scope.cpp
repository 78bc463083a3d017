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
    : m_view{view}, m_station{station}, m_endoscope{endoscope}, m_laryngoscope{station.patient()}
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
bool LiveScope::Shown::is(const Shown& other) const
{
    return laid == other.laid && contentHash == other.contentHash && blade.name == other.blade.name
           && blade.form == other.blade.form && isFlown == other.isFlown;
}

LiveScope::Shown LiveScope::toBeShown() const
{
    return {&m_station.patient(), m_patient->contentHash(), blade(), isFlown()};
}

/// An endoscope flies in the patient that all others see. While that at rest is made the
/// laryngoscope is in the one that is laid, who may give way to another one meanwhile.
void LiveScope::findPatient()
{
    const PatientModel& laid = m_station.patient();
    m_patient = isFlown() ? &laid : m_resting.of(laid);
    const PatientModel* lying = m_patient ? m_patient : &laid;
    const bool isAnother = lying != m_lying || laid.contentHash() != m_laidHash;
    m_lying = lying;
    m_laidHash = laid.contentHash();
    if (isAnother)
        m_laryngoscope.lieIn(*lying);
    m_laryngoscope.takeOwnBlade(m_station.laryngoscope().ownBlade());
}

/// Without a probe on the chin the mouth is open as in the surfaces that all others see.
FollowingThroat LiveScope::throatIn(const StationMoment& moment) const
{
    const PatientModel& laid = m_station.patient();
    const FollowingThroat throat = throatAt(moment, laid);
    if (m_patient == nullptr || m_patient == &laid)
        return throat;
    return m_patient->throat(throat.X_AJ * laid.jawInSurfaces(), moment.headPosition,
                             moment.airwayEvents);
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
    findPatient();
    const PatientModel& laid = m_station.patient();
    const StationMoment moment = m_station.momentAt(lit, level);
    const FollowingThroat throat = throatIn(moment);
    m_sight = m_laryngoscope.at(moment, throat);
    SceneFrame frame = sceneFrame(moment, laid.lungs().field(), throat);
    bendTube(frame, laid);
    frame.airway = m_laryngoscope.changesAt(moment);
    frame.eyes.emplace();
    if (!isGraded())
        m_read.reset();
    if (!isSeen() || !m_shown.is(toBeShown()))
        return frame;
    frame.blade = m_sight.tissue;
    addBlade(frame);
    m_station.bendTubeAtWork(frame, moment);
    addContents(frame, m_laryngoscope.contentsIn(moment, throat, m_sight.tissue));
    if (isFlown()) {
        m_endoscope.follow(laid, frame.airway, throat, m_sight.tissue);
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
    if (!isSeen() || m_shown.is(toBeShown()))
        return;
    m_shown = toBeShown();
    m_scene = scopeScene(m_patient->withTubeOf(m_station.patient()), m_shown.blade, m_colors);
    m_read.reset();
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
    m_read = {measuredView(ids, m_scene, frame.eyes->front(),
                           m_laryngoscope.glottisAt(frame.throat, frame.blade)),
              frame.time};
}

/// Nothing of a time after the latest frame: a session that begins anew has earlier times.
std::optional<GlotticView> LiveScope::read() const
{
    const bool isRecent = m_read && m_read->time <= m_drawn && m_drawn - m_read->time <= kMostAge;
    return isRecent ? std::optional{m_read->view} : std::nullopt;
}

std::optional<GlotticView> LiveScope::seen() const
{
    const std::optional<GlotticView> latest = read();
    return latest && latest->isTelling() ? latest : std::nullopt;
}

} // namespace carina
