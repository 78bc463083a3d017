#include "widgets/scene/view/scene_view.h"

#include "widgets/scene/view/same_picture.h"
#include "widgets/scene/view/scene_renderer.h"
#include "widgets/scene/view/scene_window.h"
#include "widgets/scene/view/shared_time.h"
#include "widgets/scene/view/spoken_scene.h"

#include "engine/core/expects.h"
#include "engine/core/monotonic_clock.h"
#include "widgets/inside_window.h"

#include <QScreen>
#include <QVBoxLayout>

#include <algorithm>
#include <set>
#include <utility>

namespace carina
{

namespace
{

constexpr Duration kDrawingBudget = std::chrono::milliseconds{25}; ///< of one frame
constexpr QColor kNight{18, 25, 31};

/// Of all views of this program.
SharedTime& sharedTime()
{
    static SharedTime times;
    return times;
}

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

std::vector<DetailEye> eyesOf(std::span<const SceneCamera> cameras)
{
    std::vector<DetailEye> eyes;
    for (const SceneCamera& camera : cameras)
        eyes.push_back({camera.pose.p_A_eye,
                        camera.pixels.height / (camera.frustum.top - camera.frustum.bottom)});
    return eyes;
}

bool isSameCamera(const SceneCamera& a, const SceneCamera& b)
{
    return a.pose.p_A_eye == b.pose.p_A_eye && a.pose.p_A_target == b.pose.p_A_target
           && a.pose.up_A == b.pose.up_A && a.pose.nearPlane == b.pose.nearPlane
           && a.pose.farPlane == b.pose.farPlane && a.frustum.left == b.frustum.left
           && a.frustum.right == b.frustum.right && a.frustum.bottom == b.frustum.bottom
           && a.frustum.top == b.frustum.top && a.pixels == b.pixels;
}

bool areSameCameras(std::span<const SceneCamera> a, std::span<const SceneCamera> b)
{
    return std::ranges::equal(a, b, isSameCamera);
}

IdPicture idPictureOf(const QImage& image)
{
    IdPicture picture{.width = image.width(), .height = image.height()};
    picture.ids.reserve(std::size_t(image.width()) * std::size_t(image.height()));
    for (int y = 0; y < image.height(); ++y) {
        const auto* row = reinterpret_cast<const QRgb*>(image.constScanLine(y));
        for (int x = 0; x < image.width(); ++x)
            picture.ids.push_back(idInPixel(row[x]));
    }
    return picture;
}

} // namespace

SceneView::SceneView(QWidget* parent)
    : QWidget(parent),
      m_window(new SceneWindow),
      m_renderer(std::make_unique<SceneRenderer>(m_window)),
      m_labels(*this),
      m_figureNames(*this),
      m_detail({}, kDrawingBudget),
      m_quality(kDrawingBudget)
{
    QWidget* container = QWidget::createWindowContainer(m_window, this);
    container->setFocusPolicy(Qt::StrongFocus);
    speakScene(*container, *m_window);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(container);
    setFocusProxy(container);
    setBackground(kNight);
    connect(m_window, &SceneWindow::tabbed, this, [this, container](bool forward) {
        container->setFocus(); // which its window took away: the way goes on from here
        focusNextPrevChild(forward);
    });
    connect(m_window, &SceneWindow::uncovered, this, [this] { m_rest.stir(); });
    connect(m_window, &SceneWindow::clicked, this, &SceneView::sendRay);
    connect(m_window, &SceneWindow::headTurned, this, &SceneView::headTurned);
    connect(m_window, &SceneWindow::headNeared, this, &SceneView::headNeared);
    connect(m_window, &SceneWindow::headReturned, this, &SceneView::headReturned);
    connect(&m_tick, &QTimer::timeout, this, &SceneView::drawFrame);
    m_tick.setTimerType(Qt::PreciseTimer);
    m_tick.setSingleShot(true);
    m_tick.start(m_interval);
}

SceneView::~SceneView() { sharedTime().forget(this); }

void SceneView::setParts(std::span<const ScenePart> parts, const Box& alsoFramed)
{
    std::set<std::uint16_t> ids;
    for (const ScenePart& part : parts)
        ids.insert(part.id);
    CARINA_EXPECTS(ids.size() == parts.size());
    m_parts.assign(parts.begin(), parts.end());
    Box framed = boundsToFrame(parts);
    framed.include(alsoFramed);
    m_window->camera().setBounds(framed);
    m_window->camera().setAspect(m_window->widthOverHeight());
    m_detail = DetailChoice{{}, kDrawingBudget};
    m_quality.beginAnew();
    m_eyes.clear();
    m_instead.reset();
    applySection();
    setLooks({});
}

void SceneView::setFigures(std::span<const SceneFigure> figures)
{
    std::set<std::uint16_t> ids;
    for (const ScenePart& part : m_parts)
        ids.insert(part.id);
    m_figureParts.clear();
    for (const SceneFigure& figure : figures)
        for (const ScenePart& part : figure.parts) {
            CARINA_EXPECTS(ids.insert(part.id).second);
            m_figureParts.push_back(part);
        }
    m_rest.stir();
    m_renderer->setFigureParts(m_figureParts);
    m_figureNames.setFigures(figures);
}

void SceneView::setLooks(const PartLooks& looks)
{
    m_own.looks = looks;
    if (!m_instead)
        applyLooks();
}

void SceneView::applyLooks()
{
    m_rest.stir();
    m_shown = withLooks(m_parts, inForce().looks);
    m_renderer->setParts(m_shown);
    m_labels.setParts(m_shown, inForce().looks);
    m_detail.setParts(m_shown);
}

void SceneView::drawInstead(const std::optional<SceneSettings>& settings)
{
    const SceneSettings before = inForce();
    m_instead = settings;
    if (inForce().looks != before.looks)
        applyLooks();
    if (inForce().section != before.section)
        applySection();
}

const OrbitCamera& SceneView::camera() const { return m_window->camera(); }

void SceneView::setSection(const std::optional<Section>& section)
{
    m_own.section = section;
    applySection();
}

void SceneView::applySection()
{
    m_rest.stir();
    m_renderer->setSection(inForce().section);
}

void SceneView::setErrorMap(const std::optional<ErrorMap>& map)
{
    m_rest.stir();
    m_renderer->setErrorMap(map);
}

void SceneView::setSpotlight(std::optional<Length> trueColorAt)
{
    m_rest.stir();
    m_renderer->setSpotlight(trueColorAt);
}

void SceneView::setNearest(std::optional<Length> nearest)
{
    if (nearest == m_nearest)
        return;
    m_rest.stir();
    m_nearest = nearest;
}

void SceneView::setFixedLevel(std::optional<int> level)
{
    m_rest.stir();
    m_detail.fix(level);
}

void SceneView::setFixedQuality(std::optional<PictureQuality> quality)
{
    m_rest.stir();
    m_quality.fix(quality);
}

void SceneView::setFixedLook(std::optional<SurfaceLook> look)
{
    m_rest.stir();
    m_look = look;
}

bool SceneView::isPreparing() const { return m_renderer->isPreparing(); }

void SceneView::resizeEvent(QResizeEvent*) { m_quality.beginAnew(); }

void SceneView::showFrom(ViewPreset preset) { m_window->showFrom(preset); }

void SceneView::showFrom(const CameraPose& pose) { m_window->camera().look(pose); }

void SceneView::follow(const SceneView& other)
{
    m_followed = &other;
    takeNoInput();
}

void SceneView::takeNoInput()
{
    m_window->setFlag(Qt::WindowTransparentForInput);
    focusProxy()->setFocusPolicy(Qt::NoFocus);
}

void SceneView::takeFrom(const SceneView& other)
{
    m_window->camera() = other.camera();
    m_window->camera().setAspect(m_window->widthOverHeight());
    const SceneSettings& theirs = other.inForce();
    if (m_own.looks != theirs.looks)
        setLooks(theirs.looks);
    if (m_own.section != theirs.section)
        setSection(theirs.section);
}

void SceneView::setLie(Lie lie) { m_window->camera().setLie(lie); }

void SceneView::setBackground(const QColor& color)
{
    m_rest.stir();
    m_renderer->setBackground(color);
}

QImage SceneView::picture() { return m_window->isExposed() ? m_renderer->picture() : QImage(); }

std::map<std::uint16_t, std::size_t> SceneView::visiblePixels()
{
    std::map<std::uint16_t, std::size_t> pixels;
    for (const ScenePart& part : m_parts)
        pixels[part.id] = 0;
    for (const ScenePart& part : m_figureParts)
        pixels[part.id] = 0;
    if (m_window->isExposed())
        m_renderer->countPixels(pixels);
    return pixels;
}

IdPicture SceneView::opaqueIds()
{
    if (!m_window->isExposed())
        return {};
    return idPictureOf(m_renderer->opaqueIds());
}

/// Before the frame is drawn whose ids are wanted.
void SceneView::beginToRead(const SceneFrame& frame)
{
    if (!std::exchange(m_asksForIds, false) || m_renderer->isReadingIds())
        return;
    m_readFrame = frame;
    m_renderer->askForIds();
}

void SceneView::tellIds()
{
    const auto ids = m_renderer->takeIds();
    if (ids && !ids->isNull() && m_idListener)
        m_idListener(idPictureOf(*ids), m_readFrame);
}

/// The frame's eyes, or the desktop's camera over the whole window.
std::vector<SceneCamera> SceneView::camerasOf(const SceneFrame& frame) const
{
    const OrbitCamera& camera = m_window->camera();
    if (!frame.eyes)
        return {{frame.viewpoint ? camera.poseOf(*frame.viewpoint) : camera.pose(),
                 camera.frustum(), m_window->pixels()}};
    std::vector<SceneCamera> cameras;
    for (const EyePicture& eye : *frame.eyes) {
        const PixelRect area =
            pixelsOf(eye.part, m_window->pixels().width, m_window->pixels().height);
        const PlacedPicture placed = letterboxed(eye.frustum, area);
        cameras.push_back({camera.poseOf(eye.X_AD), placed.frustum, placed.pixels});
        if (m_nearest)
            cameras.back().pose.nearPlane = m_nearest->si;
    }
    return cameras;
}

void SceneView::sendRay(const QPointF& position)
{
    if (const auto ray = rayAt(position))
        Q_EMIT clicked(ray->p_A_eye, ray->dir_A);
}

/// Through the picture of the eye that has this pixel of the widget.
std::optional<SightRay> SceneView::rayAt(const QPointF& position) const
{
    for (const EyeSight& eye : sightsOf(camerasOf(m_frame))) {
        const QRectF area{eye.picture};
        if (area.contains(position))
            return rayThrough({(position.x() - area.x()) / area.width(),
                               (position.y() - area.y()) / area.height()},
                              eye.sight);
    }
    return std::nullopt;
}

std::optional<SightRay> SceneView::rayUnderMouse() const
{
    const auto& place = m_window->mousePlace();
    return place ? rayAt(*place) : std::nullopt;
}

/// By where the eyes were in the latest frame: the frame source is asked for the frame only once
/// the levels are known.
void SceneView::chooseDetail()
{
    if (m_eyes.empty())
        m_eyes = eyesOf(camerasOf({}));
    m_detail.choose(m_eyes, m_rest.isFull());
}

void SceneView::drawFrame()
{
    const LocalTime began = monotonicNow();
    if (m_window->isExposed() && isInsideWindow(*this)) // behind another dock it stays exposed
        drawExposed(began);
    else
        m_rest.stir();
    const LocalTime ended = monotonicNow();
    sharedTime().took(this, ended, ended - began, m_interval);
    const auto left = m_interval - std::chrono::ceil<std::chrono::milliseconds>(ended - began);
    m_tick.start(std::max(left, std::chrono::milliseconds{0}));
}

/// The eyes, with their pictures in pixels of the widget.
std::vector<EyeSight> SceneView::sightsOf(const std::vector<SceneCamera>& cameras) const
{
    const double ratio = m_window->devicePixelRatio();
    std::vector<EyeSight> sights;
    for (const SceneCamera& camera : cameras) {
        const QRectF pixels(camera.pixels.x, camera.pixels.y, camera.pixels.width,
                            camera.pixels.height);
        sights.push_back({{camera.pose, camera.frustum, inForce().section},
                          QRectF{pixels.topLeft() / ratio, pixels.size() / ratio}.toAlignedRect()});
    }
    return sights;
}

void SceneView::placeLabels(const SceneFrame& frame, const std::vector<SceneCamera>& cameras)
{
    const std::vector<EyeSight> sights = sightsOf(cameras);
    if (frame.eyes) {
        m_labels.hide();
        if (m_sides)
            m_sides->hide();
        m_figureNames.place(frame, sights);
        return;
    }
    if (m_sides)
        m_sides->place(frame, cameras.front().pose, m_covered);
    std::vector<QRect> taken = m_sides ? m_sides->boxes() : std::vector<QRect>{};
    if (m_covered > 0)
        taken.emplace_back(0, 0, width(), m_covered);
    m_figureNames.place(frame, sights, taken);
    std::ranges::move(m_figureNames.boxes(), std::back_inserter(taken));
    m_labels.place(frame, sights.front().sight, taken);
}

bool SceneView::hasToBeDrawn(const SceneFrame& frame, const std::vector<SceneCamera>& cameras)
{
    if (m_quality.isFixed())
        return true;
    const bool isHeld =
        !m_rest.comes(areSameCameras(cameras, m_cameras) && areDrawnAlike(frame, m_frame));
    return !isHeld || m_asksForIds || m_renderer->isReadingIds() || isPreparing();
}

void SceneView::drawScene(const SceneFrame& frame, const std::vector<SceneCamera>& cameras,
                          PictureQuality quality)
{
    m_drawnQuality = quality;
    const bool isQuick = quality == PictureQuality::Quick;
    m_renderer->setQuality(quality);
    m_renderer->setLook(m_look.value_or(isQuick ? SurfaceLook::Plain : SurfaceLook::Moist));
    m_renderer->setCameras(cameras);
    m_renderer->apply(frame, m_detail.levels());
    beginToRead(frame);
    m_renderer->draw();
}

/// Of a frame that was drawn as most are. Surfaces have the time first, and edges what is left.
void SceneView::takeTime(Duration took)
{
    m_timeOfLight.frameTook(took);
    const Duration budget =
        fromSeconds(toSeconds(kDrawingBudget) * sharedTime().leftFor(m_interval));
    m_quality.setBudget(budget);
    m_detail.setBudget(budget);
    m_quality.frameTook(took, m_interval, m_detail.isFinest());
    if (m_quality.isFixed() || m_drawnQuality == PictureQuality::Quick)
        m_detail.frameTook(took);
}

void SceneView::drawExposed(LocalTime asked)
{
    if (m_followed)
        takeFrom(*m_followed);
    if (!areSameCameras(camerasOf(m_frame), m_cameras)) // turned, or of another size
        m_rest.stir();
    const bool wasFull = m_rest.isFull(); // and so are its levels of detail
    const PictureQuality before = m_drawnQuality;
    chooseDetail();
    DrawnFrame drawn;
    drawn.level = level();
    drawn.triangles = m_detail.triangles();
    drawn.asked = asked;
    drawn.lit = m_timeOfLight.of(drawn.asked, m_window->screen()->refreshRate());
    if (m_source)
        drawn.frame = m_source(drawn.level, drawn.lit);
    const std::vector<SceneCamera> cameras = camerasOf(drawn.frame);
    m_eyes = eyesOf(cameras);
    const bool isDrawn = hasToBeDrawn(drawn.frame, cameras);
    const bool isFull = wasFull && m_rest.isFull();
    if (isDrawn)
        drawScene(drawn.frame, cameras, isFull ? PictureQuality::Fine : m_quality.quality());
    drawn.swapped = monotonicNow();
    placeLabels(drawn.frame, cameras);
    m_frame = drawn.frame;
    m_cameras = cameras;
    if (!cameras.empty())
        m_sight = {cameras.front().pose, cameras.front().frustum, inForce().section};
    m_window->holdCamera(m_frame.viewpoint.has_value());
    m_window->steerHead(m_frame.isHeadSteered);
    m_times.add(drawn.asked, drawn.swapped);
    if (isDrawn && isFull)
        m_rest.fullTook(drawn.swapped - drawn.asked, m_interval);
    else if (isDrawn && !wasFull && before == m_drawnQuality)
        takeTime(drawn.swapped - drawn.asked);
    if (m_listener)
        m_listener(drawn);
    tellIds();
}

} // namespace carina
