#pragma once

#include "engine/core/session_time.h"

#include <optional>

namespace carina
{

/// Detects when breaths begin, from the height of a marker on the chest, sample by sample.
///
/// A breath is detected when the marker has risen by kShownShare of the amplitude above its lowest
/// point since the previous breath; its rise ends when the marker has fallen by as much below its
/// highest point. The amplitude is the smaller of those of the last two breaths, so that one push
/// on the chest or one jump of a registration does not hide the following breaths. After
/// kForgetting without a breath, a rise of kLeastMotion is enough again. Smaller motions are always
/// taken for noise; drift of the marker is followed.
///
/// The reported time is where the straight line through the crossings of kFootShare and kShownShare
/// of the amplitude meets the height of the lowest point. The time of the lowest point itself would
/// be arbitrary, as a chest rests there between breaths.
class BreathDetector
{
public:
    /// Takes the next sample; one whose time is not later than the last is ignored.
    /// @param height of the marker along the direction in which the chest rises, metres, from any
    ///               zero
    /// @returns the time at which a breath began, with the sample that detects it.
    /// @pre height is finite.
    std::optional<SessionTime> add(SessionTime t, double height);

private:
    [[nodiscard]] double motion() const;
    std::optional<SessionTime> rise(SessionTime t, double height);
    void forgetAfterSilence(SessionTime t);

    std::optional<SessionTime> m_last;
    bool m_isRising = false;
    double m_lowest = 0.0;
    double m_highest = 0.0;
    double m_lastMotion = 0.0; ///< highest minus lowest of the last complete breath
    double m_motion = 0.0;     ///< the smaller of that and the one before
    SessionTime m_begun{};     ///< time of the sample that detected the last breath
    SessionTime m_foot{};      ///< time of the crossing of kFootShare on the way up
    bool m_isAboveFoot = false;
};

/// Shares of the amplitude, see BreathDetector.
inline constexpr double kFootShare = 0.2;
inline constexpr double kShownShare = 0.5;
inline constexpr double kLeastMotion = 3e-3; ///< m; chests of manikins rise by 10 mm and more
inline constexpr Duration kForgetting = std::chrono::seconds{15};

} // namespace carina
