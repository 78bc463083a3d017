#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

#include <cmath>
#include <numbers>

namespace carina::test
{

/// A closed, outward surface of `rings` times `sectors` patches: an ellipsoid around `centre` with
/// the given radii, hollowed below as by a diaphragm.
inline TriangleMesh lungLikeMesh(const Vec3& centre, const Vec3& radii, std::uint32_t rings,
                                 std::uint32_t sectors)
{
    TriangleMesh mesh;
    const auto add = [&](double polar, double azimuth) {
        const Vec3 unit{std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                        std::cos(polar)};
        Vec3 p = centre + radii.cwiseProduct(unit);
        if (unit.z() < 0.0)
            p.z() += 0.35 * radii.z() * std::pow(unit.z(), 4.0);
        if (unit.z() < -0.6)
            p.z() += 1.2 * radii.z() * std::pow(-0.6 - unit.z(), 2.0);
        mesh.positions.emplace_back(p.cast<float>());
    };
    const auto at = [&](std::uint32_t ring, std::uint32_t sector) {
        return 1 + (ring - 1) * sectors + sector % sectors;
    };
    add(0.0, 0.0);
    for (std::uint32_t ring = 1; ring < rings; ++ring) {
        for (std::uint32_t sector = 0; sector < sectors; ++sector)
            add(std::numbers::pi * ring / rings, 2.0 * std::numbers::pi * sector / sectors);
    }
    add(std::numbers::pi, 0.0);
    const auto south = static_cast<std::uint32_t>(mesh.positions.size() - 1);
    for (std::uint32_t sector = 0; sector < sectors; ++sector) {
        mesh.triangles.push_back({0, at(1, sector), at(1, sector + 1)});
        for (std::uint32_t ring = 1; ring + 1 < rings; ++ring) {
            mesh.triangles.push_back(
                {at(ring, sector), at(ring + 1, sector), at(ring + 1, sector + 1)});
            mesh.triangles.push_back(
                {at(ring, sector), at(ring + 1, sector + 1), at(ring, sector + 1)});
        }
        mesh.triangles.push_back({at(rings - 1, sector), south, at(rings - 1, sector + 1)});
    }
    computeNormals(mesh);
    return mesh;
}

/// Volume by the divergence theorem along z: every triangle's area seen from above times its mean
/// height, in double. Another sum than the engine's tetrahedra.
inline double volumeByColumns(const TriangleMesh& mesh)
{
    double volume = 0.0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 a = mesh.positions[t[0]].cast<double>();
        const Vec3 b = mesh.positions[t[1]].cast<double>();
        const Vec3 c = mesh.positions[t[2]].cast<double>();
        const double areaFromAbove =
            0.5 * ((b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y()));
        volume += areaFromAbove * (a.z() + b.z() + c.z()) / 3.0;
    }
    return volume;
}

} // namespace carina::test
