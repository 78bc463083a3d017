#include "engine/geometry/mesh/vertex_color.h"

#include "engine/core/expects.h"

#include <bit>
#include <cmath>

namespace carina
{
namespace
{

/// The bits of the coordinates, with one zero.
std::array<std::uint32_t, 3> bitsOf(const Vec3f& place)
{
    std::array<std::uint32_t, 3> bits{};
    for (int axis = 0; axis < 3; ++axis)
        bits[std::size_t(axis)] = std::bit_cast<std::uint32_t>(place[axis] + 0.0F);
    return bits;
}

Rgb meanOf(std::span<const Rgb> colors)
{
    Rgb mean{};
    for (std::size_t channel = 0; channel < mean.size() && !colors.empty(); ++channel) {
        double sum = 0.0;
        for (const Rgb& color : colors)
            sum += color[channel];
        mean[channel] = static_cast<std::uint8_t>(std::lround(sum / double(colors.size())));
    }
    return mean;
}

} // namespace

std::size_t ColorsByPlace::PlaceHash::operator()(const std::array<std::uint32_t, 3>& place) const
{
    std::uint64_t mixed = 0;
    for (const std::uint32_t bits : place)
        mixed = (mixed ^ bits) * 0x9e3779b97f4a7c15ULL;
    return static_cast<std::size_t>(mixed ^ mixed >> 29);
}

ColorsByPlace::ColorsByPlace(std::span<const Vec3f> places, std::span<const Rgb> colors)
    : m_mean(meanOf(colors))
{
    CARINA_EXPECTS(places.size() == colors.size());
    m_colors.reserve(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        m_colors.emplace(bitsOf(places[i]), colors[i]);
}

std::vector<Rgb> ColorsByPlace::at(std::span<const Vec3f> places) const
{
    std::vector<Rgb> colors;
    colors.reserve(places.size());
    for (const Vec3f& place : places) {
        const auto found = m_colors.find(bitsOf(place));
        colors.push_back(found == m_colors.end() ? m_mean : found->second);
    }
    return colors;
}

} // namespace carina
