#include "engine/lungs/displacement_mode.h"

#include "engine/core/expects.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

// Amplitudes as shares of the lung's height, about 0.25 m in an adult.
constexpr double kDescent = 0.075;
constexpr double kRibLift = 0.018; // forward, and as much upward near the apex
constexpr double kRibFlare = 0.008;
/// How much less the diaphragm descends in front than at the back.
constexpr double kFrontLag = 0.3;
/// Share of the width beyond which the mediastinum no longer holds the lung.
constexpr double kMedialReach = 0.35;
/// Shares of the height below the apex from which all of the diaphragm (its domes rise into the
/// lung) and all ribs take part.
constexpr double kDomeDepth = 0.75;
constexpr double kRibDepth = 0.5;
/// Radius around the hilum that hardly moves, as a share of the height.
constexpr double kHilumRadius = 0.10;

/// A scalar of position together with its gradient.
struct Graded {
    double value;
    Vec3 gradient;

    friend Graded operator*(const Graded& a, const Graded& b)
    {
        return {a.value * b.value, a.value * b.gradient + b.value * a.gradient};
    }
};

/// t^2 (3 - 2 t), held at 0 and 1 outside.
Graded smoothStep(const Graded& x)
{
    const double t = std::clamp(x.value, 0.0, 1.0);
    return {t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t) * x.gradient};
}

/// 0 at the origin of `offset`, with zero slope, and 1 far from it.
Graded awayFrom(const Vec3& offset, double radius)
{
    const double near = std::exp(-0.5 * offset.squaredNorm() / (radius * radius));
    return {1.0 - near, near / (radius * radius) * offset};
}

Graded scaled(double k, const Graded& x) { return {k * x.value, k * x.gradient}; }

Graded lessThanOneBy(const Graded& x) { return {1.0 - x.value, -x.gradient}; }

void addAlong(const Vec3& direction, const Graded& x, Displacement& sum)
{
    sum.d_A += x.value * direction;
    sum.gradient += direction * x.gradient.transpose();
}

Mat3 cofactor(const Mat3& a)
{
    Mat3 c;
    c.col(0) = a.col(1).cross(a.col(2));
    c.col(1) = a.col(2).cross(a.col(0));
    c.col(2) = a.col(0).cross(a.col(1));
    return c;
}

} // namespace

DisplacementMode::DisplacementMode(const Box& lung_A, Side side, const Vec3& p_AH)
    : m_lung_A{lung_A},
      m_outward_A{side == Side::Left ? Vec3::UnitX() : Vec3{-Vec3::UnitX()}},
      m_medial_x{side == Side::Left ? lung_A.min.x() : lung_A.max.x()},
      m_p_AH{p_AH}
{
    CARINA_EXPECTS((lung_A.size().array() > 0.0).all());
}

Displacement DisplacementMode::at(const Vec3& p_A) const
{
    const Vec3 size = m_lung_A.size();
    const Vec3 up = Vec3::UnitZ();
    const Vec3 forward = -Vec3::UnitY();
    // Shares of the box: below the apex, in front of the back, lateral of the mediastinum.
    const Graded below{(m_lung_A.max.z() - p_A.z()) / size.z(), -up / size.z()};
    const Graded front{(m_lung_A.max.y() - p_A.y()) / size.y(), forward / size.y()};
    const Graded lateral{(p_A.x() - m_medial_x) * m_outward_A.x() / size.x(),
                         m_outward_A / size.x()};

    const Graded free = smoothStep(scaled(1.0 / kMedialReach, lateral))
                        * awayFrom(p_A - m_p_AH, kHilumRadius * size.z());
    const Graded depth = smoothStep(scaled(1.0 / kDomeDepth, below));
    const Graded descent = free * depth * depth * lessThanOneBy(scaled(kFrontLag, front));
    const Graded ribs = free * smoothStep(scaled(1.0 / kRibDepth, below));

    Displacement sum{Vec3::Zero(), Mat3::Zero()};
    addAlong(-kDescent * size.z() * up, descent, sum);
    addAlong(kRibLift * size.z() * forward, ribs * front, sum);
    addAlong(kRibLift * size.z() * up, ribs * front * lessThanOneBy(below), sum);
    addAlong(kRibFlare * size.z() * m_outward_A, ribs * lateral, sum);
    return sum;
}

DeformableMesh makeDeformable(const TriangleMesh& mesh_A, const DisplacementMode& mode)
{
    CARINA_EXPECTS(mesh_A.normals.size() == mesh_A.positions.size());
    DeformableMesh out;
    out.rest = mesh_A;
    out.displacement.reserve(mesh_A.positions.size());
    out.normalLinear.reserve(mesh_A.positions.size());
    out.normalQuadratic.reserve(mesh_A.positions.size());
    for (std::size_t i = 0; i < mesh_A.positions.size(); ++i) {
        const Displacement there = mode.at(mesh_A.positions[i].cast<double>());
        const Mat3& a = there.gradient;
        const Vec3 n0 = mesh_A.normals[i].cast<double>();
        out.displacement.emplace_back(there.d_A.cast<float>());
        out.normalLinear.emplace_back((a.trace() * n0 - a.transpose() * n0).cast<float>());
        out.normalQuadratic.emplace_back((cofactor(a) * n0).cast<float>());
    }
    return out;
}

} // namespace carina
