#pragma once

#include "widgets/scene/look/error_map.h"
#include "widgets/scene/look/organ_effects.h"
#include "widgets/scene/look/section.h"
#include "widgets/scene/surfaces/surface_entity.h"
#include "widgets/scene/view/frame_graph.h"
#include "widgets/scene/view/orbit_camera.h"
#include "widgets/scene/view/picture_finish.h"
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
class QRenderCaptureReply;
} // namespace Qt3DRender

namespace carina
{

/// A camera: its pose, its frustum, and its pixels in the window.
struct SceneCamera {
    CameraPose pose;
    Frustum frustum;
    PixelRect pixels;
};

/// The id that id.frag wrote into a pixel; std::nullopt where there is no part.
[[nodiscard]] std::optional<std::uint16_t> idInPixel(QRgb pixel);

/// Draws scene parts into a window with Qt 3D, one frame per call: draw() draws and swaps the state
/// set before it, without a frame of latency.
class SceneRenderer
{
public:
    /// @pre the window draws with OpenGL, and outlives this.
    explicit SceneRenderer(QWindow* window);
    ~SceneRenderer();
    SceneRenderer(const SceneRenderer&) = delete;
    SceneRenderer& operator=(const SceneRenderer&) = delete;

    /// Ids that are being read are not told: they are those of the parts before.
    void setParts(std::span<const ScenePart> parts);
    /// Replaces the parts that come and go, each drawn in its finest level; the others are kept.
    void setFigureParts(std::span<const ScenePart> parts);
    void setBackground(const QColor& color) { m_frameGraph.setBackground(color); }

    /// Draws in this quality from the next frame on; at first in the quickest.
    void setQuality(PictureQuality quality) { m_frameGraph.setQuality(quality, windowPixels()); }
    /// How a spotlight shows surfaces; at first plain. Takes effect as setErrorMap().
    void setLook(SurfaceLook look) { m_effects.setLook(look); }
    /// Whether a setting has not taken effect yet that needs another shader program.
    [[nodiscard]] bool isPreparing() const { return m_effects.isPreparing(); }

    /// Sets the cameras; without any, only the background is drawn.
    /// @pre at most kMostEyes cameras, whose pixels are inside the window and do not overlap.
    void setCameras(std::span<const SceneCamera> cameras);
    /// Sets the state of a frame, and the level of detail of each part, by its index.
    void apply(const SceneFrame& frame, std::span<const int> levels);
    void setSection(const std::optional<Section>& section);
    /// Unlike other settings this can take effect one or two frames later, when its shader program
    /// is compiled.
    void setErrorMap(const std::optional<ErrorMap>& map) { m_effects.setErrorMap(map); }
    /// Lights the scene by a lamp beside the first camera alone, in its direction: what is at this
    /// distance is as bright as its colour. std::nullopt: as usual. Takes effect likewise.
    void setSpotlight(std::optional<Length> trueColorAt) { m_spotlight = trueColorAt; }
    void draw();

    /// The picture of the present state; a null image if the window cannot be drawn into.
    [[nodiscard]] QImage picture();

    /// Adds to `pixels` the number of visible pixels of each part id in the present state.
    void countPixels(std::map<std::uint16_t, std::size_t>& pixels);

    /// Which opaque part is the nearest in each pixel of the present state, as id.frag codes it; a
    /// null image if the window cannot be drawn into.
    [[nodiscard]] QImage opaqueIds();

    /// Has the next draw() read the same, without waiting, in a picture of the same shape and at
    /// most 320x240 pixels: takeIds() has it some frames later.
    /// Without effect while that is under way.
    void askForIds();
    [[nodiscard]] bool isReadingIds() const { return m_idReply != nullptr; }
    /// What was read, once; nothing while it is not there. A read that does not come is given up.
    [[nodiscard]] std::optional<QImage> takeIds();

private:
    void endReading();
    [[nodiscard]] QSize windowPixels() const;
    [[nodiscard]] std::vector<QImage>
    captured(const std::vector<Qt3DRender::QRenderCapture*>& captures);

    QWindow* m_window;
    std::unique_ptr<Qt3DCore::QAspectEngine> m_engine;
    Qt3DCore::QEntity* m_root;        ///< owned by m_engine
    Cameras m_cameras;                ///< owned by m_root
    FrameGraph m_frameGraph;          ///< whose root m_root owns
    OrganEffects m_effects;           ///< whose nodes m_root owns
    PictureFinish m_finish;           ///< likewise
    Vec3 m_forward_A = Vec3::UnitY(); ///< of the cameras
    bool m_isCut = false;
    std::optional<Length> m_spotlight;
    using Surfaces = std::vector<std::unique_ptr<SurfaceEntity>>;
    [[nodiscard]] Surfaces surfacesOf(std::span<const ScenePart> parts);

    Surfaces m_surfaces;
    Surfaces m_figures;
    std::vector<int> m_figureLevels; ///< of each part of the figures: the finest
    std::unique_ptr<Qt3DRender::QRenderCaptureReply> m_idReply; ///< while ids are read
    int m_idFrames = 0;                                         ///< that were drawn since
};

} // namespace carina
