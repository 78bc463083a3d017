#include "ui/instructor/panel_docks.h"

#include "models/text/shown_as_is.h"
#include "ui/instructor/arrows_open_lists.h"
#include "ui/instructor/wheel_scrolls.h"

#include <QApplication>
#include <QEvent>
#include <QLayout>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyle>

#include <algorithm>

namespace carina
{
namespace
{

constexpr int kStateVersion = 6;  ///< changes with the panels that there are
constexpr int kDragLook_ms = 100; ///< how often the end of a drag is looked for
constexpr int kBarFrame = 16; ///< pixels around the words of a title or a tab, with some to spare

/// What a panel needs so that it is not scrolled.
int neededHeight(const QDockWidget& dock)
{
    const QWidget* panel = qobject_cast<const QScrollArea*>(dock.widget())->widget();
    const bool followsWidth = panel->layout() && panel->layout()->hasHeightForWidth();
    return followsWidth ? panel->heightForWidth(PanelDocks::kColumnWidth)
                        : panel->minimumSizeHint().height();
}

/// From where it begins, as far as it takes to see what has the keyboard.
void scrollToKeyboard(QScrollArea& area)
{
    area.verticalScrollBar()->setValue(0);
    QWidget* focused = area.window()->focusWidget();
    if (focused && focused != area.widget() && area.isAncestorOf(focused))
        area.ensureWidgetVisible(focused, 0, 0);
}

/// What the window grows by is taken by docks that expand, and not by these.
void keepHeight(QDockWidget& dock)
{
    dock.setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
}

} // namespace

PanelDocks::PanelDocks(QMainWindow& window, QList<Group> groups)
    : m_window{window}, m_groups{std::move(groups)}, m_menu{&window}
{
    m_window.setDockNestingEnabled(true);
    m_window.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    m_window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    m_window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    m_settling.setSingleShot(true);
    m_settling.setInterval(kSettling);
    connect(&m_settling, &QTimer::timeout, this, &PanelDocks::settled);
    for (const Group& group : m_groups)
        for (QDockWidget* dock : group) {
            dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable
                              | QDockWidget::DockWidgetFloatable);
            makeScrollable(*dock);
            watch(*dock);
        }
    for (const Group& group : m_groups.mid(1))
        for (QDockWidget* dock : group)
            keepHeight(*dock);
}

void PanelDocks::watch(QDockWidget& dock)
{
    // A panel behind another is out of sight and yet visible to Qt: nobody shall tab into it.
    connect(&dock, &QDockWidget::visibilityChanged, &dock, &QWidget::setEnabled);
    connect(&dock, &QDockWidget::topLevelChanged, &dock, [&dock](bool floats) {
        if (floats)
            frame(dock);
    });
    const auto settle = [this] { m_settling.start(); };
    connect(&dock, &QDockWidget::visibilityChanged, this, settle);
    connect(&dock, &QDockWidget::topLevelChanged, this, settle);
    connect(&dock, &QDockWidget::dockLocationChanged, this, settle);
    dock.installEventFilter(this);
}

bool PanelDocks::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Move || event->type() == QEvent::Resize)
        m_settling.start();
    return QObject::eventFilter(watched, event);
}

/// Lets a panel scroll where its place is too low for all of it.
void PanelDocks::makeScrollable(QDockWidget& dock)
{
    QWidget* panel = dock.widget();
    letWheelScroll(*panel);
    letArrowsOpenLists(*panel);
    auto* area = new QScrollArea{&dock};
    area->setFocusPolicy(Qt::NoFocus);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setMinimumWidth(panel->minimumSizeHint().width()
                          + area->style()->pixelMetric(QStyle::PM_ScrollBarExtent));
    area->setWidgetResizable(true);
    area->setWidget(panel);
    dock.setWidget(area);
}

/// Gives a floating panel the frame that other windows have, once it is not dragged any more: its
/// window is made anew, which would end a drag.
void PanelDocks::frame(QDockWidget& dock)
{
    if (!dock.isFloating() || !dock.windowFlags().testFlag(Qt::FramelessWindowHint))
        return;
    if (QGuiApplication::mouseButtons() != Qt::NoButton) {
        QTimer::singleShot(kDragLook_ms, &dock, [&dock] { frame(dock); });
        return;
    }
    const bool isShown = !dock.isHidden();
    dock.setWindowFlags(Qt::Window | Qt::CustomizeWindowHint | Qt::WindowTitleHint
                        | Qt::WindowMaximizeButtonHint | Qt::WindowCloseButtonHint);
    dock.setVisible(isShown);
}

QAction* PanelDocks::offer(QDockWidget& dock, const QString& text, const QKeySequence& key,
                           const QString& toolTip)
{
    QAction* action = m_menu.addAction(text);
    action->setShortcut(key);
    action->setToolTip(shownAsIs(toolTip));
    connect(action, &QAction::triggered, &dock, [&dock] { bring(dock); });
    m_window.addAction(action); // its key works while the menu is shut
    return action;
}

void PanelDocks::offerAll()
{
    m_menu.setToolTipsVisible(true);
    m_menu.addSeparator();
    QAction* close = m_menu.addAction(tr("&Close the panel in use"), this, &PanelDocks::closeOne);
    close->setShortcut(QKeySequence{QStringLiteral("Ctrl+F4")});
    m_window.addAction(close);
    connect(&m_menu, &QMenu::aboutToShow, close,
            [this, close] { close->setEnabled(withFocus() != nullptr); });
    connect(&m_menu, &QMenu::aboutToHide, close, [close] { close->setEnabled(true); });
    QAction* standard = m_menu.addAction(tr("&Standard layout"), this, &PanelDocks::layStandard);
    standard->setObjectName(QStringLiteral("standardLayout"));
    standard->setToolTip(tr("All panels are back where they were at first"));
}

/// Not Qt::Tool, by which Qt would do the same: window managers leave such a window without some of
/// its buttons. Each action is the same one everywhere, so that its key stays unambiguous.
void PanelDocks::addKeys(const QList<QAction*>& actions)
{
    for (const Group& group : m_groups)
        for (QDockWidget* dock : group)
            dock->addActions(actions);
}

QList<PanelDocks::Group> PanelDocks::places() const
{
    if (m_window.height() >= kHighWindow)
        return m_groups;
    QList<Group> places{m_groups.first(), {}};
    for (const Group& group : m_groups.mid(1))
        places.last() += group;
    return places;
}

/// The first has what its highest panel needs with its title and tabs, as far as the others keep
/// kLeastPlace, and at least its share; the others share the rest.
QList<int> PanelDocks::heightsOf(const QList<Group>& places) const
{
    const int others = int(places.size()) - 1;
    const int between = m_window.style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent);
    const int all = m_window.centralWidget()->height() - others * between;
    int first = 0;
    for (const QDockWidget* dock : places.first())
        first = std::max(first, neededHeight(*dock));
    first += 2 * (m_window.fontMetrics().height() + kBarFrame);
    first = std::max(std::min(first, all - others * kLeastPlace), all / (others + 1));
    QList<int> heights(places.size(), (all - first) / others);
    heights.first() = first;
    return heights;
}

void PanelDocks::layStandard()
{
    const QList<Group> all = places();
    for (const Group& place : all)
        for (QDockWidget* dock : place) {
            dock->setFloating(false);
            m_window.removeDockWidget(dock);
        }
    QList<QDockWidget*> heads;
    for (const Group& place : all) {
        heads += place.first();
        m_window.addDockWidget(Qt::LeftDockWidgetArea, place.first(), Qt::Vertical);
    }
    for (const Group& place : all)
        for (QDockWidget* dock : place) {
            if (dock != place.first())
                m_window.tabifyDockWidget(place.first(), dock);
            dock->show();
        }
    for (QDockWidget* head : heads)
        head->raise();
    m_window.resizeDocks(heads, QList<int>(heads.size(), kColumnWidth), Qt::Horizontal);
    m_window.resizeDocks(heads, heightsOf(all), Qt::Vertical);
}

bool PanelDocks::restore(const QByteArray& state)
{
    if (state.isEmpty() || !m_window.restoreState(state, kStateVersion))
        return false;
    for (const Group& group : m_groups)
        for (QDockWidget* dock : group)
            frame(*dock);
    return true;
}

QByteArray PanelDocks::state() const { return m_window.saveState(kStateVersion); }

void PanelDocks::bring(QDockWidget& dock)
{
    dock.show();
    dock.raise();
    dock.activateWindow(); // the main window, unless it floats
    auto* area = qobject_cast<QScrollArea*>(dock.widget());
    (area ? area->widget() : dock.widget())->setFocus();
    if (area)
        QTimer::singleShot(0, area, [area] { scrollToKeyboard(*area); }); // once it is laid out
}

QDockWidget* PanelDocks::withFocus() const
{
    const QWidget* focused = QApplication::focusWidget();
    for (const Group& group : m_groups)
        for (QDockWidget* dock : group)
            if (focused && dock->isAncestorOf(focused))
                return dock;
    return nullptr;
}

void PanelDocks::closeOne()
{
    if (QDockWidget* dock = withFocus())
        dock->close();
}

} // namespace carina
