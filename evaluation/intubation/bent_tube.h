#pragma once

#include "engine/core/units.h"
#include "engine/geometry/rigid_transform.h"
#include "evaluation/intubation/tube_corridor.h"

#include <optional>
#include <span>
#include <vector>

namespace carina
{

/// A tube as it lies: bent in a corridor, and in front of that as at rest. Of a rigid one nothing
/// but the tip is in a corridor.
struct BentTube {
    RigidTransform X_AE;          ///< of its connector
    std::vector<Vec3> p_A_inside; ///< centre line in the corridor, to the tip
    Length outside{};             ///< from the connector to the corridor

    /// The centre line from the connector to the tip.
    [[nodiscard]] std::vector<Vec3> line(std::span<const Vec3> p_E_rest) const;
};

/// The tube that lies in a corridor with the least energy of bending,
///
///     sum 1/l_i |M_i (t_i+1 - t_i) - k_i|^2,
///
/// over the nodes of its centre line between pieces of length l_i and direction t_i; M_i are two
/// axes across the tube, carried along it without rotation about it, and k_i is the same of its
/// curve at rest. Its tip and the place where it is held stay where the corridor begins and ends,
/// and are free to turn; nothing holds it back along the corridor, so that as much of it is inside
/// as its curve there is long. In front of the corridor it goes on in its curve at rest. So without
/// walls it lies as at rest, rigid, with both places in the corridor's ends.
///
/// It is turned about itself so that a tube at rest between these ends would have its x axis across
/// the line from the one to the other, as nearly to the patient's left as can be, but for `roll`.
///
/// Newton's steps from the middle line of the corridor, with its sides as stiff springs: a pure
/// function.
///
/// @param p_E_rest its centre line at rest, from the connector to the tip, in the frame of that
/// @returns nothing where the tube is shorter than its way
[[nodiscard]] std::optional<BentTube> bentTube(const TubeCorridor& corridor,
                                               std::span<const Vec3> p_E_rest, Angle roll);

} // namespace carina
