#pragma once

#include <QColor>
#include <QSize>

#include <memory>
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
} // namespace Qt3DRender

namespace carina
{

/// What Qt 3D draws each frame, in which order and into what.
///
/// The picture: the opaque layer; then each translucent layer: its nearest surface into the depth
/// buffer alone, then that nearest surface blended over what is there. A later layer is so hidden
/// where an earlier one is nearer, whichever way one looks. The airway has its far wall blended
/// before; the cage leaves no depth, so that all its ribs are seen, one through another.
///
/// The ids, on demand: the same layers with the same depth tests, unblended, into a texture of the
/// picture's size, read back layer by layer.
class FrameGraph
{
public:
    FrameGraph(QWindow* window, Qt3DRender::QCamera* camera);
    ~FrameGraph();
    FrameGraph(const FrameGraph&) = delete;
    FrameGraph& operator=(const FrameGraph&) = delete;

    /// To be made the active frame graph, and thereby owned, by Qt 3D's render settings.
    [[nodiscard]] Qt3DRender::QFrameGraphNode* root() const;

    void setBackground(const QColor& color);

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
    void addPicture(Qt3DRender::QCamera* camera);
    void addIds(Qt3DRender::QCamera* camera);

    Qt3DRender::QRenderSurfaceSelector* m_root;
    Qt3DRender::QClearBuffers* m_background = nullptr;
    Qt3DRender::QRenderCapture* m_picture = nullptr;
    Qt3DRender::QSubtreeEnabler* m_ids = nullptr;
    Qt3DRender::QTexture2D* m_idColors = nullptr;
    Qt3DRender::QTexture2D* m_idDepths = nullptr;
    std::vector<Qt3DRender::QRenderCapture*> m_idLayers;
};

} // namespace carina
