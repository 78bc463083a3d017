#include "engine/vision/camera_tracker.h"

#include "engine/core/ended_threads.h"
#include "engine/core/monotonic_clock.h"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <system_error>
#include <utility>

namespace carina
{
namespace
{

constexpr Duration kBeforeReopening = std::chrono::milliseconds{500};
constexpr Duration kLongestWait = std::chrono::milliseconds{20};
/// The oldest stamp of a camera that is believed to be one of CLOCK_MONOTONIC.
constexpr Duration kOldestStamp = std::chrono::seconds{1};

WatchedBodies watchedOf(const CameraTrackerSettings& settings)
{
    WatchedBodies watched{settings.camera, settings.dictionary, {}};
    for (const MarkedTool& tool : settings.tools)
        watched.bodies.push_back(tool.body);
    return watched;
}

} // namespace

/// What the thread does, and all that it uses.
class CameraTracker::Watching
{
public:
    Watching(CameraTrackerSettings settings, ReadSessionClock clock);

    void run(const std::stop_token& stopping);
    /// After return nothing is delivered by the thread with this token, and the clock is not read.
    void end(std::jthread& thread);
    [[nodiscard]] const std::vector<TrackedTool>& tools() const { return m_tools; }
    [[nodiscard]] std::string trouble() const;
    [[nodiscard]] std::optional<SessionTime> playedSince() const;

private:
    struct Tool {
        PoseHistory history{PoseHistory::Limits{.estimates = true}};
        std::optional<PoseSample> last; ///< X_TO, tracked
    };

    void play(PictureSource& source, const std::stop_token& stopping);
    void watch(PictureSource& source, const std::stop_token& stopping);
    void take(const GreyPicture& picture, Duration time, SessionTime exposed,
              const std::stop_token& stopping);
    void deliver(const std::vector<BodySight>& sights, SessionTime exposed);
    static void push(Tool& tool, std::optional<PoseSample> sample, SessionTime exposed);
    [[nodiscard]] std::optional<SessionTime> present(const std::stop_token& stopping) const;
    [[nodiscard]] std::optional<SessionTime> wait(SessionTime until,
                                                  const std::stop_token& stopping);
    void rest(Duration duration, const std::stop_token& stopping);
    void beginPlaying(SessionTime now);
    void say(std::string trouble);

    CameraTrackerSettings m_settings;
    ReadSessionClock m_clock;
    MarkerWatch m_watch;
    std::deque<Tool> m_tracked; // one for each of m_tools; a history cannot be moved
    std::vector<TrackedTool> m_tools;
    mutable std::mutex m_delivery; ///< held to deliver, to read the clock, and to end
    mutable std::mutex m_mutex;
    std::string m_trouble;
    std::optional<SessionTime> m_playedSince;
    std::condition_variable_any m_wake;
};

Result<std::unique_ptr<CameraTracker>> CameraTracker::make(CameraTrackerSettings settings,
                                                           ReadSessionClock clock)
{
    if (!isUsable(settings.camera))
        return fail(Errc::OutOfRange, "the calibration of the camera");
    for (const MarkedTool& tool : settings.tools)
        if (const auto checked = checkBody(tool.body, sizeOf(settings.dictionary)); !checked)
            return fail(checked.error().code, tool.name + ": " + checked.error().detail);
    return std::unique_ptr<CameraTracker>{new CameraTracker{std::move(settings), std::move(clock)}};
}

CameraTracker::CameraTracker(CameraTrackerSettings settings, ReadSessionClock clock)
    : m_watching{std::make_shared<Watching>(std::move(settings), std::move(clock))}
{
}

CameraTracker::~CameraTracker()
{
    stop();
    joinLater(std::move(m_thread));
}

Result<void> CameraTracker::start()
{
    if (m_thread.joinable() && !m_thread.get_stop_token().stop_requested())
        return {};
    try {
        m_thread = std::jthread{[watching = m_watching, before = std::move(m_thread)](
                                    const std::stop_token& stopping) mutable {
            if (before.joinable())
                before.join(); // which has the camera
            watching->run(stopping);
        }};
    } catch (const std::system_error& error) {
        return fail(Errc::TrackerFailed, error.what());
    }
    return {};
}

void CameraTracker::stop() { m_watching->end(m_thread); }

std::vector<TrackedTool> CameraTracker::tools() const { return m_watching->tools(); }

std::string CameraTracker::trouble() const { return m_watching->trouble(); }

std::optional<SessionTime> CameraTracker::playedSince() const { return m_watching->playedSince(); }

CameraTracker::Watching::Watching(CameraTrackerSettings settings, ReadSessionClock clock)
    : m_settings{std::move(settings)}, m_clock{std::move(clock)}, m_watch{watchedOf(m_settings)}
{
    for (const MarkedTool& tool : m_settings.tools)
        m_tools.push_back({tool.name, tool.role, &m_tracked.emplace_back().history});
    m_settings.place.width = m_settings.camera.width;
    m_settings.place.height = m_settings.camera.height;
}

void CameraTracker::Watching::end(std::jthread& thread)
{
    const std::lock_guard lock{m_delivery};
    thread.request_stop();
}

std::optional<SessionTime> CameraTracker::Watching::present(const std::stop_token& stopping) const
{
    const std::lock_guard lock{m_delivery};
    return stopping.stop_requested() ? std::nullopt : m_clock();
}

std::string CameraTracker::Watching::trouble() const
{
    const std::lock_guard lock{m_mutex};
    return m_trouble;
}

std::optional<SessionTime> CameraTracker::Watching::playedSince() const
{
    const std::lock_guard lock{m_mutex};
    return m_playedSince;
}

void CameraTracker::Watching::beginPlaying(SessionTime now)
{
    const std::lock_guard lock{m_mutex};
    m_playedSince = now;
}

void CameraTracker::Watching::say(std::string trouble)
{
    const std::lock_guard lock{m_mutex};
    m_trouble = std::move(trouble);
}

void CameraTracker::Watching::run(const std::stop_token& stopping)
{
    while (!stopping.stop_requested()) {
        auto source = PictureSource::open(m_settings.place);
        if (!source) {
            say(source.error().detail);
        } else if (m_settings.place.kind == PicturePlace::Kind::Camera) {
            watch(*source, stopping);
        } else {
            play(*source, stopping);
            if (m_settings.playing == Playing::Once)
                return;
        }
        rest(m_settings.place.kind == PicturePlace::Kind::Camera ? kBeforeReopening
                                                                 : RecordedTracker::kPause,
             stopping);
    }
}

/// A webcam, until it is unplugged.
void CameraTracker::Watching::watch(PictureSource& source, const std::stop_token& stopping)
{
    while (!stopping.stop_requested()) {
        const auto taken = source.next();
        const LocalTime now = monotonicNow();
        if (!taken) {
            say(m_settings.place.path.string() + ": the camera gives no picture");
            return;
        }
        Duration age{};
        if (taken->stamped) {
            const Duration stamped = machineTime(now) - *taken->stamped;
            if (stamped > Duration::zero() && stamped < kOldestStamp)
                age = stamped;
        }
        if (const auto session = present(stopping))
            take(taken->picture, taken->time, *session - age, stopping);
    }
}

/// A video from its beginning to its end.
void CameraTracker::Watching::play(PictureSource& source, const std::stop_token& stopping)
{
    const Duration period = fromSeconds(1.0 / source.rate());
    std::optional<SessionTime> begin;
    std::int64_t number = 0;
    for (;; ++number) {
        const SessionTime due = begin.value_or(SessionTime{}) + number * period;
        const auto now = wait(begin ? due : SessionTime{Duration::min()}, stopping);
        if (!now)
            return;
        if (!begin) {
            begin = *now;
            beginPlaying(*begin);
        } else if (*now > due + period && source.skip()) {
            continue;
        }
        const auto taken = source.next();
        if (!taken)
            break;
        take(taken->picture, number * period, *begin + number * period, stopping);
    }
    if (m_settings.playing == Playing::Once)
        say(m_settings.place.path.string() + ": its end is reached");
}

void CameraTracker::Watching::take(const GreyPicture& picture, Duration time, SessionTime exposed,
                                   const std::stop_token& stopping)
{
    if (picture.width != m_settings.camera.width || picture.height != m_settings.camera.height) {
        say(m_settings.place.path.string() + ": pictures of " + std::to_string(picture.width)
            + " x " + std::to_string(picture.height) + " pixels, and the calibration is for "
            + std::to_string(m_settings.camera.width) + " x "
            + std::to_string(m_settings.camera.height));
        return;
    }
    const std::vector<BodySight> sights = m_watch.look(picture, time);
    const std::lock_guard lock{m_delivery};
    if (!stopping.stop_requested())
        deliver(sights, exposed);
}

void CameraTracker::Watching::deliver(const std::vector<BodySight>& sights, SessionTime exposed)
{
    std::string ambiguous;
    for (std::size_t i = 0; i < sights.size(); ++i) {
        push(m_tracked[i], sampleOf(sights[i], m_settings.camera.focal.x(), exposed), exposed);
        if (sights[i].isAmbiguous)
            ambiguous += (ambiguous.empty() ? "" : ", ") + m_tools[i].name;
    }
    say(ambiguous.empty()
            ? ambiguous
            : ambiguous + ": two poses fit what is seen of it; show more of its markers");
}

void CameraTracker::Watching::push(Tool& tool, std::optional<PoseSample> sample,
                                   SessionTime exposed)
{
    if (sample) {
        tool.last = sample;
    } else {
        if (!tool.last)
            return; // never seen yet: a lost pose is never an identity
        sample = tool.last;
        sample->time = exposed;
        sample->validity = Validity::Lost;
        sample->covariance_O.reset();
    }
    tool.history.push(*sample);
}

/// Until a session time, or until the clock is set. @returns the present time; nothing to end.
std::optional<SessionTime> CameraTracker::Watching::wait(SessionTime until,
                                                         const std::stop_token& stopping)
{
    while (!stopping.stop_requested()) {
        const auto now = present(stopping);
        if (now && *now >= until)
            return now;
        rest(now ? std::min(until - *now, kLongestWait) : kLongestWait, stopping);
    }
    return std::nullopt;
}

void CameraTracker::Watching::rest(Duration duration, const std::stop_token& stopping)
{
    std::unique_lock lock{m_mutex};
    m_wake.wait_for(lock, stopping, duration, [] { return false; });
}

} // namespace carina
