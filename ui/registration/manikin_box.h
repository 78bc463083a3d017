#pragma once

#include "models/registration/manikin_task.h"

#include <QGroupBox>

class QComboBox;
class QLabel;
class QPushButton;

namespace carina
{

class CheckedSpinBox;

/// Which manikin the site has, and how its airway differs from the patient's.
class ManikinBox : public QGroupBox
{
    Q_OBJECT

public:
    /// @pre task outlives this.
    explicit ManikinBox(ManikinTask& task, QWidget* parent = nullptr);

    void refresh();

private:
    void layOut();
    void connectTask();
    void refreshMakes();
    void chooseImport();

    ManikinTask& m_task;
    QComboBox* m_makes; ///< children of this
    QPushButton* m_import;
    CheckedSpinBox* m_measured;
    QPushButton* m_touch;
    QPushButton* m_skip;
    QLabel* m_comparison;
};

} // namespace carina
