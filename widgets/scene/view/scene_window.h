#pragma once

#include "engine/display/eye_picture.h"
#include "widgets/scene/view/orbit_camera.h"

#include <QPointF>
#include <QWindow>

#include <optional>

namespace carina
{

/// The native window that a scene is drawn into. Mouse and keys move its camera: drag rotates, drag
/// with Shift or with the right or middle button pans, the wheel zooms, a double click resets to
/// the preset; arrow keys rotate, with Shift they pan, + and - zoom, Home resets.
///
/// Or they steer the head of who looks: drag turns it, so that what is seen follows the mouse; drag
/// with Ctrl or with the right or middle button moves it nearer (up) and farther (down), and so
/// does the wheel; arrow keys turn it to their side, + and - move it; a double click and Home take
/// it back.
class SceneWindow : public QWindow
{
    Q_OBJECT

public:
    SceneWindow();

    [[nodiscard]] OrbitCamera& camera() { return m_camera; }

    /// Looks from a preset, to which Home returns.
    void showFrom(ViewPreset preset);

    /// Mouse and keys do not move the camera while it is held.
    void holdCamera(bool held) { m_held = held; }
    /// They steer a head from now on, and not the camera; or again the camera.
    void steerHead(bool steers) { m_steersHead = steers; }
    /// Where the mouse is over the window, in its pixels, also while it rests, under a name that is
    /// written over the picture, too.
    [[nodiscard]] const std::optional<QPointF>& mousePlace() const { return m_mousePlace; }

    [[nodiscard]] double widthOverHeight() const;
    /// The whole window, in device pixels.
    [[nodiscard]] PixelRect pixels() const;

Q_SIGNALS:
    /// What was drawn may be lost: the window, or a part of it, was covered until now.
    void uncovered();
    /// Tab was pressed: the focus goes to the next (or previous) control.
    void tabbed(bool forward);
    /// The left button was pressed and released at one point.
    void clicked(const QPointF& position);
    /// The head is to be turned so that what is seen moves to the right and down, in fractions of
    /// the picture's height.
    void headTurned(double right, double down);
    /// The head is to come nearer by a factor above 1, or go away by a factor below 1.
    void headNeared(double factor);
    /// The head is to go back to its usual place.
    void headReturned();

protected:
    bool event(QEvent* event) override;
    void exposeEvent(QExposeEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void dragHead(const QMouseEvent& event, const QPointF& moved);
    [[nodiscard]] bool steer(int key);
    [[nodiscard]] bool turnOrMove(const QKeyEvent& event);
    void followMouse(QEvent& event);

    OrbitCamera m_camera;
    ViewPreset m_preset = ViewPreset::Front;
    QPointF m_pressed;
    QPointF m_lastDrag;
    bool m_dragged = false; ///< since the button was pressed
    bool m_held = false;
    bool m_steersHead = false;
    std::optional<QPointF> m_mousePlace;
};

} // namespace carina
