#pragma once

#include "engine/core/units.h"
#include "engine/geometry/rigid_transform.h"

namespace carina
{

/// How far a lower jaw can be from where it is with the mouth closed, its incisors and by how much
/// it is turned; of ours. A mouth opens by 77 mm at most (Dijkstra et al., Int J Oral Maxillofac
/// Surg 2006;35:337, of grown people), which is a turn by 46 degrees about condyles 98 mm away. The
/// rest is for a manikin whose jaw has another size and another hinge than the patient's.
inline constexpr Length kFarthestJaw = millimetres(100.0);
inline constexpr Angle kMostJawTurn = degrees(60.0);

/// Whether a jaw can have this pose, kFarthestJaw being in proportion to the patient. A probe that
/// tells another one is not on a chin, or registered wrongly.
/// @param X_AJ pose of the mandible, the identity with the mouth closed
/// @param size of the way from incisors to glottis, kReferenceWay being 1
[[nodiscard]] bool isInReachOfJaw(const RigidTransform& X_AJ, const Vec3& p_A_incisors,
                                  double size);

} // namespace carina
