#include "widgets/scene/look/draw_order.h"

#include <algorithm>
#include <cstdint>

namespace carina
{

namespace
{

constexpr float kMostSteps = 1e5F; ///< however deep the scene is

float meanEdge(std::span<const Triangle> triangles, std::span<const Vec3f> positions)
{
    float sum = 0.0F;
    for (const Triangle& t : triangles)
        sum += (positions[t[1]] - positions[t[0]]).norm();
    return triangles.empty() ? 0.0F : sum / static_cast<float>(triangles.size());
}

/// Steps from the farthest centre, 0, to each.
std::vector<std::uint32_t> stepsFromFarthest(std::span<const Vec3f> centres, const Vec3f& forward,
                                             float step)
{
    std::vector<float> depths(centres.size());
    for (std::size_t i = 0; i < centres.size(); ++i)
        depths[i] = forward.dot(centres[i]);
    const auto [least, most] = std::minmax_element(depths.begin(), depths.end());
    const float farthest = *most;
    const float perMetre = std::min(1.0F / step, kMostSteps / std::max(farthest - *least, 1e-6F));
    std::vector<std::uint32_t> steps(centres.size());
    for (std::size_t i = 0; i < depths.size(); ++i)
        steps[i] = static_cast<std::uint32_t>((farthest - depths[i]) * perMetre);
    return steps;
}

} // namespace

DrawOrder::DrawOrder(std::vector<Triangle> triangles, std::span<const Vec3f> positions)
    : m_triangles(std::move(triangles)),
      m_step(std::clamp(meanEdge(m_triangles, positions), kLeastStep, kMostStep))
{
    m_centres.reserve(m_triangles.size());
    for (const Triangle& t : m_triangles)
        m_centres.emplace_back((positions[t[0]] + positions[t[1]] + positions[t[2]]) / 3.0F);
}

std::vector<Triangle> DrawOrder::backToFront(const Vec3f& forward) const
{
    if (m_triangles.empty())
        return {};
    const std::vector<std::uint32_t> steps = stepsFromFarthest(m_centres, forward, m_step);
    const std::uint32_t nearest = *std::max_element(steps.begin(), steps.end());
    std::vector<std::uint32_t> place(nearest + 2, 0); // where the next of each step goes
    for (const std::uint32_t step : steps)
        ++place[step + 1];
    for (std::size_t step = 1; step < place.size(); ++step)
        place[step] += place[step - 1];
    std::vector<Triangle> ordered(m_triangles.size());
    for (std::size_t i = 0; i < steps.size(); ++i)
        ordered[place[steps[i]]++] = m_triangles[i];
    return ordered;
}

} // namespace carina
