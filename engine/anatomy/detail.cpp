#include "engine/anatomy/detail.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>
#include <meshoptimizer.h>
#include <utility>

namespace carina
{

namespace
{

/// Fewer triangles than this no longer show what a part is, and cost nothing to draw.
constexpr std::size_t kFewestTriangles = 64;

/// Collapse as far as the target asks: the number of triangles decides, not the error.
constexpr float kAnyError = 1.0F;

static_assert(sizeof(Triangle) == 3 * sizeof(unsigned int));
static_assert(sizeof(Vec3f) == 3 * sizeof(float));

const unsigned int* cornersOf(const std::vector<Triangle>& triangles)
{
    return triangles.empty() ? nullptr : triangles.front().data();
}

unsigned int* cornersOf(std::vector<Triangle>& triangles)
{
    return triangles.empty() ? nullptr : triangles.front().data();
}

void leaveOutRepeatedCorners(std::vector<Triangle>& triangles)
{
    std::erase_if(triangles,
                  [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
}

void joinEqualPositions(TriangleMesh& mesh)
{
    for (Vec3f& p : mesh.positions)
        p.array() += 0.0F; // -0 and 0 are the same place, but not the same bytes
    std::vector<unsigned int> remap(mesh.positions.size());
    const std::size_t joined = meshopt_generateVertexRemap(
        remap.data(), cornersOf(mesh.triangles), 3 * mesh.triangles.size(), mesh.positions.data(),
        mesh.positions.size(), sizeof(Vec3f));
    std::vector<Vec3f> positions(joined);
    meshopt_remapVertexBuffer(positions.data(), mesh.positions.data(), mesh.positions.size(),
                              sizeof(Vec3f), remap.data());
    meshopt_remapIndexBuffer(cornersOf(mesh.triangles), cornersOf(mesh.triangles),
                             3 * mesh.triangles.size(), remap.data());
    mesh.positions = std::move(positions);
    leaveOutRepeatedCorners(mesh.triangles);
}

/// Orders triangles and vertices for drawing, drops vertices nothing uses, and makes normals.
void finish(TriangleMesh& mesh)
{
    const std::size_t corners = 3 * mesh.triangles.size();
    meshopt_optimizeVertexCache(cornersOf(mesh.triangles), cornersOf(mesh.triangles), corners,
                                mesh.positions.size());
    const std::size_t used =
        meshopt_optimizeVertexFetch(mesh.positions.data(), cornersOf(mesh.triangles), corners,
                                    mesh.positions.data(), mesh.positions.size(), sizeof(Vec3f));
    mesh.positions.resize(used);
    computeNormals(mesh);
}

TriangleMesh simplified(const TriangleMesh& mesh, std::size_t triangles)
{
    TriangleMesh coarse;
    coarse.positions = mesh.positions;
    coarse.triangles.resize(mesh.triangles.size());
    const std::size_t corners = meshopt_simplify(
        cornersOf(coarse.triangles), cornersOf(mesh.triangles), 3 * mesh.triangles.size(),
        mesh.positions.front().data(), mesh.positions.size(), sizeof(Vec3f), 3 * triangles,
        kAnyError, 0, nullptr);
    coarse.triangles.resize(corners / 3);
    return coarse;
}

} // namespace

std::vector<TriangleMesh> levelsOfDetail(TriangleMesh finest, std::span<const double> shares)
{
    for (const Triangle& t : finest.triangles)
        CARINA_EXPECTS(std::max({t[0], t[1], t[2]}) < finest.positions.size());
    joinEqualPositions(finest);
    if (finest.empty())
        return std::vector<TriangleMesh>(1 + shares.size());
    finish(finest);
    const std::size_t whole = finest.triangles.size();
    std::vector<TriangleMesh> levels{std::move(finest)};
    double share = 1.0;
    for (const double next : shares) {
        CARINA_EXPECTS(next > 0.0 && next <= share);
        share = next;
        const auto wanted = static_cast<std::size_t>(std::lround(share * double(whole)));
        const TriangleMesh& finer = levels.back();
        TriangleMesh level =
            simplified(finer, std::min(std::max(wanted, kFewestTriangles), finer.triangles.size()));
        finish(level);
        levels.push_back(std::move(level));
    }
    return levels;
}

} // namespace carina
