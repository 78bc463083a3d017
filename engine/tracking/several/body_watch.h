#pragma once

#include "engine/tracking/several/body_motion.h"
#include "engine/tracking/tracker.h"

#include <memory>

namespace carina
{

/// What one device saw of a body, in its own frame.
using BodySamples = std::vector<PoseSample>;

/// What two devices saw of one body.
struct WatchedBody {
    BodySamples first;
    BodySamples second;
};

/// A device that sees the body, and its name of the tool that is fixed to it.
struct BodyWatcher {
    std::unique_ptr<Tracker> tracker; ///< not started
    std::string name;                 ///< of the device, for errors: its address
    std::string tool;
};

/// Watches one body by two devices, each of which sees a tool on it.
class BodyWatch
{
public:
    /// Starts both, which stamp by one clock.
    /// @returns WrongOption for a tool that its device does not have; the errors of Tracker::start.
    [[nodiscard]] static Result<BodyWatch> begin(BodyWatcher first, BodyWatcher second);

    /// Takes what came since the last time; to be called at least twice a second.
    void look();

    /// What was seen so far.
    [[nodiscard]] const BodySamples& first() const { return m_first.samples; }
    [[nodiscard]] const BodySamples& second() const { return m_second.samples; }
    /// For how long both saw the body so far.
    [[nodiscard]] Duration together() const;

    /// A device as it sees the body now.
    struct Sight {
        bool isSeen = false;
        std::string trouble{}; ///< what keeps the device from tracking; empty where nothing does
    };
    [[nodiscard]] Sight firstSight() const { return sightOf(m_first); }
    [[nodiscard]] Sight secondSight() const { return sightOf(m_second); }

    /// Stops both. @returns TrackerFailed where a device has not seen its tool at all, with what
    /// keeps it from that.
    [[nodiscard]] Result<WatchedBody> end();

private:
    struct Watched {
        BodyWatcher watcher;
        const PoseHistory* history = nullptr;
        std::uint64_t cursor = 0;
        BodySamples samples{};
    };

    BodyWatch(Watched first, Watched second)
        : m_first{std::move(first)}, m_second{std::move(second)}
    {
    }
    [[nodiscard]] static Result<Watched> beginOne(BodyWatcher watcher);
    [[nodiscard]] static Result<BodySamples> endOne(Watched& watched);
    static void lookAt(Watched& watched);
    [[nodiscard]] Sight sightOf(const Watched& watched) const;

    Watched m_first;
    Watched m_second;
};

} // namespace carina
