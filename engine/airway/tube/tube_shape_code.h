#pragma once

#include "engine/core/units.h"
#include "engine/geometry/rigid_transform.h"

#include <array>
#include <span>
#include <vector>

namespace carina
{

/// The shape of a tube in eight numbers, to be sent: by how much its curvature differs from that of
/// its curve at rest, in two directions as Legendre polynomials of the way along it,
///
///     k_x(s) = sum a_n P_n(2 s / L - 1), n = 0 .. 5
///     k_y(s) = sum b_n P_n(2 s / L - 1), n = 0, 1
///
/// per metre, about the axes x and y of the connector's frame E, carried along the tube without
/// rotation about it. It begins at the origin of E. In an airway it bends mainly about x. Who reads
/// it has the curve at rest: that of the patient's tube, or as it was touched.
struct TubeShapeCode {
    static constexpr std::size_t kAboutX = 6;
    static constexpr std::size_t kAboutY = 2;
    std::array<float, kAboutX + kAboutY> perMetre{};

    friend bool operator==(const TubeShapeCode&, const TubeShapeCode&) = default;
};

/// Points along a line at equal distances, `pieces` + 1.
/// @pre at least two points, no two neighbours equal; pieces above 0
[[nodiscard]] std::vector<Vec3> inPieces(std::span<const Vec3> line, int pieces);

/// Points of the centre line in E, as many as of the curve at rest.
/// @param p_E_rest at equal distances from the origin on
/// @pre at least three points, no two neighbours equal
[[nodiscard]] std::vector<Vec3> decoded(const TubeShapeCode& code, std::span<const Vec3> p_E_rest);

struct EncodedShape {
    TubeShapeCode code;
    Length error{}; ///< the greatest distance of a point from that of the decoded shape
};

/// The code by which a centre line is fitted best: least squares of the distances of its points, by
/// Gauss and Newton's method from the curvatures of the line.
/// @param p_A points at equal distances, from the connector to the tip
/// @param p_E_rest the same at rest
/// @pre at least three points, no two neighbours equal; as many of both
[[nodiscard]] EncodedShape encoded(std::span<const Vec3> p_A, const RigidTransform& X_AE,
                                   std::span<const Vec3> p_E_rest);

} // namespace carina
