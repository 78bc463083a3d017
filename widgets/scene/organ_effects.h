#pragma once

#include "widgets/scene/error_map.h"
#include "widgets/scene/scene_part.h"

#include <QString>

#include <array>
#include <optional>

namespace Qt3DCore
{
class QNode;
}
namespace Qt3DRender
{
class QEffect;
class QParameter;
class QRenderPass;
class QShaderProgram;
} // namespace Qt3DRender

namespace carina
{

/// The keys by which the frame graph picks a render pass; their values are draw layers.
inline constexpr auto kSurfacePass = "surface"; ///< organ.frag or error_map.frag: what is seen,
                                                ///< blended where translucent
inline constexpr auto kIdPass = "id";           ///< id.frag: which part

/// Of which parts are cut away.
struct SectionUniforms {
    Qt3DRender::QParameter* section;
    Qt3DRender::QParameter* cutAway;
};

/// Of where which error is drawn in which colour.
struct ErrorUniforms {
    Qt3DRender::QParameter* quadric;
    Qt3DRender::QParameter* firstBand;
    Qt3DRender::QParameter* bandCount;
    Qt3DRender::QParameter* bandColors;
};

/// One effect per draw layer, each with a surface pass and an id pass, all on the same shader
/// programs, and what cuts and colours all of them. They belong to the parent.
struct OrganEffects {
    std::array<Qt3DRender::QEffect*, kDrawLayers> of{};
    std::array<Qt3DRender::QRenderPass*, kDrawLayers> surface{};
    Qt3DRender::QShaderProgram* lit = nullptr;    ///< organ.frag: in the parts' own colours
    Qt3DRender::QShaderProgram* mapped = nullptr; ///< error_map.frag: in those of the error
    SectionUniforms cut{};
    ErrorUniforms error{};
};
[[nodiscard]] OrganEffects makeOrganEffects(Qt3DCore::QNode* parent);

/// Colours all surfaces by their error from now on, or no more.
void setErrorMap(const OrganEffects& effects, const std::optional<ErrorMap>& map);

} // namespace carina
