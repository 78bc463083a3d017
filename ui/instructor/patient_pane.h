#pragma once

#include "models/attention/attention_model.h"
#include "models/intubation/intubation_timeline.h"
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

/// The middle of the console: the patient of the station that is shown, above it the stations,
/// beneath it the steps of an intubation, and over the upper edge of the picture what needs
/// attention, so that the picture has this room while nothing does and does not move when something
/// does.
class PatientPane : public QWidget
{
    Q_OBJECT

public:
    explicit PatientPane(QWidget* parent = nullptr);
    ~PatientPane() override;

    /// To be called once, before anything else. @pre all outlive the pane.
    void setModels(StationsModel& stations, AttentionModel& attention,
                   IntubationTimeline& intubation);
    /// Draws a patient from now on. @pre both outlive the pane, or live until the next show.
    void show(const PatientModel& patient, StationView& view);
    using QWidget::show;
    /// Chooses the step of the intubation that was the latest at a moment.
    void chooseStep(SessionTime moment);

    /// @pre a patient is shown
    [[nodiscard]] StationScene& stationScene() { return *m_stationScene; }
    [[nodiscard]] StationView& view() { return *m_view; }
    [[nodiscard]] SceneView& scene();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
    /// A number typed here was refused; one sentence with the range.
    void refused(const QString& why);

private:
    void layAttention();

    std::unique_ptr<Ui::PatientPane> m_ui;
    StationView* m_view = nullptr;
    std::unique_ptr<StationScene> m_stationScene;
};

} // namespace carina
