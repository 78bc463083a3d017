#pragma once

#include "engine/core/units.h"
#include "engine/tracking/pose_sample.h"

#include <optional>

namespace carina
{

/// How the plane of a laryngoscope was held.
struct PlaneFigures {
    Duration measured{};
    double squaredTilt = 0.0; ///< mean square of the tilt from the vertical, rad^2
    Angle tilt{};             ///< its mean; positive where the right side of the plane looks up
    double variance = 0.0;    ///< of the tilt about its mean, rad^2

    friend bool operator==(const PlaneFigures&, const PlaneFigures&) = default;
};

/// Measures the plane of handle and blade of a laryngoscope, sample by sample.
///
/// The plane is that of the y and z axes of L. Its tilt is the angle between the plane and the
/// vertical, asin(x_L . up): 0 where handle and blade are moved as they are meant to be, in an
/// upright plane, whatever the handle's own inclination in it. The mean square of that angle is
/// what Carlson et al (Simul Healthc 2012;7:255) call the variability of the plane: 8.3, 28.7 and
/// 54.5 square degrees of one experienced, one intermediate and one novice person. Samples are
/// weighted by the time since the one before; a time without samples of more than kLongestGap does
/// not count.
class PlaneMeter
{
public:
    static constexpr Duration kLongestGap = std::chrono::milliseconds{150}; ///< as PoseHistory's
    static constexpr Duration kLeastMeasured = std::chrono::seconds{1};     ///< of ours

    /// @param up_F the direction against gravity, of length 1
    explicit PlaneMeter(const Vec3& up_F) : m_up_F{up_F} {}

    /// Adds the next sample X_FL; one that is lost, or not later than the last, is ignored.
    void add(const PoseSample& sample);
    /// What comes next does not continue what came before.
    void pause() { m_last.reset(); }

    /// Nothing where less than kLeastMeasured was measured.
    [[nodiscard]] std::optional<PlaneFigures> figures() const;

private:
    Vec3 m_up_F;
    std::optional<SessionTime> m_last;
    Duration m_measured{};
    double m_tilt = 0.0;    ///< rad, times seconds
    double m_squared = 0.0; ///< rad^2, times seconds
};

} // namespace carina
