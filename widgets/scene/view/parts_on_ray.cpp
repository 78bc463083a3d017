#include "widgets/scene/view/parts_on_ray.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace carina
{
namespace
{

constexpr double kFarthestMoved = 0.1; ///< metres, of a vertex by breathing and jaw
constexpr double kParallel = 1e-12;

/// Distance along a ray, and the weights of a triangle's corners there.
struct Hit {
    double distance = 0.0;
    std::array<double, 3> weights{};
};

std::optional<Hit> hitOf(const std::array<Vec3, 3>& corners, const SightRay& ray)
{
    const Vec3 first = corners[1] - corners[0];
    const Vec3 second = corners[2] - corners[0];
    const Vec3 across = ray.dir_A.cross(second);
    const double determinant = first.dot(across);
    if (!(std::abs(determinant) > kParallel * first.norm() * second.norm()))
        return std::nullopt; // nor a triangle without an area
    const Vec3 way = ray.p_A_eye - corners[0];
    const double u = way.dot(across) / determinant;
    const Vec3 around = way.cross(first);
    const double v = ray.dir_A.dot(around) / determinant;
    const double distance = second.dot(around) / determinant;
    if (u < 0.0 || v < 0.0 || u + v > 1.0 || distance <= 0.0)
        return std::nullopt;
    return Hit{distance, {1.0 - u - v, u, v}};
}

/// Whether a ray may meet a part at all: it comes near the ball around it.
bool comesNear(const ScenePart& part, const PlacedBody& place, const SightRay& ray)
{
    const Box bounds = boundsOf(*part.levels.back());
    if (bounds.empty())
        return false;
    const Vec3 way = place.at(bounds.centre()) - ray.p_A_eye;
    const double reach = place.scale * (0.5 * bounds.size().norm() + kFarthestMoved);
    return way.cross(ray.dir_A).norm() <= reach && way.dot(ray.dir_A) >= -reach;
}

std::optional<PartOnRay> firstHit(const ScenePart& part, const SceneFrame& frame,
                                  const std::optional<Section>& section, const SightRay& ray)
{
    const auto placed = placeOf(frame, part.body, part.liftedWith);
    if (!placed || !comesNear(part, *placed, ray))
        return std::nullopt;
    const TriangleMesh& mesh = *part.levels.back();
    std::vector<Vec3> corners_A;
    corners_A.reserve(mesh.positions.size());
    for (const Vec3f& p_F : mesh.positions)
        corners_A.push_back(*drawnAt(part, p_F.cast<double>(), frame));
    std::optional<PartOnRay> nearest;
    for (const Triangle& t : mesh.triangles) {
        const auto hit = hitOf({corners_A[t[0]], corners_A[t[1]], corners_A[t[2]]}, ray);
        if (!hit || (nearest && hit->distance >= nearest->distance)
            || isCutAway(part, ray.p_A_eye + hit->distance * ray.dir_A, section))
            continue;
        nearest.emplace().distance = hit->distance;
        nearest->place.weights = hit->weights;
        for (std::size_t i = 0; i < 3; ++i)
            nearest->place.corners_F[i] = mesh.positions[t[i]].cast<double>();
    }
    return nearest;
}

bool isFaint(const ScenePart& part)
{
    return part.group == MaterialGroup::Skin || part.group == MaterialGroup::Ghost;
}

} // namespace

std::vector<PartOnRay> partsOnRay(std::span<const ScenePart> shown, const SceneFrame& frame,
                                  const std::optional<Section>& section, const SightRay& ray)
{
    std::vector<PartOnRay> met;
    for (std::size_t i = 0; i < shown.size(); ++i)
        if (auto hit = firstHit(shown[i], frame, section, ray)) {
            hit->part = i;
            met.push_back(*hit);
        }
    std::ranges::sort(met, {}, [&](const PartOnRay& hit) {
        return std::tuple{isFaint(shown[hit.part]), hit.distance};
    });
    return met;
}

SightRay rayThrough(const QPointF& point, const SceneSight& sight)
{
    const Vec3 forward = (sight.pose.p_A_target - sight.pose.p_A_eye).normalized();
    const Vec3 right = forward.cross(sight.pose.up_A).normalized();
    const Vec3 up = right.cross(forward);
    const Frustum& f = sight.frustum;
    const double x = f.left + point.x() * (f.right - f.left);
    const double y = f.top - point.y() * (f.top - f.bottom);
    return {sight.pose.p_A_eye, (forward + x * right + y * up).normalized()};
}

} // namespace carina
