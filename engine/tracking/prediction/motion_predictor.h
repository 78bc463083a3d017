#pragma once

#include "engine/tracking/prediction/motion_filter.h"

#include <array>
#include <deque>

namespace carina
{

/// Predicts a tracked object O in F from its tracker's samples, whatever their noise is. How much
/// of a change is motion and how much is noise differs between trackers by more than a factor of
/// ten. So several MotionFilters run at once, which assume different jerk. Each of them forecasts
/// every pose kForecast ahead, and once that is measured, is given the square of what it was off
/// by. The one whose forecasts were the best in the last kMemory predicts, for position and
/// rotation each on its own, and the error to expect is scaled so that it is the one that was
/// found.
class MotionPredictor
{
public:
    static constexpr Duration kForecast = std::chrono::milliseconds{60};
    /// In which a forecast loses weight to 1/e. Errors of motion are so much larger than those of
    /// rest that a tool that lay still for a while is still predicted as one that moves.
    static constexpr Duration kMemory = std::chrono::seconds{10};
    /// Forecasts without which the filter of handsAndHeads() predicts, as it expects by itself.
    static constexpr int kForecastsNeeded = 30;

    /// Where the object is, and how it moves on from there (movedOn).
    struct Estimate {
        RigidTransform X_FO; ///< filtered
        Motion motion;
    };

    MotionPredictor();

    /// Adds the next sample. One that is lost, or not later than the last, is ignored.
    void add(const PoseSample& sample);

    /// At the newest sample; nothing before MotionFilter::kSamplesNeeded samples, and after a gap.
    [[nodiscard]] std::optional<Estimate> estimate() const;

private:
    static constexpr int kLeastPower = -6; ///< of two, times the jerk of handsAndHeads()
    static constexpr int kMostPower = 2;
    static constexpr std::size_t kFilters = kMostPower - kLeastPower + 1;

    /// What was found of one filter, for position or rotation: weighed sums of squares.
    struct Record {
        double found = 0.0;
        double expected = 0.0;
    };
    using Records = std::array<Record, kFilters>;
    struct Forecast {
        SessionTime due{};
        std::array<RigidTransform, kFilters> X_FO{};
        std::array<PoseDeviation, kFilters> expected{};
    };

    void compare(const Forecast& forecast, const RigidTransform& measured);
    void choose();
    void forecast();

    std::array<MotionFilter, kFilters> m_filters;
    std::optional<PoseSample> m_newest;
    int m_inARow = 0;                 ///< samples since the filters began
    std::deque<Forecast> m_forecasts; ///< not due yet
    int m_compared = 0;               ///< forecasts, at most kForecastsNeeded
    Records m_positions;
    Records m_rotations;
    std::size_t m_position = -kLeastPower; ///< the filter that predicts
    std::size_t m_rotation = -kLeastPower;
};

} // namespace carina
