#pragma once

#include "engine/core/units.h"
#include "engine/tracking/pose_sample.h"

#include <optional>
#include <span>
#include <vector>

namespace carina
{

/// A point that a stylus was held at.
struct DwellPoint {
    Vec3 p_FQ = Vec3::Zero(); ///< mean of the tip's positions, metres, in the samples' frame F
    double spread = 0.0;      ///< largest distance of a position from the mean, metres
    int samples = 0;
    SessionTime from{};
    SessionTime until{};
};

/// Turns the stream of a stylus tip into the points it was held at: a point is the first stretch
/// of `hold` in which all tracked positions lie within `radius` of their mean.
///
/// Every position stands for one mean interval of its stretch: n of them from t_1 to t_n cover
/// (t_n - t_1) n / (n - 1). Counted from first to last alone, the same second would be longer the
/// slower the tracker.
///
/// After a point the tip has to go further than `leave` from it before the next can be taken, so
/// that one touch is one point. The tip may sway about the point by more than the radius while the
/// stylus is swung in its divot: 2.4 mm in a recording with a tip calibrated to 0.46 mm. Landmarks
/// are centimetres apart.
class DwellDetector
{
public:
    struct Settings {
        Duration hold = std::chrono::seconds{1};
        Length radius = millimetres(1.0);
        Length leave = millimetres(5.0);
        Duration longestGap = std::chrono::milliseconds{200}; ///< without a tracked sample
    };

    DwellDetector() = default;
    explicit DwellDetector(const Settings& settings) : m_settings{settings} {}

    /// Takes the next position of the tip. A sample that is lost, not finite or not newer than the
    /// last is left out; after a gap longer than longestGap the hold begins anew.
    /// @returns the point, with the sample that completes it.
    std::optional<DwellPoint> push(SessionTime time, const Vec3& p_FQ, Validity validity);

    /// The next point is taken only after the tip has gone further than `leave` from here: it was
    /// taken otherwise, or the tip lay there before anybody asked for a point.
    void leave(const Vec3& p_FQ);

    /// How much of the hold the latest positions within the radius cover, 0 to 1, for a person to
    /// see; 0 once they have given a point.
    [[nodiscard]] double progress() const;

    struct Position {
        SessionTime time;
        Vec3 p_FQ;
    };

private:
    Settings m_settings;
    std::vector<Position> m_latest; ///< ascending in time, no more than cover the hold
    std::optional<SessionTime> m_last;
    std::optional<Vec3> m_taken; ///< the point just taken, until the tip has left it
};

} // namespace carina
