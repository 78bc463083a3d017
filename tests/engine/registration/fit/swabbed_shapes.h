#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"
#include "engine/geometry/rotation.h"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace carina::test
{

/// x^2/a^2 + y^2/b^2 + z^2/c^2 = 1, from a grid of angles.
inline Vec3 onEllipsoid(const Vec3& axes, double polar, double around)
{
    return axes.cwiseProduct(Vec3{std::sin(polar) * std::cos(around),
                                  std::sin(polar) * std::sin(around), std::cos(polar)});
}

inline TriangleMesh ellipsoid(const Vec3& axes, std::uint32_t rings = 90,
                              std::uint32_t across = 180)
{
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i <= rings; ++i)
        for (std::uint32_t k = 0; k < across; ++k)
            mesh.positions.push_back(
                onEllipsoid(axes, std::numbers::pi * i / rings, 2.0 * std::numbers::pi * k / across)
                    .cast<float>());
    for (std::uint32_t i = 0; i < rings; ++i)
        for (std::uint32_t k = 0; k < across; ++k) {
            const std::uint32_t next = (k + 1) % across;
            mesh.triangles.push_back({i * across + k, (i + 1) * across + k, i * across + next});
            mesh.triangles.push_back(
                {i * across + next, (i + 1) * across + k, (i + 1) * across + next});
        }
    return mesh;
}

/// A box about the origin, two triangles for each face.
inline TriangleMesh box(const Vec3& half)
{
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.positions.push_back(
            half.cwiseProduct(Vec3{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0})
                .cast<float>());
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

/// Points anywhere on a mesh, evenly over its area.
inline std::vector<Vec3> swabbed(const TriangleMesh& mesh, int count, std::mt19937& random)
{
    std::vector<double> areas;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 a = mesh.positions[t[0]].cast<double>();
        areas.push_back((mesh.positions[t[1]].cast<double>() - a)
                            .cross(mesh.positions[t[2]].cast<double>() - a)
                            .norm());
    }
    std::discrete_distribution<std::size_t> any(areas.begin(), areas.end());
    std::uniform_real_distribution<double> share{0.0, 1.0};
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        const Triangle& t = mesh.triangles[any(random)];
        double u = share(random);
        double v = share(random);
        if (u + v > 1.0) {
            u = 1.0 - u;
            v = 1.0 - v;
        }
        const Vec3 a = mesh.positions[t[0]].cast<double>();
        points.push_back(a + u * (mesh.positions[t[1]].cast<double>() - a)
                         + v * (mesh.positions[t[2]].cast<double>() - a));
    }
    return points;
}

inline Vec3 anyStep(double sigma, std::mt19937& random)
{
    std::normal_distribution<double> part{0.0, sigma};
    return {part(random), part(random), part(random)};
}

} // namespace carina::test
