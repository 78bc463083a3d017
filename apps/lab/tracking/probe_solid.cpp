#include "apps/lab/tracking/probe_solid.h"

#include "engine/anatomy/shapes/surface_mesher.h"

#include <algorithm>
#include <bit>

namespace carina::lab
{
namespace
{

// Metres.
constexpr double kRod = 4.0e-3;
constexpr double kSeatRadius = 6.0e-3;
constexpr double kSeatHeight = 4.0e-3;
constexpr double kBore = 3.2e-3;
constexpr double kCoreShare = 0.3; ///< of the mean distance of the markers from their middle
constexpr double kLeastCore = 9.0e-3;
constexpr double kFillet = 2.0e-3;
constexpr Length kVoxel = millimetres(1.5);
constexpr std::size_t kStlHeader = 80;

/// A disc across a normal, whose face is at p and which lies below it.
double discDistance(const Vec3& q, const Vec3& p, const Vec3& normal)
{
    const double along = (q - p).dot(normal);
    const double off = (q - p - along * normal).norm();
    return std::max({off - kSeatRadius, along, -along - kSeatHeight});
}

void putStl(std::string& bytes, std::uint32_t value, int count)
{
    for (int i = 0; i < count; ++i)
        bytes.push_back(static_cast<char>((value >> (8 * i)) & 0xFFU));
}

void putStl(std::string& bytes, const Vec3f& v)
{
    for (const float each : v)
        putStl(bytes, std::bit_cast<std::uint32_t>(each), 4);
}

} // namespace

TriangleMesh solidOf(const Probe& probe, Length seat)
{
    struct Arm {
        Vec3 foot; ///< of its seat
        Vec3 face;
        Vec3 normal;
    };
    const double share = 1.0 / double(probe.markers.size());
    Vec3 middle = Vec3::Zero();
    for (const ToolMarker& marker : probe.markers)
        middle += share * marker.p_OQ;
    std::vector<Arm> arms;
    Box bounds;
    double core = 0.0;
    for (const ToolMarker& marker : probe.markers) {
        const Vec3 out = marker.normal_O.isZero() ? (marker.p_OQ - middle) : marker.normal_O;
        const Vec3 normal = out.isZero() ? Vec3{Vec3::UnitZ()} : Vec3{out.normalized()};
        const Vec3 face = marker.p_OQ - seat.si * normal;
        arms.push_back({face - kSeatHeight / 2.0 * normal, face, normal});
        core += share * kCoreShare * (marker.p_OQ - middle).norm();
        bounds.include(face);
    }
    core = std::max(core, kLeastCore);
    bounds.include(middle);
    const Vec3 around = Vec3::Constant(core + kSeatRadius + kSeatHeight);
    bounds.include(Vec3{bounds.min - around});
    bounds.include(Vec3{bounds.max + around});
    return meshOf(
        {bounds,
         [=](const Vec3& q) {
             double distance = (q - middle).norm() - core;
             for (const Arm& arm : arms) {
                 distance =
                     roundedMin(distance, rodDistance(q, middle, arm.foot, kRod, kRod), kFillet);
             }
             for (const Arm& arm : arms) // nothing above a seat
                 distance =
                     std::min(std::max(distance, -std::max({(q - arm.face).norm() - kSeatRadius,
                                                            -(q - arm.face).dot(arm.normal)})),
                              discDistance(q, arm.face, arm.normal));
             const Vec3 from = q - middle;
             const double bore = std::max(Vec3{from.x(), from.y(), 0.0}.norm() - kBore, from.z());
             return std::max(distance, -bore);
         }},
        kVoxel);
}

std::string stlOf(const TriangleMesh& mesh_O, const std::string& name)
{
    std::string bytes = "Carina, millimetres: " + name;
    bytes.resize(kStlHeader, ' ');
    putStl(bytes, std::uint32_t(mesh_O.triangles.size()), 4);
    for (const Triangle& triangle : mesh_O.triangles) {
        std::array<Vec3f, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = 1e3F * mesh_O.positions[triangle[i]];
        putStl(bytes,
               Vec3f{(corners[1] - corners[0]).cross(corners[2] - corners[0]).stableNormalized()});
        for (const Vec3f& corner : corners)
            putStl(bytes, corner);
        putStl(bytes, 0, 2);
    }
    return bytes;
}

} // namespace carina::lab
