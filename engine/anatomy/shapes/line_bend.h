#pragma once

#include "engine/anatomy/shapes/swept_surface.h"

#include <span>

namespace carina
{

/// Takes what lies around a line at rest, as a tube around its centre line, to where the line is
/// bent to. What is in one section of the line at rest is in one section of the bent line, as far
/// along it, in proportion where both lines are not equally long, and in the same place across it.
/// The line does not twist: its axes are carried along it by the turn of the tangent alone, and at
/// its beginning turn as the tangent does there.
///
/// All in one frame F, metres.
class LineBend
{
public:
    /// @pre at least two points each, no two neighbours equal
    LineBend(std::span<const Vec3> p_F_rest, std::span<const Vec3> p_F_bent);

    /// A place of the line; the columns of its axes are tangent, side, and across both.
    struct Place {
        Vec3 point = Vec3::Zero();
        Mat3 axes = Mat3::Identity();
    };
    [[nodiscard]] Place atRest(double along) const { return placeOn(m_rest, along); }
    /// @param along the line at rest, metres, as above
    [[nodiscard]] Place whereBent(double along) const
    {
        return placeOn(m_bent, along * m_bent.along.back() / m_rest.along.back());
    }
    /// Along the line at rest to its place that is nearest, metres.
    [[nodiscard]] double alongTo(const Vec3& p_F) const;
    /// Where what is at p_F at rest is then.
    [[nodiscard]] Vec3 taken(const Vec3& p_F) const;

    [[nodiscard]] std::span<const Vec3> rest() const { return m_rest.points; }
    [[nodiscard]] std::span<const Vec3> bent() const { return m_bent.points; }

private:
    [[nodiscard]] static Place placeOn(const SweptLine& line, double along);

    SweptLine m_rest;
    SweptLine m_bent;
};

} // namespace carina
