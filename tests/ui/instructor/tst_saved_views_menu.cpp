#include "models/console/kept_console.h"
#include "tests/support/test_class.h"
#include "ui/instructor/save_view_dialog.h"
#include "ui/instructor/saved_views_menu.h"
#include "ui/instructor/status_line.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>

namespace carina::saved_views_menu_test
{
namespace
{

struct Shown {
    KeptConsole kept{{}};
    SavedViews views{kept};
    QWidget window;
    SavedViewsMenu menu{views,
                        [] {
                            return SavedView{{}, {0, -1, 1}, {0, 0, 1}, {0, 0, 1}};
                        },
                        &window};

    [[nodiscard]] QStringList opened()
    {
        Q_EMIT menu.aboutToShow();
        QStringList texts;
        for (const QAction* action : menu.actions())
            if (!action->isSeparator())
                texts += action->text();
        return texts;
    }
};

} // namespace

class TestSavedViewsMenu : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void savesUnderAName()
    {
        Shown shown;
        shown.window.show();
        QCOMPARE(shown.opened(), (QStringList{QStringLiteral("(No view is saved yet)"),
                                              QStringLiteral("&Save this view…"),
                                              QStringLiteral("&Delete a view")}));
        shown.menu.actions()[2]->trigger();
        auto& dialog = *shown.window.findChild<SaveViewDialog*>();
        auto& save = *dialog.findChild<QPushButton*>(QStringLiteral("saveView"));
        QVERIFY(!save.isEnabled());
        QVERIFY(!dialog.findChild<QLabel*>(QStringLiteral("fault"))->text().isEmpty());
        dialog.findChild<QLineEdit*>()->setText(QStringLiteral("Glottis & cords"));
        QVERIFY(save.isEnabled());
        save.click();
        QCOMPARE(shown.views.all().size(), std::size_t{1});
        QCOMPARE(shown.views.all()[0].p_A_eye, Vec3(0, -1, 1));
        QCOMPARE(shown.opened().front(), QStringLiteral("Glottis && cords"));
    }

    void choosesAndDeletes()
    {
        Shown shown;
        shown.views.save({QStringLiteral("A"), {0, -2, 1}, {0, 0, 1}, {0, 0, 1}});
        const QSignalSpy chosen{&shown.menu, &SavedViewsMenu::chosen};
        QCOMPARE(shown.opened().size(), 3);
        QCOMPARE(shown.opened().size(), 3); // once more
        shown.menu.actions().front()->trigger();
        QCOMPARE(chosen.size(), 1);
        shown.menu.actions().last()->menu()->actions().front()->trigger();
        QVERIFY(shown.views.all().empty());
    }

    void saysWholeStatementsOnly()
    {
        StatusLine line;
        auto& label = *line.findChild<QLabel*>();
        line.resize(2000, 30);
        line.show();
        line.say({QStringLiteral("first"), QStringLiteral("second"), QStringLiteral("third")});
        QVERIFY(label.text().endsWith(QStringLiteral("third")));
        line.resize(label.fontMetrics().horizontalAdvance(QStringLiteral("first      second th")),
                    30);
        QCoreApplication::sendPostedEvents();
        QVERIFY(label.text().startsWith(QStringLiteral("first")));
        QVERIFY(!label.text().contains(QStringLiteral("th")));
        QVERIFY(line.findChild<QLabel*>()->toolTip().contains(QStringLiteral("third")));
    }
};

CARINA_SCREEN_TEST(TestSavedViewsMenu)

} // namespace carina::saved_views_menu_test

#include "tst_saved_views_menu.moc"
