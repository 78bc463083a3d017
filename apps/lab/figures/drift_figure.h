#pragma once

#include "apps/lab/figures/drift_source.h"
#include "evaluation/drift/polynomial_fit.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace carina::lab
{

/// What the figures of the drift experiment are measured with.
struct FigureSettings {
    DriftScenario scenario;
    std::uint32_t seed = 1;
    int actions = 50; ///< of a run
    DriftSource source = virtualDrift(20);
    /// 2 acos(w) in that of `none` by action, where each program turns its own quaternion: with the
    /// other strategies the actor's comes with its messages.
    bool isAngleRaw = false;
    /// Called before each curve that is measured, with what it is of.
    std::function<void(const std::string& curve)> onCurve = [](const std::string&) {};
};

/// One line of a figure.
struct DriftCurve {
    std::string name{};
    std::vector<double> x{};
    std::vector<double> y{};
    Polynomial trend{}; ///< least squares; without coefficients where none is drawn
};

/// One figure: what was measured, in the units of its axes.
struct DriftFigure {
    std::string name{}; ///< of its files
    std::string title{};
    std::string network{}; ///< what it was measured over
    std::string xLabel{};
    std::string yLabel{};
    std::string xColumn{}; ///< of a table
    std::string yColumn{};
    bool isLogarithmic = false; ///< both axes
    bool hasLimit = false;      ///< the last curve is the limit of DriftFigures
    bool isAngleRaw = false;    ///< 2 acos(w), see FigureSettings
    std::vector<DriftCurve> curves{};
};

/// How many curves the three functions below measure together.
[[nodiscard]] std::size_t curvesToMeasure(const DriftSource& source);

inline constexpr int kTrendOfNone = 3;       ///< order, as in the 2004 paper
inline constexpr int kTrendOfStrategies = 6; ///< which says "higher"

/// Drift just before the next action against the number of the action, two participants, 100 deg/s
/// and 100 mm/s: for each strategy of the source one figure of orientation
/// and one of position. @pre more actions than kTrendOfStrategies
[[nodiscard]] Result<std::vector<DriftFigure>> figuresByAction(const FigureSettings& settings);

/// Mean of that drift against 2 to 6 participants with a line for each speed of the source: for
/// each of its strategies, orientation and position.
[[nodiscard]] Result<std::vector<DriftFigure>>
figuresByParticipants(const FigureSettings& settings);

/// Time average of the drift against the mean one-way delay for the source's strategies with
/// the limit of DriftFigures, two participants, 100 deg/s and 100 mm/s: orientation and position.
/// Not over the settings' scenario but over paths without loss that have 20/21 of the delay always
/// and 1/21 as the mean of an exponential queue, like the WAN.
[[nodiscard]] Result<std::vector<DriftFigure>> figuresByDelay(const FigureSettings& settings);

} // namespace carina::lab
