#pragma once

#include "engine/io/site/tracker_file.h"
#include "engine/tracking/delivery_thread.h"
#include "engine/tracking/igtl/igtl_client.h"
#include "engine/tracking/motion_filter.h"

#include <QThread>

#include <deque>
#include <memory>
#include <mutex>

namespace carina
{

/// Tools whose poses a server of OpenIGTLink sends, such as PLUS: the client (IgtlClient) with a
/// connection, on a thread of its own. A server that cannot be reached, goes away or sends
/// something else is tried again by itself.
class IgtlTracker : public Tracker
{
public:
    /// @returns WrongAddress where the address is not host and port.
    [[nodiscard]] static Result<std::unique_ptr<IgtlTracker>>
    make(const TrackerDescription& description, ReadSessionClock clock);
    ~IgtlTracker() override;

    [[nodiscard]] Result<void> start() override;
    void stop() override;
    [[nodiscard]] std::vector<TrackedTool> tools() const override { return m_tools; }
    [[nodiscard]] std::string trouble() const override;

private:
    class Connection;
    struct Tool {
        MotionFilter filter;
        PoseHistory history;
        std::optional<RigidTransform> X_TO; ///< the last one seen
    };

    IgtlTracker(const TrackerDescription& description, ReadSessionClock clock);
    void take(const IgtlSight& sight, LocalTime now);
    void say(std::string trouble);

    std::string m_address;
    IgtlClientSettings m_settings;
    ReadSessionClock m_clock;
    std::deque<Tool> m_tracked; // one for each of m_tools; a history cannot be moved
    std::vector<TrackedTool> m_tools;
    mutable std::mutex m_mutex;
    std::string m_trouble;
    QThread m_thread;
    std::unique_ptr<Connection> m_connection; ///< of m_thread, while that runs
};

} // namespace carina
