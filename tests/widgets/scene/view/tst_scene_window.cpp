#include "tests/support/test_class.h"
#include "widgets/scene/view/graphics.h"
#include "widgets/scene/view/scene_window.h"

#include <QCursor>
#include <QEnterEvent>
#include <QSignalSpy>
#include <QWheelEvent>

#include <cmath>
#include <numbers>

namespace carina::scene_window_test
{

namespace
{

constexpr int kHeight = 400;        ///< pixels
constexpr double kTolerance = 1e-9; ///< metres

void drag(SceneWindow& window, Qt::MouseButton button, Qt::KeyboardModifiers keys, const QPoint& by)
{
    const QPoint start(200, 200);
    QTest::mousePress(&window, button, keys, start);
    const QPointF end = start + by;
    QMouseEvent move(QEvent::MouseMove, end, window.mapToGlobal(end), Qt::NoButton, button, keys);
    QCoreApplication::sendEvent(&window, &move);
    QTest::mouseRelease(&window, button, keys, end.toPoint());
}

bool isSame(const Vec3& a, const Vec3& b) { return (a - b).norm() < kTolerance; }

void turnWheel(SceneWindow& window, int notches)
{
    QWheelEvent wheel(QPointF(200, 200), QPointF(200, 200), {}, QPoint(0, 120 * notches),
                      Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&window, &wheel);
}

} // namespace

class TestSceneWindow : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void init();
    void cleanup() { m_window.reset(); }

    void turnsByDragging();
    void movesByDragging_data();
    void movesByDragging();
    void tellsAClickFromADrag_data();
    void tellsAClickFromADrag();
    void comesNearerByTheWheel();
    void obeysKeys_data();
    void obeysKeys();
    void comesBackToItsPreset_data();
    void comesBackToItsPreset();
    void steersAHeadByDragging_data();
    void steersAHeadByDragging();
    void steersAHeadByTheWheel();
    void steersAHeadByKeys_data();
    void steersAHeadByKeys();
    void takesAHeadBack();
    void leavesTheCameraWhileAHeadIsSteered();
    void letsTheKeyboardLeave();
    void knowsWhereTheMouseRests();

private:
    [[nodiscard]] Vec3 eye() { return m_window->camera().pose().p_A_eye; }
    [[nodiscard]] Vec3 target() { return m_window->camera().pose().p_A_target; }

    std::unique_ptr<SceneWindow> m_window;
};

void TestSceneWindow::init()
{
    m_window = std::make_unique<SceneWindow>();
    m_window->resize(600, kHeight);
    Box bounds;
    bounds.include(Vec3(-0.2, -0.2, -0.2));
    bounds.include(Vec3(0.2, 0.2, 0.2));
    m_window->camera().setBounds(bounds);
    m_window->showFrom(ViewPreset::Front);
}

void TestSceneWindow::turnsByDragging()
{
    // 3 rad for the picture's height: what is seen turns right, so the eye goes to the patient's
    // right, -x, from in front of the patient, -y.
    const double distance = eye().norm();
    const int quarter = static_cast<int>(std::numbers::pi / 6.0 * kHeight);
    drag(*m_window, Qt::LeftButton, {}, QPoint(quarter, 0));
    const double angle = 3.0 * quarter / kHeight;
    QVERIFY((eye() - distance * Vec3(-std::sin(angle), -std::cos(angle), 0.0)).norm() < kTolerance);
    QVERIFY(target().norm() < kTolerance);
}

void TestSceneWindow::movesByDragging_data()
{
    QTest::addColumn<Qt::MouseButton>("button");
    QTest::addColumn<Qt::KeyboardModifiers>("keys");
    QTest::newRow("right button") << Qt::RightButton << Qt::KeyboardModifiers();
    QTest::newRow("middle button") << Qt::MiddleButton << Qt::KeyboardModifiers();
    QTest::newRow("Shift") << Qt::LeftButton << Qt::KeyboardModifiers(Qt::ShiftModifier);
}

void TestSceneWindow::movesByDragging()
{
    QFETCH(Qt::MouseButton, button);
    QFETCH(Qt::KeyboardModifiers, keys);
    const Vec3 before = eye();
    drag(*m_window, button, keys, QPoint(40, 20));
    QVERIFY(target().x() < -0.001 && target().z() > 0.001);
    QVERIFY((eye() - before - target()).norm() < kTolerance);
}

void TestSceneWindow::tellsAClickFromADrag_data()
{
    QTest::addColumn<Qt::MouseButton>("button");
    QTest::addColumn<QPoint>("by");
    QTest::addColumn<bool>("isClick");
    QTest::newRow("left button at one place") << Qt::LeftButton << QPoint(0, 0) << true;
    QTest::newRow("an unsteady finger") << Qt::LeftButton << QPoint(1, 1) << true;
    QTest::newRow("a drag") << Qt::LeftButton << QPoint(40, 20) << false;
    QTest::newRow("right button") << Qt::RightButton << QPoint(0, 0) << false;
}

void TestSceneWindow::tellsAClickFromADrag()
{
    QFETCH(Qt::MouseButton, button);
    QFETCH(QPoint, by);
    QFETCH(bool, isClick);
    QSignalSpy clicks(m_window.get(), &SceneWindow::clicked);
    drag(*m_window, button, {}, by);
    QCOMPARE(clicks.count(), isClick ? 1 : 0);
    if (isClick)
        QCOMPARE(clicks[0][0].toPointF(), QPointF(QPoint(200, 200) + by));
}

void TestSceneWindow::comesNearerByTheWheel()
{
    const double before = eye().norm();
    turnWheel(*m_window, 2);
    QVERIFY(std::abs(eye().norm() * 1.12 * 1.12 - before) < kTolerance);
    turnWheel(*m_window, -2);
    QVERIFY(std::abs(eye().norm() - before) < kTolerance);
}

void TestSceneWindow::obeysKeys_data()
{
    QTest::addColumn<int>("key");
    QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
    QTest::addColumn<Vec3>("eyeTowards"); // a direction in A that the eye goes in, at least
    const Qt::KeyboardModifiers none;
    const Qt::KeyboardModifiers shift = Qt::ShiftModifier;
    QTest::newRow("left turns it left") << int(Qt::Key_Left) << none << Vec3(1, 0, 0);
    QTest::newRow("right turns it right") << int(Qt::Key_Right) << none << Vec3(-1, 0, 0);
    QTest::newRow("up turns it up") << int(Qt::Key_Up) << none << Vec3(0, 0, -1);
    QTest::newRow("down turns it down") << int(Qt::Key_Down) << none << Vec3(0, 0, 1);
    QTest::newRow("Shift left moves it left") << int(Qt::Key_Left) << shift << Vec3(1, 0, 0);
    QTest::newRow("Shift up moves it up") << int(Qt::Key_Up) << shift << Vec3(0, 0, -1);
    QTest::newRow("plus comes nearer") << int(Qt::Key_Plus) << none << Vec3(0, 1, 0);
    QTest::newRow("equals, plus unshifted") << int(Qt::Key_Equal) << none << Vec3(0, 1, 0);
    QTest::newRow("minus goes away") << int(Qt::Key_Minus) << none << Vec3(0, -1, 0);
}

void TestSceneWindow::obeysKeys()
{
    QFETCH(int, key);
    QFETCH(Qt::KeyboardModifiers, modifiers);
    QFETCH(Vec3, eyeTowards);
    const Vec3 before = eye();
    QTest::keyClick(m_window.get(), static_cast<Qt::Key>(key), modifiers);
    QVERIFY((eye() - before).dot(eyeTowards) > 0.01);
    QCOMPARE(target().norm() > kTolerance, modifiers.testFlag(Qt::ShiftModifier));
}

void TestSceneWindow::comesBackToItsPreset_data()
{
    QTest::addColumn<bool>("byMouse");
    QTest::newRow("double click") << true;
    QTest::newRow("Home") << false;
}

void TestSceneWindow::comesBackToItsPreset()
{
    QFETCH(bool, byMouse);
    m_window->showFrom(ViewPreset::Left);
    const Vec3 before = eye();
    drag(*m_window, Qt::LeftButton, {}, QPoint(50, 30));
    QVERIFY((eye() - before).norm() > 0.01);
    if (byMouse)
        QTest::mouseDClick(m_window.get(), Qt::LeftButton, {}, QPoint(200, 200));
    else
        QTest::keyClick(m_window.get(), Qt::Key_Home);
    QVERIFY((eye() - before).norm() < kTolerance);
}

void TestSceneWindow::steersAHeadByDragging_data()
{
    QTest::addColumn<Qt::MouseButton>("button");
    QTest::addColumn<Qt::KeyboardModifiers>("keys");
    QTest::addColumn<bool>("turns");
    QTest::newRow("left button") << Qt::LeftButton << Qt::KeyboardModifiers() << true;
    QTest::newRow("Ctrl") << Qt::LeftButton << Qt::KeyboardModifiers(Qt::ControlModifier) << false;
    QTest::newRow("right button") << Qt::RightButton << Qt::KeyboardModifiers() << false;
}

void TestSceneWindow::steersAHeadByDragging()
{
    QFETCH(Qt::MouseButton, button);
    QFETCH(Qt::KeyboardModifiers, keys);
    QFETCH(bool, turns);
    QSignalSpy turned(m_window.get(), &SceneWindow::headTurned);
    QSignalSpy neared(m_window.get(), &SceneWindow::headNeared);
    m_window->steerHead(true);
    drag(*m_window, button, keys, QPoint(80, -40));
    QCOMPARE(turned.count(), turns ? 1 : 0);
    QCOMPARE(neared.count(), turns ? 0 : 1);
    if (turns) {
        QCOMPARE(turned[0][0].toDouble(), 80.0 / kHeight);
        QCOMPARE(turned[0][1].toDouble(), -40.0 / kHeight);
    } else {
        QCOMPARE(neared[0][0].toDouble(), std::exp(2.0 * 40.0 / kHeight));
    }
}

void TestSceneWindow::steersAHeadByTheWheel()
{
    QSignalSpy neared(m_window.get(), &SceneWindow::headNeared);
    m_window->steerHead(true);
    turnWheel(*m_window, 2);
    QCOMPARE(neared.count(), 1);
    QCOMPARE(neared[0][0].toDouble(), 1.12 * 1.12);
}

/// To look to one side moves what is seen to the other.
void TestSceneWindow::steersAHeadByKeys_data()
{
    QTest::addColumn<int>("key");
    QTest::addColumn<QPointF>("seenMoves"); // null: the head comes nearer or goes away
    QTest::addColumn<double>("factor");
    QTest::newRow("left") << int(Qt::Key_Left) << QPointF(0.05, 0.0) << 0.0;
    QTest::newRow("right") << int(Qt::Key_Right) << QPointF(-0.05, 0.0) << 0.0;
    QTest::newRow("up") << int(Qt::Key_Up) << QPointF(0.0, 0.05) << 0.0;
    QTest::newRow("down") << int(Qt::Key_Down) << QPointF(0.0, -0.05) << 0.0;
    QTest::newRow("plus") << int(Qt::Key_Plus) << QPointF() << 1.15;
    QTest::newRow("equals, plus unshifted") << int(Qt::Key_Equal) << QPointF() << 1.15;
    QTest::newRow("minus") << int(Qt::Key_Minus) << QPointF() << 1.0 / 1.15;
}

void TestSceneWindow::steersAHeadByKeys()
{
    QFETCH(int, key);
    QFETCH(QPointF, seenMoves);
    QFETCH(double, factor);
    QSignalSpy turned(m_window.get(), &SceneWindow::headTurned);
    QSignalSpy neared(m_window.get(), &SceneWindow::headNeared);
    m_window->steerHead(true);
    QTest::keyClick(m_window.get(), static_cast<Qt::Key>(key));
    QCOMPARE(turned.count(), seenMoves.isNull() ? 0 : 1);
    QCOMPARE(neared.count(), seenMoves.isNull() ? 1 : 0);
    if (seenMoves.isNull())
        QCOMPARE(neared[0][0].toDouble(), factor);
    else
        QCOMPARE(QPointF(turned[0][0].toDouble(), turned[0][1].toDouble()), seenMoves);
}

void TestSceneWindow::takesAHeadBack()
{
    QSignalSpy returned(m_window.get(), &SceneWindow::headReturned);
    m_window->steerHead(true);
    QTest::keyClick(m_window.get(), Qt::Key_Home);
    QCOMPARE(returned.count(), 1);
    QTest::mouseDClick(m_window.get(), Qt::LeftButton, {}, QPoint(200, 200));
    QCOMPARE(returned.count(), 2);
}

void TestSceneWindow::leavesTheCameraWhileAHeadIsSteered()
{
    const Vec3 before = eye();
    QSignalSpy turned(m_window.get(), &SceneWindow::headTurned);
    const auto use = [this] {
        drag(*m_window, Qt::LeftButton, {}, QPoint(40, 20));
        drag(*m_window, Qt::LeftButton, Qt::ShiftModifier, QPoint(40, 20));
        turnWheel(*m_window, 1);
        QTest::keyClick(m_window.get(), Qt::Key_Left);
        QTest::keyClick(m_window.get(), Qt::Key_Plus);
    };
    m_window->steerHead(true);
    use();
    QVERIFY(isSame(eye(), before) && isSame(target(), Vec3::Zero()));
    QCOMPARE(turned.count(), 3);
    m_window->steerHead(false);
    use();
    QVERIFY(!isSame(eye(), before));
    QCOMPARE(turned.count(), 3);
}

void TestSceneWindow::letsTheKeyboardLeave()
{
    QSignalSpy tabbed(m_window.get(), &SceneWindow::tabbed);
    QTest::keyClick(m_window.get(), Qt::Key_Tab);
    QTest::keyClick(m_window.get(), Qt::Key_Backtab, Qt::ShiftModifier);
    QCOMPARE(tabbed.size(), 2);
    QCOMPARE(tabbed[0][0].toBool(), true);
    QCOMPARE(tabbed[1][0].toBool(), false);
}

/// A name that is written over the picture is a window: it moves under the mouse and away again,
/// and the mouse does not move.
void TestSceneWindow::knowsWhereTheMouseRests()
{
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    const QPoint place{100, 80};
    QEvent leave{QEvent::Leave};
    QCursor::setPos(m_window->mapToGlobal(place));
    QCoreApplication::sendEvent(m_window.get(), &leave);
    QCOMPARE(m_window->mousePlace(), std::optional<QPointF>{place});
    QCursor::setPos(m_window->mapToGlobal(QPoint{700, kHeight + 50}));
    QCoreApplication::sendEvent(m_window.get(), &leave);
    QVERIFY(!m_window->mousePlace());
    QEnterEvent enter{QPointF{place}, QPointF{place}, QPointF{m_window->mapToGlobal(place)}};
    QCoreApplication::sendEvent(m_window.get(), &enter);
    QCOMPARE(m_window->mousePlace(), std::optional<QPointF>{place});
}

CARINA_SCREEN_TEST(TestSceneWindow)

} // namespace carina::scene_window_test

#include "tst_scene_window.moc"
