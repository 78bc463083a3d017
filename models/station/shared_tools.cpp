#include "models/station/shared_tools.h"

#include "engine/core/expects.h"
#include "engine/io/anatomy_set/anatomy_cache.h"
#include "engine/io/site/site.h"
#include "engine/session/participant_limits.h"
#include "engine/session/simulated_station.h"
#include "engine/tracking/reframed.h"
#include "models/errors/error_text.h"
#include "models/patient/resting_patient.h"
#include "models/station/object_tool.h"

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr int kGuardInterval_ms = 50; ///< of looks at the stylus
/// Of who hosts: apart from the numbers of all trainees, and not where the first of them stand.
constexpr unsigned kPersonOfHost = 1004;

/// X_SP of the stylus that a tracker calls so, with -z of P along the shaft.
std::optional<RigidTransform> calibratedShaft(const std::string& stylus,
                                              const SharedTools::Place& place)
{
    if (!place || !place->setup || !place->setup->guard)
        return std::nullopt;
    const StylusTip* tip = tipOfTool(place->setup->guard->styluses, stylus);
    if (tip == nullptr)
        return std::nullopt;
    return RigidTransform{Quat::FromTwoVectors(-Vec3::UnitZ(), tip->p_SQ), tip->p_SQ};
}

/// The first trainee of a session is the first to work; each other one has another number.
unsigned simulatedPerson(const SessionNode& node)
{
    const ParticipantId self = node.self();
    if (self == kNobody)
        return 0;
    return self.value == 0 ? kPersonOfHost : self.value - 1U;
}

/// How head and neck of the patient at this program's station lie now.
HeadPosition simulatedHead(const SessionNode& node)
{
    const auto state = node.state();
    const auto station = state->stations().find(ownStation(node));
    const auto now = node.now();
    return station == state->stations().end() || !now ? HeadPosition{}
                                                      : headPositionAt(station->second, *now);
}

/// What a simulated tracker with a laryngoscope does with it; nothing without, and where the
/// patient's larynx is not known.
std::optional<LaryngoscopyScript> laryngoscopyOf(const PatientModel& patient,
                                                 const SimulatedTrackerSettings& device)
{
    return device.laryngoscope ? scriptAtRest(patient, AnatomyCache::defaultFolder())
                               : std::nullopt;
}

bool hasDevice(const TrackerChoice& tracker)
{
    return !tracker.isSimulated() && !std::holds_alternative<PlayedRecording>(tracker.device);
}

/// @pre the place, if there is one, can be used.
std::optional<StationRegistration> registrationIn(const SharedTools::Place& place)
{
    return place ? std::optional{place->setup->registration} : std::nullopt;
}

std::unique_ptr<RegistrationGuard> guardOver(const StationTracking& tracking,
                                             const SharedTools::Place& place)
{
    if (!place || !place->setup || !place->setup->guard)
        return nullptr;
    return std::make_unique<RegistrationGuard>(tracking, *place->setup->guard);
}

} // namespace

SharedTools::SharedTools(SessionNode& node, Hardware hardware, PlaceOf placeOf)
    : m_node{node},
      m_station{ownStation(node)},
      m_hardware{std::move(hardware)},
      m_placeOf{std::move(placeOf)},
      m_report{node}
{
    m_looking.callOnTimeout([this] {
        if (m_laid && m_laid->guard)
            m_laid->guard->look();
        if (m_laid && m_laid->played)
            m_laid->played->look(m_station);
        if (m_laid)
            m_report.tell(standing());
    });
    m_looking.start(kGuardInterval_ms);
}

/// The tracker reads the node's clock, and the node's thread what it tracked.
SharedTools::~SharedTools()
{
    m_board->store(nullptr);
    if (m_laid && m_laid->tracking)
        m_laid->tracking->stop();
}

ReadSessionClock SharedTools::clock() const
{
    return [node = &m_node] { return node->now(); };
}

void SharedTools::setStation(StationId station)
{
    m_station = station;
    if (m_laid)
        publishPoses();
}

Result<void> SharedTools::lay(const SharedPatientModel& patient)
{
    return replace(patient, m_made);
}

void SharedTools::layAnyhow(const SharedPatientModel& patient)
{
    const auto laid = lay(patient);
    if (laid)
        return;
    m_hardware.tracker.reset();
    const auto alone = replace(patient, std::nullopt);
    CARINA_EXPECTS(alone.has_value()); // without a tracker nothing can fail
    m_fault = laid.error();
}

/// @param made the tracker to go on with; nothing: one is made where it is needed
Result<void> SharedTools::replace(const SharedPatientModel& patient,
                                  std::optional<MadeTracker> made)
{
    auto next = std::make_unique<Laid>(Laid{.given = patient, .patient = patient});
    if (m_hardware.tracker)
        if (auto tracked = track(*next, made); !tracked)
            return tracked;
    const std::unique_ptr<Laid> before = std::exchange(m_laid, std::move(next));
    const std::optional<MadeTracker> madeBefore = std::exchange(m_made, std::move(made));
    m_fault.reset();
    nameLaryngoscope();
    publishPoses();
    if (m_laid->tracking)
        share();
    for (const auto& told : m_onReplaced)
        told();
    if (before)
        stop(*before, madeBefore);
    return {};
}

/// Stops what is not tracked with any more.
void SharedTools::stop(const Laid& before, const std::optional<MadeTracker>& made) const
{
    if (!before.tracking || isTracking(before.tracking->tracker()))
        return;
    if (made && m_made && m_laid->tracking)
        made->stopBeside(*m_made);
    else
        before.tracking->stop();
}

/// With this tracker now.
bool SharedTools::isTracking(const Tracker& tracker) const
{
    return m_laid && m_laid->tracking && &m_laid->tracking->tracker() == &tracker;
}

Result<void> SharedTools::setTracker(std::optional<TrackerChoice> tracker, Devices devices)
{
    CARINA_EXPECTS(m_laid != nullptr);
    std::optional<MadeTracker> made;
    if (devices == Devices::RunOn && m_made && tracker && !tracker->isSimulated()) {
        auto next = m_made->next(*tracker, clock());
        if (!next)
            return tl::unexpected(next.error());
        made = *std::move(next);
    }
    std::optional<TrackerChoice> before = std::exchange(m_hardware.tracker, std::move(tracker));
    auto laid = replace(SharedPatientModel{m_laid->given}, std::move(made));
    if (!laid)
        m_hardware.tracker = std::move(before);
    return laid;
}

void SharedTools::holdTracker(bool holds)
{
    if (!m_made || !m_laid->tracking || !hasDevice(*m_hardware.tracker))
        return;
    if (holds)
        m_laid->tracking->stop();
    else // it was started before: what keeps it from tracking is told as ever
        (void)m_laid->tracking->start();
}

Result<void> SharedTools::track(Laid& laid, std::optional<MadeTracker>& made) const
{
    const auto place = m_placeOf(*laid.patient);
    if (!place)
        return tl::unexpected(place.error());
    laid.place = *place;
    const TrackerChoice& choice = *m_hardware.tracker;
    if (!laid.place && !choice.isSimulated())
        return fail(Errc::NotRegistered, trackerName(choice).toStdString());
    useRegistrationOn(laid, made);
    if (laid.place && !laid.place->setup)
        return {}; // nothing tells where the tools are in the patient
    if (laid.place && laid.place->setup->tube)
        laid.patient = std::make_shared<const PatientModel>(laid.given->withTube(
            centrelineOfTube(*laid.place->setup->tube), laid.place->setup->tube->outerDiameter));
    if (const auto begun = choice.isSimulated() ? simulate(laid) : connect(laid, made); !begun)
        return begun;
    laid.guard = guardOver(*laid.tracking, laid.place);
    treatPoses(laid.tracking->tracker(), m_hardware.treatment);
    if (isTracking(laid.tracking->tracker()))
        return {};
    return made ? made->start() : laid.tracking->start();
}

/// As in takePlace(): a registration that went out of date is used on, and said to be, while the
/// frame is the same.
void SharedTools::useRegistrationOn(Laid& laid, const std::optional<MadeTracker>& made) const
{
    const bool isPatientLaid = m_laid && m_laid->given == laid.given;
    if (isPatientLaid && laid.place && !laid.place->setup && m_laid->place && made && m_made
        && made->hasFrameOf(*m_made))
        laid.place->setup = m_laid->place->setup;
}

Result<void> SharedTools::connect(Laid& laid, std::optional<MadeTracker>& made) const
{
    CARINA_EXPECTS(laid.place.has_value());
    if (!made) {
        auto begun = MadeTracker::make(*m_hardware.tracker, clock());
        if (!begun)
            return tl::unexpected(begun.error());
        made = *std::move(begun);
    }
    laid.tracking =
        std::make_shared<StationTracking>(made->tracker(), laid.place->setup->registration);
    return {};
}

Result<void> SharedTools::simulate(Laid& laid) const
{
    const auto& [chosen, play] = std::get<SimulatedDevice>(m_hardware.tracker->device);
    SimulatedTrackerSettings device = chosen;
    HandMotion motion;
    if (play) {
        auto played = play(*laid.patient);
        if (!played)
            return tl::unexpected(played.error());
        device.laryngoscope = true;
        device.laryngoscopeName = played->laryngoscope;
        laid.played = std::make_shared<PlayedHands>(m_node, *std::move(played));
        laid.X_SP_played = calibratedShaft(kSimulatedStylus, laid.place).value_or(RigidTransform{});
        motion = heldByTip([hands = laid.played](SessionTime t) { return hands->at(t); },
                           laid.X_SP_played);
    }
    auto simulated = simulatedStation(
        laid.patient->landmarks(), laid.patient->tube(), clock(), registrationIn(laid.place),
        m_hardware.manikinBreathes, [node = &m_node] { return simulatedPerson(*node); }, device,
        laryngoscopyOf(*laid.patient, chosen), [node = &m_node] { return simulatedHead(*node); },
        std::move(motion));
    if (!simulated)
        return tl::unexpected(simulated.error());
    laid.truth = [truth = simulated->truth,
                  X_TA = simulated->X_TA](SessionTime t) -> std::optional<RigidTransform> {
        const auto X_TH = truth(ToolRole::Head, t);
        return X_TH ? std::optional{X_TH->inverse() * X_TA} : std::nullopt;
    };
    laid.tracking = std::move(simulated->tracking);
    return {};
}

void SharedTools::takePlace()
{
    if (!m_laid || !m_hardware.tracker)
        return;
    const auto read = m_placeOf(*m_laid->patient);
    if (!m_laid->place) { // laid without a site
        if (read && *read)
            (void)lay(SharedPatientModel{m_laid->given});
        return;
    }
    if (!read) // what was registered is shown on, but no file says any more how good it is
        m_laid->place->standing = {};
    if (!read || !*read)
        return;
    const SitePlace& place = **read;
    m_laid->place->standing = place.standing;
    if (!place.setup)
        return; // what was registered before is shown on, and said to be out of date
    // Other tools are drawn otherwise.
    if (!m_laid->tracking || !areSameTools(*place.setup, *m_laid->place->setup)) {
        (void)lay(SharedPatientModel{m_laid->given});
        return;
    }
    // The file is also written for another page or name, which lays nothing and keeps the guard.
    const SiteSetup before = std::exchange(*m_laid->place->setup, *place.setup);
    const bool isLaidAlike = isSamePlace(*place.setup, before);
    if (!isLaidAlike)
        m_laid->tracking->takeRegistration(place.setup->registration);
    if (!isLaidAlike || !isSameGuard(*place.setup, before)) {
        m_laid->guard = guardOver(*m_laid->tracking, m_laid->place);
        publishPoses();
    }
}

std::optional<BladeShape> SharedTools::blade() const
{
    return m_laid->place && m_laid->place->setup ? m_laid->place->setup->blade : std::nullopt;
}

void SharedTools::treat(const PoseTreatment& treatment)
{
    m_hardware.treatment = treatment;
    if (m_laid && m_laid->tracking)
        treatPoses(m_laid->tracking->tracker(), treatment);
}

std::optional<TrackerSight> SharedTools::trackerSight() const
{
    if (m_fault)
        return TrackerSight{.trouble = errorText(*m_fault)};
    if (!m_laid || !m_hardware.tracker)
        return std::nullopt;
    TrackerSight sight{.trouble = chinProbe().trackerTrouble(),
                       .usualVolume = usualVolume(*m_hardware.tracker),
                       .isPlaced = m_laid->tracking != nullptr};
    const auto now = m_node.now();
    if (m_laid->tracking && now)
        sight.tools = toolStatus(m_laid->tracking->tracker(), *now);
    return sight;
}

std::optional<RegistrationStanding> SharedTools::standing() const
{
    if (!m_laid || !m_hardware.tracker)
        return std::nullopt;
    if (!m_laid->place)
        return RegistrationStanding{RegistrationState::Simulated, StaleReason::None, {}};
    if (m_laid->guard && m_laid->guard->report().state == WatchState::Drifted)
        return driftedBy(m_laid->guard->report().shift_A.norm());
    return m_laid->place->standing;
}

ObjectPoses SharedTools::posesOnScreen() const
{
    return {.at = [this](ObjectKind kind, SessionTime t) -> std::optional<PoseSample> {
                const auto tool = trackedBy(kind);
                return tool ? shownAt(*tool, t) : std::nullopt;
            },
            .newest = [this](ObjectKind kind) -> std::optional<SessionTime> {
                const auto tool = trackedBy(kind);
                const auto sample =
                    tool && m_laid->tracking ? m_laid->tracking->newest(*tool) : std::nullopt;
                return sample ? std::optional{sample->time} : std::nullopt;
            },
            .isCalled =
                [this](ObjectKind kind, const std::string& name) {
                    return kind != ObjectKind::Laryngoscope || name == m_laryngoscope;
                },
            .hasTool =
                [this](ObjectKind kind) {
                    const auto tool = trackedBy(kind);
                    return tool && m_laid->tracking && m_laid->tracking->hasTool(*tool);
                },
            .handsAreDrawn = true};
}

std::optional<PoseSample> SharedTools::shownAt(ToolRole tool, SessionTime t) const
{
    const auto sample = m_laid->tracking ? m_laid->tracking->shownAt(tool, t) : std::nullopt;
    if (!sample || tool != ToolRole::Stylus)
        return sample;
    const auto X_SP = shaftOf(*m_laid);
    return X_SP ? std::optional{attached(*sample, *X_SP)} : std::nullopt;
}

std::optional<RigidTransform> SharedTools::shaftOf(const Laid& laid)
{
    if (laid.played)
        return laid.X_SP_played;
    return laid.tracking ? calibratedShaft(laid.tracking->toolName(ToolRole::Stylus), laid.place)
                         : std::nullopt;
}

void SharedTools::recordBy(PoseRecording& recording) const
{
    auto tools = tracking() ? tracking()->tracker().tools() : std::vector<TrackedTool>{};
    recording.follow(std::move(tools), tracking());
}

std::optional<PoseSample> SharedTools::Published::newest(ToolRole tool) const
{
    const auto sample = tracking ? tracking->newest(tool) : std::nullopt;
    if (!sample || tool != ToolRole::Stylus)
        return sample;
    return X_SP ? std::optional{attached(*sample, *X_SP)} : std::nullopt;
}

void SharedTools::publishPoses()
{
    m_board->store(std::make_shared<const Published>(
        Published{m_laid->tracking, shaftOf(*m_laid), m_station, m_laryngoscope}));
}

PoseSource SharedTools::source(ToolRole tool) const
{
    return [board = m_board, node = &m_node, tool]() -> std::optional<PoseSample> {
        const auto published = board->load();
        // Elsewhere another patient lies, in whose frame the pose is not.
        if (!published || published->station != ownStation(*node))
            return std::nullopt;
        return published->newest(tool);
    };
}

/// Shares the tools that others see, once: what is shared then follows the tracker.
void SharedTools::share()
{
    if (!std::exchange(m_shares, true)) {
        share(ObjectKind::Tube, ToolRole::Tube, "Tube");
        share(ObjectKind::Jaw, ToolRole::Jaw, "Jaw");
        share(ObjectKind::Head, ToolRole::Head, "Head");
        share(ObjectKind::Hand, ToolRole::Hand, "Hand");
        share(ObjectKind::Stylus, ToolRole::Stylus, "Stylus");
    }
    shareLaryngoscope();
}

void SharedTools::share(ObjectKind kind, ToolRole tool, const char* name)
{
    m_node.publish(kind, name, source(tool));
}

/// By the blade that the tracker's name for it tells. It has a new name as often as a trainee may
/// share one.
void SharedTools::nameLaryngoscope()
{
    const std::string name =
        m_laid->tracking ? m_laid->tracking->toolName(ToolRole::Laryngoscope) : std::string{};
    if (name.empty())
        return;
    const auto told = bladeOfTool(name);
    const std::string blade = told ? " " + std::string{bladeOf(*told).name} : std::string{};
    const std::string wanted = "Laryngoscope" + blade;
    const bool wasShared = std::ranges::find(m_laryngoscopes, wanted) != m_laryngoscopes.end();
    if (wasShared || m_laryngoscopes.size() < kMostOfAKind)
        m_laryngoscope = wanted;
}

/// Few trackers have one: it is shared from the first on that does, and anew under another name,
/// while what was shared under that of before is not seen any more.
void SharedTools::shareLaryngoscope()
{
    const bool isShared =
        std::ranges::find(m_laryngoscopes, m_laryngoscope) != m_laryngoscopes.end();
    if (m_laryngoscope.empty() || isShared)
        return;
    m_laryngoscopes.push_back(m_laryngoscope);
    m_node.publish(ObjectKind::Laryngoscope, m_laryngoscope,
                   [board = m_board, name = m_laryngoscope,
                    newest = source(ToolRole::Laryngoscope)]() -> std::optional<PoseSample> {
                       const auto published = board->load();
                       return published && published->laryngoscope == name ? newest()
                                                                           : std::nullopt;
                   });
}

} // namespace carina
