#include "widgets/scene/draw_order.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace carina
{

namespace
{

constexpr std::uint32_t kNearestStep = std::numeric_limits<std::uint16_t>::max();

/// How far along it each centre lies, in steps from the farthest, 0, to kNearestStep.
std::vector<std::uint16_t> stepsFromFarthest(std::span<const Vec3f> centres, const Vec3f& forward)
{
    std::vector<float> depths(centres.size());
    for (std::size_t i = 0; i < centres.size(); ++i)
        depths[i] = forward.dot(centres[i]);
    const auto [least, most] = std::minmax_element(depths.begin(), depths.end());
    const float farthest = *most;
    const float span = farthest - *least;
    const float perMetre = span > 0.0F ? static_cast<float>(kNearestStep) / span : 0.0F;
    std::vector<std::uint16_t> steps(centres.size());
    for (std::size_t i = 0; i < depths.size(); ++i)
        steps[i] = static_cast<std::uint16_t>((farthest - depths[i]) * perMetre);
    return steps;
}

} // namespace

DrawOrder::DrawOrder(std::vector<Triangle> triangles, std::span<const Vec3f> positions)
    : m_triangles(std::move(triangles))
{
    m_centres.reserve(m_triangles.size());
    for (const Triangle& t : m_triangles)
        m_centres.emplace_back(positions[t[0]] + positions[t[1]] + positions[t[2]]);
}

std::vector<Triangle> DrawOrder::backToFront(const Vec3f& forward) const
{
    if (m_triangles.empty())
        return {};
    const std::vector<std::uint16_t> steps = stepsFromFarthest(m_centres, forward);
    std::vector<std::uint32_t> place(kNearestStep + 2, 0); // where the next of each step goes
    for (const std::uint16_t step : steps)
        ++place[step + 1U];
    for (std::size_t step = 1; step < place.size(); ++step)
        place[step] += place[step - 1];
    std::vector<Triangle> ordered(m_triangles.size());
    for (std::size_t i = 0; i < steps.size(); ++i)
        ordered[place[steps[i]]++] = m_triangles[i];
    return ordered;
}

} // namespace carina
