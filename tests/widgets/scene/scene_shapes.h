#pragma once

#include "engine/geometry/deformation/chest_field.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>

namespace carina::test
{

/// A sphere about a centre, metres.
inline std::shared_ptr<const TriangleMesh> sphere(const Vec3& centre, double radius)
{
    constexpr std::uint32_t kAround = 120;
    constexpr std::uint32_t kRings = 60;
    auto mesh = std::make_shared<TriangleMesh>();
    for (std::uint32_t ring = 0; ring <= kRings; ++ring) {
        const double polar = std::numbers::pi * ring / kRings;
        for (std::uint32_t step = 0; step < kAround; ++step) {
            const double around = 2.0 * std::numbers::pi * step / kAround;
            const Vec3 normal{std::sin(polar) * std::cos(around),
                              std::sin(polar) * std::sin(around), std::cos(polar)};
            mesh->positions.emplace_back((centre + radius * normal).cast<float>());
            mesh->normals.emplace_back(normal.cast<float>());
        }
    }
    for (std::uint32_t ring = 0; ring < kRings; ++ring)
        for (std::uint32_t step = 0; step < kAround; ++step) {
            const std::uint32_t a = ring * kAround + step;
            const std::uint32_t b = ring * kAround + (step + 1) % kAround;
            mesh->triangles.push_back({a, a + kAround, b + kAround});
            mesh->triangles.push_back({a, b + kAround, b});
        }
    return mesh;
}

/// A chest whose right hilum is at kHilum_x on the x axis. What lies at smaller x grows k times
/// about it by the motion scaledBy(k): a sphere becomes a sphere.
inline constexpr double kHilum_x = 0.4;

inline ChestField wideChest()
{
    Box box_A;
    box_A.include(Vec3{-1.0, -1.0, -1.0});
    box_A.include(Vec3{3.0, 1.0, 1.0});
    return {box_A, {kHilum_x, 0.0, 0.0}, {2.0 - kHilum_x, 0.0, 0.0}};
}

inline ChestMotion scaledBy(double k)
{
    const ChestTerms<double> terms{.shrink = 1.0 - k};
    return {terms, terms};
}

} // namespace carina::test
