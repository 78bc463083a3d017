#pragma once

#include "models/station/flown_endoscope.h"

#include <QPointF>
#include <QWidget>

namespace carina
{

/// By how much one press of a key, or of a button, moves an endoscope; a notch of a wheel takes it
/// on as far. Of ours.
inline constexpr Angle kTurnEach = degrees(5.0);
inline constexpr Length kWayEach = millimetres(2.0);

/// The place of a scope's picture, with a frame around it while it has the keyboard. While an
/// endoscope is flown, keys and mouse fly it: arrow keys turn it, W, + and page up take it on, S, -
/// and page down back, Q and E roll it, Home takes it in front of the mouth; drag turns it, so that
/// what is seen follows the mouse, and the wheel takes it on and back.
class ScopeCanvas : public QWidget
{
    Q_OBJECT

public:
    /// @pre the endoscope outlives it
    explicit ScopeCanvas(FlownEndoscope& endoscope, QWidget* parent = nullptr);

    /// Where the picture is to be: within the frame.
    [[nodiscard]] QRect inner() const;
    static constexpr int kFrame = 2; ///< pixels

Q_SIGNALS:
    void doubleClicked();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    FlownEndoscope& m_endoscope;
    QPointF m_lastDrag;
};

} // namespace carina
