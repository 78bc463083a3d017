#include "evaluation/anatomy/mesh_outline.h"

#include <algorithm>
#include <map>
#include <utility>

namespace carina
{
namespace
{

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// A plane's piece of outline in one triangle leads from the point on one edge to that on another.
struct Pieces {
    std::map<Edge, Vec3> points;
    std::multimap<Edge, Edge> next;
};

Pieces piecesOf(const TriangleMesh& mesh, const Vec3& p, const Vec3& normal)
{
    std::vector<double> height;
    for (const Vec3f& q : mesh.positions)
        height.push_back((q.cast<double>() - p).dot(normal));
    Pieces pieces;
    for (const Triangle& t : mesh.triangles) {
        Edge up;
        Edge down;
        int crossings = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k];
            const std::uint32_t b = t[(k + 1) % 3];
            if ((height[a] < 0.0) == (height[b] < 0.0))
                continue;
            ++crossings;
            const Edge edge = std::minmax(a, b);
            (height[a] < 0.0 ? up : down) = edge;
            const double share = height[edge.first] / (height[edge.first] - height[edge.second]);
            const Vec3 from = mesh.positions[edge.first].cast<double>();
            const Vec3 to = mesh.positions[edge.second].cast<double>();
            pieces.points.insert({edge, from + share * (to - from)});
        }
        if (crossings == 2)
            pieces.next.insert({up, down});
    }
    return pieces;
}

void measure(Outline& outline, const Vec3& normal)
{
    const Vec3 origin = outline.points.front();
    Vec3 moment = Vec3::Zero();
    double twice = 0.0;
    for (std::size_t i = 0; i < outline.points.size(); ++i) {
        const Vec3 a = outline.points[i] - origin;
        const Vec3 b = outline.points[(i + 1) % outline.points.size()] - origin;
        const double cross = a.cross(b).dot(normal);
        twice += cross;
        moment += cross * (a + b);
    }
    outline.area = 0.5 * std::abs(twice);
    outline.centroid = origin;
    if (twice != 0.0)
        outline.centroid += moment / (3.0 * twice);
}

} // namespace

double Outline::extentAlong(const Vec3& direction) const
{
    const auto along = [&](const Vec3& p) { return p.dot(direction); };
    const auto [least, most] = std::ranges::minmax(points, {}, along);
    return along(most) - along(least);
}

std::vector<Outline> outlinesOf(const TriangleMesh& mesh, const Vec3& p, const Vec3& normal)
{
    Pieces pieces = piecesOf(mesh, p, normal);
    std::vector<Outline> outlines;
    while (!pieces.next.empty()) {
        const Edge start = pieces.next.begin()->first;
        Outline outline;
        Edge at = start;
        for (auto step = pieces.next.find(at); step != pieces.next.end();
             step = pieces.next.find(at)) {
            outline.points.push_back(pieces.points.at(at));
            at = step->second;
            pieces.next.erase(step);
        }
        if (at != start)
            continue;
        measure(outline, normal);
        outlines.push_back(std::move(outline));
    }
    return outlines;
}

} // namespace carina
