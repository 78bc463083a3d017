#include "engine/geometry/mesh/mesh_winding.h"

#include "engine/geometry/mesh/mesh_edges.h"

#include <numeric>

namespace carina
{
namespace
{

/// Two triangles that share an edge no third one uses.
struct Neighbour {
    std::uint32_t triangle;
    bool agrees; ///< the two run along the edge in opposite directions
};

std::vector<std::vector<Neighbour>> neighboursAcrossEdges(const TriangleMesh& mesh)
{
    std::vector<std::vector<Neighbour>> neighbours(mesh.triangles.size());
    forEachEdge(sortedEdgeUses(mesh), [&](EdgeUseIterator first, EdgeUseIterator last) {
        if (last - first != 2)
            return;
        const EdgeUse& a = *first;
        const EdgeUse& b = *std::next(first);
        neighbours[a.triangle].push_back({b.triangle, a.forward != b.forward});
        neighbours[b.triangle].push_back({a.triangle, a.forward != b.forward});
    });
    return neighbours;
}

void turn(Triangle& t) { std::swap(t[1], t[2]); }

/// For every triangle the first triangle of the part that hangs together with it by edges.
class Parts
{
public:
    explicit Parts(const TriangleMesh& mesh) : m_parent(mesh.triangles.size())
    {
        std::iota(m_parent.begin(), m_parent.end(), 0U);
        forEachEdge(sortedEdgeUses(mesh), [&](EdgeUseIterator first, EdgeUseIterator last) {
            for (auto it = std::next(first); it != last; ++it)
                join(first->triangle, it->triangle);
        });
    }

    std::uint32_t of(std::uint32_t triangle)
    {
        while (m_parent[triangle] != triangle)
            triangle = m_parent[triangle] = m_parent[m_parent[triangle]];
        return triangle;
    }

private:
    void join(std::uint32_t a, std::uint32_t b)
    {
        const auto [low, high] = std::minmax({of(a), of(b)});
        m_parent[high] = low;
    }

    std::vector<std::uint32_t> m_parent;
};

double tetrahedronVolume(const TriangleMesh& mesh, const Triangle& t, const Vec3f& apex)
{
    const Vec3 a = (mesh.positions[t[0]] - apex).cast<double>();
    const Vec3 b = (mesh.positions[t[1]] - apex).cast<double>();
    const Vec3 c = (mesh.positions[t[2]] - apex).cast<double>();
    return a.dot(b.cross(c)) / 6.0;
}

} // namespace

bool isClosed(const TriangleMesh& mesh)
{
    bool closed = !mesh.empty();
    forEachEdge(sortedEdgeUses(mesh), [&](EdgeUseIterator first, EdgeUseIterator last) {
        closed = closed && excessForward(first, last) == 0;
    });
    return closed;
}

TriangleMesh consistentlyWound(const TriangleMesh& mesh)
{
    enum class Winding : std::uint8_t { Unknown, Kept, Turned };
    const auto neighbours = neighboursAcrossEdges(mesh);
    std::vector<Winding> winding(mesh.triangles.size(), Winding::Unknown);
    TriangleMesh result{mesh.positions, {}, mesh.triangles};
    for (std::uint32_t seed = 0; seed < mesh.triangles.size(); ++seed) {
        if (winding[seed] != Winding::Unknown)
            continue;
        winding[seed] = Winding::Kept;
        std::vector<std::uint32_t> patch{seed};
        for (std::size_t i = 0; i < patch.size(); ++i) {
            for (const auto& [triangle, agrees] : neighbours[patch[i]]) {
                if (winding[triangle] != Winding::Unknown)
                    continue;
                const bool kept = (winding[patch[i]] == Winding::Kept) == agrees;
                winding[triangle] = kept ? Winding::Kept : Winding::Turned;
                patch.push_back(triangle);
            }
        }
        const auto isTurned = [&](std::uint32_t t) { return winding[t] == Winding::Turned; };
        const auto turned = std::count_if(patch.begin(), patch.end(), isTurned);
        const bool turnsKept = 2 * turned > static_cast<std::ptrdiff_t>(patch.size());
        for (const std::uint32_t t : patch)
            if (isTurned(t) != turnsKept)
                turn(result.triangles[t]);
    }
    return result;
}

TriangleMesh facingOutward(const TriangleMesh& mesh)
{
    Parts parts{mesh};
    std::vector<double> volume(mesh.triangles.size(), 0.0);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const std::uint32_t part = parts.of(i);
        const Vec3f& apex = mesh.positions[mesh.triangles[part][0]];
        volume[part] += tetrahedronVolume(mesh, mesh.triangles[i], apex);
    }
    TriangleMesh result{mesh.positions, {}, mesh.triangles};
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i)
        if (volume[parts.of(i)] < 0.0)
            turn(result.triangles[i]);
    return result;
}

} // namespace carina
