#include "tests/models/registration/registration_site.h"
#include "tests/support/test_class.h"

namespace carina::tool_task_test
{
namespace
{

constexpr double kExact = 1e-7; // m, and as coefficients of a rotation

const RigidTransform kX_NE{rotationFromVector({0.4, -0.9, 1.3}), {0.02, -0.05, 0.03}};
const RigidTransform kX_NL{rotationFromVector({-0.2, 0.7, 2.1}), {0.0, -0.12, 0.02}};
const BladeShape kBlade{.heelWidth = millimetres(16.0),
                        .handle = millimetres(150.0),
                        .p_L_tip = {0.0, 0.012, -0.13},
                        .p_L_half = {0.0, -0.012, -0.066}};

/// A technician whose stylus is known, with a tube and a laryngoscope at hand.
struct ToolDesk {
    RegistrationSite site{true};
    std::unique_ptr<RegistrationModel> model = site.model();
    TubeRest tube{.length = millimetres(240.0),
                  .bends = {7.0, 7.0},
                  .outerDiameter = RegistrationSite::patient().tube().outerDiameter};
    RigidTransform X_NE = kX_NE; ///< as the markers are on the tube now

    ToolDesk()
    {
        model->useTracker();
        site.swing(*model);
        model->enter(SiteStep::Tools);
    }
    [[nodiscard]] ToolTask& task() const { return model->toolTask(); }

    void touch(const TubeTouchPlace& place, const Vec3& off_T = Vec3::Zero())
    {
        site.hold(*model, site.m_X_TN_tube * (X_NE * placeOnTube(tube, place)) + off_T);
    }
    void touch(BladePlace place)
    {
        site.hold(*model, site.m_X_TN_laryngoscope * (kX_NL * placeOnBlade(kBlade, place)));
    }
    void touchTube(std::size_t count = kTubePlaces.size())
    {
        for (std::size_t i = 0; i < count; ++i)
            touch(kTubePlaces[i]);
    }
    void calibrateTube()
    {
        task().beginCalibration();
        touchTube();
    }
    /// The stylus is elsewhere before: where it rests it touches nothing.
    void checkTube()
    {
        site.holdFor(*model, 20, {0.3, 0.3, -1.0});
        task().beginCheck();
        touch(kTubePlaces.back());
    }
    [[nodiscard]] const SiteTool* stored(ToolRole role) const
    {
        return toolOfRole(model->site().tools, role);
    }
};

} // namespace

class TestToolTask : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheTubeByItsPlaces()
    {
        ToolDesk desk;
        QCOMPARE(desk.task().task().state, TaskState::Open);
        desk.task().beginCalibration();
        QVERIFY(desk.model->instruction().contains(QStringLiteral("rim of the connector")));
        desk.touchTube();
        QVERIFY2(desk.model->problem().isEmpty(), qPrintable(desk.model->problem()));
        QVERIFY(!desk.task().isTouching());
        const SiteTool* tube = desk.stored(ToolRole::Tube);
        QVERIFY(tube);
        QCOMPARE(tube->tool, std::string{"ETT"});
        QCOMPARE(tube->calibratedAt, std::string{"2004-03-27T10:15:00Z"});
        QVERIFY((tube->X_NO.matrix() - kX_NE.matrix()).norm() < 1e-5);
        QVERIFY((tube->p_NQ_tip() - kX_NE * tipOfTube(desk.tube)).norm() < kExact);
        QVERIFY(std::abs(tube->tube->length.si - desk.tube.length.si) < 1e-6);
        QCOMPARE(desk.task().task().state, TaskState::Begun); // the laryngoscope is still to do
        QVERIFY(desk.task().described().contains(QStringLiteral("240 mm")));
    }

    /// Both are in somebody's hands.
    void findsATubeThatMoves()
    {
        ToolDesk desk;
        desk.task().beginCalibration();
        for (const TubeTouchPlace& place : kTubePlaces) {
            desk.site.m_X_TN_tube =
                RigidTransform{rotationFromVector({place.share, 0.5, -place.share}),
                               {0.1 * place.share, 0.05, -1.1}};
            desk.touch(place);
        }
        const SiteTool* tube = desk.stored(ToolRole::Tube);
        QVERIFY(tube);
        QVERIFY((tube->p_NQ_tip() - kX_NE * tipOfTube(desk.tube)).norm() < kExact);
    }

    void findsTheLaryngoscopeToo()
    {
        ToolDesk desk;
        desk.calibrateTube();
        desk.task().choose(ToolRole::Laryngoscope);
        desk.task().beginCalibration();
        for (const BladePlace place : kBladePlaces)
            desk.touch(place);
        const SiteTool* scope = desk.stored(ToolRole::Laryngoscope);
        QVERIFY(scope);
        QVERIFY((scope->X_NO.matrix() - kX_NL.matrix()).norm() < kExact);
        QVERIFY(desk.task().described().startsWith(QStringLiteral("Curved blade")));
        QCOMPARE(desk.task().task().state, TaskState::Done);
        QCOMPARE(desk.model->site().tools.size(), std::size_t{2});
    }

    void takesNothingOfAToolThatIsNotSeen()
    {
        ToolDesk desk;
        desk.task().beginCalibration();
        desk.site.m_areToolsSeen = false;
        desk.touch(kTubePlaces[0]);
        QVERIFY(!desk.task().canUndo());
        desk.model->takeNow();
        QVERIFY(desk.model->problem().contains(QStringLiteral("out of view")));
        desk.site.m_areToolsSeen = true;
        desk.touch(kTubePlaces[1]);
        QVERIFY(desk.task().canUndo());
    }

    void undoesTheLastTouch()
    {
        ToolDesk desk;
        desk.task().beginCalibration();
        desk.touchTube(4);
        desk.touch(kTubePlaces[4], {0.02, 0.03, 0.0}); // a slip
        QVERIFY(desk.model->canUndo());
        desk.model->undo();
        QVERIFY(desk.task().places()[4].isNext);
        for (std::size_t i = 4; i < kTubePlaces.size(); ++i)
            desk.touch(kTubePlaces[i]);
        QVERIFY(desk.stored(ToolRole::Tube));
        desk.model->undo(); // of what is stored
        QVERIFY(!desk.stored(ToolRole::Tube));
    }

    void saysThatATouchSlippedAndTakesItAgain()
    {
        ToolDesk desk;
        desk.task().beginCalibration();
        for (std::size_t i = 0; i < kTubePlaces.size(); ++i)
            desk.touch(kTubePlaces[i], i == 5 ? Vec3{0.02, 0.02, 0.02} : Vec3{Vec3::Zero()});
        QVERIFY(!desk.stored(ToolRole::Tube));
        QVERIFY2(desk.model->problem().contains(QStringLiteral("do not fit one tube")),
                 qPrintable(desk.model->problem()));
        QVERIFY(desk.task().isTouching() && !desk.task().next());
        for (std::size_t i = 5; i < kTubePlaces.size(); ++i)
            desk.model->undo();
        for (std::size_t i = 5; i < kTubePlaces.size(); ++i)
            desk.touch(kTubePlaces[i]);
        QVERIFY(desk.stored(ToolRole::Tube));
        QVERIFY(desk.model->problem().isEmpty());
    }

    void keepsItForTheNextProgram()
    {
        ToolDesk desk;
        desk.calibrateTube();
        desk.model = desk.site.model();
        QVERIFY(desk.stored(ToolRole::Tube));
        QCOMPARE(desk.task().outerDiameter().si, desk.tube.outerDiameter.si);
        QCOMPARE(desk.model->step(), SiteStep::Tools);
    }

    void tellsABentTube()
    {
        ToolDesk desk;
        desk.calibrateTube();
        desk.checkTube();
        QVERIFY(desk.stored(ToolRole::Tube)->check && !desk.stored(ToolRole::Tube)->isBent());
        QVERIFY(desk.task().described().contains(QStringLiteral("As it was")));
        desk.X_NE = kX_NE * RigidTransform{rotationFromVector({0.02, 0.0, 0.0}), Vec3::Zero()};
        desk.checkTube(); // its markers were pushed: by 20 mrad, at 0.2 m
        QVERIFY(desk.stored(ToolRole::Tube)->isBent());
        QVERIFY(desk.task().described().contains(QStringLiteral("Bent")));
        QCOMPARE(desk.task().task().state, TaskState::Stale);
        QVERIFY(desk.model->health().join(QLatin1Char(' ')).contains(QStringLiteral("bent")));
        desk.calibrateTube();
        QVERIFY(!desk.stored(ToolRole::Tube)->check);
        QCOMPARE(desk.task().task().state, TaskState::Begun);
    }

    void isStaleAfterAnotherStylusUntilItIsChecked()
    {
        ToolDesk desk;
        desk.calibrateTube();
        desk.model->enter(SiteStep::Stylus);
        desk.model->stylus().findTip();
        desk.site.swing(*desk.model);
        desk.model->enter(SiteStep::Tools);
        QVERIFY(desk.stored(ToolRole::Tube)->stale == StaleCause::Stylus);
        QCOMPARE(desk.task().task().state, TaskState::Stale);
        desk.checkTube();
        QVERIFY(!desk.stored(ToolRole::Tube)->stale);
    }

    void saysWhenItWasCalibratedLongAgo()
    {
        ToolDesk desk;
        desk.calibrateTube();
        desk.site.m_today = desk.site.m_today.addDays(40);
        QVERIFY(
            desk.model->health().join(QLatin1Char(' ')).contains(QStringLiteral("40 days ago")));
        desk.checkTube();
        QVERIFY(!desk.model->health().join(QLatin1Char(' ')).contains(QStringLiteral("Touch its")));
    }

    void waitsForAStylus()
    {
        RegistrationSite site{true};
        const auto model = site.model();
        model->enter(SiteStep::Tools);
        QCOMPARE(model->task(SiteStep::Tools).state, TaskState::Waits);
        model->toolTask().beginCalibration();
        QVERIFY(!model->problem().isEmpty() && !model->toolTask().isTouching());
    }

    void hasNothingToDoWithoutTools()
    {
        RegistrationSite site;
        const auto model = site.model();
        QVERIFY(model->toolTask().offered().empty());
        QCOMPARE(model->task(SiteStep::Tools).state, TaskState::Done);
        QVERIFY(!model->toolTask().whyNoTouch().isEmpty());
        model->enter(SiteStep::Tools);
        QVERIFY(model->instruction().contains(QStringLiteral("no tube")));
    }

    void forgetsTouchesOfAnotherPage()
    {
        ToolDesk desk;
        desk.task().beginCalibration();
        desk.touchTube(3);
        desk.model->enter(SiteStep::Overview);
        desk.model->enter(SiteStep::Tools);
        QVERIFY(!desk.task().isTouching());
    }
};

CARINA_TEST(TestToolTask)

} // namespace carina::tool_task_test

#include "tst_tool_task.moc"
