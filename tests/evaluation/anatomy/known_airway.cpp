#include "tests/evaluation/anatomy/known_airway.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace carina::test
{
namespace
{

constexpr std::uint32_t kCorners = 64;

double rad(double degrees) { return degrees * std::numbers::pi / 180.0; }

AnatomyPart part(std::string name, PartRole role, TriangleMesh mesh)
{
    return {std::move(name), role, {}, {std::move(mesh)}};
}

} // namespace

TriangleMesh tubeOf(const Vec3& a, const Vec3& b, double wide, double deep)
{
    const Vec3 axis = (b - a).normalized();
    const Vec3 across = axis.cross(Vec3::UnitX()).normalized();
    const Vec3 aside = across.cross(axis);
    TriangleMesh mesh;
    for (const Vec3& middle : {a, b}) {
        for (std::uint32_t k = 0; k < kCorners; ++k) {
            const double turn = 2.0 * std::numbers::pi * k / kCorners;
            const Vec3 p = middle + wide * std::cos(turn) * aside + deep * std::sin(turn) * across;
            mesh.positions.push_back(p.cast<float>());
        }
    }
    mesh.positions.push_back(a.cast<float>());
    mesh.positions.push_back(b.cast<float>());
    for (std::uint32_t k = 0; k < kCorners; ++k) {
        const std::uint32_t next = (k + 1) % kCorners;
        mesh.triangles.push_back({k, next, kCorners + next});
        mesh.triangles.push_back({k, kCorners + next, kCorners + k});
        mesh.triangles.push_back({2 * kCorners, next, k});
        mesh.triangles.push_back({2 * kCorners + 1, kCorners + k, kCorners + next});
    }
    return mesh;
}

TriangleMesh boxOf(const Vec3& low, const Vec3& high)
{
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.positions.push_back(Vec3{(corner & 1) != 0 ? high.x() : low.x(),
                                      (corner & 2) != 0 ? high.y() : low.y(),
                                      (corner & 4) != 0 ? high.z() : low.z()}
                                     .cast<float>());
    for (const auto& q : {std::array{0U, 2U, 3U, 1U},
                          {4U, 5U, 7U, 6U},
                          {0U, 1U, 5U, 4U},
                          {2U, 6U, 7U, 3U},
                          {0U, 4U, 6U, 2U},
                          {1U, 3U, 7U, 5U}}) {
        mesh.triangles.push_back({q[0], q[1], q[2]});
        mesh.triangles.push_back({q[0], q[2], q[3]});
    }
    return mesh;
}

Anatomy anatomyOf(const KnownAirway& known, double size)
{
    const Vec3 up{0.0, -std::sin(rad(known.lean)), std::cos(rad(known.lean))};
    const auto downAside = [&](double angle) -> Vec3 {
        return std::sin(rad(angle)) * Vec3::UnitX() - std::cos(rad(std::abs(angle))) * up;
    };
    const Vec3 right = downAside(-known.rightAngle);
    const Vec3 left = downAside(known.leftAngle);
    Anatomy a;
    a.name = "known";
    const auto add = [&](const char* name, PartRole role, TriangleMesh mesh) {
        for (Vec3f& p : mesh.positions)
            p *= float(size);
        a.parts.push_back(part(name, role, std::move(mesh)));
    };
    add("Trachea", PartRole::Trachea,
        tubeOf(Vec3::Zero(), (known.length + 0.008) * up, 0.5 * known.coronal,
               0.5 * known.sagittal));
    add("Right main bronchus", PartRole::RightMainBronchus,
        tubeOf(-0.01 * right, 0.03 * right, 0.006, 0.006));
    const Vec3 aside{-0.03, 0.0, 0.0};
    append(a.parts.back().levels.front(), [&] {
        TriangleMesh branch = tubeOf(size * (aside - 0.01 * right), size * (aside + 0.03 * right),
                                     0.003 * size, 0.003 * size);
        return branch;
    }());
    add("Left main bronchus", PartRole::LeftMainBronchus,
        tubeOf(-0.01 * left, 0.05 * left, 0.005, 0.005));
    const Vec3 cricoid = (known.length + 0.01) * up;
    add("Cricoid cartilage", PartRole::Larynx,
        tubeOf(cricoid - 0.01 * up, cricoid + 0.01 * up, 0.012, 0.011));
    constexpr std::array kLobes{PartRole::RightUpperLobe, PartRole::RightMiddleLobe,
                                PartRole::RightLowerLobe, PartRole::LeftUpperLobe,
                                PartRole::LeftLowerLobe};
    for (std::size_t i = 0; i < kLobes.size(); ++i) {
        const double side = std::cbrt(known.lobes_ml[i] * 1e-6);
        const Vec3 corner{(i < 3 ? -0.2 : 0.1), 0.0, -0.2 * double(i)};
        add(roleName(kLobes[i]), kLobes[i], boxOf(corner, corner + Vec3::Constant(side)));
    }
    a.landmarks.p_A_glottis = size * known.cords * up;
    const Vec3 forward{0.0, -(known.teeth - known.cords), 0.0};
    a.landmarks.p_A_incisors = a.landmarks.p_A_glottis + size * forward;
    a.landmarks.path_A = {a.landmarks.p_A_incisors + size * forward, a.landmarks.p_A_incisors,
                          a.landmarks.p_A_glottis, a.landmarks.p_A_carina};
    return a;
}

} // namespace carina::test
