#pragma once

#include "engine/geometry/triangle_mesh.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace carina::test
{

/// A surface in millimetres from an OBJ file of which nothing is read but `v` and `f` lines with
/// plain indices.
inline TriangleMesh plainObj(const std::filesystem::path& file)
{
    TriangleMesh mesh;
    std::ifstream stream{file};
    for (std::string line; std::getline(stream, line);) {
        std::istringstream words{line};
        std::string key;
        words >> key;
        Vec3f p;
        Triangle t{};
        if (key == "v" && words >> p.x() >> p.y() >> p.z())
            mesh.positions.push_back(1e-3F * p);
        else if (key == "f" && words >> t[0] >> t[1] >> t[2])
            mesh.triangles.push_back({t[0] - 1, t[1] - 1, t[2] - 1});
    }
    return mesh;
}

} // namespace carina::test
