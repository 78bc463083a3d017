#pragma once

#include "engine/geometry/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace carina
{

/// Red, green and blue in sRGB, 0 to 255.
using Rgb = std::array<std::uint8_t, 3>;

/// A map from vertex positions to colours. It restores the colours after a surface was welded,
/// closed or simplified: these operations do not move the vertices that they keep.
class ColorsByPlace
{
public:
    /// Of several vertices at one position the first determines the colour.
    /// @pre as many colours as positions.
    ColorsByPlace(std::span<const Vec3f> places, std::span<const Rgb> colors);

    /// A colour per position: that of the vertex at exactly this position, else the mean of all.
    [[nodiscard]] std::vector<Rgb> at(std::span<const Vec3f> places) const;

private:
    struct PlaceHash {
        std::size_t operator()(const std::array<std::uint32_t, 3>& place) const;
    };

    std::unordered_map<std::array<std::uint32_t, 3>, Rgb, PlaceHash> m_colors;
    Rgb m_mean{};
};

} // namespace carina
