#pragma once

#include "ui/scene/station_scene.h"

#include <QTimer>
#include <QWidget>

namespace carina
{

/// A second window with the console's picture and nothing else, for a projector: over the whole of
/// a screen that the console is not on, or where there is none, a window that can be moved there.
/// F11 changes between both, Esc closes it. Where its screen is taken away, it becomes a window, so
/// that it does not cover the console.
class ProjectorWindow : public QWidget
{
    Q_OBJECT

public:
    /// @param shown the console's picture @pre all outlive the window, or live until the next show.
    ProjectorWindow(const StationScene& shown, const PatientModel& patient, const StationView& view,
                    QWidget& console);

    /// Draws another patient from now on, as the console does.
    void show(const PatientModel& patient, const StationView& view);
    using QWidget::show;
    void toggleFullScreen();

Q_SIGNALS:
    void closed();

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void follow();
    void place();
    void keepOffConsole();

    const StationScene& m_shown;
    QWidget& m_console;
    SceneView* m_scene;
    StationScene m_stationScene;
    QTimer m_following;
};

} // namespace carina
