#pragma once

#include "models/respiration/breathing_model.h"

#include <QWidget>

#include <memory>

class QCheckBox;
class QComboBox;
class QLabel;

namespace Ui
{
class BreathingPanel;
}

namespace carina
{

class CheckedSpinBox;
class RefusalLine;

/// Shows and sets the patient's breathing. A control shows the value in force or, while a change is
/// pending, the requested value; pending changes are listed below. Breathing can stop, at once or
/// over a time, and a bag by hand can take its place. A typed number outside its range is refused,
/// with the range, in a line of its own.
class BreathingPanel : public QWidget
{
    Q_OBJECT

public:
    explicit BreathingPanel(QWidget* parent = nullptr);
    ~BreathingPanel() override;

    /// @pre the model outlives the panel.
    void setModel(BreathingModel& model);

private:
    void addApnoea();
    void addBag();
    void refresh();
    void refreshApnoea(int largest_ml);
    [[nodiscard]] double shown(BreathingParameter parameter) const;

    std::unique_ptr<Ui::BreathingPanel> m_ui;
    BreathingModel* m_model = nullptr;
    QCheckBox* m_stops;
    QComboBox* m_over;
    QLabel* m_left; ///< what is left of breathing
    CheckedSpinBox* m_bagRate;
    CheckedSpinBox* m_bagVolume;
    RefusalLine* m_refused;
};

} // namespace carina
