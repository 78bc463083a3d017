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

/// How the patient breathes, to see and to change. A control shows the value in force or, while a
/// change travels, the value asked for; what travels is told beneath.
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
