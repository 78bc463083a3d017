#pragma once

#include "engine/core/units.h"
#include "engine/geometry/rigid_transform.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace carina
{

/// The form of a tube in an airway in eight numbers, to be sent: how much it is curved, per metre,
/// at s along it from its connector (s = 0) to its tip (s = L). Outside of the mouth it is two
/// arcs, as a tube at rest (engine/registration/calibration/tube_rest.h); inside it bends in the
/// median plane, and out of that at its tip, towards a main bronchus:
///
///     w o_1 where s < L / 2, else w o_2                            about x of the connector
///     (1 - w) sum a_n P_n(2 u - 1), n = 0 .. 4                     about x'
///     (1 - w) b u^6                                                about y'
///
/// with Legendre's polynomials P_n, u = (s - e) / (L - e) from where it enters the mouth (s = e) to
/// its tip, and a smooth step w that falls from 1 to 0 within kPassage to either side of e. The
/// axes x' and y' are x and y of the connector's frame E turned about z so that x' is across the
/// median plane. All are carried along the tube without rotation about it; it begins at the origin
/// of E along -z. The choice of these functions is of ours.
struct TubeForm {
    Length length{};
    Length entry{};                   ///< e, from 0 to length
    Angle plane{};                    ///< from x to x' about z
    std::array<double, 8> perMetre{}; ///< o_1, o_2, a_0 .. a_4, b

    static constexpr std::size_t kInside = 5; ///< the a_n
    static constexpr Length kPassage = millimetres(25.0);
};

/// The angle of the median plane, to which x of A is perpendicular, for a connector at X_AE; 0
/// where the tube points across it.
[[nodiscard]] Angle medianPlane(const RigidTransform& X_AE);

/// The form that fits a centre line best: least squares of the distances of its points, by Gauss'
/// and Newton's method from the curvatures of the line.
/// @param p_E points at equal distances, from the connector to the tip
/// @pre at least three points, no two neighbours equal; length above 0, entry from 0 to length
[[nodiscard]] TubeForm formOf(std::span<const Vec3> p_E, Length length, Length entry, Angle plane);

/// Points of the centre line in E, at equal distances along it, `pieces` + 1.
/// @pre length and pieces above 0
[[nodiscard]] std::vector<Vec3> lineOf(const TubeForm& form, int pieces);

} // namespace carina
