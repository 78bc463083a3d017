#pragma once

#include "models/lesson/lesson_model.h"
#include "models/respiration/respiration_model.h"
#include "models/session/people_model.h"
#include "models/session/session_model.h"
#include "models/station/stations_model.h"
#include "ui/scene/station_scene.h"

#include <QWidget>

#include <memory>

namespace Ui
{
class PatientPane;
}

namespace carina
{

/// The middle of the console: the patient of the station that is shown, from where it is seen, and
/// above it the stations, what the patient has, who is at work and through whose eyes the view is.
class PatientPane : public QWidget
{
    Q_OBJECT

public:
    explicit PatientPane(QWidget* parent = nullptr);
    ~PatientPane() override;

    /// To be called once, before anything else. @pre all outlive the pane.
    void setModels(SessionModel& session, const RespirationModel& respiration,
                   StationsModel& stations, PeopleModel& people, LessonModel& lesson);
    /// Draws a patient from now on. @pre both outlive the pane, or live until the next show.
    void show(const PatientModel& patient, StationView& view);
    using QWidget::show;

    /// @pre a patient is shown
    [[nodiscard]] StationScene& stationScene() { return *m_stationScene; }
    [[nodiscard]] SceneView& scene();

    /// Says again what changes by itself.
    void refresh();
    /// Says which part was chosen in the picture; empty: none.
    void tellPart(const QString& name);

private:
    void connectViews();
    void addEyes();
    void refreshPeople();
    [[nodiscard]] QString patientText() const;

    std::unique_ptr<Ui::PatientPane> m_ui;
    SessionModel* m_session = nullptr;
    const RespirationModel* m_respiration = nullptr;
    const StationsModel* m_stations = nullptr;
    PeopleModel* m_people = nullptr;
    const LessonModel* m_lesson = nullptr;
    QString m_part; ///< that was chosen in the picture
    StationView* m_view = nullptr;
    std::unique_ptr<StationScene> m_stationScene;
};

} // namespace carina
