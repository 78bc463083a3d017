#pragma once

#include "engine/tracking/delivery_thread.h"
#include "engine/tracking/record/recorded_tracker.h"
#include "engine/vision/marker_watch.h"
#include "engine/vision/picture_source.h"

#include <memory>
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
///
/// A driver may keep the thread waiting for a picture for seconds, of a camera that was unplugged.
/// stop() and the destructor do not wait for that: what comes then is thrown away, and the next
/// start() waits on its own thread until the camera is free.
class CameraTracker : public Tracker
{
public:
    /// @returns OutOfRange for a camera or a body that cannot be used (isUsable, checkBody).
    [[nodiscard]] static Result<std::unique_ptr<CameraTracker>> make(CameraTrackerSettings settings,
                                                                     ReadSessionClock clock);
    ~CameraTracker() override;

    [[nodiscard]] Result<void> start() override;
    void stop() override;
    [[nodiscard]] std::vector<TrackedTool> tools() const override;
    [[nodiscard]] std::string trouble() const override;
    [[nodiscard]] std::optional<SessionTime> playedSince() const override;

private:
    class Watching;

    CameraTracker(CameraTrackerSettings settings, ReadSessionClock clock);

    /// Shared with the thread, which may still wait for a picture when the tracker has ended.
    std::shared_ptr<Watching> m_watching;
    std::jthread m_thread;
};

} // namespace carina
