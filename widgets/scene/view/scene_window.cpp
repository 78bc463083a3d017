#include "widgets/scene/view/scene_window.h"

#include <QCursor>
#include <QEnterEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyleHints>
#include <QSurfaceFormat>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace carina
{

namespace
{

constexpr double kKeyStep = 0.05;      ///< of the picture's height
constexpr double kZoomPerKey = 1.15;   ///< factor
constexpr double kZoomPerNotch = 1.12; ///< factor
constexpr double kNearPerHeight = 2.0; ///< logarithm of the factor per picture height dragged
constexpr double kNotch = 120.0;       ///< eighths of a degree, as wheels report

/// The window of the program, on the screen, that a window is in.
const QWindow* outermost(const QWindow& window)
{
    const QWindow* outer = &window;
    while (outer->parent() != nullptr)
        outer = outer->parent();
    return outer;
}

} // namespace

SceneWindow::SceneWindow()
{
    setSurfaceType(QSurface::OpenGLSurface);
    setFormat(QSurfaceFormat::defaultFormat());
    create();
}

void SceneWindow::showFrom(ViewPreset preset)
{
    m_preset = preset;
    m_camera.showFrom(preset);
}

double SceneWindow::widthOverHeight() const
{
    return std::max(1, width()) / static_cast<double>(std::max(1, height()));
}

PixelRect SceneWindow::pixels() const
{
    const QSize size = this->size() * devicePixelRatio();
    return {0, 0, std::max(1, size.width()), std::max(1, size.height())};
}

void SceneWindow::resizeEvent(QResizeEvent* event)
{
    QWindow::resizeEvent(event);
    m_camera.setAspect(widthOverHeight());
}

bool SceneWindow::event(QEvent* event)
{
    followMouse(*event);
    return QWindow::event(event);
}

void SceneWindow::exposeEvent(QExposeEvent*) { Q_EMIT uncovered(); }

/// A mouse that rests sends nothing when what had come between it and the picture goes: a menu, or
/// a name, which is a window of its own that moves with what it names.
void SceneWindow::followMouse(QEvent& event)
{
    if (const auto* enter = dynamic_cast<const QEnterEvent*>(&event))
        m_mousePlace = enter->position();
    if (event.type() != QEvent::Leave)
        return;
    const QPoint place = QCursor::pos();
    const QPoint inWindow = mapFromGlobal(place);
    const bool isOver = isExposed() && QRect{QPoint{}, size()}.contains(inWindow)
                        && QGuiApplication::topLevelAt(place) == outermost(*this);
    m_mousePlace = isOver ? std::optional<QPointF>{inWindow} : std::nullopt;
}

void SceneWindow::mousePressEvent(QMouseEvent* event)
{
    requestActivate();
    m_pressed = m_lastDrag = event->position();
    m_dragged = false;
}

void SceneWindow::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && !m_dragged)
        Q_EMIT clicked(event->position());
}

void SceneWindow::mouseMoveEvent(QMouseEvent* event)
{
    m_mousePlace = event->position();
    if (event->buttons() == Qt::NoButton)
        return;
    const int farthest = QGuiApplication::styleHints()->startDragDistance();
    m_dragged = m_dragged || (event->position() - m_pressed).manhattanLength() >= farthest;
    const QPointF moved = (event->position() - m_lastDrag) / std::max(1, height());
    m_lastDrag = event->position();
    if (m_steersHead) {
        if (!moved.isNull()) // as when a button is let go
            dragHead(*event, moved);
        return;
    }
    if (m_held)
        return;
    const bool moves = event->modifiers().testFlag(Qt::ShiftModifier)
                       || !event->buttons().testFlag(Qt::LeftButton);
    if (moves)
        m_camera.pan(moved.x(), moved.y());
    else
        m_camera.orbit(moved.x(), moved.y());
}

void SceneWindow::dragHead(const QMouseEvent& event, const QPointF& moved)
{
    const bool nears = event.modifiers().testFlag(Qt::ControlModifier)
                       || !event.buttons().testFlag(Qt::LeftButton);
    if (nears)
        Q_EMIT headNeared(std::exp(-kNearPerHeight * moved.y()));
    else
        Q_EMIT headTurned(moved.x(), moved.y());
}

void SceneWindow::mouseDoubleClickEvent(QMouseEvent*)
{
    if (m_steersHead)
        Q_EMIT headReturned();
    else if (!m_held)
        m_camera.showFrom(m_preset);
}

void SceneWindow::wheelEvent(QWheelEvent* event)
{
    const double factor = std::pow(kZoomPerNotch, event->angleDelta().y() / kNotch);
    if (m_steersHead)
        Q_EMIT headNeared(factor);
    else if (!m_held)
        m_camera.zoom(factor);
}

void SceneWindow::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Tab || event->key() == Qt::Key_Backtab) {
        Q_EMIT tabbed(event->key() == Qt::Key_Tab);
        return;
    }
    if (m_steersHead)
        event->setAccepted(steer(event->key()));
    else
        event->setAccepted(!m_held && turnOrMove(*event));
}

/// To look to one side moves what is seen to the other.
bool SceneWindow::steer(int key)
{
    switch (key) {
    case Qt::Key_Left:
        Q_EMIT headTurned(kKeyStep, 0.0);
        return true;
    case Qt::Key_Right:
        Q_EMIT headTurned(-kKeyStep, 0.0);
        return true;
    case Qt::Key_Up:
        Q_EMIT headTurned(0.0, kKeyStep);
        return true;
    case Qt::Key_Down:
        Q_EMIT headTurned(0.0, -kKeyStep);
        return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        Q_EMIT headNeared(kZoomPerKey);
        return true;
    case Qt::Key_Minus:
        Q_EMIT headNeared(1.0 / kZoomPerKey);
        return true;
    case Qt::Key_Home:
        Q_EMIT headReturned();
        return true;
    default:
        return false;
    }
}

bool SceneWindow::turnOrMove(const QKeyEvent& event)
{
    double right = 0.0;
    double down = 0.0;
    switch (event.key()) {
    case Qt::Key_Left:
        right = -kKeyStep;
        break;
    case Qt::Key_Right:
        right = kKeyStep;
        break;
    case Qt::Key_Up:
        down = -kKeyStep;
        break;
    case Qt::Key_Down:
        down = kKeyStep;
        break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        m_camera.zoom(kZoomPerKey);
        return true;
    case Qt::Key_Minus:
        m_camera.zoom(1.0 / kZoomPerKey);
        return true;
    case Qt::Key_Home:
        m_camera.showFrom(m_preset);
        return true;
    default:
        return false;
    }
    if (event.modifiers().testFlag(Qt::ShiftModifier))
        m_camera.pan(right, down);
    else
        m_camera.orbit(right, down);
    return true;
}

} // namespace carina
