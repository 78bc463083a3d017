#pragma once

#include "engine/core/units.h"
#include "engine/geometry/vec.h"
#include "engine/sync/streams/stream_view.h"
#include "engine/tracking/pose_sample.h"

#include <array>
#include <deque>
#include <functional>
#include <optional>

namespace carina::lab
{

/// How far a tip was shown from where it was: what was shown at a session time, extrapolated from
/// older samples, is compared with where the owner's samples around that time have it once they
/// have arrived. When they were shown is a session time, so it does not matter how late a busy
/// program looks.
///
/// A tube that is somewhere else from one sample to the next was not moved there by a hand: its
/// owner has laid another patient, in whose frame it is. What was shown from the sample before
/// until the view has blended over is left out.
///
/// The drift is larger while a tube moves than while it is held, and a simulated trainee's moves in
/// a period: so what is seen in one time is compared with what is usual at the same phases.
class ShownPlaces
{
public:
    /// The hand of a simulated trainee is never as fast.
    static constexpr double kFastestHand = 0.2; ///< m/s
    /// The view blends again from each sample to the next, a part of what is left each time.
    static constexpr Duration kBlended = 5 * StreamView::kBlend;
    static constexpr Duration kShownInterval = std::chrono::milliseconds{20};
    static constexpr Duration kPeriod = std::chrono::seconds{20}; ///< of HandScript
    /// By then the samples around a time are there.
    static constexpr Duration kArrived = std::chrono::milliseconds{300};

    /// Where the owner's samples have the tip at a time; nothing where it was not tracked.
    using Truth = std::function<std::optional<Vec3>(SessionTime)>;

    /// The next sample of the owner has arrived.
    void heard(const PoseSample& sample, SessionTime now);
    /// The tip is shown here now. @param truth by the samples so far
    void shown(SessionTime now, const Vec3& p_A, const Truth& truth);

    /// Root mean square.
    [[nodiscard]] double drift_mm() const;
    /// The same of as many places at each phase of the motion as `other` has, where both have any.
    [[nodiscard]] double driftAtPhasesOf_mm(const ShownPlaces& other) const;
    [[nodiscard]] std::int64_t places() const;          ///< that were compared
    [[nodiscard]] int jumps() const { return m_jumps; } ///< to another patient

private:
    struct Shown {
        SessionTime time;
        Vec3 p_A;
    };

    std::optional<PoseSample> m_newest;
    std::deque<Shown> m_shown; // not compared yet
    SessionTime m_nextShown = SessionTime::min();
    SessionTime m_blended = SessionTime::min(); // after the last jump
    struct Phase {
        double squares_mm2 = 0.0;
        std::int64_t places = 0;
    };
    std::array<Phase, 40> m_phases{}; // equal parts of the period
    int m_jumps = 0;
};

} // namespace carina::lab
