#pragma once

#include <QCommandLineParser>
#include <QDockWidget>
#include <QFile>
#include <QTimer>
#include <QWidget>

#include <functional>
#include <memory>

namespace carina::program
{

inline void fetch(QDockWidget& dock)
{
    dock.show();
    dock.raise();
}

/// Fetches the panel that a control is in from behind others, or opens it, as a person has to.
template <class Control> Control* fetched(Control* control)
{
    for (QWidget* outer = control; outer; outer = outer->parentWidget())
        if (auto* dock = qobject_cast<QDockWidget*>(outer))
            fetch(*dock);
    return control;
}

/// Works a program's controls as the lines of a file say, which may be appended meanwhile. A
/// control is meant by its object name, in the dialog that is open or else in the window that is
/// shown; as long as there is none that can be used, the script waits, and tells on stderr after
/// 10 s for what.
///
/// - `press CONTROL` presses a button, a check box or a command of the tool bar.
/// - `choose LIST TEXT` chooses the row of a table whose first cell has this text, the row of a
///   list that has it within, or the entry of a combo box.
/// - `type FIELD TEXT` replaces the text of a field, or the number of a spin box.
/// - `pause SECONDS` waits, as a person does between two presses that are not to be a slip.
/// - `close` closes the window or dialog, as the button in its frame does.
/// - `picture FILE` saves what the window shows; its display must show all of it.
class ControlScript
{
public:
    /// The window that the program shows at present.
    using Window = std::function<QWidget&()>;

    /// @param file is made if there is none @pre what `window` uses outlives this.
    ControlScript(Window window, const QString& file);

private:
    void goOn();
    /// @returns false where it cannot be done yet.
    [[nodiscard]] bool perform(const QString& line) const;

    Window m_window;
    QFile m_file;
    QTimer m_timer;
    int m_waits = 0; ///< of the next line
};

/// Adds `--script FILE`.
void addScriptOption(QCommandLineParser& parser);

/// The script of `--script`; null without it. @pre what `window` uses outlives it
[[nodiscard]] std::unique_ptr<ControlScript> scriptFromOptions(const QCommandLineParser& parser,
                                                               ControlScript::Window window);

} // namespace carina::program
