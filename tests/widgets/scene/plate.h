#pragma once

#include "tests/widgets/scene/scene_fixture.h"

#include <utility>

namespace carina::test
{

inline constexpr double kPlate = 0.3; ///< half as wide and high as a plate, metres

/// A square plate in the plane y = 0 of its body that faces -y.
inline ScenePart platePart(std::uint16_t id, MaterialGroup group, const char* body = "")
{
    auto mesh = std::make_shared<TriangleMesh>();
    for (const auto& [x, z] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        mesh->positions.emplace_back(Vec3{x * kPlate, 0.0, z * kPlate}.cast<float>());
        mesh->normals.emplace_back(0.0F, -1.0F, 0.0F);
    }
    mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
    ScenePart part;
    part.id = id;
    part.group = group;
    part.color = QColor(40, 90, 200);
    part.body = body;
    part.levels = {std::move(mesh)};
    return part;
}

/// An error that grows by `perMetre` (metres) from the plane x = from on, squared.
inline Mat4 growingAlongX(double from, double perMetre)
{
    Mat4 quadric = Mat4::Zero();
    quadric(0, 0) = 1.0;
    quadric(0, 3) = quadric(3, 0) = -from;
    quadric(3, 3) = from * from;
    return perMetre * perMetre * quadric;
}

} // namespace carina::test
