#pragma once

#include "engine/geometry/deformation/blade_field.h"
#include "evaluation/intubation/motion_patient.h"

#include <array>
#include <vector>

namespace carina
{

/// A place of the corridor in which a tube lies.
struct CorridorPlace {
    Vec3 p_A = Vec3::Zero();
    Mat3 axes = Mat3::Identity(); ///< acrossAxesOf the corridor
    /// How far aside of p_A its centre line may be along the first two axes, metres; least is at
    /// most 0, and most at least.
    std::array<double, 2> least{};
    std::array<double, 2> most{};
};
/// Along a way from where the tube is held to its tip, three places at least. At both ends it is at
/// p_A. Steps are as long as those of the walls, beginning where it is held, but for the last one:
/// a place stays where it is while the tip goes on.
using TubeCorridor = std::vector<CorridorPlace>;

/// How tissue lies around a tube in the neutral position of head and neck.
struct TissueAroundWay {
    RigidTransform X_AJ; ///< of the mandible, the identity if shut
    BladeField blade{};  ///< which pushes the tongue to the front
};

/// Between which places a tube lies, at least three kWallsEach apart, and how it goes through the
/// first one.
struct CorridorEnds {
    double held = 0.0;            ///< along the way, metres
    Vec3 corner_A = Vec3::Zero(); ///< there, from the way
    double tip = 0.0;             ///< along the way
    Vec3 p_A_tip = Vec3::Zero();  ///< near that place
};

/// The corridor of a tube's centre line: between the walls of the way as jaw and blade have moved
/// them, without the tube's radius. The line from one end to the other along the way belongs to it
/// also where that leaves no room. In front of the teeth it widens by kFunnel of each metre.
/// Its places lie side by side: on the inside of a bend it reaches no farther than kInsideOfBend of
/// the radius of that.
[[nodiscard]] TubeCorridor tubeCorridor(const MotionPatient& patient, const TipWay& way,
                                        const TissueAroundWay& tissue, const CorridorEnds& ends,
                                        Length tubeRadius);
inline constexpr double kFunnel = 4.0; ///< of ours
inline constexpr double kInsideOfBend = 0.6;

} // namespace carina
