#include "engine/anatomy/mouth/lip_shape.h"

#include "engine/anatomy/airway/jaw_hinge.h"
#include "engine/anatomy/shapes/strand.h"

#include <array>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

/// Written in reference millimetres (BodyPlan) from the edge of the upper incisors, of the closed
/// mouth and of its left half.

constexpr Length kLipVoxel = millimetres(1.6);
constexpr int kPieces = 3; ///< of a line between two of its points

/// From the midline to before the corner. The upper lip rises to the peaks of the cupid's bow.
const std::array kUpperLine{Vec3{0, -8.2, 6.4}, Vec3{5.5, -7.4, 7.8}, Vec3{14, -3.0, 5.0},
                            Vec3{20.5, 3.0, 0.6}};
const std::array kLowerLine{Vec3{0, -5.2, -8.4}, Vec3{6, -4.6, -8.5}, Vec3{14, -0.8, -7.7},
                            Vec3{20.5, 4.6, -6.4}};
const Vec3 kCorner{25.5, 10.2, -4.8};
/// At the points of a line, at the corner, and where the lip ends beyond it.
constexpr std::array kRadii{4.7, 4.8, 4.4, 3.6, 2.9, 2.3};

/// Beyond the corner a lip goes on down or up, for this share of the corner's way on the jaw, and a
/// little into the cheek.
constexpr double kBeyondCorner = 0.4;
const Vec3 kIntoCheek{0.8, 1.5, 0.0};

/// The lower end of the philtrum in the upper border of the lip.
double philtrum(const Vec3& p)
{
    return rodDistance(p, {0, -13.6, 9.5}, {0, -9.7, 14.0}, 2.6, 2.6);
}

/// A value for each point of smoothThrough(line, kPieces), straight between those given.
std::vector<double> between(const std::array<double, 6>& values)
{
    std::vector<double> all;
    for (std::size_t i = 0; i + 1 < values.size(); ++i)
        for (int k = 0; k < kPieces; ++k)
            all.push_back(std::lerp(values[i], values[i + 1], double(k) / kPieces));
    all.push_back(values.back());
    return all;
}

} // namespace

double Lips::Rod::distance(const Vec3& p_A) const
{
    return tubeDistance({std::abs(p_A.x()), p_A.y(), p_A.z()}, line_A, radii);
}

Box Lips::Rod::bounds() const
{
    Box box;
    for (std::size_t i = 0; i < line_A.size(); ++i)
        for (const double side : {1.0, -1.0}) {
            const Vec3 p_A{side * line_A[i].x(), line_A[i].y(), line_A[i].z()};
            box.include(p_A - Vec3::Constant(radii[i]));
            box.include(p_A + Vec3::Constant(radii[i]));
        }
    return box;
}

Lips::Lips(const BodyPlan& plan) : m_p_A_incisors(plan.landmarks.p_A_incisors), m_unit(plan.face)
{
    const RigidTransform jaw = heldJaw(plan);
    const Vec3 p_A_closed = plan.inFace(kCorner);
    const Vec3 p_A_onJaw = jaw * p_A_closed;
    m_p_A_corner = 0.5 * (p_A_closed + p_A_onJaw);
    const double beyond = kBeyondCorner * (p_A_onJaw - p_A_closed).z();
    /// The line goes to the corner the more, the nearer it is to it.
    const auto rod = [&](const std::array<Vec3, 4>& line, const RigidTransform& X, double along) {
        const Vec3 toCorner = m_p_A_corner - X * p_A_closed;
        std::vector<Vec3> points;
        for (const Vec3& p : line) {
            const double share = p.x() / kCorner.x();
            points.emplace_back(X * plan.inFace(p) + share * share * toCorner);
        }
        points.push_back(m_p_A_corner);
        points.emplace_back(m_p_A_corner + along * beyond * Vec3::UnitZ() + m_unit * kIntoCheek);
        std::vector<double> radii = between(kRadii);
        for (double& radius : radii)
            radius *= m_unit;
        return Rod{smoothThrough(points, kPieces), std::move(radii)};
    };
    m_upper = rod(kUpperLine, {}, 1.0);
    m_lower = rod(kLowerLine, jaw, -1.0);
}

double Lips::upper(const Vec3& p_A) const
{
    const double groove = m_unit * philtrum((p_A - m_p_A_incisors) / m_unit);
    return roundedMax(m_upper.distance(p_A), -groove, 1.5 * m_unit);
}

double Lips::lower(const Vec3& p_A) const { return m_lower.distance(p_A); }

std::vector<PartPlan> Lips::parts() const
{
    const Length voxel = 1e3 * m_unit * kLipVoxel;
    return {{"Upper lip",
             PartRole::Mucosa,
             "",
             {m_upper.bounds(), [lips = *this](const Vec3& p_A) { return lips.upper(p_A); }},
             voxel},
            {"Lower lip",
             PartRole::Mucosa,
             "",
             {m_lower.bounds(), [lips = *this](const Vec3& p_A) { return lips.lower(p_A); }},
             voxel}};
}

} // namespace carina
