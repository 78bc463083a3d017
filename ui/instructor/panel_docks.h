#pragma once

#include <QByteArray>
#include <QDockWidget>
#include <QList>
#include <QMainWindow>
#include <QMenu>
#include <QTimer>

#include <chrono>

namespace carina
{

/// The panels of a window, as docks beside its picture: in front of each other by tabs, to be
/// closed, moved, floated in a frame of their own, and brought back by a menu.
class PanelDocks : public QObject
{
    Q_OBJECT

public:
    /// Panels that stand in one place, the first in front.
    using Group = QList<QDockWidget*>;

    /// Pixels: with it the picture has half of a window of 1280x800, and two thirds of 1920x1080,
    /// also without what is under the sentence that says what needs attention.
    static constexpr int kColumnWidth = 430;
    /// From this height on, each group has a place of its own: that of the first holds its panels
    /// then, too.
    static constexpr int kHighWindow = 1440;
    /// Pixels that each place but the first has in any window: three curves, and their figures.
    static constexpr int kLeastPlace = 350;
    /// How long all panels stay where they are before settled() is emitted.
    static constexpr std::chrono::milliseconds kSettling{1000};

    /// @param groups from above down; in a low window those behind the first share one place. What
    ///        the window grows by goes to the place of the first.
    /// @pre all outlive this.
    PanelDocks(QMainWindow& window, QList<Group> groups);

    /// Has a key to each panel, those to close one and to lay all as at first.
    [[nodiscard]] QMenu& menu() { return m_menu; }
    /// Adds the entry, and the key, of a panel. @param text with its mnemonic
    QAction* offer(QDockWidget& dock, const QString& text, const QKeySequence& key,
                   const QString& toolTip);
    /// Adds what concerns all of them. To be called once, behind the panels.
    void offerAll();
    /// Has the keys of these actions work also where a panel that floats has the keyboard: a window
    /// of its own, in which those of the main window do nothing else.
    void addKeys(const QList<QAction*>& actions);

    /// All panels in one column beside the picture.
    void layStandard();
    /// As state() had it. @returns whether it could be.
    bool restore(const QByteArray& state);
    [[nodiscard]] QByteArray state() const;

    /// Shows a panel that was closed, or is behind others, from its beginning, and gives it the
    /// keyboard.
    static void bring(QDockWidget& dock);

Q_SIGNALS:
    /// A panel was moved, floated, resized, shown or closed, and kSettling since nothing more.
    void settled();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    static void makeScrollable(QDockWidget& dock);
    static void frame(QDockWidget& dock);
    void watch(QDockWidget& dock);
    [[nodiscard]] QList<Group> places() const;
    [[nodiscard]] QList<int> heightsOf(const QList<Group>& places) const;
    [[nodiscard]] QDockWidget* withFocus() const;
    void closeOne();

    QMainWindow& m_window;
    QList<Group> m_groups;
    QMenu m_menu;
    QTimer m_settling;
};

} // namespace carina
