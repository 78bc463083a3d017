#pragma once

#include "engine/geometry/rotation.h"
#include "engine/tracking/simulated/simulated_tracker.h"
#include "models/tracker/device_calibration.h"

#include <cmath>
#include <memory>
#include <vector>

namespace carina::test
{

/// Two simulated trackers that see one body, which a hand turns to and fro. They run only as far as
/// a test steps them; how they truly stand to each other is written here.
class TwoTrackers
{
public:
    static inline const Quat kR_TD = rotationFromVector({0.2, 1.1, -0.3});
    /// The body is about 1.2 m before both.
    static inline const RigidTransform kX_TD{kR_TD,
                                             Vec3{0.0, 0.0, -1.2} - kR_TD* Vec3{0.02, 0.04, -1.1}};
    static inline const RigidTransform kX_OP{rotationFromVector({1.3, 0.2, -0.5}),
                                             Vec3{0.03, -0.02, 0.05}};
    static constexpr Duration kLate = std::chrono::milliseconds{37};

    /// How the body is turned about each axis of T and moved along it: amplitudes, rad and m.
    Vec3 swing{0.5, 0.4, 0.45};
    Vec3 path{0.09, 0.07, 0.05};
    /// How far the probe of the second device slips on the body, m.
    double slip = 0.0;
    bool isHiddenFromSecond = false;

    /// The first device has "jaw" on the body; the second has "tube" on it, and "head", which
    /// another hand turns, and "stylus", which lies still.
    [[nodiscard]] static DevicesToCalibrate devices()
    {
        DevicesToCalibrate both;
        both.first.address = "first:1";
        both.first.tools = {{"jaw", ToolRole::Jaw}};
        both.second.address = "second:1";
        both.second.tools = {
            {"tube", ToolRole::Tube}, {"head", ToolRole::Head}, {"stylus", ToolRole::Stylus}};
        return both;
    }

    [[nodiscard]] MakeDevice make()
    {
        return [this](const TrackerDescription& described) -> Result<std::unique_ptr<Tracker>> {
            return std::make_unique<Stepped>(added(described.address == "first:1"));
        };
    }

    /// How many trackers are there.
    [[nodiscard]] std::size_t inUse() const
    {
        std::size_t count = 0;
        for (const Made& each : m_made)
            count += each.tracker.expired() ? 0U : 1U;
        return count;
    }

    /// Both see the hand for so long; what they saw is taken on the way.
    void run(DeviceCalibration& calibration, double seconds)
    {
        constexpr int kBetweenLooks = 15;
        const int steps = int(std::lround(60.0 * seconds));
        for (int i = 1; i <= steps; ++i) {
            m_now += fromSeconds(1.0 / 60.0);
            for (const Made& each : m_made)
                if (const auto tracker = each.tracker.lock())
                    tracker->advance(m_now + (each.isFirst ? Duration{} : kLate));
            if (i % kBetweenLooks == 0)
                calibration.look();
        }
    }

private:
    /// A simulated tracker that a test steps.
    class Stepped : public Tracker
    {
    public:
        explicit Stepped(std::shared_ptr<SimulatedTracker> tracker) : m_tracker{std::move(tracker)}
        {
        }
        [[nodiscard]] Result<void> start() override { return {}; }
        void stop() override {}
        [[nodiscard]] std::vector<TrackedTool> tools() const override { return m_tracker->tools(); }

    private:
        std::shared_ptr<SimulatedTracker> m_tracker; ///< shared with who steps it
    };

    struct Made {
        std::weak_ptr<SimulatedTracker> tracker;
        bool isFirst = false;
    };

    [[nodiscard]] std::shared_ptr<SimulatedTracker> added(bool isFirst)
    {
        SimulatedTrackerSettings settings;
        settings.seed = isFirst ? 1 : 2;
        settings.rate = hertz(isFirst ? 60.0 : 30.0);
        auto tracker = std::make_shared<SimulatedTracker>(
            settings,
            [this, isFirst](ToolRole role, SessionTime stamp) {
                return isFirst ? seenByFirst(role, stamp) : seenBySecond(role, stamp - kLate);
            },
            [] { return std::optional<SessionTime>{}; });
        m_made.push_back({tracker, isFirst});
        return tracker;
    }

    /// X_TO, in even and in uneven time of the hand.
    [[nodiscard]] RigidTransform bodyAt(double t) const
    {
        return {
            rotationFromVector({swing.x() * std::sin(3.1 * t), swing.y() * std::sin(4.7 * t + 1.0),
                                swing.z() * std::sin(2.3 * t + 0.4)}),
            Vec3{path.x() * std::sin(0.9 * t), path.y() * std::cos(1.4 * t),
                 -1.2 + path.z() * std::sin(t)}};
    }
    [[nodiscard]] std::optional<RigidTransform> seenByFirst(ToolRole role, SessionTime t) const
    {
        return role == ToolRole::Jaw ? std::optional{bodyAt(toSeconds(t.time_since_epoch()))}
                                     : std::nullopt;
    }
    [[nodiscard]] std::optional<RigidTransform> seenBySecond(ToolRole role, SessionTime time) const
    {
        const double t = toSeconds(time.time_since_epoch());
        const RigidTransform X_DT = kX_TD.inverse();
        if (role == ToolRole::Tube && !isHiddenFromSecond)
            return X_DT * bodyAt(t)
                   * RigidTransform::translation({slip * std::sin(5.0 * t), 0.0, 0.0}) * kX_OP;
        if (role == ToolRole::Head)
            return RigidTransform{
                rotationFromVector({0.5 * std::sin(2.0 * t + 0.3), 0.4 * std::sin(3.7 * t), 0.0}),
                Vec3{0.0, 0.0, -1.0}};
        return role == ToolRole::Stylus
                   ? std::optional{RigidTransform::translation({0.1, 0.0, -1.1})}
                   : std::nullopt;
    }

    std::vector<Made> m_made;
    SessionTime m_now{std::chrono::seconds{100}};
};

/// How far the frame of the second device is off, where the body was.
inline double millimetresOff(const RigidTransform& X_TD)
{
    const Vec3 p_D = TwoTrackers::kX_TD.inverse() * Vec3{0.0, 0.0, -1.2};
    return 1e3 * (X_TD * p_D - TwoTrackers::kX_TD * p_D).norm();
}

inline double degreesOff(const RigidTransform& X_TD)
{
    return inDegrees(angleBetween(X_TD.rotation(), TwoTrackers::kX_TD.rotation()));
}

} // namespace carina::test
