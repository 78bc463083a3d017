#include "tests/support/test_class.h"
#include "tests/ui/instructor/console_desk.h"
#include "tests/ui/trainee/trainee_desk.h"
#include "ui/panels/session/undo_button.h"
#include "widgets/scene/view/graphics.h"

#include <QApplication>
#include <QMenu>
#include <QTableView>

#include <set>
#include <vector>

namespace carina::every_menu_test
{
namespace
{

using test::FakeSessionNode;

/// What is wrong for who has no mouse: each entry has a text, and no two have one key. Entries that
/// are hidden now may be there together another time, so their keys count, too.
QStringList faultsOfMenu(const QMenu& menu)
{
    QStringList faults;
    std::set<QString> keys;
    for (const QAction* action : menu.actions()) {
        if (action->isVisible() && !action->isSeparator() && action->text().isEmpty())
            faults += QStringLiteral("An entry has no text");
        const QString key = QKeySequence::mnemonic(action->text()).toString();
        if (!key.isEmpty() && !keys.insert(key).second)
            faults += action->text() + QStringLiteral(" has the key of another entry");
    }
    return faults;
}

/// All that there are, filled as when they open.
std::vector<QMenu*> openedMenus()
{
    std::vector<QMenu*> menus;
    for (QWidget* window : QApplication::topLevelWidgets())
        if (auto* menu = qobject_cast<QMenu*>(window))
            menus.push_back(menu);
    for (QMenu* menu : menus)
        Q_EMIT menu->aboutToShow();
    return menus;
}

/// @param count how many there are that have entries
void verifyMenus(std::size_t count)
{
    QStringList faults;
    std::size_t filled = 0;
    for (const QMenu* menu : openedMenus()) {
        faults += faultsOfMenu(*menu);
        filled += menu->actions().isEmpty() ? 0U : 1U;
    }
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char{'\n'})));
    QCOMPARE(filled, count);
}

} // namespace

/// Each entry of each menu has a text, and a key of its own where it has one.
class TestEveryMenu : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void findsWhatIsAmiss()
    {
        QMenu menu;
        menu.addAction(QStringLiteral("&Open"));
        menu.addAction(QStringLiteral("&Other"));
        menu.addAction(QStringLiteral("R && D"));
        menu.addSeparator();
        menu.addAction(QString{});
        QCOMPARE(faultsOfMenu(menu),
                 (QStringList{QStringLiteral("&Other has the key of another entry"),
                              QStringLiteral("An entry has no text")}));
    }

    /// Panels, saved views and which to delete, eyes, stations to move to, places, to whom it is
    /// shown, and what else needs attention.
    void ofTheConsole()
    {
        const test::ScratchFolder folder;
        KeptConsole kept{folder.path()};
        kept.keepViews(
            {{QStringLiteral("Front & back"), {0.0, -0.4, 1.9}, {0.0, 0.0, 1.3}, {0.0, 0.0, 1.0}}});
        test::ConsoleDesk desk{folder};
        desk.node.addStation("Room & hall");
        desk.node.linkReports = {{FakeSessionNode::kTrainee, LinkState::Away, {}, {}, {}},
                                 {FakeSessionNode::kObserver, LinkState::Away, {}, {}, {}}};
        QCoreApplication::sendPostedEvents();
        desk.attention.look();
        auto& people = desk.find<QTableView>("table");
        people.setCurrentIndex(people.model()->index(0, 0));
        verifyMenus(8);
    }

    void ofTheHistory()
    {
        ChangeHistory history;
        const UndoButton button{history};
        for (const char* change : {"Mute Tom & Ann", "PEEP", "Parts & cuts"})
            history.add(button, QString::fromLatin1(change), [] {});
        verifyMenus(1);
    }

    /// Its own, whose eyes, who is at work, and where others see this one.
    void ofTheTraineesWindow()
    {
        const test::TraineeDesk desk;
        verifyMenus(4);
    }
};

CARINA_SCREEN_TEST(TestEveryMenu)

} // namespace carina::every_menu_test

#include "tst_every_menu.moc"
