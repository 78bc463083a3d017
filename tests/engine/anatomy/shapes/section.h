#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"

namespace carina::test
{

/// A plane in the frame of a mesh.
struct Plane {
    Vec3 point;
    Vec3 normal; ///< unit length
};

/// Where a plane cuts a closed mesh.
struct Section {
    double area = 0.0;
    Vec3 centroid = Vec3::Zero();
    std::vector<Vec3> points; ///< on the outline
};

/// The section, its area and centroid by Green's theorem on the outline.
Section sectionOf(const TriangleMesh& mesh, const Plane& plane);

/// How often a closed mesh winds around a point: 1 inside, 0 outside, from the solid angles of its
/// triangles (van Oosterom and Strackee 1983).
double windingNumber(const TriangleMesh& mesh, const Vec3& p);

/// Direction of the straight line that fits points best: the main axis of their scatter, turned
/// towards `sense`.
Vec3 directionOf(const std::vector<Vec3>& points, const Vec3& sense);

} // namespace carina::test
