#include "evaluation/anatomy/surface_distance.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

/// Calls visit(p, area) with the middle of each of n * n equal pieces of a triangle: rows of pieces
/// that stand upright and, between them, pieces on their head.
template <class Visit> void forEachPiece(const Corners& t, int n, const Visit& visit)
{
    const Vec3 ab = (t.b - t.a) / n;
    const Vec3 ac = (t.c - t.a) / n;
    const double area = 0.5 * ab.cross(ac).norm();
    for (int i = 0; i < n; ++i) {
        for (int k = 0; i + k < n; ++k) {
            const Vec3 corner = t.a + i * ab + k * ac;
            visit(Vec3{corner + (ab + ac) / 3.0}, area);
            if (i + k + 1 < n)
                visit(Vec3{corner + (ab + ac) * (2.0 / 3.0)}, area);
        }
    }
}

} // namespace

Length meanDistance(const TriangleMesh& from, const SurfaceTree& to, Length spacing)
{
    CARINA_EXPECTS(spacing.si > 0.0);
    double area = 0.0;
    double moment = 0.0;
    for (const Triangle& triangle : from.triangles) {
        const Corners t = cornersOf(from, triangle);
        const double longest =
            std::max({(t.b - t.a).norm(), (t.c - t.a).norm(), (t.c - t.b).norm()});
        const int n = std::max(1, int(std::ceil(longest / spacing.si)));
        forEachPiece(t, n, [&](const Vec3& p, double piece) {
            moment += piece * to.distanceTo(p);
            area += piece;
        });
    }
    CARINA_EXPECTS(area > 0.0);
    return metres(moment / area);
}

} // namespace carina
