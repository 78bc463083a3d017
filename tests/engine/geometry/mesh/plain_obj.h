#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace carina::test
{

/// Of "7" and "7//3": 6.
inline std::uint32_t indexOf(const std::string& corner)
{
    return static_cast<std::uint32_t>(std::stoul(corner)) - 1;
}

/// A surface in millimetres from an OBJ file of which nothing is read but `v` lines, and of `f`
/// lines the first index of each corner.
inline TriangleMesh plainObj(const std::filesystem::path& file)
{
    TriangleMesh mesh;
    std::ifstream stream{file};
    for (std::string line; std::getline(stream, line);) {
        std::istringstream words{line};
        std::string key;
        words >> key;
        Vec3f p;
        std::array<std::string, 3> corners;
        if (key == "v" && words >> p.x() >> p.y() >> p.z())
            mesh.positions.push_back(1e-3F * p);
        else if (key == "f" && words >> corners[0] >> corners[1] >> corners[2])
            mesh.triangles.push_back(
                {indexOf(corners[0]), indexOf(corners[1]), indexOf(corners[2])});
    }
    return mesh;
}

} // namespace carina::test
