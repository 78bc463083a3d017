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

/// With its dot, in lower case.
std::string endingOfName(const std::filesystem::path& file)
{
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

} // namespace

std::optional<SurfaceFormat> surfaceFormat(const std::filesystem::path& file)
{
    const std::string ending = endingOfName(file);
    for (std::size_t i = 0; i < kEndings.size(); ++i)
        if (ending == std::string{"."} + kEndings[i])
            return static_cast<SurfaceFormat>(i);
    return std::nullopt;
}

const FileLimit& limitOfSetFile(const std::filesystem::path& file)
{
    const std::string ending = endingOfName(file);
    if (surfaceFormat(file) || ending == ".bin")
        return kSurfaceLimit;
    if (ending == ".png" || ending == ".jpg" || ending == ".jpeg")
        return kPictureLimit;
    return ending == ".mtl" ? kMaterialLimit : kDescriptionLimit;
}

const char* endingOf(SurfaceFormat format) { return kEndings[static_cast<std::size_t>(format)]; }

} // namespace carina
