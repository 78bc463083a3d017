#pragma once

#include "models/respiration/respiration_model.h"

#include <QWidget>

class QComboBox;
class QFormLayout;
class QLabel;
class QListWidget;
class QPushButton;
class QSlider;

namespace carina
{

class CheckedDoubleSpinBox;
class RefusalLine;

/// Shows and sets the patient's position, diseases and ventilator. The diseases are a list;
/// the controls below it change the one that is selected. A control shows the value
/// in force or, while a change is pending, the requested value; pending changes are listed below.
/// For a person without permission the panel states the reason.
class ConditionPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ConditionPanel(QWidget* parent = nullptr);

    /// @pre the model outlives the panel.
    void setModel(RespirationModel& model);

private:
    void layOut();
    void addSeverity(QFormLayout& rows);
    void explain();
    CheckedDoubleSpinBox* addNumber(QFormLayout& rows, const char* objectName, const QString& label,
                                    const QString& accessibleName, const QString& unit);
    void offerChoices();
    void connectCondition();
    void connectVentilator();
    void offerList();
    void setCondition();
    void addCondition();
    [[nodiscard]] std::size_t place() const;
    void selectRow(int row);
    void refreshConditions();
    void refreshSelected();
    void refresh();
    void refreshVentilator(const VentilatorSettings& ventilator);

    RespirationModel* m_model = nullptr;
    /// Normal was chosen for the selected condition, which is gone: what is chosen next is added.
    bool m_isAdding = false;
    QLabel* m_obstacle;
    QWidget* m_controls;
    QComboBox* m_position;
    QListWidget* m_conditions;
    QPushButton* m_add;
    QPushButton* m_remove;
    QComboBox* m_condition;
    CheckedDoubleSpinBox* m_severity;
    QSlider* m_severitySlider;
    QComboBox* m_side;
    QComboBox* m_mode;
    CheckedDoubleSpinBox* m_peep = nullptr;
    CheckedDoubleSpinBox* m_driving = nullptr;
    CheckedDoubleSpinBox* m_limit = nullptr;
    CheckedDoubleSpinBox* m_pause = nullptr;
    CheckedDoubleSpinBox* m_ownRate = nullptr;
    CheckedDoubleSpinBox* m_ownEffort = nullptr;
    CheckedDoubleSpinBox* m_trigger = nullptr;
    RefusalLine* m_refused;
    QLabel* m_travelling;
    QPushButton* m_undo;
};

} // namespace carina
