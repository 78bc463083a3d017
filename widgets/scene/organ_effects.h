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
class QParameter;
} // namespace Qt3DRender

namespace carina
{

/// The keys by which the frame graph picks a render pass; their values are draw layers.
inline constexpr auto kSurfacePass = "surface"; ///< organ.frag: lit and, where translucent, blended
inline constexpr auto kIdPass = "id";           ///< id.frag: which part

/// Of which parts are cut away.
struct SectionUniforms {
    Qt3DRender::QParameter* section;
    Qt3DRender::QParameter* cutAway;
};

/// One effect per draw layer, each with a surface pass and an id pass, all on the same two shader
/// programs, and what cuts all of them. They belong to the parent.
struct OrganEffects {
    std::array<Qt3DRender::QEffect*, kDrawLayers> of{};
    SectionUniforms cut{};
};
[[nodiscard]] OrganEffects makeOrganEffects(Qt3DCore::QNode* parent);

} // namespace carina
