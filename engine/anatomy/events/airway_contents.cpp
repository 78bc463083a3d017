#include "engine/anatomy/events/airway_contents.h"

#include "engine/anatomy/airway/pharynx_place.h"
#include "engine/anatomy/events/airway_changes.h"

#include <cmath>

namespace carina
{
namespace
{

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

/// Across the pharynx.
struct FluidRow {
    double z_mm;
    double half_mm;
};

template <class RowAt> void addRippledSurface(TriangleMesh& mesh, RowAt rowAt)
{
    for (int row = 0; row <= kRows; ++row)
        for (int column = 0; column <= kColumns; ++column) {
            const auto [z_mm, half_mm] = rowAt(row);
            const double x_mm = std::lerp(-half_mm, half_mm, column / double(kColumns));
            const Vec3 p{1e-3 * x_mm, 0.0, 1e-3 * z_mm};
            mesh.positions.emplace_back(p.cast<float>());
            const Vec3 normal = rippled(x_mm, z_mm);
            mesh.normals.emplace_back(normal.cast<float>());
        }
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column) {
            const auto a = static_cast<std::uint32_t>(row * (kColumns + 1) + column);
            const auto above = a + std::uint32_t{kColumns + 1};
            mesh.triangles.push_back({a, a + 1, above + 1});
            mesh.triangles.push_back({a, above + 1, above});
        }
}

/// A flat side, its corners counter-clockwise seen from outside.
void addFlat(TriangleMesh& mesh, const std::array<Vec3, 4>& corners)
{
    const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Vec3& p_F : corners) {
        mesh.positions.emplace_back(p_F.cast<float>());
        mesh.normals.emplace_back(normal.cast<float>());
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
}

} // namespace

std::vector<ThroatContent> fluidsIn(const UpperAirway& airway, const AirwayEvents& events)
{
    std::vector<ThroatContent> fluids;
    for (const AirwayEventKind kind : kThroatFluids) {
        const double severity = severityOf(events, kind);
        if (severity <= 0.0 || !canShow(airway, kind))
            continue;
        const double back = airway.larynxSize() * (kBackWall - severity * kDeepestFluid).si;
        fluids.push_back({kind, airway.p_A_notch + back * Vec3::UnitY(), airway.size()});
    }
    return fluids;
}

std::optional<ThroatContent> foreignBodyIn(const UpperAirway& airway, const AirwayEvents& events)
{
    const double severity = severityOf(events, AirwayEventKind::ForeignBody);
    if (severity <= 0.0 || !canShow(airway, AirwayEventKind::ForeignBody))
        return std::nullopt;
    const double size = airway.larynxSize();
    const Vec3 right = -airway.up_A.cross(airway.forward_A()); // the patient's
    const Vec3 p_A_fossa =
        airway.p_A_notch
        + size * 1e-3 * (13.0 * right - 1.0 * airway.forward_A() + 8.0 * airway.up_A);
    const Vec3 p_A_over =
        0.5 * (airway.p_A_commissure + airway.p_A_notch) + size * 15e-3 * airway.up_A;
    return ThroatContent{AirwayEventKind::ForeignBody,
                         p_A_fossa + severity * (p_A_over - p_A_fossa), size};
}

TriangleMesh fluidMesh()
{
    TriangleMesh mesh;
    const auto rowAt = [](int row) {
        const double z_mm =
            std::lerp(-inMillimetres(kFluidFoot), kFluidHead_mm, row / double(kRows));
        return FluidRow{z_mm, pharynxSectionAt(z_mm).halfWidth - kWallOfPharynx_mm};
    };
    addRippledSurface(mesh, rowAt);
    const auto corner = [&rowAt](int row, double side, double back_mm) {
        return Vec3{1e-3 * Vec3{side * rowAt(row).half_mm, back_mm, rowAt(row).z_mm}};
    };
    const double behind_mm = inMillimetres(kFluidBehind);
    for (int row = 0; row < kRows; ++row) {
        for (const double side : {-1.0, 1.0}) {
            const int low = side < 0.0 ? row + 1 : row;
            const int high = side < 0.0 ? row : row + 1;
            addFlat(mesh, {corner(low, side, 0.0), corner(low, side, behind_mm),
                           corner(high, side, behind_mm), corner(high, side, 0.0)});
        }
        addFlat(mesh, {corner(row, 1.0, behind_mm), corner(row, -1.0, behind_mm),
                       corner(row + 1, -1.0, behind_mm), corner(row + 1, 1.0, behind_mm)});
    }
    addFlat(mesh, {corner(0, -1.0, behind_mm), corner(0, 1.0, behind_mm), corner(0, 1.0, 0.0),
                   corner(0, -1.0, 0.0)});
    addFlat(mesh, {corner(kRows, -1.0, 0.0), corner(kRows, 1.0, 0.0), corner(kRows, 1.0, behind_mm),
                   corner(kRows, -1.0, behind_mm)});
    return mesh;
}

} // namespace carina
