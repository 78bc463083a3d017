#pragma once

#include "models/respiration/breathing_model.h"

#include <QWidget>

#include <memory>

class QAbstractSlider;

namespace Ui
{
class BreathingPanel;
}

namespace carina
{

/// Shows and sets the patient's breathing. A control shows the value in force or, while a change is
/// pending, the requested value; pending changes are listed below.
class BreathingPanel : public QWidget
{
    Q_OBJECT

public:
    explicit BreathingPanel(QWidget* parent = nullptr);
    ~BreathingPanel() override;

    /// @pre the model outlives the panel.
    void setModel(BreathingModel& model);

private:
    void refresh();
    [[nodiscard]] double shown(BreathingParameter parameter) const;

    std::unique_ptr<Ui::BreathingPanel> m_ui;
    BreathingModel* m_model = nullptr;
};

} // namespace carina
