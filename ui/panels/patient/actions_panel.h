#pragma once

#include "models/objects/object_action_model.h"

#include <QWidget>

#include <memory>
#include <optional>

class QComboBox;

namespace Ui
{
class ActionsPanel;
}

namespace carina
{

/// The owner of a shared object, lifting it out and putting it back, and the actions on it: rotate,
/// translate or scale until stopped, undo, back to its place.
/// For a person without permission the panel states the reason.
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
    void refreshSpeed();

    std::unique_ptr<Ui::ActionsPanel> m_ui;
    std::optional<ActionKind> m_shownKind; ///< whose range and unit the speed has
    ObjectActionModel* m_model = nullptr;
};

} // namespace carina
