#include "tests/models/registration_site.h"

#include <QSignalSpy>
#include <QTest>

#include <algorithm>

namespace carina
{
namespace
{

constexpr double kExact = 1e-9; // m, of exact samples

/// A wizard whose stylus is known, on the page where landmarks are touched.
struct Desk {
    RegistrationSite site;
    std::unique_ptr<RegistrationModel> model = site.model();
    std::vector<Landmark> landmarks = site.landmarks();

    Desk()
    {
        model->useTracker();
        site.swing(*model);
        model->landmarkTask().accept();
    }

    void touch(std::size_t landmark, const RigidTransform& X_TA)
    {
        site.hold(*model, X_TA * landmarks[landmark].p_AQ);
    }
    void touch(std::size_t landmark) { touch(landmark, site.X_TA); }
    void register_()
    {
        for (std::size_t i = 0; i < landmarks.size(); ++i)
            touch(i);
        model->enter(SiteStep::Fit);
        model->fitting().fit();
    }
    [[nodiscard]] bool isTouched(std::size_t landmark) const
    {
        return model->landmarks()[landmark].spread_mm.has_value();
    }
};

/// Where somebody pushed the manikin to: X_T'A of a push and the place from before.
RigidTransform pushed(const RigidTransform& X_TA)
{
    return RigidTransform{rotationFromVector({0.05, -0.3, 0.1}), {0.04, -0.02, 0.03}} * X_TA;
}

bool liesAt(const RegistrationModel& model, const RigidTransform& X_TA)
{
    return (model.site().registration->X_AT * X_TA).matrix().isApprox(Mat4::Identity(), kExact);
}

} // namespace

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

    void laysAMovedManikinAnewByThreeOfItsLandmarks()
    {
        Desk desk;
        desk.register_();
        const RigidTransform X_TA = pushed(desk.site.X_TA);
        QVERIFY(!liesAt(*desk.model, X_TA));
        desk.model->touching().beginRelay();
        QCOMPARE(desk.model->step(), SiteStep::Touch);
        QVERIFY(!desk.isTouched(0));
        for (const std::size_t landmark : {0U, 2U, 7U}) {
            desk.model->touching().choose(landmark);
            desk.touch(landmark, X_TA);
        }
        QVERIFY2(liesAt(*desk.model, X_TA), qPrintable(desk.model->problem()));
        QVERIFY(!desk.model->touching().isRelaying());
        QCOMPARE(desk.model->site().registration->relays.size(), std::size_t{1});
        // How it was laid anew is not in the touches of before: no fit of them knows its error.
        desk.model->fitting().fit();
        QVERIFY(!desk.model->problem().isEmpty());
        QVERIFY(liesAt(*desk.model, X_TA));
        QCOMPARE(desk.model->site().registration->relays.size(), std::size_t{1});
    }

    void goesOnLayingItAnewAfterACrash()
    {
        Desk desk;
        desk.register_();
        const RigidTransform X_TA = pushed(desk.site.X_TA);
        desk.model->touching().beginRelay();
        desk.touch(0, X_TA);
        desk.model.reset();
        desk.model = desk.site.model();
        QVERIFY(desk.model->touching().isRelaying());
        QVERIFY(desk.isTouched(0));
        for (const std::size_t landmark : {2U, 7U}) {
            desk.model->touching().choose(landmark);
            desk.touch(landmark, X_TA);
        }
        QVERIFY(liesAt(*desk.model, X_TA));
    }

    /// Notch, left fifth rib and right angle of the jaw: the lungs could turn by centimetres.
    void asksForOneMoreWhereThreeAreNearlyOnALine()
    {
        Desk desk;
        desk.register_();
        const RigidTransform X_TA = pushed(desk.site.X_TA);
        desk.model->touching().beginRelay();
        for (const std::size_t landmark : {0U, 2U, 5U}) {
            desk.model->touching().choose(landmark);
            desk.touch(landmark, X_TA);
        }
        QVERIFY(desk.model->touching().isRelaying());
        QVERIFY(desk.model->problem().contains(QStringLiteral("one more")));
        desk.model->touching().choose(7);
        desk.touch(7, X_TA);
        QVERIFY(liesAt(*desk.model, X_TA));
    }

    void laysNothingAnewThatIsStale()
    {
        Desk desk;
        desk.register_();
        desk.model->touching().beginRelay();
        desk.touch(0, pushed(desk.site.X_TA));
        desk.model->stylus().findTip();
        desk.site.swing(*desk.model); // all that was touched rests on the tip of before
        QVERIFY(!desk.model->touching().isRelaying());
        desk.model->touching().beginRelay();
        QVERIFY(!desk.model->touching().isRelaying());
        QVERIFY(!desk.model->problem().isEmpty());
    }

    /// While it is laid anew, a landmark that was not touched before tells nothing.
    void takesOnlyWhatWasTouchedBefore()
    {
        Desk desk;
        for (const std::size_t i : {0U, 1U, 2U, 3U})
            desk.touch(i);
        desk.model->fitting().fit();
        const RigidTransform X_TA = pushed(desk.site.X_TA);
        desk.model->touching().beginRelay();
        desk.model->touching().choose(5);
        desk.touch(5, X_TA);
        QVERIFY(!desk.isTouched(5));
        QVERIFY(desk.model->touching().isRelaying());
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

    void leavesTheManikinWhereItWas()
    {
        Desk desk;
        desk.register_();
        desk.model->touching().beginRelay();
        desk.touch(0, pushed(desk.site.X_TA));
        desk.model->touching().cancelRelay();
        QVERIFY(!desk.model->touching().isRelaying());
        QVERIFY(liesAt(*desk.model, desk.site.X_TA));
        QCOMPARE(desk.model->task(SiteStep::Touch).state, TaskState::Done);
    }

    void saysWhenATouchDoesNotFitTheManikin()
    {
        Desk desk;
        desk.register_();
        const RigidTransform X_TA = pushed(desk.site.X_TA);
        desk.model->touching().beginRelay();
        for (const std::size_t landmark : {0U, 2U}) {
            desk.model->touching().choose(landmark);
            desk.touch(landmark, X_TA);
        }
        desk.model->touching().choose(7);
        desk.site.hold(*desk.model, X_TA * Vec3{desk.landmarks[7].p_AQ + Vec3{0.02, 0.01, 0.0}});
        QVERIFY(!desk.model->problem().isEmpty());
        QVERIFY(desk.model->touching().isRelaying());
        QVERIFY(liesAt(*desk.model, desk.site.X_TA)); // until it is known better
        desk.model->touching().choose(7);
        desk.touch(7, X_TA);
        QVERIFY(liesAt(*desk.model, X_TA));
    }
};

} // namespace carina

QTEST_GUILESS_MAIN(carina::TestTouchTask)
#include "tst_touch_task.moc"
