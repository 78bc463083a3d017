#pragma once

#include <cstdint>
#include <vector>

namespace carina
{

/// A picture in grey, row by row from the top: 0 is black, 255 white.
struct GreyPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels{}; ///< width times height

    [[nodiscard]] double at(int x, int y) const
    {
        return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
};

} // namespace carina
