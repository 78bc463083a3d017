#include "ui/panels/session/undo_button.h"

#include "models/text/shown_as_is.h"

#include <QKeyEvent>

namespace carina
{
namespace
{

constexpr int kMostListed = 20;
constexpr int kWidest = 320; ///< pixels, of its words: a quarter of the smallest window

/// A button's text in which & is no mark of a key.
QString unmarked(QString text) { return text.replace(QLatin1Char{'&'}, QStringLiteral("&&")); }

} // namespace

UndoButton::UndoButton(ChangeHistory& history, QWidget* parent)
    : QToolButton{parent}, m_history{history}, m_undo{new QAction{this}}
{
    setObjectName(QStringLiteral("undoChange"));
    setPopupMode(QToolButton::MenuButtonPopup);
    setToolButtonStyle(Qt::ToolButtonTextOnly);
    setFocusPolicy(Qt::StrongFocus);
    setMenu(&m_menu);
    const auto undo = [this] { m_history.undo(); };
    connect(this, &QToolButton::clicked, &m_history, undo);
    m_undo->setShortcuts(QKeySequence::Undo);
    connect(m_undo, &QAction::triggered, &m_history, undo);
    addAction(m_undo);
    connect(&m_menu, &QMenu::aboutToShow, this, &UndoButton::list);
    connect(&m_history, &ChangeHistory::changed, this, &UndoButton::refresh);
    refresh();
}

void UndoButton::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Down && isEnabled())
        return showMenu();
    QToolButton::keyPressEvent(event);
}

void UndoButton::refresh()
{
    const QStringList texts = m_history.texts();
    if (texts.isEmpty())
        clearFocus(); // else the next control gets it, and the next press of a key
    setEnabled(!texts.isEmpty());
    m_undo->setEnabled(!texts.isEmpty());
    const QString named = texts.isEmpty() ? tr("Nothing to undo") : tr("Undo: %1").arg(texts[0]);
    setAccessibleName(named);
    setText(unmarked(fontMetrics().elidedText(named, Qt::ElideRight, kWidest)));
    setToolTip(shownAsIs(texts.isEmpty() ? tr("Takes back the last change of any panel (Ctrl+Z)")
                                         : tr("%1 (Ctrl+Z)", "undo of a change").arg(named)));
}

void UndoButton::list()
{
    m_menu.clear();
    const QStringList texts = m_history.texts();
    for (int place = 0; place < std::min<int>(kMostListed, int(texts.size())); ++place) {
        const QString& text = texts[place];
        m_menu.addAction(unmarked(place == 0 ? text : tr("down to %1").arg(text)), &m_history,
                         [this, place] { m_history.undo(place + 1); });
    }
}

} // namespace carina
