#pragma once

#include "engine/scoring/score/metric.h"

#include <array>
#include <optional>

namespace carina
{

/// What others measured, mean and standard deviation.
struct GroupFigure {
    double mean = 0.0;                 ///< in the metric's unit
    std::optional<double> deviation{}; ///< nothing where it is not told
};

/// Figures of the literature that are shown beside those of a try. They are of other manikins,
/// patients and devices: for comparison, not limits.
struct LiteratureFigure {
    Metric metric;
    GroupFigure expert;
    GroupFigure novice;
    const char* source;
};

/// The times of the sources do not begin and end exactly as the metrics do beside which they stand:
/// Carlson's is of a laryngoscopy, that of St. Marianna Med J of a whole intubation, Declercq's of
/// the intubation alone. Carlson's groups are one person each.
inline constexpr std::array kLiteratureFigures{
    LiteratureFigure{
        Metric::BladeTime, {5.50, 0.68}, {12.38, 1.06}, "Carlson et al, Simul Healthc 2012;7:255"},
    LiteratureFigure{Metric::PlaneTilt,
                     {8.3, std::nullopt},
                     {54.5, std::nullopt},
                     "Carlson et al, Simul Healthc 2012;7:255"},
    LiteratureFigure{Metric::TimeToBreath, {21.6, 7.6}, {30.4, 8.3}, "St. Marianna Med J 10(2):51"},
    LiteratureFigure{Metric::HeadTravel, {13.1, 7.7}, {39.2, 8.1}, "St. Marianna Med J 10(2):51"},
    LiteratureFigure{Metric::TimeToCords,
                     {11.0, std::nullopt},
                     {21.0, std::nullopt},
                     "Declercq et al, Ann Intensive Care 2016;6:83"},
};

/// The figures of a metric; nullptr where there are none.
[[nodiscard]] constexpr const LiteratureFigure* literatureOf(Metric metric)
{
    for (const LiteratureFigure& figure : kLiteratureFigures)
        if (figure.metric == metric)
            return &figure;
    return nullptr;
}

} // namespace carina
