#pragma once

#include "engine/scoring/course/depth_rule.h"
#include "engine/scoring/score/advice.h"
#include "engine/scoring/score/rubric.h"

namespace carina
{

/// What is told of one try at intubating.
struct TryReport {
    TryMetrics metrics{};
    DepthRule rule = DepthRule::TenthOfHeight;
    Rubric rubric{};
    Score score{};
    std::vector<Advice> advice{};

    friend bool operator==(const TryReport&, const TryReport&) = default;
};

/// A try judged by a rubric, with what is advised.
/// @param rule by which the depth is judged
[[nodiscard]] inline TryReport reportOf(const TryMetrics& metrics, DepthRule rule,
                                        const Rubric& rubric)
{
    return {metrics, rule, rubric, scoreOf(metrics, rubric), adviceFor(metrics)};
}

} // namespace carina
