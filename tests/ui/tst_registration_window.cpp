#include "tests/models/registration_site.h"
#include "ui/registration_window.h"
#include "widgets/scene/graphics.h"
#include "widgets/scene/scene_view.h"

#include <QApplication>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableView>
#include <QTest>

namespace carina
{

class TestRegistrationWindow : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void leadsThroughTheSteps();
    void obeysTheReturnKey();
    void saysWhyAStepIsClosed();
    void showsProgressOnlyWhileThereIsSome();
    void choosesALandmarkByMouseAndKeyboard();
    void movesALandmarkToWhereTheModelIsClicked();
    void tellsHowFarTheStylusIsFromTheAnatomy();
    void namesEveryControlForAScreenReader();
};

namespace
{

struct Desk {
    RegistrationSite site;
    std::unique_ptr<RegistrationModel> model = site.model();
    std::unique_ptr<RegistrationWindow> window = std::make_unique<RegistrationWindow>(*model);

    Desk()
    {
        window->resize(1280, 800);
        window->show();
    }
    template <class Widget> [[nodiscard]] Widget& find(const char* name) const
    {
        return *window->findChild<Widget*>(QLatin1String{name});
    }
    [[nodiscard]] QPushButton& button(const char* name) const { return find<QPushButton>(name); }

    void touchAll() { site.touchAll(*model); }
};

} // namespace

void TestRegistrationWindow::leadsThroughTheSteps()
{
    Desk desk;
    QVERIFY(!desk.button("next").isEnabled());
    QCOMPARE(desk.button("primary").text(), QStringLiteral("&Use this tracker"));
    desk.button("primary").click();
    QCOMPARE(desk.model->step(), SiteStep::Stylus);
    QCOMPARE(desk.button("primary").text(), QStringLiteral("&Start swinging"));
    desk.button("primary").click();
    QVERIFY(desk.model->isSwinging());
    QCOMPARE(desk.button("primary").text(), QStringLiteral("&Cancel"));
    desk.button("primary").click();
    QVERIFY(!desk.model->isSwinging());
    desk.site.swing(*desk.model);
    desk.button("next").click();
    QCOMPARE(desk.model->step(), SiteStep::Landmarks);
    QVERIFY(desk.button("builtin").isVisible());
    desk.button("primary").click();
    QCOMPARE(desk.model->step(), SiteStep::Touch);
    QVERIFY(!desk.button("builtin").isVisible());
    QVERIFY(!desk.button("primary").isVisible()); // touching is done by hand
    QCOMPARE(desk.button("step4").text(), QStringLiteral("●  &4  Touch 0/4 – now"));
    for (const Landmark& landmark : desk.site.landmarks().landmarks)
        desk.site.hold(*desk.model, desk.site.X_TA * landmark.p_AQ);
    QCOMPARE(desk.button("step4").text(), QStringLiteral("●  &4  Touch 4/4 – now"));
    desk.button("next").click();
    desk.button("primary").click();
    QVERIFY(desk.model->isDone(SiteStep::Fit));
    desk.button("next").click();
    QCOMPARE(desk.model->step(), SiteStep::Verify);
    QVERIFY(!desk.button("next").isVisible());
    QCOMPARE(desk.button("primary").text(), QStringLiteral("&Finish"));
    desk.button("primary").click();
    QVERIFY(!desk.window->isVisible());
}

void TestRegistrationWindow::obeysTheReturnKey()
{
    Desk desk;
    QApplication::setActiveWindow(desk.window.get()); // the display has no window manager
    QTest::keyClick(desk.window.get(), Qt::Key_Return);
    QCOMPARE(desk.model->step(), SiteStep::Stylus);
    desk.site.swing(*desk.model);
    QVERIFY(desk.button("next").isDefault()); // what is done is not done again
    QTest::keyClick(desk.window.get(), Qt::Key_Return);
    QCOMPARE(desk.model->step(), SiteStep::Landmarks);
}

void TestRegistrationWindow::saysWhyAStepIsClosed()
{
    const Desk desk;
    for (const char* step : {"step2", "step3", "step4", "step5", "step6"}) {
        QVERIFY(!desk.button(step).isEnabled());
        QVERIFY(!desk.button(step).toolTip().isEmpty());
    }
    desk.button("primary").click();
    QVERIFY(desk.button("step2").isDefault());
    QVERIFY(desk.button("step3").isEnabled());
    desk.button("step3").click();
    QCOMPARE(desk.model->step(), SiteStep::Landmarks);
}

void TestRegistrationWindow::showsProgressOnlyWhileThereIsSome()
{
    Desk desk;
    desk.button("primary").click();
    QVERIFY(!desk.find<QProgressBar>("progress").isVisible());
    desk.model->startSwing();
    for (int i = 0; i < 120; ++i) {
        desk.site.tipAt({0.1, 0.0, -1.0});
        desk.model->look();
    }
    QTRY_COMPARE(desk.find<QProgressBar>("progress").value(), 25); // of 480 poses
    QVERIFY(desk.find<QProgressBar>("progress").isVisible());
}

void TestRegistrationWindow::choosesALandmarkByMouseAndKeyboard()
{
    Desk desk;
    auto& table = desk.find<QTableView>("landmarks");
    const auto click = [&](int row) {
        const QPoint place = table.visualRect(table.model()->index(row, 0)).center();
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, place);
    };
    click(2);
    QVERIFY(!desk.model->nextLandmark()); // nothing to choose one for yet
    desk.button("primary").click();
    desk.model->enter(SiteStep::Landmarks);
    click(2);
    QCOMPARE(desk.model->nextLandmark(), std::optional<std::size_t>{2});
    QApplication::setActiveWindow(desk.window.get()); // the display has no window manager
    table.setFocus();
    QTest::keyClick(&table, Qt::Key_Up);
    QCOMPARE(desk.model->nextLandmark(), std::optional<std::size_t>{2}); // only looked at
    QTest::keyClick(&table, Qt::Key_Space);
    QCOMPARE(desk.model->nextLandmark(), std::optional<std::size_t>{1});
}

void TestRegistrationWindow::movesALandmarkToWhereTheModelIsClicked()
{
    Desk desk;
    desk.button("primary").click();
    desk.model->enter(SiteStep::Landmarks);
    desk.model->choose(0);
    const Vec3 before = desk.model->landmarks()[0].p_AQ;
    // From in front of the right lung straight back.
    Q_EMIT desk.find<SceneView>("scene").clicked({-0.06, -1.0, -0.05}, Vec3::UnitY());
    const Vec3 after = desk.model->landmarks()[0].p_AQ;
    QVERIFY((after - before).norm() > 0.01);
    QVERIFY(std::abs(after.x() + 0.06) < 1e-9 && std::abs(after.z() + 0.05) < 1e-9);
    desk.button("undo").click();
    QVERIFY((desk.model->landmarks()[0].p_AQ - before).norm() < 1e-9);
}

void TestRegistrationWindow::tellsHowFarTheStylusIsFromTheAnatomy()
{
    Desk desk;
    desk.touchAll();
    desk.model->fit();
    QVERIFY(desk.find<QWidget>("place").isHidden());
    desk.model->enter(SiteStep::Verify);
    QVERIFY(desk.find<QWidget>("place").isVisible());
    const Vec3 xiphoid = desk.site.landmarks().landmarks[1].p_AQ;
    desk.site.tipAt(desk.site.X_TA * Vec3{xiphoid + Vec3{0.0, -0.003, 0.004}});
    desk.model->look();
    QTRY_VERIFY(desk.find<QLabel>("stylus").text().startsWith(
        QStringLiteral("5.0 mm from Xiphoid process")));
}

void TestRegistrationWindow::namesEveryControlForAScreenReader()
{
    const Desk desk;
    for (const QPushButton* button : desk.window->findChildren<QPushButton*>())
        QVERIFY2(!button->text().isEmpty(), qPrintable(button->objectName()));
    for (const char* name : {"scene", "landmarks", "progress", "steps", "instruction", "tools"})
        QVERIFY2(!desk.find<QWidget>(name).accessibleName().isEmpty(), name);
}

} // namespace carina

QTEST_MAIN(carina::TestRegistrationWindow)
#include "tst_registration_window.moc"
