#include "widgets/scene/figures/figure_shapes.h"

#include "engine/anatomy/shapes/swept_surface.h"

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace carina
{
namespace
{

constexpr std::uint32_t kBands = 16;
constexpr std::uint32_t kSectors = 24;
constexpr double kRound = 2.0;
constexpr double kBoxy = 6.0;

const Vec3 kSkullCentre{0.0, 0.0, 0.085};
const Vec3 kSkullRadii{0.077, kHeadTop, 0.098};
const Vec3 kChinCentre{0.0, -0.075, 0.045};
const Vec3 kChinRadii{0.052, 0.055, 0.055};
const Vec3 kVisorCentre{0.0, 0.005, -0.012};
const Vec3 kVisorRadii{0.088, 0.043, 0.035};
const Vec3 kPalmCentre{0.0, -0.012, 0.05};
const Vec3 kPalmRadii{0.042, 0.016, 0.052};
constexpr double kRayRadius = 0.0022;
constexpr double kArrowLength = 0.025;
constexpr double kArrowRadius = 0.007;
constexpr double kPointedEnd = 0.02; ///< radius of a pointed end, of the largest radius

std::shared_ptr<const TriangleMesh> keptMesh(TriangleMesh mesh)
{
    return std::make_shared<const TriangleMesh>(std::move(mesh));
}

/// Rings from one point to another.
TriangleMesh rod(const Vec3& p_F_from, const Vec3& p_F_to, std::span<const Ring> rings)
{
    return sweptSurface(sweptLine(std::array{p_F_from, p_F_to}), rings);
}

/// A thin line with an arrowhead, along -z.
TriangleMesh arrow(double from, double until)
{
    const double length = until - from;
    return rod({0.0, 0.0, -from}, {0.0, 0.0, -until},
               std::array{Ring{0.0, kRayRadius}, Ring{length - kArrowLength, kRayRadius},
                          Ring{length - kArrowLength, kArrowRadius},
                          Ring{length, kPointedEnd * kArrowRadius}});
}

TriangleMesh finger(const Vec3& p_F_from, const Vec3& p_F_to, double radius)
{
    const double length = (p_F_to - p_F_from).norm();
    const double end = 0.7 * radius;
    return rod(
        p_F_from, p_F_to,
        std::array{Ring{0.0, radius}, Ring{length - end, radius}, Ring{length, 0.4 * radius}});
}

TriangleMesh madeHead()
{
    TriangleMesh head = superellipsoid(kSkullCentre, kSkullRadii, kRound);
    append(head, superellipsoid(kChinCentre, kChinRadii, kRound));
    return head;
}

/// The index finger stretched out, the others bent, the thumb aside.
TriangleMesh madeHand()
{
    TriangleMesh hand = superellipsoid(kPalmCentre, kPalmRadii, 3.0);
    append(hand, finger({-0.024, -0.006, 0.02}, {-0.02, -0.004, -0.07}, 0.009));
    for (const double x : {-0.004, 0.014, 0.031})
        append(hand, finger({x, -0.006, 0.01}, {x, -0.034, -0.012}, 0.009));
    append(hand, finger({-0.034, -0.014, 0.07}, {-0.062, -0.02, 0.02}, 0.0105));
    return hand;
}

/// As a pen, thicker where it is held.
TriangleMesh madeStylus()
{
    constexpr double kRadius = 0.006;
    return rod(Vec3::Zero(), {0.0, 0.0, 0.15},
               std::array{Ring{0.0, kPointedEnd * kRadius}, Ring{0.03, 0.6 * kRadius},
                          Ring{0.05, kRadius}, Ring{0.15, kRadius}});
}

TriangleMesh madeHandle()
{
    return rod({0.0, -0.004, 0.0}, {0.0, kHandleLength, 0.0},
               std::array{Ring{0.0, 0.5 * kHandleRadius}, Ring{0.02, 0.5 * kHandleRadius},
                          Ring{0.024, kHandleRadius}, Ring{kHandleLength, kHandleRadius},
                          Ring{kHandleLength + 0.004, 0.8 * kHandleRadius}});
}

} // namespace

/// A flat strip that first bends away from the handle and rises at its tip, as the tongue does.
TriangleMesh bladeMesh(const BladeForm& form)
{
    constexpr int kPoints = 24;
    std::vector<Vec3> centre;
    for (int i = 0; i <= kPoints; ++i)
        centre.push_back(middleOfBlade(form, double(i) / kPoints));
    const SweptLine line = sweptLine(centre);
    const double length = line.along.back();
    std::vector<Ring> rings; // the surface is straight between two of them
    for (int i = 0; i <= kPoints; ++i)
        rings.push_back({length * i / kPoints, (i < kPoints ? 1.0 : 0.5) * kBladeHalfThickness});
    TriangleMesh blade = sweptSurface(line, rings);
    for (auto& position : blade.positions)
        position.x() *= float(0.5 * form.width / kBladeHalfThickness);
    computeNormals(blade);
    return blade;
}

TriangleMesh superellipsoid(const Vec3& p_F_centre, const Vec3& radii, double exponent)
{
    TriangleMesh mesh;
    const auto add = [&](const Vec3& direction) {
        const double size = std::pow(std::pow(std::abs(direction.x()) / radii.x(), exponent)
                                         + std::pow(std::abs(direction.y()) / radii.y(), exponent)
                                         + std::pow(std::abs(direction.z()) / radii.z(), exponent),
                                     -1.0 / exponent);
        mesh.positions.push_back((p_F_centre + size * direction).cast<float>());
    };
    add(Vec3::UnitY());
    for (std::uint32_t band = 1; band < kBands; ++band)
        for (std::uint32_t sector = 0; sector < kSectors; ++sector) {
            const double polar = std::numbers::pi * band / kBands;
            const double around = 2.0 * std::numbers::pi * sector / kSectors;
            // By the shape's own proportions, so that its corners are as dense as its faces.
            add(Vec3{radii.x() * std::sin(polar) * std::sin(around), radii.y() * std::cos(polar),
                     radii.z() * std::sin(polar) * std::cos(around)});
        }
    add(-Vec3::UnitY());
    const auto corner = [](std::uint32_t band, std::uint32_t sector) {
        return 1 + (band - 1) * kSectors + sector % kSectors;
    };
    const std::uint32_t last = corner(kBands - 1, kSectors - 1) + 1;
    for (std::uint32_t sector = 0; sector < kSectors; ++sector) {
        mesh.triangles.push_back({0, corner(1, sector), corner(1, sector + 1)});
        for (std::uint32_t band = 1; band + 1 < kBands; ++band) {
            mesh.triangles.push_back(
                {corner(band, sector), corner(band + 1, sector), corner(band, sector + 1)});
            mesh.triangles.push_back(
                {corner(band, sector + 1), corner(band + 1, sector), corner(band + 1, sector + 1)});
        }
        mesh.triangles.push_back(
            {corner(kBands - 1, sector + 1), corner(kBands - 1, sector), last});
    }
    computeNormals(mesh);
    return mesh;
}

const FigureShapes& figureShapes()
{
    static const FigureShapes shapes{.head = keptMesh(madeHead()),
                                     .visor =
                                         keptMesh(superellipsoid(kVisorCentre, kVisorRadii, kBoxy)),
                                     .gaze = keptMesh(arrow(0.04, kGazeLength)),
                                     .hand = keptMesh(madeHand()),
                                     .stylus = keptMesh(madeStylus()),
                                     .ray = keptMesh(arrow(0.01, kRayLength)),
                                     .handle = keptMesh(madeHandle())};
    return shapes;
}

} // namespace carina
