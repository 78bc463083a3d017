#include "tests/models/registration/touch_desk.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

namespace carina::touch_task_test
{

using namespace test;

class TestTouchTask : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void knowsLandmarksInAnyOrder()
    {
        Desk desk;
        // The first three as they are asked for, the others as it suits.
        for (const std::size_t landmark : {0U, 1U, 2U, 6U, 4U, 7U, 3U, 5U}) {
            QVERIFY(!desk.isTouched(landmark));
            desk.touch(landmark);
            QVERIFY2(desk.isTouched(landmark), qPrintable(desk.model->problem()));
        }
        QVERIFY(!desk.model->nextLandmark());
        desk.model->enter(SiteStep::Fit);
        desk.model->fitting().fit();
        QVERIFY(liesAt(*desk.model, desk.site.X_TA));
    }

    void saysWhichOneItTook()
    {
        Desk desk;
        QSignalSpy told{desk.model.get(), &RegistrationModel::told};
        desk.touch(0);
        QCOMPARE(told.size(), qsizetype{1});
        QCOMPARE(told[0][0].toString(), QString::fromStdString(desk.landmarks[0].name));
    }

    void refusesAPlaceThatIsNoLandmark()
    {
        Desk desk;
        for (const std::size_t landmark : {0U, 1U, 2U})
            desk.touch(landmark);
        const Vec3 p_AQ = desk.landmarks[3].p_AQ + Vec3{0.0, 0.0, 0.03};
        desk.site.hold(*desk.model, desk.site.X_TA * p_AQ);
        QVERIFY(!desk.isTouched(3));
        QVERIFY2(desk.model->problem().contains(QStringLiteral("30")),
                 qPrintable(desk.model->problem()));
        desk.model->touching().choose(3); // a person says that it is meant
        desk.site.hold(*desk.model, desk.site.X_TA * p_AQ);
        QVERIFY(!desk.isTouched(3)); // it still rests there: it is to be touched again
        desk.site.holdFor(*desk.model, 3, desk.site.X_TA * Vec3{0.3, 0.3, 0.3});
        desk.site.hold(*desk.model, desk.site.X_TA * p_AQ);
        QVERIFY(desk.isTouched(3));
        QVERIFY(desk.model->problem().isEmpty());
    }

    void takesALandmarkAgainByItsPlace()
    {
        Desk desk;
        for (const std::size_t landmark : {0U, 1U, 2U, 3U})
            desk.touch(landmark);
        const Vec3 p_TQ = desk.site.X_TA * Vec3{desk.landmarks[1].p_AQ + Vec3{0.001, 0.0, 0.0}};
        desk.site.hold(*desk.model, p_TQ);
        QCOMPARE(desk.model->site().touched.size(), std::size_t{4});
        QVERIFY((desk.model->site().touched.back().p_TQ - p_TQ).norm() < kExact);
        QCOMPARE(desk.model->site().touched.back().landmark, desk.landmarks[1].name);
    }

    void takesAPointByAKey()
    {
        Desk desk;
        for (int i = 0; i < 20; ++i) // not yet held for long enough
            desk.site.tipAt(desk.site.X_TA * desk.landmarks[0].p_AQ);
        desk.model->look();
        QVERIFY(!desk.isTouched(0));
        desk.model->takeNow();
        QVERIFY(desk.isTouched(0));
        desk.site.m_now += std::chrono::seconds{1}; // and the stylus is gone
        desk.model->takeNow();
        QVERIFY(!desk.isTouched(1));
        QVERIFY(!desk.model->problem().isEmpty());
    }

    /// A key takes a point once, and what was taken by a key is not taken again by resting there.
    void takesAPointOnce()
    {
        Desk desk;
        const Vec3 p_TQ = desk.site.X_TA * desk.landmarks[0].p_AQ;
        desk.site.holdFor(*desk.model, 20, p_TQ);
        desk.model->takeNow();
        QVERIFY(desk.isTouched(0));
        desk.site.hold(*desk.model, p_TQ);
        desk.model->takeNow();
        QVERIFY(!desk.model->problem().isEmpty());
        QCOMPARE(desk.model->site().touched.size(), std::size_t{1});
        desk.model->undo();
        QVERIFY(!desk.model->canUndo() || desk.model->site().touched.empty());
    }

    /// A stylus that lies in view when the page is entered touches nothing.
    void leavesAloneAStylusThatRests()
    {
        Desk desk;
        const Vec3 table{0.3, 0.2, -1.0};
        desk.site.holdFor(*desk.model, 20, table);
        desk.model->enter(SiteStep::Landmarks);
        desk.model->enter(SiteStep::Touch);
        desk.site.hold(*desk.model, table);
        QVERIFY(desk.model->site().touched.empty());
        desk.touch(0);
        QVERIFY(desk.isTouched(0));
    }

    /// Nor does one that lies there when the program is started again.
    void leavesAloneAStylusThatRestsWhenItStarts()
    {
        Desk desk;
        desk.model.reset();
        desk.site.m_now += std::chrono::seconds{10};
        desk.model = desk.site.model();
        desk.site.holdFor(*desk.model, 120, {0.3, 0.2, -1.0});
        QVERIFY(desk.model->site().touched.empty());
        desk.touch(0);
        QVERIFY(desk.isTouched(0));
    }
};

CARINA_TEST(TestTouchTask)

} // namespace carina::touch_task_test

#include "tst_touch_task.moc"
