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
        // What was touched before lies on the manikin still: another fit finds the same place.
        desk.model->fitting().fit();
        QVERIFY(liesAt(*desk.model, X_TA));
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
