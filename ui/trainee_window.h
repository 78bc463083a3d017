#pragma once

#include "ui/station_scene.h"

#include <QLabel>
#include <QMenu>
#include <QWidget>

namespace carina
{

/// What a trainee sees: the anatomy over black and nothing else. What has to be known appears in
/// one line at the lower edge and leaves by itself; Esc opens a menu.
class TraineeWindow : public QWidget
{
    Q_OBJECT

public:
    /// @pre all outlive the window.
    TraineeWindow(const SessionNode& node, StationId station, const PatientModel& patient,
                  const StationView& view);

    [[nodiscard]] StationScene& stationScene() { return m_stationScene; }

private:
    void makeMenu();
    void refreshNotice();

    const SessionNode& m_node;
    StationId m_station;
    SceneView* m_scene;
    QLabel* m_notice;
    StationScene m_stationScene;
    QMenu m_menu;
};

} // namespace carina
