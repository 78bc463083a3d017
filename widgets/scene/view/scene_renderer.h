#pragma once

#include "widgets/scene/look/error_map.h"
#include "widgets/scene/look/organ_effects.h"
#include "widgets/scene/look/section.h"
#include "widgets/scene/surfaces/surface_entity.h"
#include "widgets/scene/view/frame_graph.h"
#include "widgets/scene/view/orbit_camera.h"
#include "widgets/scene/view/scene_frame.h"

#include <QImage>

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace Qt3DCore
{
class QAspectEngine;
class QEntity;
} // namespace Qt3DCore
namespace Qt3DRender
{
class QRenderCapture;
} // namespace Qt3DRender

namespace carina
{

/// From where and through what a scene is seen, and in which pixels of its window.
struct SceneCamera {
    CameraPose pose;
    Frustum frustum;
    PixelRect pixels;
};

/// Draws scene parts into a window with Qt 3D, one frame per call: what was set before draw() is
/// what that call draws and swaps, not a frame later.
class SceneRenderer
{
public:
    /// @pre the window draws with OpenGL, and outlives this.
    explicit SceneRenderer(QWindow* window);
    ~SceneRenderer();
    SceneRenderer(const SceneRenderer&) = delete;
    SceneRenderer& operator=(const SceneRenderer&) = delete;

    void setParts(std::span<const ScenePart> parts);
    void setBackground(const QColor& color) { m_frameGraph.setBackground(color); }

    /// Draws as these cameras see it from now on; the background alone without any.
    /// @pre at most kMostEyes, whose pixels lie in the window and do not overlap.
    void setCameras(std::span<const SceneCamera> cameras);
    /// Draws each part, by its place among the parts, in its level of detail.
    void apply(const SceneFrame& frame, std::span<const int> levels);
    void setSection(const std::optional<Section>& section);
    /// Unlike all else this may be seen a frame or two later: another shader program takes over.
    void setErrorMap(const std::optional<ErrorMap>& map) { m_effects.setErrorMap(map); }
    void draw();

    /// The picture as it is set now; a null image where the window cannot be drawn into.
    [[nodiscard]] QImage picture();

    /// Adds for each id the pixels in which it is seen now.
    void countPixels(std::map<std::uint16_t, std::size_t>& pixels);

private:
    [[nodiscard]] QSize windowPixels() const;
    [[nodiscard]] std::vector<QImage>
    captured(const std::vector<Qt3DRender::QRenderCapture*>& captures);

    QWindow* m_window;
    std::unique_ptr<Qt3DCore::QAspectEngine> m_engine;
    Qt3DCore::QEntity* m_root;        ///< owned by m_engine
    Cameras m_cameras;                ///< owned by m_root
    FrameGraph m_frameGraph;          ///< whose root m_root owns
    OrganEffects m_effects;           ///< whose nodes m_root owns
    Vec3 m_forward_A = Vec3::UnitY(); ///< of the cameras
    bool m_isCut = false;
    std::vector<std::unique_ptr<SurfaceEntity>> m_surfaces;
};

} // namespace carina
