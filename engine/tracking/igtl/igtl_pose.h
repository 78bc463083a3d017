#pragma once

#include "engine/core/session_time.h"
#include "engine/geometry/mesh/triangle_mesh.h"
#include "engine/geometry/rigid_transform.h"
#include "engine/tracking/igtl/igtl_message.h"

namespace carina
{

// Between contents of OpenIGTLink, in millimetres and single precision, and the engine.

/// @returns NotFinite, NotARotation; OutOfRange for a position beyond 100 m. A quaternion is
/// brought
///          to unit length, as the programs of the protocol's own library need it; one shorter than
///          a half or longer than 2 is refused.
[[nodiscard]] Result<RigidTransform> poseOf(const IgtlMatrix& matrix);
[[nodiscard]] Result<RigidTransform> poseOf(const IgtlPosition& position);
[[nodiscard]] Result<RigidTransform> poseOf(const IgtlQuaternionTracked& tool);

/// Whether it is the identity, bit by bit, which senders without a way to say that they do not see
/// a tool put in its place.
[[nodiscard]] bool isPlaceholder(const RigidTransform& X);

[[nodiscard]] IgtlMatrix igtlMatrix(const RigidTransform& X);
[[nodiscard]] std::array<float, 3> igtlPoint(const Vec3& p);
/// x y z w
[[nodiscard]] std::array<float, 4> igtlQuaternion(const RigidTransform& X);

/// Adds a surface, whose vertices become those of its frame F in G. @pre X_GF is rigid.
void appendSurface(IgtlPolyData& data, const RigidTransform& X_GF, const TriangleMesh& mesh_F);

/// A time since 1970 (UTC) as a header has it, and back.
[[nodiscard]] std::uint64_t igtlStamp(Duration since1970);
[[nodiscard]] Duration sinceEpoch(std::uint64_t stamp);

} // namespace carina
