#include "tests/models/registration/touch_desk.h"
#include "tests/support/test_class.h"

namespace carina::laying_anew_test
{

using namespace test;

/// A manikin that was moved after its registration.
class TestLayingAnew : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void laysAMovedManikinAnewByThreeOfItsLandmarks()
    {
        Desk desk;
        desk.register_();
        const RigidTransform X_TA = pushed(desk.site.X_TA);
        QVERIFY(!liesAt(*desk.model, X_TA));
        desk.model->touching().beginRelay();
        QCOMPARE(desk.model->step(), SiteStep::Touch);
        QVERIFY(!desk.isTouched(0));
        desk.touchChosen({0, 2, 7}, X_TA);
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
        desk.touchChosen({0}, X_TA);
        desk.model.reset();
        desk.model = desk.site.model();
        QVERIFY(desk.model->touching().isRelaying());
        QVERIFY(desk.isTouched(0));
        desk.touchChosen({2, 7}, X_TA);
        QVERIFY(liesAt(*desk.model, X_TA));
    }

    /// Who touches what is asked for needs three.
    void asksFirstForWhatTellsMost()
    {
        Desk desk;
        desk.register_();
        const RigidTransform X_TA = pushed(desk.site.X_TA);
        desk.model->touching().beginRelay();
        for (int i = 0; i < 3; ++i)
            desk.touch(*desk.model->nextLandmark(), X_TA);
        QVERIFY2(liesAt(*desk.model, X_TA), qPrintable(desk.model->problem()));
        QCOMPARE(desk.model->step(), SiteStep::Verify);
        QCOMPARE(desk.model->site().registration->relays.back().landmarks, 3);
    }

    /// Notch, left fifth rib and right angle of the jaw: the lungs could turn by centimetres.
    void asksForOneMoreWhereThreeAreNearlyOnALine()
    {
        Desk desk;
        desk.register_();
        const RigidTransform X_TA = pushed(desk.site.X_TA);
        desk.model->touching().beginRelay();
        desk.touchChosen({0, 2, 5}, X_TA);
        QVERIFY(desk.model->touching().isRelaying());
        QVERIFY(desk.model->problem().contains(QStringLiteral("one more")));
        desk.touchChosen({7}, X_TA);
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
        QCOMPARE(desk.model->problem(), desk.model->touching().whyNoRelay());
    }

    void laysAnewOnlyWhatIsRegistered()
    {
        Desk desk;
        QVERIFY(!desk.model->touching().whyNoRelay().isEmpty());
        desk.model->touching().beginRelay();
        QVERIFY(!desk.model->touching().isRelaying());
        desk.register_();
        QVERIFY(desk.model->touching().whyNoRelay().isEmpty());
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
        desk.touchChosen({5}, X_TA);
        QVERIFY(!desk.isTouched(5));
        QVERIFY(desk.model->touching().isRelaying());
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
        desk.touchChosen({0, 2}, X_TA);
        desk.model->touching().choose(7);
        desk.site.hold(*desk.model, X_TA * Vec3{desk.landmarks[7].p_AQ + Vec3{0.02, 0.01, 0.0}});
        QVERIFY(!desk.model->problem().isEmpty());
        QVERIFY(desk.model->touching().isRelaying());
        QVERIFY(liesAt(*desk.model, desk.site.X_TA)); // until it is known better
        desk.touchChosen({7}, X_TA);
        QVERIFY(liesAt(*desk.model, X_TA));
    }
};

CARINA_TEST(TestLayingAnew)

} // namespace carina::laying_anew_test

#include "tst_laying_anew.moc"
