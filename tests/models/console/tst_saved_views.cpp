#include "models/console/kept_console.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

#include <cmath>
#include <vector>

namespace carina::saved_views_test
{
namespace
{

SavedView named(const QString& name)
{
    return {name, {0.1, -0.7, 1.25}, {0.0, 0.02, 1.2}, {0.0, 0.0, 1.0}};
}

} // namespace

class TestSavedViews : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void areThereAtTheNextStart()
    {
        const test::ScratchFolder folder;
        KeptConsole kept{folder.path()};
        SavedViews views{kept};
        QVERIFY(views.all().empty());
        const QSignalSpy changed{&views, &SavedViews::changed};
        views.save(named(QStringLiteral(" Glottis, [left]=1 ")));
        views.save(named(QStringLiteral("Öffnung")));
        QCOMPARE(changed.size(), 2);
        KeptConsole again{folder.path()};
        const SavedViews next{again};
        QCOMPARE(next.all().size(), std::size_t{2});
        QVERIFY(next.all()[0] == named(QStringLiteral("Glottis, [left]=1")));
        QVERIFY(next.all()[1] == named(QStringLiteral("Öffnung")));
    }

    void replaceOneOfTheSameName()
    {
        const test::ScratchFolder folder;
        KeptConsole kept{folder.path()};
        SavedViews views{kept};
        views.save(named(QStringLiteral("A")));
        SavedView another = named(QStringLiteral("A"));
        another.p_A_eye.x() = 2.0;
        views.save(another);
        QCOMPARE(views.all().size(), std::size_t{1});
        QCOMPARE(views.all()[0].p_A_eye.x(), 2.0);
    }

    void canBeDeleted()
    {
        const test::ScratchFolder folder;
        KeptConsole kept{folder.path()};
        SavedViews views{kept};
        views.save(named(QStringLiteral("A")));
        views.save(named(QStringLiteral("B")));
        views.remove(QStringLiteral("A"));
        QCOMPARE(KeptConsole{folder.path()}.views().size(), std::size_t{1});
        QCOMPARE(views.all()[0].name, QStringLiteral("B"));
    }

    void comeBackByUndo()
    {
        const test::ScratchFolder folder;
        KeptConsole kept{folder.path()};
        ChangeHistory history;
        SavedViews views{kept};
        views.setHistory(history);
        for (const char* name : {"A", "B", "C"})
            views.save(named(QLatin1String{name}));
        const std::vector<SavedView> before = views.all();
        views.remove(QStringLiteral("B"));
        views.remove(QStringLiteral("none"));
        QCOMPARE(history.texts(), QStringList{QStringLiteral("View B → deleted")});
        history.undo();
        QVERIFY(views.all() == before); // in its place
        QVERIFY(KeptConsole{folder.path()}.views() == before);
    }

    void comeBackWhereTheyWereSavedOver()
    {
        const test::ScratchFolder folder;
        KeptConsole kept{folder.path()};
        ChangeHistory history;
        SavedViews views{kept};
        views.setHistory(history);
        views.save(named(QStringLiteral("A")));
        views.save(named(QStringLiteral("B")));
        const std::vector<SavedView> before = views.all();
        SavedView another = named(QStringLiteral(" A "));
        another.p_A_eye.x() = 2.0;
        views.save(another);
        views.save(another); // as it is
        QCOMPARE(history.texts(), QStringList{QStringLiteral("View A → saved over")});
        history.undo();
        QVERIFY(views.all() == before);
        QVERIFY(KeptConsole{folder.path()}.views() == before);
    }

    void staySavedOverWhereAnotherHasTheName()
    {
        KeptConsole kept{{}};
        ChangeHistory history;
        SavedViews views{kept};
        const QSignalSpy refused{&history, &ChangeHistory::refused};
        SavedView another = named(QStringLiteral("A"));
        another.p_A_eye.x() = 2.0;
        views.save(named(QStringLiteral("A")));
        views.setHistory(history);
        views.save(another);
        views.remove(QStringLiteral("A"));
        SavedView third = named(QStringLiteral("A"));
        third.p_A_eye.x() = 3.0;
        views.save(third);
        history.undo(2); // the deletion first
        QCOMPARE(refused.size(), 2);
        QCOMPARE(refused.last().front().toString(),
                 QStringLiteral("Not undone: another view is called A now."));
        QVERIFY(views.all() == std::vector{third});
    }

    void stayDeletedWhereTheyHaveNoPlace()
    {
        KeptConsole kept{{}};
        ChangeHistory history;
        SavedViews views{kept};
        views.setHistory(history);
        const QSignalSpy refused{&history, &ChangeHistory::refused};
        views.save(named(QStringLiteral("A")));
        views.remove(QStringLiteral("A"));
        SavedView another = named(QStringLiteral("A"));
        another.p_A_eye.x() = 2.0;
        views.save(another);
        history.undo();
        QCOMPARE(refused.last().front().toString(),
                 QStringLiteral("Not undone: another view is called A now."));
        QVERIFY(views.all() == std::vector{another});
        views.remove(QStringLiteral("A"));
        for (std::size_t number = 0; number < SavedViews::kMost; ++number)
            views.save(named(QString::number(number)));
        history.undo();
        QCOMPARE(refused.last().front().toString(),
                 QStringLiteral("Not undone: there are 20 views, as many as there can be."));
        QCOMPARE(views.all().size(), SavedViews::kMost);
    }

    void needANameAndRoom()
    {
        KeptConsole kept{{}};
        SavedViews views{kept};
        QVERIFY(!views.faultOf(QStringLiteral("  ")).isEmpty());
        QVERIFY(!views.faultOf(QString{41, QLatin1Char{'x'}}).isEmpty());
        for (std::size_t number = 0; number < SavedViews::kMost; ++number) {
            const QString name = QString::number(number);
            QVERIFY(views.faultOf(name).isEmpty());
            views.save(named(name));
        }
        QVERIFY(!views.faultOf(QStringLiteral("one more")).isEmpty());
        QVERIFY(views.faultOf(QStringLiteral("3")).isEmpty()); // is replaced
    }

    void areLeftOutWhereNoCameraCanStandThere()
    {
        const test::ScratchFolder folder;
        folder.write("console.ini", "[views]\nsize=3\n1\\name=Nowhere\n1\\from=0,0,0,0,0,0,0,0,1\n"
                                    "2\\name=Words\n2\\from=a,b\n"
                                    "3\\name=Good\n3\\from=0,-1,0,0,0,0,0,0,1\n");
        const auto views = KeptConsole{folder.path()}.views();
        QCOMPARE(views.size(), std::size_t{1});
        QCOMPARE(views[0].name, QStringLiteral("Good"));
        QVERIFY(!isPossible({{}, {0, 0, std::nan("")}, {}, {0, 0, 1}}));
        QVERIFY(!isPossible({{}, {0, 0, 1}, {}, {0, 0, 1}}));
    }

    void leaveThePanelsAsTheyAre()
    {
        const test::ScratchFolder folder;
        KeptConsole kept{folder.path()};
        QVERIFY(kept.panels().isEmpty());
        const QByteArray panels{"\0\xff panels", 9};
        kept.keepPanels(panels);
        kept.keepViews({named(QStringLiteral("A"))});
        QCOMPARE(KeptConsole{folder.path()}.panels(), panels);
    }
};

CARINA_TEST(TestSavedViews)

} // namespace carina::saved_views_test

#include "tst_saved_views.moc"
