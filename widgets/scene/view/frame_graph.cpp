#include "widgets/scene/view/frame_graph.h"

#include "widgets/scene/look/organ_effects.h"
#include "widgets/scene/view/picture_finish.h"

#include <QWindow>
#include <Qt3DRender/QBlendEquation>
#include <Qt3DRender/QBlendEquationArguments>
#include <Qt3DRender/QCamera>
#include <Qt3DRender/QCameraSelector>
#include <Qt3DRender/QClearBuffers>
#include <Qt3DRender/QClipPlane>
#include <Qt3DRender/QCullFace>
#include <Qt3DRender/QDepthTest>
#include <Qt3DRender/QFilterKey>
#include <Qt3DRender/QMultiSampleAntiAliasing>
#include <Qt3DRender/QNoDepthMask>
#include <Qt3DRender/QNoDraw>
#include <Qt3DRender/QParameter>
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

#include <tuple>
#include <utility>

namespace carina
{

namespace
{

using Qt3DRender::QFrameGraphNode;

/// A branch that draws nothing but what has a pass with this key and value.
Qt3DRender::QRenderPassFilter* passes(const char* key, int value, QFrameGraphNode* parent)
{
    auto* match = new Qt3DRender::QFilterKey;
    match->setName(QString::fromLatin1(key));
    match->setValue(value);
    auto* filter = new Qt3DRender::QRenderPassFilter(parent);
    filter->addMatch(match);
    return filter;
}

Qt3DRender::QRenderPassFilter* passes(const char* key, DrawLayer layer, QFrameGraphNode* parent)
{
    return passes(key, static_cast<int>(layer), parent);
}

/// Blends what comes over what is there.
void addBlending(Qt3DRender::QRenderStateSet* set)
{
    set->addRenderState(new Qt3DRender::QNoDepthMask);
    auto* blend = new Qt3DRender::QBlendEquationArguments;
    blend->setSourceRgb(Qt3DRender::QBlendEquationArguments::SourceAlpha);
    blend->setDestinationRgb(Qt3DRender::QBlendEquationArguments::OneMinusSourceAlpha);
    blend->setSourceAlpha(Qt3DRender::QBlendEquationArguments::Zero);
    blend->setDestinationAlpha(Qt3DRender::QBlendEquationArguments::One);
    set->addRenderState(blend);
    set->addRenderState(new Qt3DRender::QBlendEquation);
}

/// A texture of a render target, attached at a point.
template <class Texture>
Texture* attach(Qt3DRender::QRenderTarget* target,
                Qt3DRender::QRenderTargetOutput::AttachmentPoint point,
                Qt3DRender::QAbstractTexture::TextureFormat format)
{
    auto* output = new Qt3DRender::QRenderTargetOutput;
    auto* texture = new Texture(output);
    texture->setFormat(format);
    texture->setSize(1, 1);
    output->setAttachmentPoint(point);
    output->setTexture(texture);
    target->addOutput(output);
    return texture;
}

/// Colours and depths of the target that is drawn into in this quality.
std::pair<Qt3DRender::QAbstractTexture*, Qt3DRender::QAbstractTexture*>
attachAll(Qt3DRender::QRenderTarget* target, PictureQuality quality)
{
    using Output = Qt3DRender::QRenderTargetOutput;
    using Texture = Qt3DRender::QAbstractTexture;
    if (quality == PictureQuality::Fine) {
        using Samples = Qt3DRender::QTexture2DMultisample;
        auto* colors = attach<Samples>(target, Output::Color0, Texture::RGBA8_UNorm);
        auto* depths = attach<Samples>(target, Output::Depth, Texture::D24);
        colors->setSamples(kSamplesPerPixel);
        depths->setSamples(kSamplesPerPixel);
        return {colors, depths};
    }
    auto* colors = attach<Qt3DRender::QTexture2D>(target, Output::Color0, Texture::RGBA8_UNorm);
    colors->setMinificationFilter(Texture::Linear);
    colors->setMagnificationFilter(Texture::Linear);
    return {colors, attach<Qt3DRender::QTexture2D>(target, Output::Depth, Texture::D24)};
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

/// A branch that reads back what the branches before it drew. It clears the stencil
/// buffer, which does not exist: Qt 3D skips a branch without any operation, and its capture.
Qt3DRender::QRenderCapture* captures(QFrameGraphNode* parent)
{
    auto* capture = new Qt3DRender::QRenderCapture(parent);
    clears(capture, Qt3DRender::QClearBuffers::StencilBuffer);
    return capture;
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
    : m_root(new Qt3DRender::QRenderSurfaceSelector), m_clip(new Qt3DRender::QClipPlane(m_root))
{
    m_clip->setPlaneIndex(0);
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

/// How the fragments of a branch meet what is there already.
Qt3DRender::QRenderStateSet* FrameGraph::addStates(QFrameGraphNode* parent, Depth depth,
                                                   bool onlyFrontFaces)
{
    auto* set = new Qt3DRender::QRenderStateSet(parent);
    auto* cull = new Qt3DRender::QCullFace;
    cull->setMode(onlyFrontFaces ? Qt3DRender::QCullFace::Back : Qt3DRender::QCullFace::NoCulling);
    set->addRenderState(cull);
    auto* test = new Qt3DRender::QDepthTest;
    test->setDepthFunction(Qt3DRender::QDepthTest::LessOrEqual);
    set->addRenderState(test);
    if (depth == Depth::TestOnly)
        addBlending(set);
    m_states.push_back(set);
    return set;
}

Qt3DRender::QSubtreeEnabler* FrameGraph::branchOf(PictureQuality quality)
{
    auto* drawn = new Qt3DRender::QSubtreeEnabler(m_root);
    drawn->setEnabled(quality == PictureQuality::Quick);
    m_pictures[static_cast<std::size_t>(quality)].drawn.push_back(drawn);
    return drawn;
}

void FrameGraph::addSurfaces(PictureQuality quality, const Cameras& cameras,
                             QFrameGraphNode* parent)
{
    auto* viewport = new Qt3DRender::QViewport(parent);
    m_pictures[static_cast<std::size_t>(quality)].background =
        clears(viewport, Qt3DRender::QClearBuffers::ColorDepthBuffer);
    for (std::size_t view = 0; view < cameras.size(); ++view) {
        QFrameGraphNode* shown = addView(view, cameras, viewport);
        for (Qt3DRender::QRenderStateSet* set :
             {addStates(passes(kSurfacePass, DrawLayer::Closed, shown), Depth::Write, true),
              addStates(passes(kSurfacePass, DrawLayer::Open, shown), Depth::Write, false),
              addStates(passes(kSurfacePass, DrawLayer::Blended, shown), Depth::TestOnly, true)})
            if (quality == PictureQuality::Fine)
                set->addRenderState(new Qt3DRender::QMultiSampleAntiAliasing);
    }
}

void FrameGraph::addUnfinished(PictureQuality quality, const Cameras& cameras)
{
    auto* selector = new Qt3DRender::QRenderTargetSelector(branchOf(quality));
    auto* target = new Qt3DRender::QRenderTarget(selector);
    Picture& picture = m_pictures[static_cast<std::size_t>(quality)];
    std::tie(picture.colors, picture.depths) = attachAll(target, quality);
    selector->setTarget(target);
    addSurfaces(quality, cameras, selector);
}

/// Draws the window from what is unfinished.
void FrameGraph::addFinish(PictureQuality quality, const Cameras& cameras)
{
    auto* viewport = new Qt3DRender::QViewport(branchOf(quality));
    auto* selector = new Qt3DRender::QCameraSelector(viewport); // Qt 3D draws nothing without one
    selector->setCamera(cameras.front());
    auto* set =
        new Qt3DRender::QRenderStateSet(passes(kFinishPass, static_cast<int>(quality), selector));
    auto* cull = new Qt3DRender::QCullFace;
    cull->setMode(Qt3DRender::QCullFace::NoCulling);
    set->addRenderState(cull);
    auto* test = new Qt3DRender::QDepthTest;
    test->setDepthFunction(Qt3DRender::QDepthTest::Always);
    set->addRenderState(test);
    set->addRenderState(new Qt3DRender::QNoDepthMask);
}

void FrameGraph::addPicture(const Cameras& cameras)
{
    addSurfaces(PictureQuality::Quick, cameras, branchOf(PictureQuality::Quick));
    for (const PictureQuality quality : {PictureQuality::Smoothed, PictureQuality::Fine}) {
        addUnfinished(quality, cameras);
        addFinish(quality, cameras);
    }
    m_picture = captures(new Qt3DRender::QViewport(m_root));
}

void FrameGraph::setQuality(PictureQuality quality, const QSize& window)
{
    for (std::size_t place = 0; place < m_pictures.size(); ++place) {
        const Picture& picture = m_pictures[place];
        const bool isDrawn = place == static_cast<std::size_t>(quality);
        for (Qt3DRender::QSubtreeEnabler* branch : picture.drawn)
            branch->setEnabled(isDrawn);
        for (Qt3DRender::QAbstractTexture* texture : {picture.colors, picture.depths})
            if (texture != nullptr)
                texture->setSize(isDrawn ? window.width() : 1, isDrawn ? window.height() : 1);
    }
}

void FrameGraph::addIds(const Cameras& cameras)
{
    using Output = Qt3DRender::QRenderTargetOutput;
    auto* target = new Qt3DRender::QRenderTarget;
    m_idColors = attach<Qt3DRender::QTexture2D>(target, Output::Color0,
                                                Qt3DRender::QAbstractTexture::RGBA8_UNorm);
    m_idDepths =
        attach<Qt3DRender::QTexture2D>(target, Output::Depth, Qt3DRender::QAbstractTexture::D24);
    m_ids = new Qt3DRender::QSubtreeEnabler(m_root);
    m_ids->setEnabled(false);
    auto* selector = new Qt3DRender::QRenderTargetSelector(m_ids);
    selector->setTarget(target);
    auto* viewport = new Qt3DRender::QViewport(selector);
    auto* first = new Qt3DRender::QSubtreeEnabler(viewport);
    m_laterIds = new Qt3DRender::QSubtreeEnabler(viewport);

    for (int layer = 0; layer < kLayers; ++layer) {
        QFrameGraphNode* branch = layer == 0 ? first : m_laterIds;
        clears(branch, layer == 0 ? Qt3DRender::QClearBuffers::ColorDepthBuffer
                                  : Qt3DRender::QClearBuffers::ColorBuffer)
            ->setClearColor(QColor(0, 0, 0, 0));
        for (std::size_t view = 0; view < cameras.size(); ++view)
            addIdLayer(layer, addView(view, cameras, branch));
        m_idLayers.push_back(captures(branch));
    }
}

void FrameGraph::addIdLayer(int layer, QFrameGraphNode* view)
{
    const auto add = [&](DrawLayer drawn, bool onlyFrontFaces) {
        Qt3DRender::QRenderPassFilter* filter = passes(kIdPass, drawn, view);
        filter->addParameter(
            new Qt3DRender::QParameter(QStringLiteral("layer"), static_cast<float>(layer)));
        addStates(filter, Depth::Write, onlyFrontFaces);
    };
    if (layer > 0) {
        add(DrawLayer::Blended, true);
        return;
    }
    add(DrawLayer::Closed, true);
    add(DrawLayer::Open, false);
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

void FrameGraph::setBackground(const QColor& color)
{
    for (const Picture& picture : m_pictures)
        picture.background->setClearColor(color);
}

void FrameGraph::setCut(bool cut)
{
    if (cut == m_isCut)
        return;
    m_isCut = cut;
    for (Qt3DRender::QRenderStateSet* set : m_states) {
        if (cut)
            set->addRenderState(m_clip);
        else
            set->removeRenderState(m_clip);
    }
}

void FrameGraph::drawIds(Ids drawn, const QSize& pixels)
{
    m_idColors->setSize(pixels.width(), pixels.height());
    m_idDepths->setSize(pixels.width(), pixels.height());
    m_ids->setEnabled(drawn != Ids::None);
    m_laterIds->setEnabled(drawn == Ids::All);
}

} // namespace carina
