#pragma once

#include "engine/display/eye_picture.h"
#include "widgets/scene/view/scene_frame.h"

#include <QColor>
#include <QSize>

#include <array>
#include <vector>

class QWindow;

namespace Qt3DRender
{
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

/// One for each view.
using Cameras = std::array<Qt3DRender::QCamera*, kMostEyes>;

/// What Qt 3D draws each frame, in which order and into what.
///
/// The picture, in each view that is shown: what is opaque; then what is translucent, each triangle
/// blended over what is there, in the order of its list of corners (DrawOrder), where nothing
/// opaque is nearer.
///
/// The ids, on demand, layer by layer (layerOf): what is nearest of the layer and not behind an
/// earlier one, into a texture of the picture's size that is read back after each.
class FrameGraph
{
public:
    /// One view, of the whole window, is shown.
    FrameGraph(QWindow* window, const Cameras& cameras);
    ~FrameGraph();
    FrameGraph(const FrameGraph&) = delete;
    FrameGraph& operator=(const FrameGraph&) = delete;

    /// To be made the active frame graph, and thereby owned, by Qt 3D's render settings.
    [[nodiscard]] Qt3DRender::QFrameGraphNode* root() const;

    void setBackground(const QColor& color);

    /// Whether a section cuts from now on, as the vertex shader says what lies beyond it.
    void setCut(bool cut);

    /// Draws what a view's camera sees into these pixels of the window, or no more.
    void showView(std::size_t view, const PixelRect& pixels, const QSize& window);
    void hideView(std::size_t view);

    /// Reads the whole picture back.
    [[nodiscard]] Qt3DRender::QRenderCapture* pictureCapture() const { return m_picture; }

    /// Draws ids as well from now on, or no more.
    void setIdsDrawn(bool drawn, const QSize& pixels);
    /// One for each layer.
    [[nodiscard]] const std::vector<Qt3DRender::QRenderCapture*>& idCaptures() const
    {
        return m_idLayers;
    }

private:
    enum class Depth { Write, TestOnly };

    /// Where the graph forks into a view.
    struct Branch {
        Qt3DRender::QSubtreeEnabler* shown;
        Qt3DRender::QViewport* part;
    };

    Qt3DRender::QRenderStateSet* addStates(Qt3DRender::QFrameGraphNode* parent, Depth depth,
                                           bool onlyFrontFaces);
    void addPicture(const Cameras& cameras);
    void addIdLayer(int layer, Qt3DRender::QFrameGraphNode* view);
    void addIds(const Cameras& cameras);
    [[nodiscard]] Qt3DRender::QFrameGraphNode* addView(std::size_t view, const Cameras& cameras,
                                                       Qt3DRender::QFrameGraphNode* parent);

    Qt3DRender::QRenderSurfaceSelector* m_root;
    Qt3DRender::QClearBuffers* m_background = nullptr;
    Qt3DRender::QRenderCapture* m_picture = nullptr;
    Qt3DRender::QSubtreeEnabler* m_ids = nullptr;
    Qt3DRender::QTexture2D* m_idColors = nullptr;
    Qt3DRender::QTexture2D* m_idDepths = nullptr;
    std::vector<Qt3DRender::QRenderCapture*> m_idLayers;
    std::array<std::vector<Branch>, kMostEyes> m_views;
    std::vector<Qt3DRender::QRenderStateSet*> m_states;
    Qt3DRender::QClipPlane* m_clip;
    bool m_isCut = false;
};

} // namespace carina
