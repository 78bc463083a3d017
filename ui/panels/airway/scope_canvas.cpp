#include "ui/panels/airway/scope_canvas.h"

#include "models/patient/laryngoscopy.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <functional>

namespace carina
{
namespace
{

constexpr double kWheelNotch = 120.0; ///< eighths of a degree, as wheels report

/// What a key does to an endoscope; empty: nothing.
std::function<void(FlownEndoscope&)> flightOf(int key)
{
    switch (key) {
    case Qt::Key_Left:
        return [](FlownEndoscope& scope) { scope.turn(-1.0 * kTurnEach, {}); };
    case Qt::Key_Right:
        return [](FlownEndoscope& scope) { scope.turn(kTurnEach, {}); };
    case Qt::Key_Up:
        return [](FlownEndoscope& scope) { scope.turn({}, kTurnEach); };
    case Qt::Key_Down:
        return [](FlownEndoscope& scope) { scope.turn({}, -1.0 * kTurnEach); };
    case Qt::Key_Q:
        return [](FlownEndoscope& scope) { scope.roll(-1.0 * kTurnEach); };
    case Qt::Key_E:
        return [](FlownEndoscope& scope) { scope.roll(kTurnEach); };
    case Qt::Key_W:
    case Qt::Key_Plus:
    case Qt::Key_PageUp:
        return [](FlownEndoscope& scope) { scope.advance(kWayEach); };
    case Qt::Key_S:
    case Qt::Key_Minus:
    case Qt::Key_PageDown:
        return [](FlownEndoscope& scope) { scope.advance(-1.0 * kWayEach); };
    case Qt::Key_Home:
        return [](FlownEndoscope& scope) { scope.goBack(); };
    default:
        return {};
    }
}

bool isUnmodified(const QKeyEvent& event)
{
    return (event.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) == Qt::NoModifier;
}

} // namespace

ScopeCanvas::ScopeCanvas(FlownEndoscope& endoscope, QWidget* parent)
    : QWidget{parent}, m_endoscope{endoscope}
{
    setFocusPolicy(Qt::StrongFocus);
}

QRect ScopeCanvas::inner() const { return rect().adjusted(kFrame, kFrame, -kFrame, -kFrame); }

/// Its keys are those of windows, too, while the keyboard is elsewhere.
bool ScopeCanvas::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && m_endoscope.isFlown()) {
        const auto& key = *static_cast<QKeyEvent*>(event);
        if (isUnmodified(key) && flightOf(key.key()))
            event->accept();
    }
    return QWidget::event(event);
}

void ScopeCanvas::keyPressEvent(QKeyEvent* event)
{
    const auto fly = m_endoscope.isFlown() && isUnmodified(*event)
                         ? flightOf(event->key())
                         : std::function<void(FlownEndoscope&)>{};
    if (fly)
        fly(m_endoscope);
    else
        QWidget::keyPressEvent(event);
}

void ScopeCanvas::paintEvent(QPaintEvent*)
{
    QPainter painter{this};
    if (hasFocus())
        painter.fillRect(rect(), palette().color(QPalette::Highlight));
    painter.fillRect(inner(), Qt::black);
}

void ScopeCanvas::mousePressEvent(QMouseEvent* event) { m_lastDrag = event->position(); }

void ScopeCanvas::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF moved = (event->position() - m_lastDrag) / std::max(1, inner().height());
    m_lastDrag = event->position();
    const Angle high = Laryngoscopy::fieldOfView(ScopeEye::Video);
    if (m_endoscope.isFlown())
        m_endoscope.turn(-moved.x() * high, moved.y() * high);
}

void ScopeCanvas::mouseDoubleClickEvent(QMouseEvent*) { Q_EMIT doubleClicked(); }

void ScopeCanvas::wheelEvent(QWheelEvent* event)
{
    if (m_endoscope.isFlown())
        m_endoscope.advance((event->angleDelta().y() / kWheelNotch) * kWayEach);
    else
        QWidget::wheelEvent(event);
}

void ScopeCanvas::focusInEvent(QFocusEvent* event)
{
    QWidget::focusInEvent(event);
    update();
}

void ScopeCanvas::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    update();
}

} // namespace carina
