#pragma once

#include "engine/core/session_time.h"

#include <cstddef>
#include <vector>

namespace carina
{

/// Chooses the level of detail that this machine can draw: the finest that is expected to stay
/// within the budget per frame.
///
/// The time per triangle is measured on the frames drawn. A level is left for a coarser one when
/// the mean of kFramesPerDecision frames is over budget, and for a finer one when that is expected
/// to take less than kComfort of the budget; so it does not swing between two.
class LevelChoice
{
public:
    static constexpr int kFramesPerDecision = 20;
    static constexpr double kComfort = 0.6;
    static constexpr std::size_t kFirstTriangles =
        150'000; ///< at most, before anything is measured

    /// @param triangles drawn in each level, finest first; empty means one level.
    LevelChoice(std::vector<std::size_t> triangles, Duration budgetPerFrame);

    [[nodiscard]] int level() const { return m_level; }

    /// One frame was drawn at level() and took this long.
    void frameTook(Duration drawing);

private:
    void decide(Duration mean);

    std::vector<std::size_t> m_triangles;
    Duration m_budget;
    int m_level = 0;
    int m_frames = 0;
    Duration m_sum{};
};

} // namespace carina
