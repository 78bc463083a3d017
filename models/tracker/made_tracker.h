#pragma once

#include "models/tracker/tracker_choice.h"

namespace carina
{

/// A tracker and the devices that it is made of, so that the next one can go on with those that
/// stay as they are.
class MadeTracker
{
public:
    /// A tracker that is not started.
    /// @pre the choice is not the simulated tracker.
    /// @returns the errors of makeTracker.
    [[nodiscard]] static Result<MadeTracker> make(const TrackerChoice& choice,
                                                  const ReadSessionClock& clock);

    /// The tracker of another choice, which takes over the devices of this one that are described
    /// alike, as they run, and puts them in their new places. A device that was the first goes on
    /// only as the first, in whose frame all track. A recording is made anew.
    /// @pre and @returns as make(); nothing is changed then.
    [[nodiscard]] Result<MadeTracker> next(const TrackerChoice& choice,
                                           const ReadSessionClock& clock) const;

    /// Shared with all who read its poses.
    [[nodiscard]] const std::shared_ptr<Tracker>& tracker() const { return m_tracker; }

    /// Starts all devices that do not run.
    /// @returns the error of the first one that does not start; then those run that were taken
    ///          over, and no other.
    [[nodiscard]] Result<void> start() const;
    /// Stops the devices that the other one does not have.
    void stopBeside(const MadeTracker& other) const;

    /// Whether both track in the frame of one device.
    [[nodiscard]] bool hasFrameOf(const MadeTracker& other) const;

private:
    struct Device {
        QByteArray content; ///< of its description; empty for a recording
        std::shared_ptr<Tracker> tracker;
        bool isTakenOver = false;
    };

    [[nodiscard]] const Device* alike(const QByteArray& content, bool isFirst) const;
    [[nodiscard]] bool has(const Tracker& tracker) const;

    std::vector<Device> m_devices;
    std::shared_ptr<Tracker> m_tracker;
};

} // namespace carina
