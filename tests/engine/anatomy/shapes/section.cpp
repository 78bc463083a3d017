#include "tests/engine/anatomy/shapes/section.h"

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <numbers>

namespace carina::test
{

namespace
{

/// Adds the piece of outline that one triangle gives, with the solid on its left seen against the
/// normal. Distances of exactly 0 count as above.
void cut(const std::array<Vec3, 3>& corner, const Plane& plane, std::vector<Vec3>& outline)
{
    std::array<double, 3> height{};
    for (std::size_t k = 0; k < 3; ++k)
        height[k] = (corner[k] - plane.point).dot(plane.normal);
    std::array<Vec3, 2> ends;
    int found = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t n = (k + 1) % 3;
        if ((height[k] >= 0.0) == (height[n] >= 0.0))
            continue;
        const Vec3 p = corner[k] + height[k] / (height[k] - height[n]) * (corner[n] - corner[k]);
        ends[height[k] >= 0.0 ? 0U : 1U] = p;
        ++found;
    }
    if (found == 2)
        outline.insert(outline.end(), ends.begin(), ends.end());
}

} // namespace

Section sectionOf(const TriangleMesh& mesh, const Plane& plane)
{
    Section section;
    for (const Triangle& t : mesh.triangles) {
        cut({mesh.positions[t[0]].cast<double>(), mesh.positions[t[1]].cast<double>(),
             mesh.positions[t[2]].cast<double>()},
            plane, section.points);
    }
    Vec3 moment = Vec3::Zero();
    double twice = 0.0;
    for (std::size_t i = 0; i + 1 < section.points.size(); i += 2) {
        const Vec3 a = section.points[i] - plane.point;
        const Vec3 b = section.points[i + 1] - plane.point;
        const double wedge = a.cross(b).dot(plane.normal);
        twice += wedge;
        moment += wedge / 3.0 * (a + b);
    }
    section.area = std::abs(0.5 * twice);
    if (twice != 0.0)
        section.centroid = plane.point + moment / twice;
    return section;
}

double windingNumber(const TriangleMesh& mesh, const Vec3& p)
{
    double angle = 0.0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3 a = mesh.positions[t[0]].cast<double>() - p;
        const Vec3 b = mesh.positions[t[1]].cast<double>() - p;
        const Vec3 c = mesh.positions[t[2]].cast<double>() - p;
        const double la = a.norm();
        const double lb = b.norm();
        const double lc = c.norm();
        angle += 2.0
                 * std::atan2(a.dot(b.cross(c)),
                              la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return angle / (4.0 * std::numbers::pi);
}

Vec3 directionOf(const std::vector<Vec3>& points, const Vec3& sense)
{
    Vec3 mean = Vec3::Zero();
    for (const Vec3& p : points)
        mean += p / double(points.size());
    Mat3 scatter = Mat3::Zero();
    for (const Vec3& p : points)
        scatter += (p - mean) * (p - mean).transpose();
    const Vec3 axis = Eigen::SelfAdjointEigenSolver<Mat3>{scatter}.eigenvectors().col(2);
    return axis.dot(sense) < 0.0 ? Vec3{-axis} : axis;
}

} // namespace carina::test
