#include "widgets/scene/scene_view.h"

#include "widgets/scene/merged_surface.h"
#include "widgets/scene/scene_renderer.h"
#include "widgets/scene/scene_window.h"

#include "engine/core/expects.h"
#include "engine/core/monotonic_clock.h"

#include <QScreen>
#include <QVBoxLayout>

#include <algorithm>
#include <set>

namespace carina
{

namespace
{

constexpr std::chrono::milliseconds kTick{16};
constexpr Duration kDrawingBudget = std::chrono::milliseconds{25}; ///< of one frame
constexpr QColor kNight{18, 25, 31};

/// What presets show whole; everything, where no part asks for it.
Box boundsToFrame(std::span<const ScenePart> parts)
{
    Box framed;
    Box all;
    for (const ScenePart& part : parts) {
        const Box bounds = boundsOf(*part.levels.back());
        all.include(bounds);
        if (part.framed)
            framed.include(bounds);
    }
    return framed.empty() ? all : framed;
}

} // namespace

SceneView::SceneView(QWidget* parent)
    : QWidget(parent),
      m_window(new SceneWindow),
      m_renderer(std::make_unique<SceneRenderer>(m_window)),
      m_levelChoice({}, kDrawingBudget)
{
    QWidget* container = QWidget::createWindowContainer(m_window, this);
    container->setFocusPolicy(Qt::StrongFocus);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(container);
    setFocusProxy(container);
    setBackground(kNight);
    connect(m_window, &SceneWindow::tabbed, this,
            [this](bool forward) { focusNextPrevChild(forward); });
    connect(m_window, &SceneWindow::clicked, this, &SceneView::sendRay);
    connect(&m_tick, &QTimer::timeout, this, &SceneView::drawFrame);
    m_tick.setTimerType(Qt::PreciseTimer);
    m_tick.start(kTick);
}

SceneView::~SceneView() = default;

void SceneView::setParts(std::span<const ScenePart> parts, const Box& alsoFramed)
{
    m_ids.clear();
    for (const ScenePart& part : parts)
        m_ids.push_back(part.id);
    CARINA_EXPECTS(std::set<std::uint16_t>(m_ids.begin(), m_ids.end()).size() == m_ids.size());
    m_renderer->setParts(parts);
    m_levels = levelCount(parts);
    m_levelChoice = LevelChoice(trianglesPerLevel(parts), kDrawingBudget);
    Box framed = boundsToFrame(parts);
    framed.include(alsoFramed);
    m_window->camera().setBounds(framed);
    m_window->camera().setAspect(m_window->widthOverHeight());
}

void SceneView::showFrom(ViewPreset preset) { m_window->showFrom(preset); }

void SceneView::setInteractive(bool interactive) { m_window->setInteractive(interactive); }

void SceneView::setBackground(const QColor& color) { m_renderer->setBackground(color); }

int SceneView::level() const
{
    return m_fixedLevel ? std::clamp(*m_fixedLevel, 0, m_levels - 1) : m_levelChoice.level();
}

QImage SceneView::picture() { return m_window->isExposed() ? m_renderer->picture() : QImage(); }

std::map<std::uint16_t, std::size_t> SceneView::visiblePixels()
{
    std::map<std::uint16_t, std::size_t> pixels;
    for (const std::uint16_t id : m_ids)
        pixels[id] = 0;
    if (m_window->isExposed())
        m_renderer->countPixels(pixels);
    return pixels;
}

/// The frame's eyes, or the desktop's camera over the whole window.
std::vector<SceneCamera> SceneView::camerasOf(const SceneFrame& frame) const
{
    const OrbitCamera& camera = m_window->camera();
    if (!frame.eyes)
        return {{camera.pose(), camera.frustum(), m_window->pixels()}};
    std::vector<SceneCamera> cameras;
    for (const EyePicture& eye : *frame.eyes) {
        const PixelRect area =
            pixelsOf(eye.part, m_window->pixels().width, m_window->pixels().height);
        const PlacedPicture placed = letterboxed(eye.frustum, area);
        cameras.push_back({camera.poseOf(eye.X_AD), placed.frustum, placed.pixels});
    }
    return cameras;
}

void SceneView::sendRay(const QPointF& position)
{
    const double height = std::max(1, m_window->height());
    const OrbitCamera& camera = m_window->camera();
    Q_EMIT clicked(camera.pose().p_A_eye,
                   camera.directionThrough((position.x() - 0.5 * m_window->width()) / height,
                                           0.5 - position.y() / height));
}

void SceneView::drawFrame()
{
    if (!m_window->isExposed())
        return;
    DrawnFrame drawn;
    drawn.level = level();
    drawn.asked = monotonicNow();
    drawn.lit = m_timeOfLight.of(drawn.asked, m_window->screen()->refreshRate());
    if (m_source)
        drawn.frame = m_source(drawn.level, drawn.lit);
    m_renderer->setCameras(camerasOf(drawn.frame));
    m_renderer->apply(drawn.frame, drawn.level);
    m_renderer->draw();
    drawn.swapped = monotonicNow();
    m_times.add(drawn.asked, drawn.swapped);
    m_timeOfLight.frameTook(drawn.swapped - drawn.asked);
    m_levelChoice.frameTook(drawn.swapped - drawn.asked);
    if (m_listener)
        m_listener(drawn);
}

} // namespace carina
