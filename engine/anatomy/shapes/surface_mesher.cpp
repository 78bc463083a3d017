#include "engine/anatomy/shapes/surface_mesher.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <openvdb/openvdb.h>
#include <openvdb/tools/SignedFloodFill.h>
#include <openvdb/tools/VolumeToMesh.h>

namespace carina
{

namespace
{

using Leaf = openvdb::FloatTree::LeafNodeType;

/// Distances are kept this many voxels to either side of the surface.
constexpr double kBandInVoxels = 3.0;
/// The steepest an Implicit may be.
constexpr double kSteepest = 2.0;

/// Whether no surface can run through a block of the grid, judged from the distance at its centre.
bool awayFromSurface(const Implicit& distance, const openvdb::Coord& origin, double voxel)
{
    constexpr double kHalf = 0.5 * Leaf::DIM;
    const Vec3 centre = voxel
                        * (Vec3{double(origin.x()), double(origin.y()), double(origin.z())}
                           + Vec3::Constant(kHalf - 0.5));
    const double reach = std::numbers::sqrt3 * (kHalf + 1.0) * voxel;
    return std::abs(distance(centre)) > kSteepest * reach;
}

void sampleBlock(openvdb::FloatGrid& grid, const Implicit& distance, const openvdb::Coord& origin,
                 double voxel)
{
    const double band = kBandInVoxels * voxel;
    Leaf* leaf = grid.tree().touchLeaf(origin);
    for (openvdb::Index i = 0; i < Leaf::SIZE; ++i) {
        const openvdb::Coord at = leaf->offsetToGlobalCoord(i);
        const double d = distance(voxel * Vec3{double(at.x()), double(at.y()), double(at.z())});
        leaf->setValueOn(i, float(std::clamp(d, -band, band)));
    }
}

openvdb::FloatGrid::Ptr sampled(const ImplicitShape& shape, double voxel)
{
    auto grid = openvdb::FloatGrid::create(float(kBandInVoxels * voxel));
    grid->setTransform(openvdb::math::Transform::createLinearTransform(voxel));
    constexpr int kDim = Leaf::DIM;
    const auto firstBlock = [voxel](double x) { return int(std::floor(x / voxel / kDim)) * kDim; };
    const Vec3 margin = Vec3::Constant(kBandInVoxels * voxel);
    const Vec3 low = shape.bounds.min - margin;
    const Vec3 high = shape.bounds.max + margin;
    for (int x = firstBlock(low.x()); x * voxel < high.x(); x += kDim) {
        for (int y = firstBlock(low.y()); y * voxel < high.y(); y += kDim) {
            for (int z = firstBlock(low.z()); z * voxel < high.z(); z += kDim) {
                const openvdb::Coord origin{x, y, z};
                if (!awayFromSurface(shape.distance, origin, voxel))
                    sampleBlock(*grid, shape.distance, origin, voxel);
            }
        }
    }
    openvdb::tools::signedFloodFill(grid->tree());
    return grid;
}

/// From the place in the even grid to that in space. Nowhere does it lengthen, so the shape stays
/// as flat there as an Implicit has to be.
Vec3 drawnTogether(const FinePlace& fine, const Vec3& p_grid)
{
    const Vec3 from = p_grid - fine.p;
    const double r = from.norm();
    if (!(r > 0.0))
        return p_grid;
    const double nearer = (1.0 - fine.share) * fine.reach * -std::expm1(-r / fine.reach);
    return fine.p + (1.0 - nearer / r) * from;
}

/// The shape in the even grid.
ImplicitShape spread(const ImplicitShape& shape, const FinePlace& fine)
{
    const Vec3 most = Vec3::Constant((1.0 - fine.share) * fine.reach);
    return {{shape.bounds.min - most, shape.bounds.max + most},
            [distance = shape.distance, fine](const Vec3& p_grid) {
                return distance(drawnTogether(fine, p_grid));
            }};
}

} // namespace

TriangleMesh meshOf(const ImplicitShape& shape, Length voxel, const FinePlace& fine)
{
    CARINA_EXPECTS(voxel.si > 0.0 && !shape.bounds.empty());
    CARINA_EXPECTS(fine.share > 0.0 && fine.share <= 1.0 && fine.reach > 0.0);
    if (fine.share < 1.0) {
        TriangleMesh mesh = meshOf(spread(shape, fine), voxel);
        for (Vec3f& p : mesh.positions)
            p = drawnTogether(fine, p.cast<double>()).cast<float>();
        return mesh;
    }
    openvdb::initialize();
    std::vector<openvdb::Vec3s> points;
    std::vector<openvdb::Vec3I> threes;
    std::vector<openvdb::Vec4I> fours;
    openvdb::tools::volumeToMesh(*sampled(shape, voxel.si), points, threes, fours);
    TriangleMesh mesh;
    mesh.positions.reserve(points.size());
    for (const openvdb::Vec3s& p : points)
        mesh.positions.emplace_back(p.x(), p.y(), p.z());
    // Quads are cut along the shorter way.
    const auto squared = [&mesh](std::uint32_t a, std::uint32_t b) {
        return (mesh.positions[a] - mesh.positions[b]).squaredNorm();
    };
    for (const openvdb::Vec3I& t : threes)
        mesh.triangles.push_back({t[0], t[1], t[2]});
    for (const openvdb::Vec4I& q : fours) {
        const bool turn = squared(q[1], q[3]) < squared(q[0], q[2]);
        const std::array<std::uint32_t, 4> c{q[turn ? 1 : 0], q[turn ? 2 : 1], q[turn ? 3 : 2],
                                             q[turn ? 0 : 3]};
        mesh.triangles.push_back({c[0], c[1], c[2]});
        mesh.triangles.push_back({c[0], c[2], c[3]});
    }
    return mesh;
}

} // namespace carina
