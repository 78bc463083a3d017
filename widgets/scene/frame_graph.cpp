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

} // namespace

FrameGraph::FrameGraph(QWindow* window, Qt3DRender::QCamera* camera)
    : m_root(new Qt3DRender::QRenderSurfaceSelector)
{
    m_root->setSurface(window);
    addPicture(camera);
    addIds(camera);
}

FrameGraph::~FrameGraph() = default;

QFrameGraphNode* FrameGraph::root() const { return m_root; }

void FrameGraph::addPicture(Qt3DRender::QCamera* camera)
{
    using Cull = Qt3DRender::QCullFace;
    auto* viewport = new Qt3DRender::QViewport(m_root);
    m_background = new Qt3DRender::QClearBuffers(viewport);
    m_background->setBuffers(Qt3DRender::QClearBuffers::ColorDepthBuffer);
    new Qt3DRender::QNoDraw(m_background);

    auto* view = new Qt3DRender::QCameraSelector(viewport);
    view->setCamera(camera);
    states(passes(kSurfacePass, 0, view), Depth::Write, Cull::NoCulling);
    for (int layer = 1; layer < kLayers; ++layer) {
        Qt3DRender::QRenderPassFilter* surfaces = passes(kSurfacePass, layer, view);
        if (layer == layerOf(MaterialGroup::Airway))
            states(surfaces, Depth::TestOnly, Cull::Front);
        if (layer != layerOf(MaterialGroup::Veil))
            states(surfaces, Depth::WriteOnly, Cull::Back);
        states(surfaces, Depth::TestOnly, Cull::Back);
    }

    // The last branch clears a depth buffer that nobody needs any more: a branch that does nothing
    // at all would be skipped together with its capture.
    m_picture = new Qt3DRender::QRenderCapture(viewport);
    auto* last = new Qt3DRender::QClearBuffers(m_picture);
    last->setBuffers(Qt3DRender::QClearBuffers::DepthBuffer);
    new Qt3DRender::QNoDraw(last);
}

void FrameGraph::addIds(Qt3DRender::QCamera* camera)
{
    using Output = Qt3DRender::QRenderTargetOutput;
    auto* target = new Qt3DRender::QRenderTarget;
    m_idColors = attach(target, Output::Color0, Qt3DRender::QAbstractTexture::RGBA8_UNorm);
    m_idDepths = attach(target, Output::Depth, Qt3DRender::QAbstractTexture::D24);
    m_ids = new Qt3DRender::QSubtreeEnabler(m_root);
    m_ids->setEnabled(false);
    auto* selector = new Qt3DRender::QRenderTargetSelector(m_ids);
    selector->setTarget(target);
    auto* view = new Qt3DRender::QCameraSelector(new Qt3DRender::QViewport(selector));
    view->setCamera(camera);

    for (int layer = 0; layer < kLayers; ++layer) {
        auto* capture = new Qt3DRender::QRenderCapture(view);
        auto* clear = new Qt3DRender::QClearBuffers(capture);
        clear->setBuffers(layer == 0 ? Qt3DRender::QClearBuffers::ColorDepthBuffer
                                     : Qt3DRender::QClearBuffers::ColorBuffer);
        clear->setClearColor(QColor(0, 0, 0, 0));
        states(passes(kIdPass, layer, clear), Depth::Write,
               layer == 0 ? Qt3DRender::QCullFace::NoCulling : Qt3DRender::QCullFace::Back);
        m_idLayers.push_back(capture);
    }
}

void FrameGraph::setBackground(const QColor& color) { m_background->setClearColor(color); }

void FrameGraph::setIdsDrawn(bool drawn, const QSize& pixels)
{
    m_idColors->setSize(pixels.width(), pixels.height());
    m_idDepths->setSize(pixels.width(), pixels.height());
    m_ids->setEnabled(drawn);
}

} // namespace carina
