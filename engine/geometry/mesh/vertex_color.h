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

/// The colours of the vertices of a surface by where they lie: finds them again after the surface
/// was welded, closed or simplified, all of which leave the vertices they keep in place.
class ColorsByPlace
{
public:
    /// Of several vertices at one place the first counts.
    /// @pre one colour for each place.
    ColorsByPlace(std::span<const Vec3f> places, std::span<const Rgb> colors);

    /// A colour for each place: that of the vertex there, else the mean of all.
    [[nodiscard]] std::vector<Rgb> at(std::span<const Vec3f> places) const;

private:
    struct PlaceHash {
        std::size_t operator()(const std::array<std::uint32_t, 3>& place) const;
    };

    std::unordered_map<std::array<std::uint32_t, 3>, Rgb, PlaceHash> m_colors;
    Rgb m_mean{};
};

} // namespace carina
