#include "engine/anatomy/events/airway_contents.h"

#include "engine/anatomy/airway/pharynx_place.h"
#include "engine/anatomy/events/airway_changes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina
{
namespace
{

/// Up into the nasopharynx, behind the palate, where no eye in mouth or throat sees it end.
constexpr double kFluidHead_mm = 85.0;
constexpr double kPoolHead_mm = 52.0; ///< at most: the palate
constexpr double kWallOfPharynx_mm = 2.0;
constexpr int kRows = 60;
constexpr int kColumns = 24;

/// Facing the front, tilted as by long waves across each other: so little from one corner of the
/// grid to the next that a highlight on it is round.
Vec3 rippled(double x_mm, double z_mm)
{
    constexpr double kSteep = 0.06;
    constexpr double kPerMillimetre = 0.25;
    const double x = kPerMillimetre * x_mm;
    const double z = kPerMillimetre * z_mm;
    const double slope_x = std::sin(0.9 * x + 0.4 * z) + std::sin(0.5 * x - 0.7 * z);
    const double slope_z = std::sin(0.8 * z + 0.3 * x) + std::sin(1.3 * z - 0.5 * x);
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

/// How deep a fluid stands at a height in F where it has this depth behind the notch.
double depthAt_mm(double depth_mm, double z_mm)
{
    return depth_mm - (pharynxSectionAt(0.0).back - pharynxSectionAt(z_mm).back);
}

/// As high as it is anything but a film.
double poolHead_mm(double depth_mm)
{
    constexpr double kFilm_mm = 0.2;
    double z_mm = 0.0;
    while (z_mm < kPoolHead_mm && depthAt_mm(depth_mm, z_mm + 1.0) > kFilm_mm)
        z_mm += 1.0;
    return z_mm;
}

/// Half an ellipse behind the surface, as a strip of it from row to row; its ends are shut.
struct PoolBottom {
    static constexpr int kAround = 16;

    template <class RowAt, class DeepAt>
    static void add(TriangleMesh& mesh, RowAt rowAt, DeepAt deepAt)
    {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (int row = 0; row <= kRows; ++row)
            for (int step = 0; step <= kAround; ++step)
                addPoint(mesh, rowAt(row), deepAt(row), step);
        constexpr std::uint32_t kPoints = kAround + 1;
        for (std::uint32_t row = 0; row < kRows; ++row)
            for (std::uint32_t step = 0; step < kAround; ++step) {
                const std::uint32_t a = first + row * kPoints + step;
                mesh.triangles.push_back({a, a + kPoints + 1, a + 1});
                mesh.triangles.push_back({a, a + kPoints, a + kPoints + 1});
            }
        addEnd(mesh, rowAt(0), deepAt(0), -1.0);
        addEnd(mesh, rowAt(kRows), deepAt(kRows), 1.0);
    }

private:
    /// From the right side (-x) over the back to the left.
    static Vec3 pointAt(const FluidRow& row, double deep_mm, int step)
    {
        const double angle = std::numbers::pi * (1.0 - double(step) / kAround);
        return {1e-3 * row.half_mm * std::cos(angle), 1e-3 * deep_mm * std::sin(angle),
                1e-3 * row.z_mm};
    }
    static void addPoint(TriangleMesh& mesh, const FluidRow& row, double deep_mm, int step)
    {
        const Vec3 p = pointAt(row, deep_mm, step);
        const Vec3 normal{p.x() / (row.half_mm * row.half_mm), p.y() / (deep_mm * deep_mm), 0.0};
        mesh.positions.emplace_back(p.cast<float>());
        mesh.normals.emplace_back(normal.normalized().cast<float>());
    }
    /// @param up 1 where it looks to the head, -1 to the feet
    static void addEnd(TriangleMesh& mesh, const FluidRow& row, double deep_mm, double up)
    {
        const auto middle = static_cast<std::uint32_t>(mesh.positions.size());
        const auto add = [&mesh, up](const Vec3& p) {
            mesh.positions.emplace_back(p.cast<float>());
            mesh.normals.emplace_back(0.0F, 0.0F, float(up));
        };
        add({0.0, 0.0, 1e-3 * row.z_mm});
        for (int step = 0; step <= kAround; ++step)
            add(pointAt(row, deep_mm, step));
        for (std::uint32_t step = 1; step <= kAround; ++step) {
            const std::uint32_t one = middle + step;
            if (up > 0.0)
                mesh.triangles.push_back({middle, one + 1, one});
            else
                mesh.triangles.push_back({middle, one, one + 1});
        }
    }
};

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
        fluids.push_back({.kind = kind,
                          .p_AF = airway.p_A_notch + back * Vec3::UnitY(),
                          .size = airway.size(),
                          .depth = severity * airway.larynxSize() / airway.size() * kDeepestFluid});
    }
    return fluids;
}

std::vector<ThroatContent> valleculaFluidsIn(const UpperAirway& airway, const AirwayEvents& events)
{
    std::vector<ThroatContent> fluids;
    const Vec3 up_A = (airway.p_A_epiglottisTip - airway.p_A_vallecula).normalized();
    for (const AirwayEventKind kind : kThroatFluids) {
        const double severity = severityOf(events, kind);
        if (severity <= 0.0 || !canShow(airway, kind))
            continue;
        const double size = severity * airway.larynxSize();
        const double up = 0.5 * size * kValleculaPoolHeight.si;
        fluids.push_back({.kind = kind,
                          .p_AF = airway.p_A_vallecula + up * up_A,
                          .size = size,
                          .place = ContentPlace::Vallecula});
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
    return ThroatContent{.kind = AirwayEventKind::ForeignBody,
                         .p_AF = p_A_fossa + severity * (p_A_over - p_A_fossa),
                         .size = size};
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

TriangleMesh poolMesh(Length depth)
{
    const double depth_mm = inMillimetres(depth);
    const double head_mm = poolHead_mm(depth_mm);
    const auto rowAt = [head_mm](int row) {
        const double z_mm = std::lerp(-inMillimetres(kFluidFoot), head_mm, row / double(kRows));
        return FluidRow{z_mm, pharynxSectionAt(z_mm).halfWidth - kWallOfPharynx_mm};
    };
    const auto deepAt = [depth_mm, &rowAt](int row) {
        constexpr double kFilm_mm = 0.05;
        return std::max(kFilm_mm, depthAt_mm(depth_mm, rowAt(row).z_mm));
    };
    TriangleMesh mesh;
    addRippledSurface(mesh, rowAt);
    PoolBottom::add(mesh, rowAt, deepAt);
    return mesh;
}

TriangleMesh valleculaPoolMesh()
{
    constexpr int kAround = 32;
    constexpr int kRings = 8;
    TriangleMesh mesh;
    const Vec3 half{0.5 * kValleculaPoolWidth.si, kValleculaPoolDepth.si,
                    0.5 * kValleculaPoolHeight.si};
    const auto add = [&mesh](const Vec3& p, const Vec3& normal) {
        mesh.positions.emplace_back(p.cast<float>());
        mesh.normals.emplace_back(normal.normalized().cast<float>());
    };
    // Rings from the edge to the bottom (behind), then the surface: an edge ring and its middle.
    for (int ring = 0; ring <= kRings; ++ring)
        for (int step = 0; step < kAround; ++step) {
            const double down = 0.5 * std::numbers::pi * ring / kRings;
            const double around = 2.0 * std::numbers::pi * step / kAround;
            const Vec3 unit{std::cos(down) * std::cos(around), std::sin(down),
                            std::cos(down) * std::sin(around)};
            add(half.cwiseProduct(unit), unit.cwiseQuotient(half));
        }
    for (int step = 0; step < kAround; ++step) {
        const double around = 2.0 * std::numbers::pi * step / kAround;
        const Vec3 p{half.x() * std::cos(around), 0.0, half.z() * std::sin(around)};
        add(p, rippled(1e3 * p.x(), 1e3 * p.z()));
    }
    add(Vec3::Zero(), rippled(0.0, 0.0));
    const auto at = [](int ring, int step) {
        return static_cast<std::uint32_t>(ring * kAround + step % kAround);
    };
    const std::uint32_t middle = at(kRings + 2, 0);
    for (int step = 0; step < kAround; ++step) {
        for (int ring = 0; ring < kRings; ++ring) {
            mesh.triangles.push_back({at(ring, step), at(ring + 1, step), at(ring + 1, step + 1)});
            mesh.triangles.push_back({at(ring, step), at(ring + 1, step + 1), at(ring, step + 1)});
        }
        mesh.triangles.push_back({middle, at(kRings + 1, step), at(kRings + 1, step + 1)});
    }
    return mesh;
}

} // namespace carina
