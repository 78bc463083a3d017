#pragma once

#include "engine/registration/calibration/pivot_calibration.h"
#include "engine/tracking/pose_sample.h"

#include <optional>
#include <vector>

namespace carina
{

/// The stage of a collection.
enum class PivotStage : std::uint8_t {
    Waiting,  ///< until the tool is swung with its tip at rest
    Swinging, ///< poses are collected
    Done,
};

/// What is still missing: the first of these that applies.
enum class PivotNeed : std::uint8_t {
    Swing,      ///< the tool is not swung about a point
    Motion,     ///< it did not move enough
    Directions, ///< it did not move in enough directions: it was turned about one axis
    Stillness,  ///< the tip does not stay in one place
    Poses,      ///< more of the same: the tip's uncertainty is still too large
    Nothing,
};

/// The progress of a collection, to be shown to the user.
struct PivotProgress {
    PivotStage stage = PivotStage::Waiting;
    PivotNeed need = PivotNeed::Swing;
    double share = 0.0;                  ///< completed share, 0 to 1
    int poses = 0;                       ///< number of poses used
    TurnCoverage coverage{};             ///< of these poses; tells which directions are missing
    std::optional<double> uncertainty{}; ///< RMS error of the tip, metres; nothing without a fit
};

/// Collects the poses of a stylus for calibratePivot without a button: starts when the stylus is
/// swung about a point, and ends when every direction turned enough and the tip's uncertainty is
/// small enough.
///
/// The stylus counts as swung when, in the latest `window`, a direction of it turned by `start`
/// while one point within `reach` of the markers stood still. A pose is used when the stylus has
/// rotated by at least one degree since the last used pose, so that neither pauses nor a fast
/// tracker add weight. The collection restarts when the tip is away from its place for more than
/// half of a window, or when too many poses disagree (PivotCalibration::refusal).
class PivotCollector
{
public:
    struct Settings {
        PivotSettings calibration{};
        Length certainty = millimetres(0.15);        ///< RMS error of the tip at which it ends
        Duration shortest = std::chrono::seconds{4}; ///< of a collection
        Duration window = std::chrono::seconds{1};
        Angle start = degrees(4.0);        ///< RMS turn
        Length reach = millimetres(400.0); ///< largest distance from the markers to the tip
    };

    PivotCollector() = default;
    explicit PivotCollector(const Settings& settings) : m_settings{settings} {}

    /// Takes the next pose of the stylus. A pose that is lost, not finite, a kilometre away or not
    /// later than the last is ignored, and so is every pose when the collection is done.
    /// @returns the calibration, with the pose that completes it.
    std::optional<PivotCalibration> push(SessionTime time, const RigidTransform& X_TS,
                                         Validity validity);

    [[nodiscard]] const PivotProgress& progress() const { return m_progress; }

    /// Discards all poses and waits for a swing.
    void restart();

private:
    void keepLatest(SessionTime time, const RigidTransform& X_TS);
    [[nodiscard]] bool isSwung() const;
    [[nodiscard]] bool hasLeft(const PivotCalibration& pivot) const;
    void begin(SessionTime time);
    std::optional<PivotCalibration> evaluate(SessionTime time);

    struct Timed {
        SessionTime time;
        RigidTransform X_TS;
    };

    Settings m_settings;
    PivotProgress m_progress;
    std::vector<Timed> m_latest;           ///< of the latest window, ascending in time
    std::vector<RigidTransform> m_counted; ///< the poses used, for calibratePivot
    std::optional<SessionTime> m_last;
    SessionTime m_since{};     ///< start of the swing
    SessionTime m_evaluated{}; ///< time of the latest fit
};

} // namespace carina
