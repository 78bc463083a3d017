#include "widgets/scene/surfaces/detail_choice.h"

#include "engine/core/expects.h"
#include "engine/geometry/mesh/triangle_mesh.h"

#include <algorithm>

namespace carina
{

namespace
{

constexpr double kLeastDistance = 0.01; ///< metres; nothing is looked at from nearer

/// Of the levels in order, those whose deviation is known to be less than something: how many.
int coarsestWithin(std::span<const double> deviations, double most)
{
    int level = 0;
    for (std::size_t next = 1; next < deviations.size() && deviations[next] <= most; ++next)
        level = static_cast<int>(next);
    return level;
}

} // namespace

DetailChoice::DetailChoice(std::span<const ScenePart> parts, Duration budgetPerFrame)
    : m_budget(budgetPerFrame)
{
    CARINA_EXPECTS(budgetPerFrame > Duration::zero());
    setParts(parts);
}

void DetailChoice::setParts(std::span<const ScenePart> parts)
{
    m_parts.clear();
    m_pixelsPerMetre.assign(parts.size(), 0.0);
    m_levels.assign(parts.size(), 0);
    for (const ScenePart& part : parts) {
        CARINA_EXPECTS(!part.levels.empty());
        const Box bounds = boundsOf(*part.levels.back());
        Part known;
        known.centre = bounds.centre();
        known.radius = 0.5 * bounds.size().norm();
        known.sharesLevel = part.sharesLevel;
        known.deviations = part.deviations;
        known.deviations.resize(std::min(known.deviations.size(), part.levels.size()));
        for (const auto& level : part.levels)
            known.triangles.push_back(level->triangles.size());
        m_parts.push_back(std::move(known));
    }
    takeFixedLevel();
}

void DetailChoice::fix(std::optional<int> level)
{
    m_fixed = level;
    takeFixedLevel();
}

void DetailChoice::takeFixedLevel()
{
    if (!m_fixed)
        return;
    for (std::size_t i = 0; i < m_parts.size(); ++i)
        m_levels[i] = std::clamp(*m_fixed, 0, static_cast<int>(m_parts[i].triangles.size()) - 1);
}

const std::vector<int>& DetailChoice::choose(std::span<const DetailEye> eyes, bool isResting)
{
    if (m_fixed || eyes.empty())
        return m_levels;
    measureErrors(eyes);
    if (m_isFirst && !m_parts.empty()) {
        m_isFirst = false;
        while (m_tolerance_px < kCoarsestTolerance_px
               && trianglesOf(levelsWithin(m_tolerance_px)) > kFirstTriangles)
            m_tolerance_px *= kStep;
    }
    m_levels = levelsWithin(isResting ? kFinestTolerance_px : m_tolerance_px);
    return m_levels;
}

void DetailChoice::measureErrors(std::span<const DetailEye> eyes)
{
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
        m_pixelsPerMetre[i] = 0.0;
        for (const DetailEye& eye : eyes) {
            const double distance = std::max(
                (m_parts[i].centre - eye.p_A_eye).norm() - m_parts[i].radius, kLeastDistance);
            m_pixelsPerMetre[i] = std::max(m_pixelsPerMetre[i], eye.pixelsPerTangent / distance);
        }
    }
}

/// As coarse as the tolerance permits, but only well within it coarser than now.
int DetailChoice::levelOf(std::size_t part, double tolerance_px) const
{
    const std::vector<double>& deviations = m_parts[part].deviations;
    if (m_pixelsPerMetre[part] <= 0.0)
        return m_levels[part];
    const double most = tolerance_px / m_pixelsPerMetre[part];
    const int within = coarsestWithin(deviations, most);
    const int calmly = coarsestWithin(deviations, kCalm * most);
    return std::min(within, std::max(calmly, m_levels[part]));
}

std::vector<int> DetailChoice::levelsWithin(double tolerance_px) const
{
    std::vector<int> levels(m_parts.size(), 0);
    std::optional<int> shared;
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
        levels[i] = levelOf(i, tolerance_px);
        if (m_parts[i].sharesLevel)
            shared = std::min(shared.value_or(levels[i]), levels[i]);
    }
    for (std::size_t i = 0; i < m_parts.size(); ++i)
        if (m_parts[i].sharesLevel)
            levels[i] = *shared;
    return levels;
}

std::size_t DetailChoice::trianglesOf(const std::vector<int>& levels) const
{
    std::size_t sum = 0;
    for (std::size_t i = 0; i < m_parts.size(); ++i)
        sum += m_parts[i].triangles[static_cast<std::size_t>(levels[i])];
    return sum;
}

int DetailChoice::sharedLevel() const
{
    std::optional<int> finest;
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
        if (m_parts[i].sharesLevel)
            return m_levels[i];
        finest = std::min(finest.value_or(m_levels[i]), m_levels[i]);
    }
    return finest.value_or(0);
}

void DetailChoice::frameTook(Duration drawing)
{
    m_sum += drawing;
    if (++m_frames < kFramesPerDecision && m_sum < kFramesPerDecision * m_budget)
        return;
    decide(m_sum / m_frames);
    m_frames = 0;
    m_sum = Duration::zero();
}

void DetailChoice::decide(Duration mean)
{
    if (m_fixed || m_isFirst)
        return;
    const double share = toSeconds(mean) / toSeconds(m_budget);
    if (share > 1.0) {
        m_tolerance_px =
            std::min(m_tolerance_px * std::clamp(share, kStep, kLongStep), kCoarsestTolerance_px);
        return;
    }
    const double finer = std::max(m_tolerance_px / kStep, kFinestTolerance_px);
    const auto now = static_cast<double>(std::max<std::size_t>(triangles(), 1));
    const double growth = static_cast<double>(trianglesOf(levelsWithin(finer))) / now;
    if (growth * share < kComfort)
        m_tolerance_px = finer;
}

} // namespace carina
