#include "engine/anatomy/detail.h"

#include "engine/core/expects.h"
#include "engine/geometry/mesh/mesh_edges.h"
#include "engine/geometry/mesh/mesh_winding.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <meshoptimizer.h>

#include <utility>

namespace carina
{

namespace
{

/// Fewer triangles than this no longer show what a part is, and cost nothing to draw.
constexpr std::size_t kFewestTriangles = 64;

/// No limit of the error: only the target number of triangles ends the simplification.
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

struct Simplified {
    TriangleMesh mesh;
    double deviation;
};

Simplified simplified(const TriangleMesh& mesh, std::size_t triangles)
{
    TriangleMesh coarse;
    float shareOfExtent = 0.0F;
    coarse.positions = mesh.positions;
    coarse.triangles.resize(mesh.triangles.size());
    const std::size_t corners = meshopt_simplify(
        cornersOf(coarse.triangles), cornersOf(mesh.triangles), 3 * mesh.triangles.size(),
        mesh.positions.front().data(), mesh.positions.size(), sizeof(Vec3f), 3 * triangles,
        kAnyError, 0, &shareOfExtent);
    coarse.triangles.resize(corners / 3);
    const float extent =
        meshopt_simplifyScale(mesh.positions.front().data(), mesh.positions.size(), sizeof(Vec3f));
    return {std::move(coarse), double{shareOfExtent} * double{extent}};
}

/// Removes pairs of triangles on the same three vertices that face opposite ways.
void cancelOpposites(std::vector<Triangle>& triangles)
{
    const auto turned = [](Triangle t, bool over) {
        if (over)
            std::swap(t[1], t[2]);
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        return t;
    };
    std::map<Triangle, int> uses;
    for (const Triangle& t : triangles)
        ++uses[turned(t, false)];
    std::erase_if(triangles, [&](const Triangle& t) {
        const auto opposite = uses.find(turned(t, true));
        return opposite != uses.end() && opposite->second == 1 && uses[turned(t, false)] == 1;
    });
}

/// A union-find structure: which corners of triangles are the same vertex.
class CornerGroups
{
public:
    explicit CornerGroups(std::size_t corners)
    {
        m_parent.reserve(corners);
        for (std::size_t i = 0; i < corners; ++i)
            m_parent.push_back(i);
    }

    [[nodiscard]] std::size_t groupOf(std::size_t corner)
    {
        while (m_parent[corner] != corner)
            corner = m_parent[corner] = m_parent[m_parent[corner]];
        return corner;
    }

    void join(std::size_t a, std::size_t b) { m_parent[groupOf(a)] = groupOf(b); }

private:
    std::vector<std::size_t> m_parent;
};

std::size_t cornerAt(const TriangleMesh& mesh, std::uint32_t triangle, std::uint32_t vertex)
{
    const Triangle& t = mesh.triangles[triangle];
    return 3 * std::size_t{triangle}
           + std::size_t(std::find(t.begin(), t.end(), vertex) - t.begin());
}

/// The mesh with a vertex of its own for every fan of triangles that hang together across edges of
/// two, so that sheets no longer share the edges at which they touch.
TriangleMesh withFansApart(const TriangleMesh& mesh)
{
    CornerGroups groups{3 * mesh.triangles.size()};
    forEachEdge(sortedEdgeUses(mesh), [&](EdgeUseIterator first, EdgeUseIterator last) {
        if (last - first != 2)
            return;
        for (const std::uint32_t vertex : {first->low, first->high})
            groups.join(cornerAt(mesh, first->triangle, vertex),
                        cornerAt(mesh, std::next(first)->triangle, vertex));
    });
    TriangleMesh apart;
    constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> vertexOfGroup(3 * mesh.triangles.size(), kNone);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        Triangle t{};
        for (std::size_t k = 0; k < 3; ++k) {
            std::uint32_t& vertex = vertexOfGroup[groups.groupOf(3 * i + k)];
            if (vertex == kNone) {
                vertex = std::uint32_t(apart.positions.size());
                apart.positions.push_back(mesh.positions[mesh.triangles[i][k]]);
            }
            t[k] = vertex;
        }
        apart.triangles.push_back(t);
    }
    return apart;
}

bool sheetsTouch(const TriangleMesh& mesh)
{
    bool touch = false;
    forEachEdge(sortedEdgeUses(mesh), [&touch](EdgeUseIterator first, EdgeUseIterator last) {
        touch = touch || last - first > 2;
    });
    return touch;
}

/// Separates sheets of a thin part that a collapse brought into contact along an edge, unless this
/// would open a closed surface.
void partTouchingSheets(TriangleMesh& mesh)
{
    if (!sheetsTouch(mesh))
        return;
    cancelOpposites(mesh.triangles);
    TriangleMesh apart = withFansApart(mesh);
    if (isClosed(apart) || !isClosed(mesh))
        mesh = std::move(apart);
    cancelOpposites(mesh.triangles);
}

} // namespace

LevelsOfDetail levelsOfDetail(TriangleMesh finest, std::span<const double> shares)
{
    for (const Triangle& t : finest.triangles)
        CARINA_EXPECTS(std::max({t[0], t[1], t[2]}) < finest.positions.size());
    joinEqualPositions(finest);
    if (finest.empty())
        return {std::vector<TriangleMesh>(1 + shares.size()),
                std::vector<double>(1 + shares.size(), 0.0)};
    finish(finest);
    const std::size_t whole = finest.triangles.size();
    LevelsOfDetail levels;
    levels.meshes.push_back(std::move(finest));
    levels.deviations.push_back(0.0);
    double share = 1.0;
    for (const double next : shares) {
        CARINA_EXPECTS(next > 0.0 && next <= share);
        share = next;
        const auto wanted = static_cast<std::size_t>(std::lround(share * double(whole)));
        const TriangleMesh& finer = levels.meshes.back();
        auto [level, deviation] =
            simplified(finer, std::min(std::max(wanted, kFewestTriangles), finer.triangles.size()));
        partTouchingSheets(level);
        finish(level);
        levels.meshes.push_back(std::move(level));
        levels.deviations.push_back(levels.deviations.back() + deviation);
    }
    return levels;
}

} // namespace carina
