#pragma once

#include "engine/core/session_time.h"

#include <optional>

namespace carina
{

/// Finds the beginnings of breaths in the height of a marker on a chest, sample by sample.
///
/// A breath has begun when the marker has risen by kShownShare of the motion of breaths above the
/// lowest point since the last one's top; and has ended its rise when it has come down by as much
/// from its highest. The motion is the smaller of the last two, so that one lean on the chest or
/// one jump of a registration does not hide what follows; and kLeastMotion is enough again after
/// kForgetting without a beginning. The beginning is told as the time at which the line through the
/// crossings of kFootShare and kShownShare leaves the lowest point: a chest rests long at that
/// point, and the time of the point itself would be anywhere in the rest. Motions below
/// kLeastMotion are noise, drift of the marker is followed.
class BreathDetector
{
public:
    /// @param height of the marker along the way the chest rises, metres, whatever its zero
    /// @returns when a breath began that this sample is the first to show.
    /// @pre height is finite. A time not later than the last is ignored.
    std::optional<SessionTime> add(SessionTime t, double height);

private:
    [[nodiscard]] double motion() const;
    std::optional<SessionTime> rise(SessionTime t, double height);
    void forgetAfterSilence(SessionTime t);

    std::optional<SessionTime> m_last;
    bool m_isRising = false;
    double m_lowest = 0.0;
    double m_highest = 0.0;
    double m_lastMotion = 0.0; ///< highest less lowest of the last whole breath
    double m_motion = 0.0;     ///< the smaller of that and the one before
    SessionTime m_begun{};     ///< when the last beginning was found
    SessionTime m_foot{};      ///< when the foot's height was passed on the way up
    bool m_isAboveFoot = false;
};

inline constexpr double kFootShare = 0.2;
inline constexpr double kShownShare = 0.5;
inline constexpr double kLeastMotion = 3e-3; ///< m; chests of manikins rise by 10 mm and more
inline constexpr Duration kForgetting = std::chrono::seconds{15};

} // namespace carina
