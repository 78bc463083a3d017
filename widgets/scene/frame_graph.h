#pragma once

#include "engine/display/eye_picture.h"
#include "widgets/scene/scene_frame.h"

#include <QColor>
#include <QSize>

#include <array>
#include <vector>

class QWindow;

namespace Qt3DRender
{
class QCamera;
class QClearBuffers;
class QFrameGraphNode;
class QRenderCapture;
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
/// The picture, in each view that is shown: the opaque layer; then each translucent layer: its
/// nearest surface into the depth buffer alone, then that nearest surface blended over what is
/// there. A later layer is so hidden where an earlier one is nearer, whichever way one looks. The
/// airway has its far wall blended before; the cage leaves no depth, so that all its ribs are seen,
/// one through another.
///
/// The ids, on demand: the same layers of the same views with the same depth tests, unblended, into
/// a texture of the picture's size, read back layer by layer.
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
    /// Where the graph forks into a view.
    struct Branch {
        Qt3DRender::QSubtreeEnabler* shown;
        Qt3DRender::QViewport* part;
    };

    void addPicture(const Cameras& cameras);
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
};

} // namespace carina
