#pragma once

#include "engine/display/eye_picture.h"
#include "widgets/scene/look/picture_quality.h"
#include "widgets/scene/view/scene_frame.h"

#include <QColor>
#include <QSize>

#include <array>
#include <vector>

class QWindow;

namespace Qt3DRender
{
class QAbstractTexture;
class QCamera;
class QClearBuffers;
class QClipPlane;
class QFrameGraphNode;
class QRenderCapture;
class QRenderStateSet;
class QRenderSurfaceSelector;
class QSubtreeEnabler;
class QTexture2D;
class QViewport;
} // namespace Qt3DRender

namespace carina
{

/// One camera per view.
using Cameras = std::array<Qt3DRender::QCamera*, kMostEyes>;

/// The Qt 3D frame graph: the render passes of a frame, their order and their targets.
///
/// The picture, in each shown view: opaque surfaces; then translucent ones with depth test, each
/// triangle blended in the order of the index buffer (DrawOrder). In the quickest quality they are
/// drawn into the window; else into a texture, from which PictureFinish draws the window.
///
/// The ids, on demand, layer by layer (layerOf): the nearest surface of the layer that is not
/// behind an earlier layer, into a texture that is read back after each layer.
class FrameGraph
{
public:
    /// Starts with one shown view that fills the window.
    FrameGraph(QWindow* window, const Cameras& cameras);
    ~FrameGraph();
    FrameGraph(const FrameGraph&) = delete;
    FrameGraph& operator=(const FrameGraph&) = delete;

    /// To be set as the active frame graph of Qt 3D's render settings, which then own it.
    [[nodiscard]] Qt3DRender::QFrameGraphNode* root() const;

    void setBackground(const QColor& color);

    /// Enables the clip plane of a section; the vertex shader computes the clip distance.
    void setCut(bool cut);

    /// Draws the picture of a view's camera into these pixels of the window.
    void showView(std::size_t view, const PixelRect& pixels, const QSize& window);
    void hideView(std::size_t view);

    /// Draws the picture in this quality, from the next frame on.
    /// @param window in pixels; to be said anew when it changes
    void setQuality(PictureQuality quality, const QSize& window);
    /// What is drawn before it is finished; nullptr in the quickest quality.
    [[nodiscard]] Qt3DRender::QAbstractTexture* unfinished(PictureQuality quality) const
    {
        return ofQuality(quality).colors;
    }

    /// Reads the whole picture back.
    [[nodiscard]] Qt3DRender::QRenderCapture* pictureCapture() const { return m_picture; }

    /// The id passes that are drawn: none, that of opaque parts, which is layer 0, or all.
    enum class Ids { None, Opaque, All };
    /// Selects them, and the size of their picture.
    void drawIds(Ids drawn, const QSize& pixels = {1, 1});
    /// One capture per layer.
    [[nodiscard]] const std::vector<Qt3DRender::QRenderCapture*>& idCaptures() const
    {
        return m_idLayers;
    }

private:
    enum class Depth { Write, TestOnly };

    /// The branch of the graph for a view.
    struct Branch {
        Qt3DRender::QSubtreeEnabler* shown;
        Qt3DRender::QViewport* part;
    };

    /// The branches of a quality, which are enabled while it is drawn.
    struct Picture {
        std::vector<Qt3DRender::QSubtreeEnabler*> drawn;
        Qt3DRender::QClearBuffers* background = nullptr;
        Qt3DRender::QAbstractTexture* colors = nullptr;
        Qt3DRender::QAbstractTexture* depths = nullptr;
    };
    [[nodiscard]] const Picture& ofQuality(PictureQuality quality) const
    {
        return m_pictures[static_cast<std::size_t>(quality)];
    }
    /// A branch that is drawn in this quality alone.
    Qt3DRender::QSubtreeEnabler* branchOf(PictureQuality quality);
    void addSurfaces(PictureQuality quality, const Cameras& cameras,
                     Qt3DRender::QFrameGraphNode* parent);
    void addUnfinished(PictureQuality quality, const Cameras& cameras);
    void addFinish(PictureQuality quality, const Cameras& cameras);

    Qt3DRender::QRenderStateSet* addStates(Qt3DRender::QFrameGraphNode* parent, Depth depth,
                                           bool onlyFrontFaces);
    void addPicture(const Cameras& cameras);
    void addIdLayer(int layer, Qt3DRender::QFrameGraphNode* view);
    void addIds(const Cameras& cameras);
    [[nodiscard]] Qt3DRender::QFrameGraphNode* addView(std::size_t view, const Cameras& cameras,
                                                       Qt3DRender::QFrameGraphNode* parent);

    Qt3DRender::QRenderSurfaceSelector* m_root;
    std::array<Picture, kPictureQualities> m_pictures;
    Qt3DRender::QRenderCapture* m_picture = nullptr;
    Qt3DRender::QSubtreeEnabler* m_ids = nullptr;
    Qt3DRender::QSubtreeEnabler* m_laterIds = nullptr; ///< of all layers but the first
    Qt3DRender::QTexture2D* m_idColors = nullptr;
    Qt3DRender::QTexture2D* m_idDepths = nullptr;
    std::vector<Qt3DRender::QRenderCapture*> m_idLayers;
    std::array<std::vector<Branch>, kMostEyes> m_views;
    std::vector<Qt3DRender::QRenderStateSet*> m_states;
    Qt3DRender::QClipPlane* m_clip;
    bool m_isCut = false;
};

} // namespace carina
