#pragma once

#include "engine/core/units.h"
#include "engine/scoring/motion/local_motion.h"
#include "engine/tracking/pose_sample.h"

#include <deque>
#include <optional>

namespace carina
{

/// How something moved.
struct MotionFigures {
    Duration watched{};            ///< from the first sample to the last, without pauses
    Duration measured{};           ///< of that, the time over which the means are taken
    Length path{};                 ///< of the origin
    Length verticalTravel{};       ///< up and down together
    double meanAcceleration = 0.0; ///< of its magnitude, m/s^2
    double meanJerk = 0.0;         ///< of its magnitude, m/s^3
    SessionTime jerkiest{};        ///< when the jerk was the largest
    /// Minus the logarithm of the dimensionless jerk, -ln(T^3 / v^2 * integral of jerk^2 over T)
    /// with the highest speed v (Balasubramanian et al, J NeuroEng Rehabil 2015;12:112): the
    /// larger, the smoother. -5.3 of one movement of minimum jerk. Nothing where nothing moved.
    std::optional<double> smoothness{};

    friend bool operator==(const MotionFigures&, const MotionFigures&) = default;
};

/// Measures how the origin of a tool or head O moves in F, sample by sample. It keeps the samples
/// of the last kWindow, and one before them.
///
/// Position and derivatives are those of the cubic of least squares (motionAtZero) over kWindow,
/// in its middle. White noise of 0.35 mm at 60 Hz becomes 0.1 mm of position, 0.011 m/s^2 and
/// 0.31 m/s^3 on each axis; of a sine of 1 Hz 88 % of the acceleration and 91 % of the jerk are
/// left, of 2 Hz 60 and 68 %. So figures are comparable with each other, and with those of another
/// smoothing only roughly.
///
/// The path is that of the smoothed position, from one place to the next that is kPathStep away:
/// noise at rest adds nothing. After a gap longer than kLongestGap the derivatives begin anew, and
/// the straight line across it counts as path, the least that it can have been. Half of kWindow at
/// either end of what is seen without a gap is not measured.
class MotionMeter
{
public:
    static constexpr Duration kWindow = std::chrono::milliseconds{400};     ///< of ours
    static constexpr Duration kLongestGap = std::chrono::milliseconds{150}; ///< as PoseHistory's
    static constexpr Duration kLeastStep = std::chrono::milliseconds{2};    ///< of ours
    static constexpr Length kPathStep = millimetres(1.0);                   ///< of ours
    static constexpr std::size_t kLeastPoints = 7;                      ///< in a window; of ours
    static constexpr Duration kLeastMeasured = std::chrono::seconds{1}; ///< of ours
    static constexpr double kLeastShare = 0.5;                          ///< of ours

    /// @param up_F the direction against gravity, of length 1
    explicit MotionMeter(const Vec3& up_F) : m_up_F{up_F} {}

    /// Adds the next sample. One that is lost adds only time; one less than kLeastStep after the
    /// last is ignored.
    void add(const PoseSample& sample);
    /// What comes next does not continue what came before, as after the tool was laid down.
    void pause();

    /// Nothing where less than kLeastMeasured or kLeastShare of the time watched was measured.
    [[nodiscard]] std::optional<MotionFigures> figures() const;

private:
    struct Place {
        SessionTime time;
        Vec3 p_F;
    };

    void measure(SessionTime middle);
    void follow(const LocalMotion& motion);

    Vec3 m_up_F;
    std::deque<Place> m_window;            ///< without a gap; without the first, below kWindow
    std::optional<SessionTime> m_last;     ///< sample, seen or lost
    std::optional<SessionTime> m_measured; ///< the last middle, unless after a gap
    std::optional<Vec3> m_p_F;             ///< where the path has come to
    MotionFigures m_sum{};                 ///< accelerations and jerks times seconds
    double m_highestSpeed = 0.0;           ///< m/s
    double m_highestJerk = 0.0;            ///< m/s^3
    double m_squaredJerk = 0.0;            ///< times seconds
};

} // namespace carina
