#include "engine/io/mesh/surface_format.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace carina
{
namespace
{

constexpr std::array kEndings{"obj", "ply", "stl", "gltf", "glb"}; // in the order of SurfaceFormat

} // namespace

std::optional<SurfaceFormat> surfaceFormat(const std::filesystem::path& file)
{
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (std::size_t i = 0; i < kEndings.size(); ++i)
        if (ending == std::string{"."} + kEndings[i])
            return static_cast<SurfaceFormat>(i);
    return std::nullopt;
}

const char* endingOf(SurfaceFormat format) { return kEndings[static_cast<std::size_t>(format)]; }

} // namespace carina
