#pragma once

#include "engine/io/site/tracker_file.h"
#include "engine/tracking/delivery_thread.h"
#include "engine/tracking/motion_filter.h"

#include <QThread>

#include <deque>
#include <memory>
#include <mutex>

namespace carina
{

/// A tracker of NDI at a serial port or on the network: the client (NdiClient) with a port, on a
/// thread of its own. A port that cannot be opened, or is closed, is tried again by itself, so that
/// a device may be plugged in at any time.
class NdiTracker : public Tracker
{
public:
    /// Without tools it only looks what is there.
    /// @returns WrongAddress
    [[nodiscard]] static Result<std::unique_ptr<NdiTracker>>
    make(const TrackerDescription& description, ReadSessionClock clock);
    ~NdiTracker() override;

    [[nodiscard]] Result<void> start() override;
    void stop() override;
    [[nodiscard]] std::vector<TrackedTool> tools() const override { return m_tools; }
    [[nodiscard]] std::string trouble() const override;
    /// The device, while it tracks. May be called from any thread.
    [[nodiscard]] std::optional<NdiFound> found() const;

private:
    class Line;
    struct Tool {
        MotionFilter filter;
        PoseHistory history;
        std::optional<PoseSample> last; ///< X_TO, tracked
    };

    NdiTracker(const TrackerDescription& description, ReadSessionClock clock);
    void take(const NdiMeasurement& measurement, LocalTime now);
    void say(std::string trouble, std::optional<NdiFound> found = {});

    std::string m_address;
    NdiClientSettings m_settings;
    ReadSessionClock m_clock;
    std::deque<Tool> m_tracked; // one for each of m_tools; a history cannot be moved
    std::vector<TrackedTool> m_tools;
    mutable std::mutex m_mutex;
    std::string m_trouble;
    std::optional<NdiFound> m_found;
    QThread m_thread;
    std::unique_ptr<Line> m_line; ///< of m_thread, while that runs
};

} // namespace carina
