#include "engine/geometry/mesh/mean_edge.h"

namespace carina
{

float meanEdge(std::span<const Triangle> triangles, std::span<const Vec3f> positions)
{
    float sum = 0.0F;
    for (const Triangle& t : triangles)
        sum += (positions[t[1]] - positions[t[0]]).norm();
    return triangles.empty() ? 0.0F : sum / static_cast<float>(triangles.size());
}

} // namespace carina
