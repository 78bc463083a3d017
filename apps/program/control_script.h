#pragma once

#include <QDockWidget>
#include <QFile>
#include <QTimer>
#include <QWidget>

namespace carina
{

/// Fetches the panel that a control is in from behind others, as a person has to.
template <class Control> Control* fetched(Control* control)
{
    for (QWidget* outer = control; outer; outer = outer->parentWidget())
        if (auto* dock = qobject_cast<QDockWidget*>(outer))
            dock->raise();
    return control;
}

/// Works a window's controls as the lines of a file say, which may be appended meanwhile. A control
/// is meant by its object name, in the dialog that is open or else in the window; as long as there
/// is none that can be used, the script waits.
///
/// - `press CONTROL` presses a button, a check box or a command of the tool bar.
/// - `choose TABLE TEXT` chooses the row of a table whose first cell has this text.
/// - `type FIELD TEXT` replaces the text of a field, or the number of a spin box.
class ControlScript
{
public:
    /// @param file is made if there is none @pre window outlives this.
    ControlScript(QWidget& window, const QString& file);

private:
    void goOn();
    /// @returns false where it cannot be done yet.
    [[nodiscard]] bool perform(const QString& line) const;

    QWidget& m_window;
    QFile m_file;
    QTimer m_timer;
};

} // namespace carina
