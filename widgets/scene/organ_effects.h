#pragma once

#include "widgets/scene/scene_part.h"

#include <QString>

#include <array>

namespace Qt3DCore
{
class QNode;
}
namespace Qt3DRender
{
class QEffect;
}

namespace carina
{

/// The keys by which the frame graph picks a render pass; their values are layers.
inline constexpr auto kSurfacePass = "surface"; ///< organ.frag: lit and, where translucent, blended
inline constexpr auto kIdPass = "id";           ///< id.frag: which part

/// One effect per material group, each with a surface pass and an id pass, all on the same two
/// shader programs. They belong to the parent.
using OrganEffects = std::array<Qt3DRender::QEffect*, kMaterialGroups>;
[[nodiscard]] OrganEffects makeOrganEffects(Qt3DCore::QNode* parent);

} // namespace carina
