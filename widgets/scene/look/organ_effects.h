#pragma once

#include "widgets/scene/look/error_map.h"
#include "widgets/scene/surfaces/scene_part.h"

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
inline constexpr auto kComingPass = "coming";   ///< never picked: its program is made ready

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

/// One effect per draw layer, each with a surface pass and an id pass, and what cuts and colours
/// all of them. They belong to the parent.
class OrganEffects
{
public:
    explicit OrganEffects(Qt3DCore::QNode* parent);

    [[nodiscard]] Qt3DRender::QEffect* of(DrawLayer layer) const;
    [[nodiscard]] const SectionUniforms& cut() const { return m_cut; }

    /// Colours all surfaces by their error from now on, or no more.
    void setErrorMap(const std::optional<ErrorMap>& map);
    /// From now on the jaw moves; until then it is left out of the shader.
    void letJawMove();
    /// One more frame is drawn. What was asked for is drawn with when its programs are compiled, a
    /// frame or two later: Qt 3D leaves out what has no such program yet.
    void countFrame();

private:
    struct Pass {
        Qt3DRender::QRenderPass* drawn = nullptr;
        Qt3DRender::QRenderPass* coming = nullptr;
    };
    struct Layer {
        Qt3DRender::QEffect* effect = nullptr;
        Pass surface;
        Pass id;
        bool hasManyRegions = false; ///< as OrganShader says
        /// By whether the jaw moves, and by whether the error is drawn.
        std::array<std::array<Qt3DRender::QShaderProgram*, 2>, 2> surfacePrograms{};
        std::array<Qt3DRender::QShaderProgram*, 2> idPrograms{};
    };
    void askForPrograms();
    void usePrograms();

    std::array<Layer, kDrawLayers> m_layers;
    SectionUniforms m_cut{};
    ErrorUniforms m_error{};
    bool m_movesJaw = false;
    bool m_isMapped = false;
    int m_framesToCome = 0; ///< until other programs are drawn with; 0 where none are asked for
};

} // namespace carina
