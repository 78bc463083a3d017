#include "tests/support/test_class.h"
#include "tests/widgets/scene/scene_fixture.h"
#include "widgets/scene/view/graphics.h"

#include <QLabel>

namespace carina::side_labels_test
{

using namespace carina::test;

namespace
{

constexpr double kSmall = 1e-9;
const QRectF kRim{10.0, 20.0, 400.0, 300.0};
const Vec3 kPatientsLeft = Vec3::UnitX();

CameraPose looking(const Vec3& forward_A, const Vec3& up_A)
{
    CameraPose pose;
    pose.p_A_target = forward_A;
    pose.up_A = up_A;
    return pose;
}

QLabel* wordOn(const SceneView& view, const char* word)
{
    for (QLabel* label : view.findChildren<QLabel*>())
        if (label->text() == QLatin1String{word})
            return label;
    return nullptr;
}

std::unique_ptr<SceneView> namedView(SceneView::FrameSource source, const char* body = "")
{
    auto view =
        shownView({spherePart(1, MaterialGroup::Bone, Vec3::Zero(), 0.05)}, std::move(source));
    view->nameSides(body);
    return view;
}

} // namespace

class TestSideLabels : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void pointsToTheRim_data();
    void pointsToTheRim();
    void pointsNowhereAlongTheLineOfSight();
    void followsTheView();
    void followsThePatientAsItIsTurned_data();
    void followsThePatientAsItIsTurned();
    void namesNoSidesOfAPatientThatIsNotDrawn();
    void namesNoSidesToAHeadset();
    void standsBelowWhatCoversTheUpperEdge();
};

/// The patient's left is +x of A, behind is +y, the head +z.
void TestSideLabels::pointsToTheRim_data()
{
    QTest::addColumn<QVector3D>("forward");
    QTest::addColumn<QVector3D>("up");
    QTest::addColumn<QPointF>("left");
    const QVector3D head{0, 0, 1};
    QTest::newRow("from the front") << QVector3D{0, 1, 0} << head << QPointF{410.0, 170.0};
    QTest::newRow("from behind") << QVector3D{0, -1, 0} << head << QPointF{10.0, 170.0};
    QTest::newRow("lying on the right side")
        << QVector3D{0, 1, 0} << QVector3D{1, 0, 0} << QPointF{210.0, 20.0};
    QTest::newRow("halfway to that")
        << QVector3D{0, 1, 0} << QVector3D{1, 0, 1} << QPointF{360.0, 20.0};
}

void TestSideLabels::pointsToTheRim()
{
    QFETCH(QVector3D, forward);
    QFETCH(QVector3D, up);
    QFETCH(QPointF, left);
    const CameraPose pose =
        looking({forward.x(), forward.y(), forward.z()}, {up.x(), up.y(), up.z()});
    const auto found = pointedAt(kPatientsLeft, pose, kRim);
    QVERIFY(found);
    QVERIFY(std::hypot(found->x() - left.x(), found->y() - left.y()) < kSmall);
    const QPointF across = *found + *pointedAt(-kPatientsLeft, pose, kRim) - 2.0 * kRim.center();
    QVERIFY(std::hypot(across.x(), across.y()) < kSmall);
}

void TestSideLabels::pointsNowhereAlongTheLineOfSight()
{
    const auto turned = [](double degrees) {
        const double angle = degrees * std::numbers::pi / 180.0;
        return looking({std::cos(angle), std::sin(angle), 0.0}, Vec3::UnitZ());
    };
    QVERIFY(!pointedAt(kPatientsLeft, turned(0.0), kRim));
    QVERIFY(!pointedAt(kPatientsLeft, turned(29.0), kRim));
    QVERIFY(pointedAt(kPatientsLeft, turned(31.0), kRim));
}

void TestSideLabels::followsTheView()
{
    const auto view = namedView([](int, LocalTime) { return SceneFrame{}; });
    view->showFrom(ViewPreset::Front);
    QVERIFY(draws(*view, 3));
    const QLabel* right = wordOn(*view, "Right");
    const QLabel* left = wordOn(*view, "Left");
    QVERIFY(right && left && right->isVisible() && left->isVisible());
    QVERIFY(right->geometry().right() < view->width() / 4);
    QVERIFY(left->x() > view->width() * 3 / 4);
    for (const QLabel* word : {right, left})
        QVERIFY(view->rect().contains(word->geometry()));
    view->showFrom(ViewPreset::Back);
    QVERIFY(draws(*view, 2));
    QVERIFY(right->x() > left->x());
    view->showFrom(ViewPreset::Left);
    QVERIFY(draws(*view, 2));
    QVERIFY(!right->isVisible() && !left->isVisible());
}

/// Turned about the long axis, seen from the front: the patient's left lies at cos(angle) to the
/// right, and within 30 degrees of the line of sight there is neither side.
void TestSideLabels::followsThePatientAsItIsTurned_data()
{
    QTest::addColumn<double>("turnedDeg");
    QTest::addColumn<int>("leftIs"); // at the right edge of the picture 1, at the left one -1
    QTest::newRow("as it lay") << 0.0 << 1;
    QTest::newRow("an eighth of a turn") << 45.0 << 1;
    QTest::newRow("just before both vanish") << 59.0 << 1;
    QTest::newRow("just behind that") << 61.0 << 0;
    QTest::newRow("a quarter of a turn") << 90.0 << 0;
    QTest::newRow("just after it") << 121.0 << -1;
    QTest::newRow("half a turn") << 180.0 << -1;
    QTest::newRow("three quarters") << 270.0 << 0;
}

void TestSideLabels::followsThePatientAsItIsTurned()
{
    QFETCH(double, turnedDeg);
    QFETCH(int, leftIs);
    SceneFrame frame;
    const Quat turn{Eigen::AngleAxisd{turnedDeg * std::numbers::pi / 180.0, Vec3::UnitZ()}};
    frame.bodies["patient"] = PlacedBody{RigidTransform{turn, {0.0, 0.0, 0.02}}, 1.3};
    const auto view = namedView([&](int, LocalTime) { return frame; }, "patient");
    view->showFrom(ViewPreset::Front);
    QVERIFY(draws(*view, 3));
    const QLabel* right = wordOn(*view, "Right");
    const QLabel* left = wordOn(*view, "Left");
    QCOMPARE(left->isVisible(), leftIs != 0);
    QCOMPARE(right->isVisible(), leftIs != 0);
    if (leftIs != 0)
        QCOMPARE(left->x() > right->x(), leftIs > 0);
}

void TestSideLabels::namesNoSidesOfAPatientThatIsNotDrawn()
{
    SceneFrame frame;
    const auto view = namedView([&](int, LocalTime) { return frame; }, "patient");
    QVERIFY(draws(*view, 3));
    QVERIFY(!wordOn(*view, "Right")->isVisible() && !wordOn(*view, "Left")->isVisible());
    frame.bodies["patient"] = RigidTransform{};
    QVERIFY(draws(*view, 2));
    QVERIFY(wordOn(*view, "Right")->isVisible() && wordOn(*view, "Left")->isVisible());
}

void TestSideLabels::namesNoSidesToAHeadset()
{
    SceneFrame frame;
    const auto view = namedView([&](int, LocalTime) { return frame; });
    QVERIFY(draws(*view, 2));
    QVERIFY(wordOn(*view, "Right")->isVisible());
    frame = frontFrame();
    QVERIFY(draws(*view, 2));
    QVERIFY(!wordOn(*view, "Right")->isVisible() && !wordOn(*view, "Left")->isVisible());
}

/// As the left of a patient who lies on the right side, seen from the front.
void TestSideLabels::standsBelowWhatCoversTheUpperEdge()
{
    constexpr int kCovered = 60; // pixels
    const auto view = namedView([](int, LocalTime) { return SceneFrame{}; });
    view->setLie(Lie::OnRightSide);
    view->showFrom(ViewPreset::Front);
    QVERIFY(draws(*view, 3));
    const QLabel* left = wordOn(*view, "Left");
    QVERIFY(left->isVisible());
    QVERIFY(left->y() < kCovered);
    view->keepNamesBelow(kCovered);
    QVERIFY(draws(*view, 2));
    QVERIFY(left->isVisible());
    QVERIFY(left->y() >= kCovered);
    QVERIFY(left->y() < view->height() / 4);
    view->keepNamesBelow(0);
    QVERIFY(draws(*view, 2));
    QVERIFY(left->y() < kCovered);
}

CARINA_SCREEN_TEST(TestSideLabels)

} // namespace carina::side_labels_test

#include "tst_side_labels.moc"
