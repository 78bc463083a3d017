#include "widgets/scene/view/scene_renderer.h"

#include "engine/core/expects.h"
#include "widgets/scene/look/chest_uniforms.h"

#include <QVector4D>
#include <QWindow>
#include <Qt3DCore/QAspectEngine>
#include <Qt3DCore/QEntity>
#include <Qt3DRender/QCamera>
#include <Qt3DRender/QParameter>
#include <Qt3DRender/QRenderAspect>
#include <Qt3DRender/QRenderCapture>
#include <Qt3DRender/QRenderSettings>

#include <algorithm>

namespace carina
{

namespace
{

/// Frames within which a capture that was asked for must have come back.
constexpr int kMostCaptureFrames = 8;

/// Of ids that are read while others are drawn: reading takes time for each pixel.
constexpr QSize kMostRead{320, 240};

/// The same shape, and at most this size.
QSize atMost(const QSize& size, const QSize& most)
{
    const bool fits = size.width() <= most.width() && size.height() <= most.height();
    return fits ? size : size.scaled(most, Qt::KeepAspectRatio).expandedTo({1, 1});
}

QVector3D toQt(const Vec3& v)
{
    const Vec3f single = v.cast<float>();
    return {single.x(), single.y(), single.z()};
}

Cameras makeCameras(Qt3DCore::QNode* parent)
{
    Cameras cameras{};
    for (Qt3DRender::QCamera*& camera : cameras)
        camera = new Qt3DRender::QCamera(parent);
    return cameras;
}

/// Sees the frustum's edges, given at unit distance, as far out on the near plane as they are
/// there.
void aim(Qt3DRender::QCamera& camera, const SceneCamera& seen)
{
    const auto onNearPlane = [&seen](double tangent) {
        return static_cast<float>(tangent * seen.pose.nearPlane);
    };
    camera.lens()->setFrustumProjection(
        onNearPlane(seen.frustum.left), onNearPlane(seen.frustum.right),
        onNearPlane(seen.frustum.bottom), onNearPlane(seen.frustum.top),
        static_cast<float>(seen.pose.nearPlane), static_cast<float>(seen.pose.farPlane));
    camera.setPosition(toQt(seen.pose.p_A_eye));
    camera.setViewCenter(toQt(seen.pose.p_A_target));
    camera.setUpVector(toQt(seen.pose.up_A));
}

void countIn(const QImage& ids, std::map<std::uint16_t, std::size_t>& pixels)
{
    for (int y = 0; y < ids.height(); ++y) {
        const auto* row = reinterpret_cast<const QRgb*>(ids.constScanLine(y));
        for (int x = 0; x < ids.width(); ++x)
            if (const auto id = idInPixel(row[x]))
                ++pixels[*id];
    }
}

} // namespace

std::optional<std::uint16_t> idInPixel(QRgb pixel)
{
    if (qBlue(pixel) != 255)
        return std::nullopt;
    return static_cast<std::uint16_t>(qRed(pixel) + 256 * qGreen(pixel));
}

SceneRenderer::SceneRenderer(QWindow* window)
    : m_window(window),
      m_engine(std::make_unique<Qt3DCore::QAspectEngine>()),
      m_root(new Qt3DCore::QEntity),
      m_cameras(makeCameras(m_root)),
      m_frameGraph(window, m_cameras),
      m_effects(m_root),
      m_finish(m_frameGraph.unfinished(PictureQuality::Smoothed),
               m_frameGraph.unfinished(PictureQuality::Fine), m_root)
{
    m_engine->setRunMode(Qt3DCore::QAspectEngine::Manual);
    m_engine->registerAspect(new Qt3DRender::QRenderAspect);
    auto* settings = new Qt3DRender::QRenderSettings;
    settings->setActiveFrameGraph(m_frameGraph.root());
    m_root->addComponent(settings);
    m_engine->setRootEntity(Qt3DCore::QEntityPtr(m_root));
}

SceneRenderer::~SceneRenderer()
{
    m_idReply.reset();
    m_figures.clear();
    m_surfaces.clear();
    m_engine->setRootEntity({});
}

void SceneRenderer::setParts(std::span<const ScenePart> parts)
{
    endReading();
    m_surfaces.clear();
    m_surfaces = surfacesOf(parts);
}

void SceneRenderer::endReading()
{
    if (!m_idReply)
        return;
    m_idReply.reset();
    m_frameGraph.drawIds(FrameGraph::Ids::None);
}

void SceneRenderer::setFigureParts(std::span<const ScenePart> parts)
{
    m_figures.clear();
    m_figures = surfacesOf(parts);
    m_figureLevels.assign(parts.size(), 0);
}

SceneRenderer::Surfaces SceneRenderer::surfacesOf(std::span<const ScenePart> parts)
{
    Surfaces surfaces;
    for (MergedSurface& surface : mergedSurfaces(parts)) {
        Qt3DRender::QEffect* effect = m_effects.of(surface.key.layer, surface.key.region);
        surfaces.push_back(std::make_unique<SurfaceEntity>(std::move(surface), effect, m_root));
        surfaces.back()->setCut(m_isCut);
    }
    return surfaces;
}

void SceneRenderer::setCameras(std::span<const SceneCamera> cameras)
{
    CARINA_EXPECTS(cameras.size() <= kMostEyes);
    if (!cameras.empty())
        m_forward_A = (cameras[0].pose.p_A_target - cameras[0].pose.p_A_eye).normalized();
    for (std::size_t view = 0; view < kMostEyes; ++view) {
        if (view < cameras.size()) {
            aim(*m_cameras[view], cameras[view]);
            m_frameGraph.showView(view, cameras[view].pixels, windowPixels());
        } else {
            m_frameGraph.hideView(view);
        }
    }
}

void SceneRenderer::apply(const SceneFrame& frame, std::span<const int> levels)
{
    if (isJawMoved(frame.throat.X_AJ))
        m_effects.letJawMove();
    if (frame.airway.isThere())
        m_effects.letAirwayChange();
    if (frame.throat.neck.isBent())
        m_effects.letNeckBend();
    if (frame.blade.isThere())
        m_effects.letBladePush();
    m_effects.setSpotlight(m_spotlight ? std::optional{Spotlight{m_forward_A, *m_spotlight}}
                                       : std::nullopt);
    m_effects.countFrame();
    for (const std::unique_ptr<SurfaceEntity>& surface : m_surfaces) {
        surface->apply(frame);
        surface->show(levels, m_forward_A);
    }
    for (const std::unique_ptr<SurfaceEntity>& surface : m_figures) {
        surface->apply(frame);
        surface->show(m_figureLevels, m_forward_A);
    }
}

void SceneRenderer::setSection(const std::optional<Section>& section)
{
    m_isCut = section.has_value();
    m_frameGraph.setCut(m_isCut);
    for (const Surfaces* surfaces : {&m_surfaces, &m_figures})
        for (const std::unique_ptr<SurfaceEntity>& surface : *surfaces)
            surface->setCut(m_isCut);
    const Section cut = section.value_or(Section{Vec3::Zero(), 0.0, Cut::All});
    m_effects.cut().section->setValue(
        QVector4D{toQt(cut.normal_A), static_cast<float>(cut.distance)});
    m_effects.cut().cutAway->setValue(cut.cut == Cut::AllButAirway ? 1.0F : 0.0F);
}

void SceneRenderer::draw() { m_engine->processFrame(); }

QImage SceneRenderer::picture()
{
    const std::vector<QImage> images = captured({m_frameGraph.pictureCapture()});
    return images.empty() ? QImage() : images.front();
}

void SceneRenderer::countPixels(std::map<std::uint16_t, std::size_t>& pixels)
{
    m_frameGraph.drawIds(FrameGraph::Ids::All, windowPixels());
    for (const QImage& layer : captured(m_frameGraph.idCaptures()))
        countIn(layer, pixels);
    m_frameGraph.drawIds(FrameGraph::Ids::None);
}

QImage SceneRenderer::opaqueIds()
{
    m_frameGraph.drawIds(FrameGraph::Ids::Opaque, windowPixels());
    const std::vector<QImage> layers = captured({m_frameGraph.idCaptures().front()});
    m_frameGraph.drawIds(FrameGraph::Ids::None);
    return layers.empty() ? QImage() : layers.front();
}

void SceneRenderer::askForIds()
{
    if (m_idReply)
        return;
    m_frameGraph.drawIds(FrameGraph::Ids::Opaque, atMost(windowPixels(), kMostRead));
    m_idReply.reset(m_frameGraph.idCaptures().front()->requestCapture());
    m_idFrames = 0;
}

std::optional<QImage> SceneRenderer::takeIds()
{
    if (!m_idReply || (!m_idReply->isComplete() && ++m_idFrames <= kMostCaptureFrames))
        return std::nullopt;
    const std::unique_ptr<Qt3DRender::QRenderCaptureReply> reply = std::move(m_idReply);
    m_frameGraph.drawIds(FrameGraph::Ids::None);
    if (!reply->isComplete())
        return std::nullopt;
    QImage image = reply->image();
    image.reinterpretAsFormat(QImage::Format_RGB32); // alpha means nothing here
    return image;
}

QSize SceneRenderer::windowPixels() const
{
    return m_window->size() * m_window->devicePixelRatio();
}

/// The captures of one and the same frame, as RGB32; none if they do not come.
std::vector<QImage>
SceneRenderer::captured(const std::vector<Qt3DRender::QRenderCapture*>& captures)
{
    std::vector<std::unique_ptr<Qt3DRender::QRenderCaptureReply>> replies;
    for (Qt3DRender::QRenderCapture* capture : captures)
        replies.emplace_back(capture->requestCapture());
    const auto complete = [](const auto& reply) { return reply->isComplete(); };
    for (int frame = 0; frame < kMostCaptureFrames; ++frame) {
        if (std::all_of(replies.begin(), replies.end(), complete))
            break;
        draw();
    }
    std::vector<QImage> images;
    for (const auto& reply : replies) {
        if (!reply->isComplete())
            return {};
        QImage image = reply->image();
        image.reinterpretAsFormat(QImage::Format_RGB32); // alpha means nothing here
        images.push_back(std::move(image));
    }
    return images;
}

} // namespace carina
