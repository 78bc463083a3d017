#include "engine/vision/camera_tracker.h"

#include "engine/core/monotonic_clock.h"

#include <algorithm>
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
    : m_settings{std::move(settings)}, m_clock{std::move(clock)}, m_watch{watchedOf(m_settings)}
{
    for (const MarkedTool& tool : m_settings.tools)
        m_tools.push_back({tool.name, tool.role, &m_tracked.emplace_back().history});
    m_settings.place.width = m_settings.camera.width;
    m_settings.place.height = m_settings.camera.height;
}

Result<void> CameraTracker::start()
{
    if (m_thread.joinable())
        return {};
    try {
        m_thread = std::jthread{[this](const std::stop_token& stopping) { run(stopping); }};
    } catch (const std::system_error& error) {
        return fail(Errc::TrackerFailed, error.what());
    }
    return {};
}

void CameraTracker::stop()
{
    m_thread.request_stop();
    if (m_thread.joinable())
        m_thread.join();
    m_thread = {};
}

std::string CameraTracker::trouble() const
{
    const std::lock_guard lock{m_mutex};
    return m_trouble;
}

void CameraTracker::say(std::string trouble)
{
    const std::lock_guard lock{m_mutex};
    m_trouble = std::move(trouble);
}

void CameraTracker::run(const std::stop_token& stopping)
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
void CameraTracker::watch(PictureSource& source, const std::stop_token& stopping)
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
        if (const auto present = m_clock())
            take(taken->picture, taken->time, *present - age);
    }
}

/// A video from its beginning to its end.
void CameraTracker::play(PictureSource& source, const std::stop_token& stopping)
{
    const Duration period = fromSeconds(1.0 / source.rate());
    std::optional<SessionTime> begin;
    std::int64_t number = 0;
    for (;; ++number) {
        const SessionTime due = begin.value_or(SessionTime{}) + number * period;
        const auto present = wait(begin ? due : SessionTime{Duration::min()}, stopping);
        if (!present)
            return;
        if (!begin)
            begin = *present;
        else if (*present > due + period && source.skip())
            continue;
        const auto taken = source.next();
        if (!taken)
            break;
        take(taken->picture, number * period, *begin + number * period);
    }
    if (m_settings.playing == Playing::Once)
        say(m_settings.place.path.string() + ": its end is reached");
}

void CameraTracker::take(const GreyPicture& picture, Duration time, SessionTime exposed)
{
    if (picture.width != m_settings.camera.width || picture.height != m_settings.camera.height) {
        say(m_settings.place.path.string() + ": pictures of " + std::to_string(picture.width)
            + " x " + std::to_string(picture.height) + " pixels, and the calibration is for "
            + std::to_string(m_settings.camera.width) + " x "
            + std::to_string(m_settings.camera.height));
        return;
    }
    const std::vector<BodySight> sights = m_watch.look(picture, time);
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

void CameraTracker::push(Tool& tool, std::optional<PoseSample> sample, SessionTime exposed)
{
    if (sample) {
        tool.last = sample;
    } else {
        if (!tool.last)
            return; // never seen yet: a lost pose is never an identity
        sample = tool.last;
        sample->time = exposed;
        sample->validity = Validity::Lost;
    }
    tool.history.push(*sample);
}

/// Until a session time, or until the clock is set. @returns the present time; nothing to end.
std::optional<SessionTime> CameraTracker::wait(SessionTime until, const std::stop_token& stopping)
{
    while (!stopping.stop_requested()) {
        const auto present = m_clock();
        if (present && *present >= until)
            return present;
        rest(present ? std::min(until - *present, kLongestWait) : kLongestWait, stopping);
    }
    return std::nullopt;
}

void CameraTracker::rest(Duration duration, const std::stop_token& stopping)
{
    std::unique_lock lock{m_mutex};
    m_wake.wait_for(lock, stopping, duration, [] { return false; });
}

} // namespace carina
