#pragma once

#include "engine/core/units.h"
#include "engine/tracking/pose_sample.h"

#include <optional>
#include <span>
#include <vector>

namespace carina
{

/// A point at which a stylus was held still.
struct DwellPoint {
    Vec3 p_FQ = Vec3::Zero(); ///< mean of the tip's positions, metres, in the samples' frame F
    double spread = 0.0;      ///< largest distance of a position from the mean, metres
    int samples = 0;
    SessionTime from{};
    SessionTime until{};
};

/// Detects the points at which a stylus tip is held still: a point is the first interval of
/// duration `hold` in which all tracked positions lie within `radius` of their mean.
///
/// Each position represents one mean sampling interval: n positions from t_1 to t_n have the
/// duration (t_n - t_1) n / (n - 1). With t_n - t_1 alone a slower tracker would require a longer
/// hold.
///
/// After a point the tip has to move further than `leave` from it before the next point can be
/// taken, so that one touch gives one point. `leave` is larger than `radius`, because the computed
/// tip may move while the stylus is swung in a divot: by 2.4 mm in a recording with a tip
/// calibrated to 0.46 mm. Landmarks are centimetres apart.
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

    /// Takes the next position of the tip. A sample that is lost, not finite or not later than the
    /// last is ignored; after a gap longer than longestGap the hold restarts.
    /// @returns the point, with the sample that completes it.
    std::optional<DwellPoint> push(SessionTime time, const Vec3& p_FQ, Validity validity);

    /// Ignores the tip until it is further than `leave` from this point, because the point was
    /// taken in another way, or the tip was there before a point was requested.
    void leave(const Vec3& p_FQ);

    /// The completed share of the hold, 0 to 1, for display to the user; 0 after a point.
    [[nodiscard]] double progress() const;

    /// A tracked position of the tip, metres.
    struct Position {
        SessionTime time;
        Vec3 p_FQ;
    };

private:
    Settings m_settings;
    std::vector<Position> m_latest; ///< ascending in time, just enough for the hold
    std::optional<SessionTime> m_last;
    std::optional<Vec3> m_taken; ///< the last point, until the tip has left it
};

} // namespace carina
