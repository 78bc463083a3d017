#include "widgets/scene/level_choice.h"

#include "engine/core/expects.h"

#include <utility>

namespace carina
{

LevelChoice::LevelChoice(std::vector<std::size_t> triangles, Duration budgetPerFrame)
    : m_triangles(std::move(triangles)), m_budget(budgetPerFrame)
{
    CARINA_EXPECTS(budgetPerFrame > Duration::zero());
    const int coarsest = static_cast<int>(m_triangles.size()) - 1;
    while (m_level < coarsest && m_triangles[static_cast<std::size_t>(m_level)] > kFirstTriangles)
        ++m_level;
}

void LevelChoice::frameTook(Duration drawing)
{
    m_sum += drawing;
    if (++m_frames < kFramesPerDecision)
        return;
    decide(m_sum / m_frames);
    m_frames = 0;
    m_sum = Duration::zero();
}

void LevelChoice::decide(Duration mean)
{
    const int coarsest = static_cast<int>(m_triangles.size()) - 1;
    if (mean > m_budget) {
        m_level = m_level < coarsest ? m_level + 1 : m_level;
        return;
    }
    if (m_level == 0)
        return;
    const auto level = static_cast<std::size_t>(m_level);
    const double growth =
        static_cast<double>(m_triangles[level - 1]) / static_cast<double>(m_triangles[level]);
    if (growth * toSeconds(mean) < kComfort * toSeconds(m_budget))
        --m_level;
}

} // namespace carina
