#pragma once

#include "engine/geometry/deformable_mesh.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>

namespace carina::test
{

/// A sphere about a centre, metres, whose displacement grows its radius by `growth` metres at
/// amplitude 1. Normals stay, since a sphere stays a sphere.
inline std::shared_ptr<const DeformableMesh> sphere(const Vec3& centre, double radius,
                                                    double growth = 0.0)
{
    constexpr std::uint32_t kAround = 120;
    constexpr std::uint32_t kRings = 60;
    auto mesh = std::make_shared<DeformableMesh>();
    for (std::uint32_t ring = 0; ring <= kRings; ++ring) {
        const double polar = std::numbers::pi * ring / kRings;
        for (std::uint32_t step = 0; step < kAround; ++step) {
            const double around = 2.0 * std::numbers::pi * step / kAround;
            const Vec3 normal{std::sin(polar) * std::cos(around),
                              std::sin(polar) * std::sin(around), std::cos(polar)};
            mesh->rest.positions.emplace_back((centre + radius * normal).cast<float>());
            mesh->rest.normals.emplace_back(normal.cast<float>());
            mesh->displacement.emplace_back((growth * normal).cast<float>());
            mesh->normalLinear.emplace_back(Vec3f::Zero());
            mesh->normalQuadratic.emplace_back(Vec3f::Zero());
        }
    }
    for (std::uint32_t ring = 0; ring < kRings; ++ring)
        for (std::uint32_t step = 0; step < kAround; ++step) {
            const std::uint32_t a = ring * kAround + step;
            const std::uint32_t b = ring * kAround + (step + 1) % kAround;
            mesh->rest.triangles.push_back({a, a + kAround, b + kAround});
            mesh->rest.triangles.push_back({a, b + kAround, b});
        }
    return mesh;
}

} // namespace carina::test
