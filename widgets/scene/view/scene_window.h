#pragma once

#include "engine/display/eye_picture.h"
#include "widgets/scene/view/orbit_camera.h"

#include <QPointF>
#include <QWindow>

namespace carina
{

/// The native window that a scene is drawn into. Turns mouse and keys into motions of its camera:
/// drag turns, Shift or the right or middle button moves, the wheel zooms, a double click shows all
/// again; arrows turn, with Shift they move, + and - zoom, Home shows all again.
class SceneWindow : public QWindow
{
    Q_OBJECT

public:
    SceneWindow();

    [[nodiscard]] OrbitCamera& camera() { return m_camera; }
    void setInteractive(bool interactive) { m_interactive = interactive; }

    /// Looks from a preset; Home comes back to it.
    void showFrom(ViewPreset preset);

    [[nodiscard]] double widthOverHeight() const;
    /// All of the window, in pixels of the screen.
    [[nodiscard]] PixelRect pixels() const;

Q_SIGNALS:
    /// The person wants to leave the view for the next (or previous) control.
    void tabbed(bool forward);
    /// The left button was pressed and let go at one place.
    void clicked(const QPointF& position);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] bool turnOrMove(const QKeyEvent& event);

    OrbitCamera m_camera;
    ViewPreset m_preset = ViewPreset::Front;
    QPointF m_pressed;
    QPointF m_lastDrag;
    bool m_dragged = false; ///< since the button was pressed
    bool m_interactive = true;
};

} // namespace carina
