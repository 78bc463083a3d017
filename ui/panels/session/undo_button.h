#pragma once

#include "models/session/change_history.h"

#include <QAction>
#include <QMenu>
#include <QToolButton>

namespace carina
{

/// Takes back the last change of any panel, which it names; Ctrl+Z. Its menu lists the changes, the
/// last first: choosing one takes back all down to it.
class UndoButton : public QToolButton
{
    Q_OBJECT

public:
    /// @pre the history outlives this.
    explicit UndoButton(ChangeHistory& history, QWidget* parent = nullptr);

    /// What its key does; another window that is to have the key adds it.
    [[nodiscard]] QAction& undoAction() const { return *m_undo; }

protected:
    /// The arrow key down opens the list.
    void keyPressEvent(QKeyEvent* event) override;

private:
    void refresh();
    void list();

    ChangeHistory& m_history;
    QAction* m_undo;
    QMenu m_menu;
};

} // namespace carina
