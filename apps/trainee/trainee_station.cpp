#include "apps/trainee/trainee_station.h"

#include "engine/core/expects.h"
#include "engine/io/site/site.h"
#include "engine/session/simulated_station.h"
#include "engine/tracking/reframed.h"

namespace carina
{
namespace
{

constexpr int kLookInterval_ms = 50; ///< at the stylus

/// X_SP of the tracked stylus, with -z of P along the shaft.
std::optional<RigidTransform> tipOf(const StationTracking& tracking,
                                    const TraineeStation::Place& place)
{
    if (!place || !place->setup || !place->setup->guard)
        return std::nullopt;
    const StylusTip* tip =
        tipOfTool(place->setup->guard->styluses, tracking.toolName(ToolRole::Stylus));
    if (tip == nullptr)
        return std::nullopt;
    return RigidTransform{Quat::FromTwoVectors(-Vec3::UnitZ(), tip->p_SQ), tip->p_SQ};
}

/// The first trainee of a session is the first to work; each other one has another number.
unsigned simulatedPerson(const SessionNode& node)
{
    const ParticipantId self = node.self();
    return self == kNobody || self.value == 0 ? 0U : self.value - 1U;
}

bool hasDeviceOf(const TrackerChoice& tracker)
{
    return !tracker.isSimulated() && !std::holds_alternative<PlayedRecording>(tracker.device);
}

/// @pre the place, if there is one, can be used.
std::optional<StationRegistration> registrationIn(const TraineeStation::Place& place)
{
    return place ? std::optional{place->setup->registration} : std::nullopt;
}

std::unique_ptr<RegistrationGuard> guardOf(const StationTracking& tracking,
                                           const TraineeStation::Place& place)
{
    if (!place || !place->setup || !place->setup->guard)
        return nullptr;
    return std::make_unique<RegistrationGuard>(tracking, *place->setup->guard);
}

} // namespace

TraineeStation::TraineeStation(std::unique_ptr<SessionNode> node, Hardware hardware,
                               PlaceOf placeOf)
    : m_node{std::move(node)},
      m_station{ownStation(*m_node)},
      m_hardware{std::move(hardware)},
      m_placeOf{std::move(placeOf)},
      m_report{*m_node}
{
    if (m_hardware.tracker)
        publish();
    QObject::connect(&m_looking, &QTimer::timeout, &m_looking, [this] {
        if (m_laid && m_laid->guard)
            m_laid->guard->look();
        if (const auto standing = this->standing())
            m_report.tell(*standing);
    });
    m_looking.start(kLookInterval_ms);
}

/// The node asks the tracking for poses, the tracking reads the node's clock: neither may end while
/// the other runs.
TraineeStation::~TraineeStation()
{
    m_manikin.reset();
    if (m_laid && m_laid->tracking)
        m_laid->tracking->stop();
    m_laid.reset();
    m_node.reset();
}

/// Shares the tools that others see: the newest sample of each, in the patient's frame.
void TraineeStation::publish()
{
    if (m_manikin)
        return; // what is shared follows the tracker
    share(ObjectKind::Tube, ToolRole::Tube, "Tube");
    share(ObjectKind::Jaw, ToolRole::Jaw, "Jaw");
    share(ObjectKind::Head, ToolRole::Head, "Head");
    share(ObjectKind::Hand, ToolRole::Hand, "Hand");
    share(ObjectKind::Stylus, ToolRole::Stylus, "Stylus");
    m_manikin = std::make_unique<ManikinBreaths>(*m_node, [this]() -> std::optional<PoseSample> {
        const auto published = m_published.load();
        return published ? published->newest(ToolRole::Chest) : std::nullopt;
    });
}

void TraineeStation::share(ObjectKind kind, ToolRole tool, std::string name)
{
    m_node->publish(kind, std::move(name), [this, tool]() -> std::optional<PoseSample> {
        const auto published = m_published.load();
        return published ? published->newest(tool) : std::nullopt;
    });
}

/// Few trackers have one: it is shared from the first on that does.
void TraineeStation::shareLaryngoscope()
{
    if (m_sharesLaryngoscope || !m_laid->tracking
        || m_laid->tracking->toolName(ToolRole::Laryngoscope).empty())
        return;
    m_sharesLaryngoscope = true;
    share(ObjectKind::Laryngoscope, ToolRole::Laryngoscope, "Laryngoscope");
}

void TraineeStation::setStation(StationId station)
{
    m_station = station;
    if (m_laid)
        m_laid->view->setStation(station);
}

Result<void> TraineeStation::lay(const SharedPatientModel& patient,
                                 const std::function<void()>& show)
{
    auto next = std::make_unique<Laid>(Laid{patient, patient, nullptr, {}, nullptr, nullptr, {}});
    if (m_hardware.tracker)
        if (const auto tracked = track(*next); !tracked)
            return tracked;
    next->view =
        std::make_unique<StationView>(*m_node, m_station, next->patient->lungs(),
                                      next->tracking ? posesOf(*next->tracking) : ObjectPoses{});
    const std::unique_ptr<Laid> before = std::exchange(m_laid, std::move(next));
    if (m_laid->tracking)
        m_device = m_hardware.tracker->isSimulated() ? nullptr : m_laid->tracking->sharedTracker();
    publishPoses();
    shareLaryngoscope();
    if (show)
        show();
    if (before && before->tracking && !isTracking(before->tracking->tracker()))
        before->tracking->stop();
    for (const auto& told : m_onLaid)
        told();
    return {};
}

/// With this tracker now.
bool TraineeStation::isTracking(const Tracker& tracker) const
{
    return m_laid && m_laid->tracking && &m_laid->tracking->tracker() == &tracker;
}

Result<void> TraineeStation::setTracker(std::optional<TrackerChoice> tracker,
                                        const std::function<void()>& show)
{
    CARINA_EXPECTS(m_laid != nullptr);
    std::optional<TrackerChoice> before = std::exchange(m_hardware.tracker, std::move(tracker));
    std::shared_ptr<Tracker> deviceBefore = std::exchange(m_device, nullptr);
    auto laid = lay(SharedPatientModel{m_laid->given}, show);
    if (!laid) {
        m_hardware.tracker = std::move(before);
        m_device = std::move(deviceBefore);
    } else if (m_hardware.tracker) {
        publish();
    }
    return laid;
}

void TraineeStation::holdTracker(bool holds)
{
    const bool hasDevice = m_device && m_laid->tracking && hasDeviceOf(*m_hardware.tracker);
    if (hasDevice && holds)
        m_laid->tracking->stop();
    else if (hasDevice) // it was started before: what keeps it from tracking is told as ever
        (void)m_laid->tracking->start();
}

std::optional<PoseSample> TraineeStation::Published::newest(ToolRole tool) const
{
    const auto sample = tracking ? tracking->newest(tool) : std::nullopt;
    if (!sample || tool != ToolRole::Stylus)
        return sample;
    return X_SP ? std::optional{attached(*sample, *X_SP)} : std::nullopt;
}

void TraineeStation::publishPoses()
{
    m_published.store(std::make_shared<const Published>(
        Published{m_laid->tracking,
                  m_laid->tracking ? tipOf(*m_laid->tracking, m_laid->place) : std::nullopt}));
}

Result<void> TraineeStation::track(Laid& laid)
{
    const auto place = m_placeOf(*laid.patient);
    if (!place)
        return tl::unexpected(place.error());
    laid.place = *place;
    if (!laid.place && !m_hardware.tracker->isSimulated())
        return fail(Errc::NotRegistered, trackerName(*m_hardware.tracker).toStdString());
    if (laid.place && !laid.place->setup)
        return {}; // nothing tells where the tools are in the patient
    if (laid.place && laid.place->setup->tube)
        laid.patient = std::make_shared<const PatientModel>(laid.given->withTube(
            centrelineOfTube(*laid.place->setup->tube), laid.place->setup->tube->outerDiameter));
    if (const auto made = m_hardware.tracker->isSimulated() ? simulate(laid) : connect(laid); !made)
        return made;
    laid.guard = guardOf(*laid.tracking, laid.place);
    treatPoses(laid.tracking->tracker(), m_hardware.treatment);
    if (isTracking(laid.tracking->tracker()))
        return {};
    return laid.tracking->start();
}

Result<void> TraineeStation::connect(Laid& laid) const
{
    CARINA_EXPECTS(laid.place.has_value());
    std::shared_ptr<Tracker> device = m_device;
    if (!device) {
        auto made = makeTracker(*m_hardware.tracker, [node = m_node.get()] { return node->now(); });
        if (!made)
            return tl::unexpected(made.error());
        device = *std::move(made);
    }
    laid.tracking =
        std::make_shared<StationTracking>(std::move(device), laid.place->setup->registration);
    return {};
}

Result<void> TraineeStation::simulate(Laid& laid) const
{
    auto simulated = simulatedStation(
        laid.patient->landmarks(), laid.patient->tube(),
        [node = m_node.get()] { return node->now(); }, registrationIn(laid.place),
        m_hardware.manikinBreathes, [node = m_node.get()] { return simulatedPerson(*node); },
        std::get<SimulatedDevice>(m_hardware.tracker->device).settings);
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

void TraineeStation::takePlace(const std::function<void()>& show)
{
    if (!m_laid || !m_hardware.tracker)
        return;
    const auto read = m_placeOf(*m_laid->patient);
    if (!m_laid->place) { // laid without a site
        if (read && *read)
            (void)lay(SharedPatientModel{m_laid->given}, show);
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
    if (!m_laid->tracking) {
        (void)lay(SharedPatientModel{m_laid->given}, show);
        return;
    }
    if (!areSameTools(*place.setup, *m_laid->place->setup)) { // which are drawn otherwise
        (void)lay(SharedPatientModel{m_laid->given}, show);
        return;
    }
    // The file is also written for another page or name, which lays nothing and keeps the guard.
    const SiteSetup before = std::exchange(*m_laid->place->setup, *place.setup);
    const bool isLaidAlike = isSamePlace(*place.setup, before);
    if (!isLaidAlike)
        m_laid->tracking->takeRegistration(place.setup->registration);
    if (!isLaidAlike || !isSameGuard(*place.setup, before)) {
        m_laid->guard = guardOf(*m_laid->tracking, m_laid->place);
        publishPoses();
    }
}

std::optional<BladeShape> TraineeStation::blade() const
{
    return m_laid && m_laid->place && m_laid->place->setup ? m_laid->place->setup->blade
                                                           : std::nullopt;
}

void TraineeStation::treat(const PoseTreatment& treatment)
{
    m_hardware.treatment = treatment;
    if (m_laid && m_laid->tracking)
        treatPoses(m_laid->tracking->tracker(), treatment);
}

std::optional<TrackerSight> TraineeStation::trackerSight() const
{
    if (!m_laid || !m_hardware.tracker)
        return std::nullopt;
    TrackerSight sight{.trouble = chinProbe().trackerTrouble(),
                       .usualVolume = usualVolume(*m_hardware.tracker)};
    const auto now = m_node->now();
    if (m_laid->tracking && now)
        sight.tools = toolStatus(m_laid->tracking->tracker(), *now);
    return sight;
}

std::optional<RegistrationStanding> TraineeStation::standing() const
{
    if (!m_laid || !m_hardware.tracker)
        return std::nullopt;
    if (!m_laid->place)
        return RegistrationStanding{RegistrationState::Simulated, StaleReason::None, {}};
    if (m_laid->guard && m_laid->guard->report().state == WatchState::Drifted)
        return driftedBy(m_laid->guard->report().shift_A.norm());
    return m_laid->place->standing;
}

} // namespace carina
