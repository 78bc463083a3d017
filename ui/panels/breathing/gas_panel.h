#pragma once

#include "models/physiology/gas_model.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace carina
{

class CheckedDoubleSpinBox;
class RefusalLine;

/// Shows and sets what the patient breathes, where the tube is, its cuff and how far it is
/// obstructed, and gives drugs by the patient's weight. A control shows the value in force or,
/// while a change is pending, the requested value; pending changes are listed below. For a person
/// without permission the panel states the reason.
class GasPanel : public QWidget
{
    Q_OBJECT

public:
    explicit GasPanel(QWidget* parent = nullptr);

    /// @pre the model outlives the panel.
    void setModel(GasModel& model);
    /// The keyboard goes to the place of the tube.
    void goToTube();

private:
    void layOut();
    void layTube(QFormLayout& rows);
    void laySetTube(QFormLayout& rows);
    void layDrugs(QFormLayout& rows);
    void explain();
    void connectTube();
    void connectDrugs();
    [[nodiscard]] DrugKind drug() const;
    [[nodiscard]] double dose_mgPerKg() const;
    void offerDose();
    void refresh();
    void refreshTube();
    void refreshDose();

    GasModel* m_model = nullptr;
    QLabel* m_obstacle;
    QWidget* m_controls;
    CheckedDoubleSpinBox* m_oxygen;
    QCheckBox* m_mask;
    QCheckBox* m_probe;
    QLabel* m_tube; ///< where it is
    QComboBox* m_tubeSeat;
    CheckedDoubleSpinBox* m_tubeSize;
    QCheckBox* m_cuff;
    QPushButton* m_stylet;
    CheckedDoubleSpinBox* m_obstruction;
    QComboBox* m_drug;
    CheckedDoubleSpinBox* m_dose;
    QLabel* m_whole; ///< the dose for this patient
    QPushButton* m_give;
    QLabel* m_given;
    RefusalLine* m_refused;
    QLabel* m_travelling;
    QPushButton* m_undo;
};

} // namespace carina
