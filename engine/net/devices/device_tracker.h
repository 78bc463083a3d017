#pragma once

#include "engine/net/devices/device_client.h"
#include "engine/net/devices/device_log.h"
#include "engine/tracking/delivery_thread.h"

#include <QThread>

#include <deque>
#include <memory>
#include <mutex>

namespace carina
{

/// A tracker at a serial port or on the network: the client of its protocol (DeviceClient) with a
/// port, on a thread of its own. A port that cannot be opened, or is closed, is tried again by
/// itself, so that a device may be plugged in, or a server be started, at any time. When a device
/// falls silent, each tool that it saw gets one lost sample.
class DeviceTracker : public Tracker
{
public:
    /// Without tools it only looks what is there.
    /// @param log where the bytes of the conversation are written; null: nowhere
    /// @returns WrongAddress
    [[nodiscard]] static Result<std::unique_ptr<DeviceTracker>>
    make(const TrackerDescription& description, ReadSessionClock clock,
         std::unique_ptr<DeviceLog> log = {});
    ~DeviceTracker() override;

    [[nodiscard]] Result<void> start() override;
    void stop() override;
    [[nodiscard]] std::vector<TrackedTool> tools() const override { return m_tools; }
    [[nodiscard]] std::string trouble() const override;
    [[nodiscard]] ToolSight sightOf(std::size_t tool) const override;
    /// The device, while it answers. May be called from any thread.
    [[nodiscard]] std::optional<DeviceFound> found() const;

private:
    class Line;
    struct Tool {
        PoseHistory history{PoseHistory::Limits{.estimates = true}};
        std::optional<RigidTransform> X_TO; ///< the last one seen
    };

    DeviceTracker(TrackerDescription description, ReadSessionClock clock,
                  std::unique_ptr<DeviceLog> log);
    void take(const DeviceSight& sight);
    void say(std::string trouble, std::optional<DeviceFound> found = {}, bool isSilent = true);
    void loseTools();

    TrackerDescription m_description;
    ReadSessionClock m_clock;
    std::unique_ptr<DeviceLog> m_log;
    std::deque<Tool> m_tracked; // one for each of m_tools; a history cannot be moved
    std::vector<TrackedTool> m_tools;
    mutable std::mutex m_mutex;
    std::string m_trouble;
    std::optional<DeviceFound> m_found;
    bool m_isSilent = false;
    std::vector<ToolSight> m_sights; ///< of each tool, at the newest exposure
    QThread m_thread;
    std::unique_ptr<Line> m_line; ///< of m_thread, while that runs
};

} // namespace carina
