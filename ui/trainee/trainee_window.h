#pragma once

#include "models/objects/object_action_model.h"
#include "models/patient/session_patient.h"
#include "models/station/chin_probe_model.h"
#include "ui/scene/station_scene.h"

#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>

#include <array>
#include <vector>

namespace carina
{

class PartsPanel;
class SectionPanel;

/// What a trainee sees: the anatomy over black and nothing else, on a screen or before the eyes.
/// What has to be known appears over its lower edge, to each eye that has a picture of its own, and
/// leaves by itself; the picture stays where it is meanwhile. Esc opens a menu; from there the
/// actions on shared objects, and the parts of the patient, come beside the picture, before a
/// headset in a window of their own.
class TraineeWindow : public QMainWindow
{
    Q_OBJECT

public:
    /// @pre all outlive the window.
    TraineeWindow(const SessionNode& node, SessionPatient& patient, const StationView& view,
                  const HeadsetView& headset, ViewOutput output, ChinProbeModel chinProbe,
                  ObjectActionModel& actions);

    /// Draws another patient from now on. @param chinProbe of the tracking that goes with it
    /// @pre all outlive the window, or their successors.
    void show(const PatientModel& patient, const StationView& view, ChinProbeModel chinProbe);
    using QMainWindow::show;

    [[nodiscard]] StationScene& stationScene() { return m_stationScene; }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void makeActions(ObjectActionModel& actions);
    void makeParts();
    void addPanel(QDockWidget* dock, QWidget* panel, const QString& menuText);
    void makeMenu();
    void addOutputs();
    void addPresets();
    void addMotion();
    void addChinProbe();
    void addFetching();
    [[nodiscard]] QString notice() const;
    [[nodiscard]] QPoint menuPlace() const;
    void showTo(ViewOutput output);
    void refreshNotice();
    void placeNotice(std::size_t place, const QString& notice, const QRect& within);

    const SessionNode& m_node;
    SessionPatient& m_patient;
    SceneView* m_scene;
    QDockWidget* m_actions;
    QDockWidget* m_parts;
    PartsPanel* m_partsPanel;
    SectionPanel* m_section;
    std::array<QLabel*, 2> m_notices; ///< all the window, or its left half; and its right half
    HeadsetView m_headset;
    ChinProbeModel m_chinProbe;
    StationScene m_stationScene;
    QMenu m_menu;
    std::vector<QAction*> m_presets; ///< of the screen's camera
};

} // namespace carina
