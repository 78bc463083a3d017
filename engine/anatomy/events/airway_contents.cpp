#include "engine/anatomy/events/airway_contents.h"

#include "engine/anatomy/airway/pharynx_place.h"
#include "engine/anatomy/events/airway_changes.h"

#include <cmath>

namespace carina
{
namespace
{

constexpr double kFluidFoot_mm = -8.0;
constexpr double kFluidHead_mm = 52.0;
constexpr double kWallOfPharynx_mm = 2.0;
constexpr int kRows = 40;
constexpr int kColumns = 24;

/// Facing the front, tilted as by waves of some millimetres across each other.
Vec3 rippled(double x_mm, double z_mm)
{
    constexpr double kSteep = 0.3;
    const double slope_x = std::sin(0.9 * x_mm + 0.4 * z_mm) + std::sin(0.5 * x_mm - 0.7 * z_mm);
    const double slope_z = std::sin(0.8 * z_mm + 0.3 * x_mm) + std::sin(1.3 * z_mm - 0.5 * x_mm);
    return Vec3{kSteep * slope_x, -1.0, kSteep * slope_z}.normalized();
}

} // namespace

std::vector<ThroatContent> fluidsIn(const UpperAirway& airway, const AirwayEvents& events)
{
    std::vector<ThroatContent> fluids;
    const double size = airway.size();
    for (const AirwayEventKind kind : kThroatFluids) {
        const double severity = severityOf(events, kind);
        if (severity <= 0.0 || !canShow(airway, kind))
            continue;
        const double back = size * (kBackWall - severity * kDeepestFluid).si;
        fluids.push_back({kind, airway.p_A_notch + back * Vec3::UnitY(), size});
    }
    return fluids;
}

std::optional<ThroatContent> foreignBodyIn(const UpperAirway& airway, const AirwayEvents& events)
{
    const double severity = severityOf(events, AirwayEventKind::ForeignBody);
    if (severity <= 0.0 || !canShow(airway, AirwayEventKind::ForeignBody))
        return std::nullopt;
    const double size = airway.size();
    const Vec3 right = -airway.up_A.cross(airway.forward_A()); // the patient's
    const Vec3 p_A_fossa =
        airway.p_A_notch
        + size * 1e-3 * (13.0 * right - 1.0 * airway.forward_A() + 8.0 * airway.up_A);
    const Vec3 p_A_over =
        0.5 * (airway.p_A_commissure + airway.p_A_notch) + size * 15e-3 * airway.up_A;
    return ThroatContent{AirwayEventKind::ForeignBody,
                         p_A_fossa + severity * (p_A_over - p_A_fossa), size};
}

TriangleMesh fluidSurface()
{
    TriangleMesh mesh;
    for (int row = 0; row <= kRows; ++row) {
        const double z_mm = std::lerp(kFluidFoot_mm, kFluidHead_mm, double(row) / kRows);
        const double half_mm = pharynxSectionAt(z_mm).halfWidth - kWallOfPharynx_mm;
        for (int column = 0; column <= kColumns; ++column) {
            const double x_mm = std::lerp(-half_mm, half_mm, double(column) / kColumns);
            mesh.positions.emplace_back(Vec3{1e-3 * x_mm, 0.0, 1e-3 * z_mm}.cast<float>());
            mesh.normals.emplace_back(rippled(x_mm, z_mm).cast<float>());
        }
    }
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column) {
            const auto a = static_cast<std::uint32_t>(row * (kColumns + 1) + column);
            const auto above = a + std::uint32_t{kColumns + 1};
            mesh.triangles.push_back({a, a + 1, above + 1});
            mesh.triangles.push_back({a, above + 1, above});
        }
    return mesh;
}

} // namespace carina
