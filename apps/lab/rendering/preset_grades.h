#pragma once

#include "apps/lab/rendering/scope_series.h"

#include <cstdint>

namespace carina::lab
{

/// How the presets that are named for a grade are measured.
struct GradeOrder {
    ScopeWay way{}; ///< but the eye, which is that of each preset
    int draws = 20; ///< of each preset
    std::uint32_t seed = 1;
};

/// The share of the draws of a preset that are to be of its grade.
inline constexpr double kRightGrades = 0.9;

/// Draws patients of each preset that is named for a grade of Cormack and Lehane (drawnFrom), looks
/// at each as it is promised for, with the blade lifted as usual, and counts the grades. The keys
/// of what is returned are in the help of `render`.
///
/// @param anatomy with the mouth shut
/// @returns what canShowAll, patientOf, Laryngoscopy::of and drawShots fail with
/// @pre as drawShots
[[nodiscard]] Result<QJsonObject> countGrades(Anatomy anatomy, const GradeOrder& order);

} // namespace carina::lab
