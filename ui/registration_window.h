#pragma once

#include "models/landmark_table_model.h"
#include "models/registration_model.h"
#include "ui/registration_scene.h"

#include <QWidget>

#include <memory>

class QPushButton;

namespace Ui
{
class RegistrationWindow;
}

namespace carina
{

class ResidualBar;

/// The wizard that registers a patient's anatomy to a manikin: the steps, the patient in three
/// dimensions with the landmarks, what the tracker sees and what was touched, and one sentence that
/// says what to do now. Return presses the button that goes on.
class RegistrationWindow : public QWidget
{
    Q_OBJECT

public:
    /// @pre registration outlives the window.
    explicit RegistrationWindow(RegistrationModel& registration);
    ~RegistrationWindow() override;

private:
    void connectButtons();
    void connectTable();
    void connectModel();
    void refresh();
    void refreshSteps();
    void refreshButtons();
    void refreshProgress();
    void refreshTools();
    void refreshStylus();
    void act();
    void enterNext();
    void chooseLandmark(int row);
    [[nodiscard]] QString actionText() const;
    /// The button that goes on.
    [[nodiscard]] QPushButton& mainButton() const;

    std::unique_ptr<Ui::RegistrationWindow> m_ui;
    RegistrationModel& m_registration;
    LandmarkTableModel m_landmarks;
    ResidualBar* m_bars; ///< a child of this
    std::unique_ptr<RegistrationScene> m_scene;
};

} // namespace carina
