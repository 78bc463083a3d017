#pragma once

#include "models/objects/object_action_model.h"

#include <QWidget>

#include <memory>

class QComboBox;

namespace Ui
{
class ActionsPanel;
}

namespace carina
{

/// Whose a shared object is, and what is done to it: turned, moved or scaled until it is stopped.
/// To those who may do nothing it says so.
class ActionsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit ActionsPanel(QWidget* parent = nullptr);
    ~ActionsPanel() override;

    /// @pre the model outlives the panel.
    void setModel(ObjectActionModel& model);

private:
    void connectObject();
    void connectAction();
    void refresh();
    void refreshObject();
    void refreshAction();

    std::unique_ptr<Ui::ActionsPanel> m_ui;
    ObjectActionModel* m_model = nullptr;
};

} // namespace carina
