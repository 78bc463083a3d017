#include "tests/support/test_class.h"
#include "tests/ui/registration/registration_desk.h"
#include "ui/registration/registration_paper.h"
#include "widgets/scene/view/graphics.h"
#include "widgets/scene/view/scene_view.h"

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QTableView>

#include <algorithm>

namespace carina::registration_window_test
{

class TestRegistrationWindow : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void leadsFromTheTrackerToTheTouches();
    void leadsFromTheTouchesToTheEnd();
    void obeysTheReturnKey();
    void opensEveryStepAndSaysWhatItWaitsFor();
    void showsProgressOnlyWhileThereIsSome();
    void choosesALandmarkByMouseAndKeyboard();
    void movesALandmarkToWhereTheModelIsClicked();
    void showsWhatIsStale();
    void offersToLayAnewWhereThatIsPossible();
    void offersToRepairExchangedLandmarks();
    void asksForTheVerdictOnceAllPlacesAreTouched();
    void writesTheRuleOfTheVerdictAndAsksForAName();
    void leadsBackToTheTouchesWhereItIsNotGood();
    void choosesAPlaceToCheck();
    void tellsHowFarTheStylusIsFromTheAnatomy();
    void comparesTheManikinByKeyboard();
    void showsTheWholeHead();
    void fitsItsPagesWithoutScrollBars();
};

void TestRegistrationWindow::leadsFromTheTrackerToTheTouches()
{
    RegistrationDesk desk;
    QCOMPARE(desk.button("primary").text(), QStringLiteral("&Use this tracker"));
    QVERIFY(desk.click("primary"));
    QCOMPARE(desk.model->step(), SiteStep::Stylus);
    QCOMPARE(desk.button("primary").text(), QStringLiteral("&Stop")); // it looks for the tip
    QVERIFY(desk.click("primary"));
    QVERIFY(!desk.model->stylus().isLookingForTip());
    QCOMPARE(desk.button("primary").text(), QStringLiteral("&Find the tip"));
    QVERIFY(desk.click("primary"));
    desk.site.swing(*desk.model);
    QCOMPARE(desk.button("primary").text(), QStringLiteral("Find the tip &again"));
    QVERIFY(desk.click("next"));
    QCOMPARE(desk.model->step(), SiteStep::Landmarks);
    QVERIFY(desk.click("primary"));
    QCOMPARE(desk.model->step(), SiteStep::Touch);
    QCOMPARE(desk.button("step5").text(), QStringLiteral("○  &5  Touch – open"));
    desk.site.touchFirst(*desk.model, 1);
    QCOMPARE(desk.button("step5").text(), QStringLiteral("◐  &5  Touch – begun"));
}

void TestRegistrationWindow::leadsFromTheTouchesToTheEnd()
{
    RegistrationDesk desk;
    desk.site.touchAll(*desk.model);
    QCOMPARE(desk.button("step5").text(), QStringLiteral("✓  &5  Touch – done"));
    QVERIFY(!desk.button("primary").isEnabled()); // nothing is left to be touched
    QVERIFY(desk.click("next"));
    QVERIFY(desk.click("primary"));
    QCOMPARE(desk.model->task(SiteStep::Fit).state, TaskState::Done);
    QVERIFY(desk.click("next"));
    QCOMPARE(desk.model->step(), SiteStep::Verify);
    QVERIFY(!desk.button("primary").isEnabled()); // nothing is checked yet
    desk.site.verifyAll(*desk.model);
    QCOMPARE(desk.button("primary").text(), QStringLiteral("&Record: good"));
    QVERIFY(desk.click("primary"));
    QVERIFY(desk.click("next"));
    QCOMPARE(desk.model->step(), SiteStep::Overview);
    QVERIFY(!desk.button("next").isVisible());
    QCOMPARE(desk.button("primary").text(), QStringLiteral("&Finish"));
    QVERIFY(desk.click("primary"));
    QVERIFY(!desk.window->isVisible());
}

void TestRegistrationWindow::obeysTheReturnKey()
{
    RegistrationDesk desk;
    desk.press(Qt::Key_Return);
    QCOMPARE(desk.model->step(), SiteStep::Stylus);
    desk.site.swing(*desk.model);
    QVERIFY(desk.button("next").isDefault()); // what is done is not done again
    desk.press(Qt::Key_Return);
    QCOMPARE(desk.model->step(), SiteStep::Landmarks);
}

void TestRegistrationWindow::opensEveryStepAndSaysWhatItWaitsFor()
{
    const RegistrationDesk desk;
    for (int step = 1; step <= 8; ++step) {
        const QByteArray name = QStringLiteral("step%1").arg(step).toLatin1();
        QVERIFY(desk.click(name));
        QCOMPARE(int(desk.model->step()), step - 1);
        QVERIFY(desk.button(name).isDefault());
    }
    QVERIFY(desk.button("step5").text().contains(QStringLiteral("not yet")));
    QCOMPARE(desk.button("step5").accessibleDescription(),
             QStringLiteral("Find the tip of the stylus first."));
}

void TestRegistrationWindow::showsProgressOnlyWhileThereIsSome()
{
    RegistrationDesk desk;
    QVERIFY(desk.click("primary"));
    QVERIFY(!desk.find<QProgressBar>("progress").isVisible());
    desk.site.swingFor(*desk.model, 200);
    QTRY_COMPARE(desk.find<QProgressBar>("progress").value(),
                 qRound(100.0 * desk.model->progress()));
    QVERIFY(desk.find<QProgressBar>("progress").value() > 20);
    QVERIFY(desk.find<QProgressBar>("progress").isVisible());
    desk.site.swing(*desk.model);
    QTRY_VERIFY(!desk.find<QProgressBar>("progress").isVisible());
}

void TestRegistrationWindow::choosesALandmarkByMouseAndKeyboard()
{
    RegistrationDesk desk;
    desk.model->enter(SiteStep::Landmarks);
    auto& table = desk.find<QTableView>("landmarks");
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {},
                      table.visualRect(table.model()->index(2, 0)).center());
    QCOMPARE(desk.model->nextLandmark(), std::optional<std::size_t>{2});
    QVERIFY(desk.tabTo("landmarks"));
    desk.press(Qt::Key_Up);
    QCOMPARE(desk.model->nextLandmark(), std::optional<std::size_t>{2}); // only looked at
    desk.press(Qt::Key_Space);
    QCOMPARE(desk.model->nextLandmark(), std::optional<std::size_t>{1});
}

void TestRegistrationWindow::movesALandmarkToWhereTheModelIsClicked()
{
    RegistrationDesk desk;
    desk.model->enter(SiteStep::Landmarks);
    desk.find<QCheckBox>("snapping").setChecked(false);
    desk.model->landmarkTask().choose(0);
    const Vec3 before = desk.model->landmarks()[0].p_AQ;
    // From in front of the right lung straight back.
    Q_EMIT desk.find<SceneView>("scene").clicked({-0.06, -1.0, -0.05}, Vec3::UnitY());
    const Vec3 after = desk.model->landmarks()[0].p_AQ;
    QVERIFY((after - before).norm() > 0.01);
    QVERIFY(std::abs(after.x() + 0.06) < 1e-9 && std::abs(after.z() + 0.05) < 1e-9);
    QVERIFY(desk.click("undo"));
    QVERIFY((desk.model->landmarks()[0].p_AQ - before).norm() < 1e-9);
}

void TestRegistrationWindow::showsWhatIsStale()
{
    RegistrationDesk desk;
    desk.site.fitAll(*desk.model);
    desk.model->enter(SiteStep::Stylus);
    QVERIFY(desk.click("primary"));
    desk.site.swing(*desk.model);
    for (const char* step : {"step5", "step6"}) {
        QVERIFY(desk.button(step).text().startsWith(QStringLiteral("▲")));
        QCOMPARE(desk.button(step).accessibleDescription(),
                 QStringLiteral("Out of date: the stylus was calibrated afterwards."));
    }
    QVERIFY(desk.click("step1"));
    QVERIFY(desk.find<QLabel>("health").text().contains(QStringLiteral("Touch: Out of date")));
    QCOMPARE(desk.button("primary").text(), QStringLiteral("&Go on: Touch"));
    QVERIFY(desk.click("undo"));
    QVERIFY(desk.button("step5").text().startsWith(QStringLiteral("✓")));
}

/// With the reason, where it would be refused.
void TestRegistrationWindow::offersToLayAnewWhereThatIsPossible()
{
    RegistrationDesk desk;
    const auto& why = desk.find<QLabel>("whyNotMoved");
    desk.model->enter(SiteStep::Overview);
    QVERIFY(!desk.button("moved").isVisible() && !why.isVisible());
    desk.site.fitAll(*desk.model);
    desk.model->enter(SiteStep::Overview);
    QVERIFY(desk.button("moved").isEnabled() && !why.isVisible());
    desk.model->landmarkTask().chooseSet(1);
    QVERIFY(!desk.button("moved").isEnabled() && why.isVisible());
    QCOMPARE(why.text(), desk.model->touching().whyNoRelay());
}

void TestRegistrationWindow::offersToRepairExchangedLandmarks()
{
    RegistrationDesk desk;
    desk.site.prepare(*desk.model);
    for (const std::size_t landmark : {0U, 1U, 3U, 2U, 4U, 5U, 6U, 7U}) {
        desk.model->touching().choose(*desk.model->touching().next());
        desk.site.hold(*desk.model, desk.site.X_TA * desk.site.landmarks()[landmark].p_AQ);
    }
    QVERIFY(desk.click("next"));
    const QLabel& findings = desk.find<QLabel>("findings");
    QVERIFY(findings.isVisible());
    for (const std::size_t landmark : {2U, 3U})
        QVERIFY(
            findings.text().contains(QString::fromStdString(desk.site.landmarks()[landmark].name)));
    QVERIFY(!findings.text().contains(QString::fromStdString(desk.site.landmarks()[0].name)));
    QVERIFY(desk.button("primary").text().contains(QStringLiteral("xchange")));
    QVERIFY(desk.click("primary")); // there is no fit but the right one
    QVERIFY(!findings.isVisible());
    QVERIFY(desk.button("primary").text().contains(QStringLiteral("Fit")));
    QVERIFY(desk.model->site().registration->rms < 1e-9);
}

/// It can be recorded before, where a place cannot be touched.
void TestRegistrationWindow::asksForTheVerdictOnceAllPlacesAreTouched()
{
    RegistrationDesk desk;
    desk.site.fitAll(*desk.model);
    desk.model->enter(SiteStep::Verify);
    const std::size_t places = desk.model->verifying().points().size();
    for (std::size_t touched = 1; touched <= places; ++touched) {
        desk.site.hold(*desk.model,
                       desk.site.X_TA * desk.model->verifying().points()[touched - 1].p_AQ);
        QCOMPARE(desk.button("primary").isEnabled(), touched >= VerifyTask::kFewestPoints);
        QCOMPARE(desk.button("primary").isDefault(), touched == places);
        QVERIFY(!desk.button("next").isDefault());
    }
    QVERIFY(desk.click("primary"));
    QVERIFY(desk.button("next").isDefault());
}

void TestRegistrationWindow::writesTheRuleOfTheVerdictAndAsksForAName()
{
    RegistrationDesk desk;
    desk.site.fitAll(*desk.model);
    desk.model->enter(SiteStep::Verify);
    const auto& verdict = desk.find<QLabel>("verdict");
    QVERIFY(!verdict.text().contains(QStringLiteral("Rule:")));
    for (const CheckPoint& point : desk.model->verifying().points())
        desk.site.hold(*desk.model, desk.site.X_TA * point.p_AQ);
    QVERIFY(verdict.text().contains(QStringLiteral("Rule:")));
    auto& name = desk.find<QLineEdit>("judge");
    QVERIFY(name.isVisible());
    const auto isAskedFor = [&] {
        const auto labels = desk.window->findChildren<QLabel*>();
        return std::ranges::any_of(labels, [](const QLabel* label) {
            return label->isVisible() && label->text().contains(QStringLiteral("is asked for"));
        });
    };
    QVERIFY(isAskedFor());
    name.setFocus();
    QTest::keyClicks(&name, QStringLiteral("A. Frei"));
    QVERIFY(!isAskedFor());
    desk.find<QTableView>("checks").setFocus();
    QCOMPARE(desk.model->site().operatorName, std::string{"A. Frei"});
    QVERIFY(desk.click("primary"));
    QCOMPARE(desk.model->site().verification->operatorName, std::string{"A. Frei"});
    QVERIFY(!name.isVisible());
}

void TestRegistrationWindow::leadsBackToTheTouchesWhereItIsNotGood()
{
    RegistrationDesk desk;
    desk.site.fitAll(*desk.model);
    desk.model->enter(SiteStep::Verify);
    for (const CheckPoint& point : desk.model->verifying().points())
        desk.site.hold(*desk.model, desk.site.X_TA * point.p_AQ + Vec3{0.0, 0.0, 0.02});
    QPushButton& primary = desk.button("primary");
    QCOMPARE(primary.text(), QStringLiteral("&Record: not good enough"));
    QVERIFY(desk.click("primary"));
    QVERIFY(desk.model->verifying().isRecorded());
    QVERIFY(desk.model->instruction().startsWith(QStringLiteral("The registration is recorded")));
    QCOMPARE(primary.text(), QStringLiteral("Touch &again"));
    QVERIFY(primary.isDefault());
    desk.model->enter(SiteStep::Overview);
    QCOMPARE(primary.text(), QStringLiteral("&Go on: Touch"));
    desk.model->enter(SiteStep::Verify);
    QVERIFY(desk.click("primary"));
    QCOMPARE(desk.model->step(), SiteStep::Touch);
    QVERIFY(desk.model->instruction().contains(QStringLiteral("choose a landmark")));
}

void TestRegistrationWindow::choosesAPlaceToCheck()
{
    RegistrationDesk desk;
    desk.site.fitAll(*desk.model);
    desk.model->enter(SiteStep::Verify);
    auto& table = desk.find<QTableView>("checks");
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {},
                      table.visualRect(table.model()->index(2, 0)).center());
    QCOMPARE(desk.model->verifying().next(), std::optional<std::size_t>{2});
    QVERIFY(desk.tabTo("checks"));
    desk.press(Qt::Key_Up);
    desk.press(Qt::Key_Space);
    QCOMPARE(desk.model->verifying().next(), std::optional<std::size_t>{1});
    const QModelIndex place = table.model()->index(1, 0);
    QCOMPARE(place.data(Qt::ToolTipRole), place.data());
}

void TestRegistrationWindow::tellsHowFarTheStylusIsFromTheAnatomy()
{
    RegistrationDesk desk;
    desk.site.fitAll(*desk.model);
    desk.model->enter(SiteStep::Verify);
    const Vec3 xiphoid = desk.site.landmarks()[1].p_AQ;
    desk.site.tipAt(desk.site.X_TA * Vec3{xiphoid + Vec3{0.0, -0.003, 0.004}});
    desk.model->look();
    QTRY_VERIFY(desk.find<QLabel>("stylus").text().startsWith(
        QStringLiteral("The tip is 5.0 mm from Xiphoid process")));
    desk.site.m_now += std::chrono::seconds{1};
    QTRY_VERIFY(desk.find<QLabel>("stylus").text().contains(QStringLiteral("out of view")));
}

/// Its make, its length, and its airway touched, without a mouse.
void TestRegistrationWindow::comparesTheManikinByKeyboard()
{
    RegistrationDesk desk;
    desk.site.fitAll(*desk.model);
    desk.model->enter(SiteStep::Overview);
    QVERIFY(desk.tabTo("manikin"));
    desk.press(Qt::Key_Down);
    QCOMPARE(desk.model->manikin().chosen(), std::optional<std::size_t>{0});
    QVERIFY(desk.find<QWidget>("manikin").hasFocus());
    QVERIFY(desk.tabTo("teethToCarina"));
    for (const Qt::Key key : {Qt::Key_2, Qt::Key_4, Qt::Key_5})
        desk.press(key);
    desk.press(Qt::Key_Tab);
    const auto& said = desk.find<QLabel>("airways");
    QVERIFY2(said.text().contains(QStringLiteral("ends 13 mm above the manikin")),
             qPrintable(said.text()));
    const RegistrationReport report = reportOf(*desk.model, {});
    QVERIFY(report.manikin.startsWith(QStringLiteral("METI")));
    QVERIFY(report.notes.join(QLatin1Char('\n')).contains(QStringLiteral("ends 13 mm above")));
    QVERIFY(!desk.button("skipAirway").isVisible());
    QVERIFY(desk.tabTo("touchAirway"));
    desk.press(Qt::Key_Space);
    QVERIFY(desk.model->manikin().isTouching());
    QVERIFY(desk.button("skipAirway").isVisible());
    QVERIFY(desk.find<QLabel>("instruction").text().contains(QStringLiteral("upper incisors")));
    desk.site.hold(*desk.model,
                   desk.site.X_TA * RegistrationSite::patient().landmarks().p_A_incisors);
    QVERIFY(desk.find<QLabel>("instruction").text().contains(QStringLiteral("epiglottis")));
    QVERIFY(desk.tabTo("skipAirway"));
    desk.press(Qt::Key_Space);
    QVERIFY(desk.find<QLabel>("instruction").text().contains(QStringLiteral("vocal cords")));
    QVERIFY(desk.tabTo("touchAirway"));
    desk.press(Qt::Key_Space);
    QVERIFY(!desk.model->manikin().isTouching());
}

void TestRegistrationWindow::showsTheWholeHead()
{
    const RegistrationDesk desk;
    Vec3 top = Vec3::Zero();
    for (const PatientSurface& surface : desk.site.patient().surfaces())
        if (surface.description.role == PartRole::Skin)
            for (const Vec3f& p_A : surface.levels.back()->positions)
                top = p_A.z() > top.z() ? Vec3{p_A.cast<double>()} : top;
    QVERIFY(top.z() > desk.site.patient().landmarks().p_A_incisors.z());
    auto& scene = desk.find<SceneView>("scene");
    for (const ViewPreset side : {ViewPreset::Front, ViewPreset::Left, ViewPreset::Right}) {
        scene.showFrom(side);
        QVERIFY(seenPoint(top, {scene.camera().pose(), scene.camera().frustum()}));
    }
}

/// Those on which a person works with the stylus in hand, in the window as it opens.
void TestRegistrationWindow::fitsItsPagesWithoutScrollBars()
{
    RegistrationDesk desk;
    desk.site.touchAll(*desk.model);
    desk.window->resize(1280, 800);
    QTRY_COMPARE(desk.window->size(), QSize(1280, 800));
    const auto& area = desk.find<QScrollArea>("pageArea");
    for (const SiteStep step : {SiteStep::Tracker, SiteStep::Stylus, SiteStep::Landmarks,
                                SiteStep::Touch, SiteStep::Stylus}) {
        desk.model->enter(step);
        QCoreApplication::sendPostedEvents();
        QTRY_COMPARE(area.horizontalScrollBar()->maximum(), 0);
        QTRY_COMPARE(area.verticalScrollBar()->maximum(), 0);
        QVERIFY(area.widget()->width() == area.viewport()->width());
    }
}

CARINA_SCREEN_TEST(TestRegistrationWindow)

} // namespace carina::registration_window_test

#include "tst_registration_window.moc"
