#include "widgets/scene/frame_graph.h"

#include "widgets/scene/organ_effects.h"

#include <QWindow>
#include <Qt3DRender/QBlendEquation>
#include <Qt3DRender/QBlendEquationArguments>
#include <Qt3DRender/QCamera>
#include <Qt3DRender/QCameraSelector>
#include <Qt3DRender/QClearBuffers>
#include <Qt3DRender/QColorMask>
#include <Qt3DRender/QCullFace>
#include <Qt3DRender/QDepthTest>
#include <Qt3DRender/QFilterKey>
#include <Qt3DRender/QNoDepthMask>
#include <Qt3DRender/QNoDraw>
#include <Qt3DRender/QRenderCapture>
#include <Qt3DRender/QRenderPassFilter>
#include <Qt3DRender/QRenderStateSet>
#include <Qt3DRender/QRenderSurfaceSelector>
#include <Qt3DRender/QRenderTarget>
#include <Qt3DRender/QRenderTargetOutput>
#include <Qt3DRender/QRenderTargetSelector>
#include <Qt3DRender/QSubtreeEnabler>
#include <Qt3DRender/QTexture>
#include <Qt3DRender/QViewport>

namespace carina
{

namespace
{

using Qt3DRender::QFrameGraphNode;

/// A branch that draws nothing but this layer, with this pass.
Qt3DRender::QRenderPassFilter* passes(const char* key, int layer, QFrameGraphNode* parent)
{
    auto* match = new Qt3DRender::QFilterKey;
    match->setName(QString::fromLatin1(key));
    match->setValue(layer);
    auto* filter = new Qt3DRender::QRenderPassFilter(parent);
    filter->addMatch(match);
    return filter;
}

enum class Depth { Write, WriteOnly, TestOnly };

/// How the fragments of a branch meet what is there already.
Qt3DRender::QRenderStateSet* states(QFrameGraphNode* parent, Depth depth,
                                    Qt3DRender::QCullFace::CullingMode culled)
{
    auto* set = new Qt3DRender::QRenderStateSet(parent);
    auto* cull = new Qt3DRender::QCullFace;
    cull->setMode(culled);
    set->addRenderState(cull);
    auto* test = new Qt3DRender::QDepthTest;
    test->setDepthFunction(Qt3DRender::QDepthTest::LessOrEqual);
    set->addRenderState(test);
    if (depth == Depth::WriteOnly) {
        auto* mask = new Qt3DRender::QColorMask;
        mask->setRedMasked(false);
        mask->setGreenMasked(false);
        mask->setBlueMasked(false);
        mask->setAlphaMasked(false);
        set->addRenderState(mask);
    }
    if (depth == Depth::TestOnly) {
        set->addRenderState(new Qt3DRender::QNoDepthMask);
        auto* blend = new Qt3DRender::QBlendEquationArguments;
        blend->setSourceRgb(Qt3DRender::QBlendEquationArguments::SourceAlpha);
        blend->setDestinationRgb(Qt3DRender::QBlendEquationArguments::OneMinusSourceAlpha);
        blend->setSourceAlpha(Qt3DRender::QBlendEquationArguments::Zero);
        blend->setDestinationAlpha(Qt3DRender::QBlendEquationArguments::One);
        set->addRenderState(blend);
        set->addRenderState(new Qt3DRender::QBlendEquation);
    }
    return set;
}

/// A texture of a render target, attached at a point.
Qt3DRender::QTexture2D* attach(Qt3DRender::QRenderTarget* target,
                               Qt3DRender::QRenderTargetOutput::AttachmentPoint point,
                               Qt3DRender::QAbstractTexture::TextureFormat format)
{
    auto* output = new Qt3DRender::QRenderTargetOutput;
    auto* texture = new Qt3DRender::QTexture2D(output);
    texture->setFormat(format);
    texture->setSize(1, 1);
    output->setAttachmentPoint(point);
    output->setTexture(texture);
    target->addOutput(output);
    return texture;
}

/// A branch that clears buffers and draws nothing.
Qt3DRender::QClearBuffers* clears(QFrameGraphNode* parent,
                                  Qt3DRender::QClearBuffers::BufferType buffers)
{
    auto* clear = new Qt3DRender::QClearBuffers(parent);
    clear->setBuffers(buffers);
    new Qt3DRender::QNoDraw(clear);
    return clear;
}

/// A branch that reads back what the branches before it drew. It clears a stencil buffer that there
/// is none of: a branch that does nothing at all would be skipped together with its capture.
Qt3DRender::QRenderCapture* captures(QFrameGraphNode* parent)
{
    auto* capture = new Qt3DRender::QRenderCapture(parent);
    clears(capture, Qt3DRender::QClearBuffers::StencilBuffer);
    return capture;
}

/// The branches of all layers of the picture.
void addLayers(QFrameGraphNode* view)
{
    using Cull = Qt3DRender::QCullFace;
    states(passes(kSurfacePass, 0, view), Depth::Write, Cull::NoCulling);
    for (int layer = 1; layer < kLayers; ++layer) {
        Qt3DRender::QRenderPassFilter* surfaces = passes(kSurfacePass, layer, view);
        if (layer == layerOf(MaterialGroup::Airway))
            states(surfaces, Depth::TestOnly, Cull::Front);
        if (layer != layerOf(MaterialGroup::Veil))
            states(surfaces, Depth::WriteOnly, Cull::Back);
        states(surfaces, Depth::TestOnly, Cull::Back);
    }
}

/// Pixels as shares of the window. Qt 3D rounds the shares down to pixels, and y from below:
/// parts of a pixel keep that from missing by one.
QRectF shareOf(const PixelRect& pixels, const QSize& window)
{
    return {(pixels.x + 0.25) / window.width(), (pixels.y - 0.5) / window.height(),
            (pixels.width + 0.25) / window.width(), (pixels.height + 0.25) / window.height()};
}

} // namespace

FrameGraph::FrameGraph(QWindow* window, const Cameras& cameras)
    : m_root(new Qt3DRender::QRenderSurfaceSelector)
{
    m_root->setSurface(window);
    addPicture(cameras);
    addIds(cameras);
    for (std::size_t view = 1; view < m_views.size(); ++view)
        hideView(view);
}

FrameGraph::~FrameGraph() = default;

QFrameGraphNode* FrameGraph::root() const { return m_root; }

QFrameGraphNode* FrameGraph::addView(std::size_t view, const Cameras& cameras,
                                     QFrameGraphNode* parent)
{
    auto* shown = new Qt3DRender::QSubtreeEnabler(parent);
    auto* part = new Qt3DRender::QViewport(shown);
    m_views[view].push_back({shown, part});
    auto* selector = new Qt3DRender::QCameraSelector(part);
    selector->setCamera(cameras[view]);
    return selector;
}

void FrameGraph::addPicture(const Cameras& cameras)
{
    auto* viewport = new Qt3DRender::QViewport(m_root);
    m_background = clears(viewport, Qt3DRender::QClearBuffers::ColorDepthBuffer);
    for (std::size_t view = 0; view < cameras.size(); ++view)
        addLayers(addView(view, cameras, viewport));
    m_picture = captures(viewport);
}

void FrameGraph::addIds(const Cameras& cameras)
{
    using Output = Qt3DRender::QRenderTargetOutput;
    auto* target = new Qt3DRender::QRenderTarget;
    m_idColors = attach(target, Output::Color0, Qt3DRender::QAbstractTexture::RGBA8_UNorm);
    m_idDepths = attach(target, Output::Depth, Qt3DRender::QAbstractTexture::D24);
    m_ids = new Qt3DRender::QSubtreeEnabler(m_root);
    m_ids->setEnabled(false);
    auto* selector = new Qt3DRender::QRenderTargetSelector(m_ids);
    selector->setTarget(target);
    auto* viewport = new Qt3DRender::QViewport(selector);

    for (int layer = 0; layer < kLayers; ++layer) {
        clears(viewport, layer == 0 ? Qt3DRender::QClearBuffers::ColorDepthBuffer
                                    : Qt3DRender::QClearBuffers::ColorBuffer)
            ->setClearColor(QColor(0, 0, 0, 0));
        for (std::size_t view = 0; view < cameras.size(); ++view)
            states(passes(kIdPass, layer, addView(view, cameras, viewport)), Depth::Write,
                   layer == 0 ? Qt3DRender::QCullFace::NoCulling : Qt3DRender::QCullFace::Back);
        m_idLayers.push_back(captures(viewport));
    }
}

void FrameGraph::showView(std::size_t view, const PixelRect& pixels, const QSize& window)
{
    for (const Branch& branch : m_views[view]) {
        branch.part->setNormalizedRect(shareOf(pixels, window));
        branch.shown->setEnabled(true);
    }
}

void FrameGraph::hideView(std::size_t view)
{
    for (const Branch& branch : m_views[view])
        branch.shown->setEnabled(false);
}

void FrameGraph::setBackground(const QColor& color) { m_background->setClearColor(color); }

void FrameGraph::setIdsDrawn(bool drawn, const QSize& pixels)
{
    m_idColors->setSize(pixels.width(), pixels.height());
    m_idDepths->setSize(pixels.width(), pixels.height());
    m_ids->setEnabled(drawn);
}

} // namespace carina
