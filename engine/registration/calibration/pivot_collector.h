#pragma once

#include "engine/registration/calibration/pivot_calibration.h"
#include "engine/tracking/pose_sample.h"

#include <optional>
#include <vector>

namespace carina
{

enum class PivotStage : std::uint8_t {
    Waiting,  ///< for the tool to be swung with its tip at rest
    Swinging, ///< poses are collected
    Done,
};

/// What is still missing, the first of these that is.
enum class PivotNeed : std::uint8_t {
    Swing,      ///< the tool is not swung about a point
    Motion,     ///< it did not move enough
    Directions, ///< it did not move in enough directions: it was turned about one axis
    Stillness,  ///< the tip does not stay in one place
    Poses,      ///< nothing but more of the same: the tip is not certain enough yet
    Nothing,
};

/// How far a collection has come, for a person to see.
struct PivotProgress {
    PivotStage stage = PivotStage::Waiting;
    PivotNeed need = PivotNeed::Swing;
    double share = 0.0;                  ///< of the way to the end, 0 to 1
    int poses = 0;                       ///< that count
    TurnCoverage coverage{};             ///< of these; from it what directions are missing
    std::optional<double> uncertainty{}; ///< RMS of the tip, metres, where there is one already
};

/// Collects the poses of a stylus for calibratePivot without a button: begins when the stylus is
/// swung about a point, and ends when every direction turned enough and the tip is certain enough.
///
/// A stylus is swung when in the latest window some direction of it turned by `start` and yet one
/// point of it, within reach of its markers, stood still. A pose counts when the stylus has turned
/// by a degree since the last that did: a stylus at rest tells nothing, nor does a fast tracker. A
/// tip that then leaves its place for half of a window makes the collection begin anew.
class PivotCollector
{
public:
    struct Settings {
        PivotSettings calibration{};
        Length certainty = millimetres(0.15); ///< RMS of the tip at which it ends
        Duration shortest = std::chrono::seconds{4};
        Duration window = std::chrono::seconds{1};
        Angle start = degrees(4.0);
        Length reach = millimetres(400.0); ///< from the markers to the tip, at most
    };

    PivotCollector() = default;
    explicit PivotCollector(const Settings& settings) : m_settings{settings} {}

    /// Takes the next pose of the stylus. One that is lost, not finite, a kilometre away or not
    /// newer than the last is left out, as are all once it is done.
    /// @returns the calibration, with the pose that completes it.
    std::optional<PivotCalibration> push(SessionTime time, const RigidTransform& X_TS,
                                         Validity validity);

    [[nodiscard]] const PivotProgress& progress() const { return m_progress; }

    /// Begins anew.
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
    std::vector<Timed> m_latest;           ///< of one window, ascending in time
    std::vector<RigidTransform> m_counted; ///< turned against each other
    std::optional<SessionTime> m_last;
    SessionTime m_since{};     ///< began swinging
    SessionTime m_evaluated{}; ///< last time
};

} // namespace carina
