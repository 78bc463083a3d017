#pragma once

#include "engine/core/units.h"
#include "engine/geometry/vec.h"
#include "widgets/scene/look/error_map.h"
#include "widgets/scene/look/organ_shader.h"
#include "widgets/scene/look/picture_quality.h"
#include "widgets/scene/surfaces/scene_part.h"

#include <QString>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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

/// Filter keys with which the frame graph selects a render pass; their values are draw layers.
inline constexpr auto kSurfacePass = "surface"; ///< organ.frag, moist.frag or error_map.frag
inline constexpr auto kIdPass = "id";           ///< id.frag: the id of the part
inline constexpr auto kComingPass = "coming";   ///< never selected; compiles its program

/// Parameters of the section plane and of the parts that it cuts.
struct SectionUniforms {
    Qt3DRender::QParameter* section;
    Qt3DRender::QParameter* cutAway;
};

/// Parameters of the error map.
struct ErrorUniforms {
    Qt3DRender::QParameter* quadric;
    Qt3DRender::QParameter* firstBand;
    Qt3DRender::QParameter* bandCount;
    struct Band {
        Qt3DRender::QParameter* color;
        Qt3DRender::QParameter* line; ///< the colour of the line where it begins
    };
    std::array<Band, kMostErrorBands> bands; ///< singly: Qt 6.4 leaks a list each time it is set
};

/// A lamp beside the eye, as on the blade of a video laryngoscope.
struct Spotlight {
    Vec3 dir_A = Vec3::UnitY();             ///< unit; its axis
    Length trueColorAt = millimetres(40.0); ///< what is so far away is as bright as its colour
};

/// Two effects per draw layer, for surfaces that go with the throat and for those that do not, each
/// with a surface pass and an id pass, and the parameters common to all. The parent owns the nodes.
class OrganEffects
{
public:
    explicit OrganEffects(Qt3DCore::QNode* parent);

    /// @param region of the whole surface; std::nullopt if it varies by vertex (SurfaceKey)
    [[nodiscard]] Qt3DRender::QEffect* of(DrawLayer layer, std::optional<ChestRegion> region) const;
    [[nodiscard]] const SectionUniforms& cut() const { return m_cut; }

    /// Colours all surfaces by their error; std::nullopt ends this.
    void setErrorMap(const std::optional<ErrorMap>& map);
    /// Enables the motion of the jaw, which the shaders leave out before.
    void letJawMove();
    /// Enables what a laryngoscope's blade does to tissue, and the motion of the jaw.
    void letBladePush();
    /// Enables what events change of an airway, its form and its colours.
    void letAirwayChange();
    /// Enables that head and neck move.
    void letNeckBend();
    /// Lights the scene by a lamp beside the eye alone; std::nullopt: as usual. Of two lamps only
    /// the uniform differs.
    void setSpotlight(const std::optional<Spotlight>& lamp);
    /// How the spotlight shows surfaces; without one this has no effect.
    void setLook(SurfaceLook look);
    /// To be called once per frame. A newly requested program is used only when it is compiled, one
    /// or two frames later, because Qt 3D does not draw an entity whose program is not ready.
    void countFrame();
    /// Whether what was requested last is not used yet.
    [[nodiscard]] bool isPreparing() const { return m_framesToCome > 0; }

private:
    struct Pass {
        Qt3DRender::QRenderPass* drawn = nullptr;
        Qt3DRender::QRenderPass* coming = nullptr;
    };
    struct Layer {
        Qt3DRender::QEffect* effect = nullptr;
        Pass surface;
        Pass id;
        bool hasManyRegions = false; ///< see OrganShader
        bool isInThroat = false;     ///< jaw, events or a blade move it
        /// The programs that were ever requested, by their shaders.
        std::map<std::pair<OrganShader, std::string>, Qt3DRender::QShaderProgram*> programs{};
    };
    [[nodiscard]] std::vector<Qt3DRender::QParameter*> parameters() const;
    void askForPrograms();
    [[nodiscard]] const char* surfaceShader() const;
    Qt3DRender::QShaderProgram* programOf(Layer& layer, const OrganShader& needs,
                                          const char* fragmentShader);
    void usePrograms();

    std::array<Layer, 2 * kDrawLayers> m_layers; ///< those in the throat second
    SectionUniforms m_cut{};
    ErrorUniforms m_error{};
    Qt3DRender::QParameter* m_spot;
    OrganShader m_needs{.movesJaw = false,
                        .pushesTissue = false,
                        .changesAirway = false,
                        .bendsNeck = false}; ///< of each layer, but regions
    bool m_isMapped = false;
    int m_framesToCome = 0; ///< until the requested programs are used; 0 if none are requested
};

} // namespace carina
