#pragma once

#include "models/registration/registration_model.h"
#include "models/tracker/pose_recording.h"
#include "ui/registration/registration_scene.h"

#include <QWidget>

#include <memory>
#include <vector>

class QPushButton;

namespace Ui
{
class RegistrationWindow;
}

namespace carina
{

class RegistrationPage;

/// The wizard that registers a patient's anatomy to a manikin: the steps and their states, a 3-D
/// view of the patient, the page of the present step, the visibility of the tools, and one sentence
/// that says what to do now. Return presses the main button; Page Down, or a foot switch that sends
/// it, takes a point.
class RegistrationWindow : public QWidget
{
    Q_OBJECT

public:
    /// @pre both outlive the window.
    RegistrationWindow(RegistrationModel& registration, PoseRecording& recording);
    ~RegistrationWindow() override;

    /// Writes the report of the registration as PDF. @returns the errors of
    /// writeRegistrationReport.
    [[nodiscard]] Result<void> writeReport(const QString& file);

Q_SIGNALS:
    /// A person wants to work with another tracker than the model has.
    void anotherTrackerWanted();
    /// The site's devices are to be tracked with: a person wants it, or the tracker was made of
    /// them and they were changed.
    void siteDevicesWanted();

private:
    void addPages();
    void connectButtons();
    void connectModel();
    void turnPage();
    void refresh();
    void refreshSteps();
    void refreshButtons();
    void refreshProgress();
    void refreshTools();
    void refreshError();
    [[nodiscard]] QImage pictureWithScale() const;
    void askForReport();
    void hear(const QString& words);
    void enterNext();
    [[nodiscard]] SiteStep nextStep() const;
    [[nodiscard]] RegistrationPage& page() const;
    /// The button for the next thing to do: the action of the present page or, if that is done or
    /// not possible, the button to the next page.
    [[nodiscard]] QPushButton& mainButton() const;

    std::unique_ptr<Ui::RegistrationWindow> m_ui;
    RegistrationModel& m_registration;
    PoseRecording& m_recording;
    std::vector<RegistrationPage*> m_pages; ///< of kSteps, children of this
    std::unique_ptr<RegistrationScene> m_scene;
};

} // namespace carina
