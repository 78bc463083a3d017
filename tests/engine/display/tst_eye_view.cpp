#include "engine/display/eye_view.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <limits>

namespace carina::eye_view_test
{

namespace
{

constexpr double kTangentTolerance = 1e-15;
constexpr double kLengthTolerance_m = 1e-12;

/// A screen of 0.8 m by 0.6 m, 2 m ahead of eyes that lie at unequal heights and depths.
DisplayGeometry unevenDisplay()
{
    return {.p_HDl = {-0.03, 0.01, 0.0},
            .p_HDr = {0.05, -0.01, 0.5},
            .p_HQ_screenCentre = {0.1, 0.2, -2.0},
            .screenWidth = 0.8,
            .screenHeight = 0.6};
}

bool isNear(const Frustum& f, const Frustum& truth)
{
    return std::abs(f.left - truth.left) < kTangentTolerance
           && std::abs(f.right - truth.right) < kTangentTolerance
           && std::abs(f.bottom - truth.bottom) < kTangentTolerance
           && std::abs(f.top - truth.top) < kTangentTolerance;
}

} // namespace

class TestEyeView : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void spansTheScreenFromEachEye_data();
    void spansTheScreenFromEachEye();
    void turnsNeitherEye();
    void seesMoreOfItsOwnSide();
    void knowsAUsualHeadset();
    void refusesWhatCannotBeSeen_data();
    void refusesWhatCannotBeSeen();
    void takesAnEyeAMillimetreBeforeTheScreen();
};

void TestEyeView::spansTheScreenFromEachEye_data()
{
    QTest::addColumn<Eye>("eye");
    QTest::addColumn<Vec3>("p_HD");
    QTest::addColumn<Frustum>("frustum");
    // The screen's edges in H: x from -0.3 to 0.5, y from -0.1 to 0.5, z = -2.
    QTest::newRow("left") << Eye::Left << Vec3{-0.03, 0.01, 0.0}
                          << Frustum{-0.27 / 2.0, 0.53 / 2.0, -0.11 / 2.0, 0.49 / 2.0};
    QTest::newRow("right") << Eye::Right << Vec3{0.05, -0.01, 0.5}
                           << Frustum{-0.35 / 2.5, 0.45 / 2.5, -0.09 / 2.5, 0.51 / 2.5};
    QTest::newRow("middle") << Eye::Middle << Vec3{0.01, 0.0, 0.25}
                            << Frustum{-0.31 / 2.25, 0.49 / 2.25, -0.1 / 2.25, 0.5 / 2.25};
}

void TestEyeView::spansTheScreenFromEachEye()
{
    QFETCH(Eye, eye);
    QFETCH(Vec3, p_HD);
    QFETCH(Frustum, frustum);
    const Result<EyeView> view = eyeView(unevenDisplay(), eye);
    QVERIFY(view.has_value());
    QVERIFY((view->X_HD.translation() - p_HD).norm() < kLengthTolerance_m);
    QVERIFY(isNear(view->frustum, frustum));
}

void TestEyeView::turnsNeitherEye()
{
    for (const Eye eye : {Eye::Left, Eye::Right, Eye::Middle})
        QVERIFY(eyeView(unevenDisplay(), eye)->X_HD.rotation().coeffs()
                == Quat::Identity().coeffs());
}

// The same screen lies further to the right for the left eye.
void TestEyeView::seesMoreOfItsOwnSide()
{
    const Frustum left = eyeView(defaultDisplay(), Eye::Left)->frustum;
    const Frustum right = eyeView(defaultDisplay(), Eye::Right)->frustum;
    QVERIFY(std::abs(left.left - right.left - 0.063) < kTangentTolerance);
    QVERIFY(std::abs(left.right - right.right - 0.063) < kTangentTolerance);
}

void TestEyeView::knowsAUsualHeadset()
{
    const DisplayGeometry display = defaultDisplay();
    QVERIFY(((display.p_HDr - display.p_HDl) - Vec3(0.063, 0.0, 0.0)).norm() < kLengthTolerance_m);
    QVERIFY((display.p_HDl + display.p_HDr).norm() < kLengthTolerance_m);
    const Frustum middle = eyeView(display, Eye::Middle)->frustum;
    QVERIFY(isNear({-middle.right, -middle.left, -middle.top, -middle.bottom}, middle));
    // 52 degrees along the diagonal: tan 26 deg = 0.4877325885658614, four fifths and three fifths.
    QVERIFY(isNear(middle, {-0.3901860708526891, 0.3901860708526891, -0.2926395531395168,
                            0.2926395531395168}));
}

void TestEyeView::refusesWhatCannotBeSeen_data()
{
    QTest::addColumn<DisplayGeometry>("display");
    QTest::addColumn<Errc>("code");
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const auto row = [](const char* name, Errc code, auto spoil) {
        DisplayGeometry display = unevenDisplay();
        spoil(display);
        QTest::newRow(name) << display << code;
    };
    row("a left eye that is no number", Errc::NotFinite, [](auto& d) { d.p_HDl.x() = kNaN; });
    row("a right eye that is no number", Errc::NotFinite, [](auto& d) { d.p_HDr.z() = kInfinity; });
    row("a screen nowhere", Errc::NotFinite, [](auto& d) { d.p_HQ_screenCentre.y() = kNaN; });
    row("a width that is no number", Errc::NotFinite, [](auto& d) { d.screenWidth = kNaN; });
    row("an endless height", Errc::NotFinite, [](auto& d) { d.screenHeight = kInfinity; });
    row("no width", Errc::OutOfRange, [](auto& d) { d.screenWidth = 0.0; });
    row("a negative width", Errc::OutOfRange, [](auto& d) { d.screenWidth = -0.8; });
    row("no height", Errc::OutOfRange, [](auto& d) { d.screenHeight = 0.0; });
    row("a negative height", Errc::OutOfRange, [](auto& d) { d.screenHeight = -0.6; });
    row("an eye on the screen", Errc::OutOfRange, [](auto& d) { d.p_HDl.z() = -2.0; });
    row("an eye just before the screen", Errc::OutOfRange,
        [](auto& d) { d.p_HDl.z() = -2.0 + 0.9e-3; });
    row("an eye behind the screen", Errc::OutOfRange, [](auto& d) { d.p_HDl.z() = -3.0; });
    row("a screen endlessly far", Errc::OutOfRange, [](auto& d) {
        d.p_HDl.z() = 1e308;
        d.p_HQ_screenCentre.z() = -1e308;
    });
    row("a width lost in the distance", Errc::OutOfRange, [](auto& d) { d.screenWidth = 1e-20; });
    row("a height lost in the distance", Errc::OutOfRange, [](auto& d) { d.screenHeight = 1e-20; });
}

void TestEyeView::refusesWhatCannotBeSeen()
{
    QFETCH(DisplayGeometry, display);
    QFETCH(Errc, code);
    const Result<EyeView> view = eyeView(display, Eye::Left);
    QVERIFY(!view.has_value());
    QCOMPARE(view.error().code, code);
}

void TestEyeView::takesAnEyeAMillimetreBeforeTheScreen()
{
    DisplayGeometry display = unevenDisplay();
    display.p_HDl.z() = -2.0 + 1.1e-3;
    QVERIFY(eyeView(display, Eye::Left).has_value());
    display.p_HDr.z() = -3.0;
    QVERIFY(eyeView(display, Eye::Left).has_value()); // the other eye is not asked for
    QVERIFY(!eyeView(display, Eye::Right).has_value());
}

CARINA_TEST(TestEyeView)

} // namespace carina::eye_view_test

#include "tst_eye_view.moc"
