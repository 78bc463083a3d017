#pragma once

#include "ui/registration/registration_page.h"

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace carina
{

class CheckedDoubleSpinBox;
class ToolLayoutDialog;

/// Calibrates tube and laryngoscope by touches with the stylus, and checks them by one.
class ToolsPage : public RegistrationPage
{
    Q_OBJECT

public:
    explicit ToolsPage(RegistrationModel& registration);

    void refresh() override;
    [[nodiscard]] QString actionText() const override;
    [[nodiscard]] bool canAct() const override;
    void act() override;

private:
    void connectControls();
    void layOut();
    void refreshTools();
    void refreshPlaces();
    void showLayout();
    [[nodiscard]] ToolTask& task() const { return registration().toolTask(); }

    QComboBox* m_tools; ///< children of this
    QLabel* m_diameterLabel;
    CheckedDoubleSpinBox* m_diameter;
    QLabel* m_described;
    QListWidget* m_places;
    QPushButton* m_check;
    QPushButton* m_stop;
    QPushButton* m_layout;
    ToolLayoutDialog* m_layoutDialog = nullptr; ///< from when it is first shown
};

} // namespace carina
