#pragma once

#include "engine/tracking/delivery_thread.h"
#include "engine/tracking/record/recorded_tracker.h"
#include "engine/vision/marker_watch.h"
#include "engine/vision/picture_source.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace carina
{

/// A tool that wears markers.
struct MarkedTool {
    std::string name;
    ToolRole role = ToolRole::Other;
    MarkerBody body;
};

struct CameraTrackerSettings {
    PicturePlace place{};
    CameraModel camera{};
    MarkerDictionary dictionary = MarkerDictionary::Bits4Of50;
    Playing playing = Playing::Once; ///< of a video or folder
    std::vector<MarkedTool> tools{};
};

/// A tracker that is a camera: it finds markers in the pictures of a webcam, a video or a folder,
/// on a thread of its own.
///
/// The sample of a webcam's picture has the driver's stamp, where it gives one, else the time of
/// its arrival. A video is played at its own speed, its first picture when the tracker starts;
/// pictures whose time has passed before they could be looked at are left out. A webcam that is not
/// there, or goes away, is tried again every half second. A tool that is not seen keeps its last
/// pose, marked as lost; one that was never seen has none.
class CameraTracker : public Tracker
{
public:
    /// @returns OutOfRange for a camera or a body that cannot be used (isUsable, checkBody).
    [[nodiscard]] static Result<std::unique_ptr<CameraTracker>> make(CameraTrackerSettings settings,
                                                                     ReadSessionClock clock);
    ~CameraTracker() override { stop(); }

    [[nodiscard]] Result<void> start() override;
    void stop() override;
    [[nodiscard]] std::vector<TrackedTool> tools() const override { return m_tools; }
    [[nodiscard]] std::string trouble() const override;

private:
    struct Tool {
        PoseHistory history{PoseHistory::Limits{.estimates = true}};
        std::optional<PoseSample> last; ///< X_TO, tracked
    };

    CameraTracker(CameraTrackerSettings settings, ReadSessionClock clock);
    void run(const std::stop_token& stopping);
    void play(PictureSource& source, const std::stop_token& stopping);
    void watch(PictureSource& source, const std::stop_token& stopping);
    void take(const GreyPicture& picture, Duration time, SessionTime exposed);
    static void push(Tool& tool, std::optional<PoseSample> sample, SessionTime exposed);
    [[nodiscard]] std::optional<SessionTime> wait(SessionTime until,
                                                  const std::stop_token& stopping);
    void rest(Duration duration, const std::stop_token& stopping);
    void say(std::string trouble);

    CameraTrackerSettings m_settings;
    ReadSessionClock m_clock;
    MarkerWatch m_watch;
    std::deque<Tool> m_tracked; // one for each of m_tools; a history cannot be moved
    std::vector<TrackedTool> m_tools;
    mutable std::mutex m_mutex;
    std::string m_trouble;
    std::condition_variable_any m_wake;
    std::jthread m_thread; // last: ends before what it uses
};

} // namespace carina
