#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/geometry/deformation/neck_field.h"
#include "engine/geometry/mesh/triangle_mesh.h"
#include "engine/geometry/rigid_transform.h"

#include <span>
#include <string>
#include <vector>

namespace carina
{

/// One piece of a tracheal tube, whose tip is cut obliquely and opens to the patient's left, in the
/// connector's frame E: "Tube", "Depth marks", "Cuff", which lies flat, kInflatedCuff, which
/// encloses it, or "Connector".
struct TubePiece {
    std::string name;
    TriangleMesh mesh; ///< closed, with normals
};

inline constexpr const char* kInflatedCuff = "Inflated cuff";

/// A tracheal tube as a rigid body, whose shape fits one airway at its final depth.
///
/// E, the connector's frame: origin at the centre of the tube's end at the connector, +z out of the
/// patient along the tube, +x to the patient's left, +y completes the right-handed frame. Metres.
struct TubeShape {
    RigidTransform X_AE;          ///< pose at the final depth
    std::vector<Vec3> p_E_centre; ///< centreline, from the connector to the tip
    Vec3 p_E_tip = Vec3::Zero();
    Length tipAboveCarina; ///< along the path, at the final depth
    Length innerDiameter;
    Length outerDiameter;
    std::vector<TubePiece> pieces;
    bool fitsAirway = true; ///< it is shaped like the airway; else it is as it was touched
};

/// Outer diameter of a tube for its inner one, from a manufacturer's list (6.0 mm: 8.2, 6.5: 8.9,
/// 7.0: 9.6, 7.5: 10.2, 8.0: 10.9 mm), with linear interpolation and extrapolation.
[[nodiscard]] Length outerDiameterOf(Length innerDiameter);

/// The inner diameter of a tube whose outer one was measured: of the sizes that are sold, half a
/// millimetre apart from 2 to 12 mm, the one with the nearest outer diameter by that list. A tube
/// of another maker, with a thicker or thinner wall, can be one size off.
[[nodiscard]] Length soldInnerDiameterOf(Length outerDiameter);

/// How far above the carina the tip of a tube is at its final depth: 30 mm, and of the tubes of
/// infants, below 5 mm, less in proportion. A newborn's tube of 3.0 mm is then 9.4 cm deep at the
/// teeth, to the textbooks' 6 cm and the weight in kg; at one year 12 cm, as age / 2 + 12 says.
[[nodiscard]] Length usualTipAboveCarina(Length innerDiameter);

/// Makes the tube that lies along `path_A`, with its tip `tipAboveCarina` before the end of the
/// path and its connector 5 cm in front of the incisors. Depth marks are 1 cm apart from 5 cm above
/// the tip on, every fifth one broader.
///
/// @param path_A centreline of the airway, from in front of the incisors to the carina, metres
/// @returns NoAirway where the path is empty or too short for the tube; OutOfRange for an inner
///          diameter outside 2 to 12 mm or a negative tipAboveCarina.
[[nodiscard]] Result<TubeShape> makeTube(Length innerDiameter, std::span<const Vec3> path_A,
                                         const Vec3& p_A_incisors,
                                         Length tipAboveCarina = millimetres(30.0));

/// The tube with another centreline, as one that was touched has it at rest: at the final depth its
/// tip lies at the same place, and its ends lie along the same line. Its inner diameter is that of
/// a tube that is sold with the outer one (soldInnerDiameterOf).
/// @pre at least two points, no two neighbours equal; the outer diameter is above 0.
[[nodiscard]] TubeShape tubeAlong(const TubeShape& tube, std::span<const Vec3> p_E_centre,
                                  Length outerDiameter);

/// A tube that fits an airway in neutral position, as it fits that airway where the neck has taken
/// it: each place p_E to X_E'A N(X_AE p_E), N being the motion of the neck. Its connector, in front
/// of the teeth, goes with the head. It becomes longer or shorter as the way from the teeth does,
/// by a few millimetres, where a real tube would stick out more or less. A tube that was touched is
/// rigid, and stays as it is.
[[nodiscard]] TubeShape bent(TubeShape tube, const NeckField& neck);

/// The centreline of bent(tube, neck), as long as that of the tube: at its tip cut, or straight on.
[[nodiscard]] std::vector<Vec3> centreIn(const NeckField& neck, const TubeShape& tube);

/// How far the tip of bent(tube, neck), with its connector at X_AE, is from where it is at the
/// final depth of the airway as the neck has taken that. Also for a tube that was touched, whose
/// tip lies at the same place there.
[[nodiscard]] Length tipFromPlace(const TubeShape& tube, const NeckField& neck,
                                  const RigidTransform& X_AE);

} // namespace carina
