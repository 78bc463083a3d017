#include "tests/support/test_class.h"
#include "tests/support/throat_motion.h"
#include "tests/widgets/scene/scene_fixture.h"
#include "widgets/scene/view/graphics.h"

namespace carina::jaw_in_view_test
{

using namespace carina::test;

namespace
{

const ThroatField kThroat{{0.0, 0.03, -0.2}, {0.0, 0.0, -0.06}, {0.0, -0.07, 0.0}};
const Vec3 p_A_tongue{0.0, -0.05, -0.01};
constexpr double kAside = 0.3;      ///< metres the jaw goes
constexpr double kRadius = 0.005;   ///< of what follows it
constexpr int kSwitchFrames = 3;    ///< within which another shader program has taken over
constexpr double kTolerance = 0.02; ///< of the picture's width

/// In widths of the picture from its middle.
double column(double x)
{
    const double focal = 0.5 * kHeight / std::tan(0.5 * OrbitCamera::kVerticalFieldOfView);
    return 0.5 + focal * x / (kDistance + p_A_tongue.y()) / kWidth;
}

} // namespace

class TestJawInView : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void init();
    void followsAJawThatBeginsToMove_data();
    void followsAJawThatBeginsToMove();
};

void TestJawInView::init()
{
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
}

void TestJawInView::followsAJawThatBeginsToMove_data()
{
    QTest::addColumn<MaterialGroup>("group");
    QTest::newRow("opaque") << MaterialGroup::SoftTissue;
    QTest::newRow("translucent") << MaterialGroup::Airway;
}

/// What follows the jaw is drawn by a program that is compiled only now: not a frame may be without
/// the part, and soon it is where the jaw takes it.
void TestJawInView::followsAJawThatBeginsToMove()
{
    QFETCH(MaterialGroup, group);
    ScenePart tongue = spherePart(1, group, p_A_tongue, kRadius);
    tongue.region = ChestRegion::Throat;
    SceneFrame shown = frontFrame();
    shown.throat.field = kThroat;
    std::vector<double> seen;
    const auto view = shownView({tongue}, [&](int, LocalTime) { return shown; });
    QVERIFY(draws(*view, 5));
    view->onFrameDrawn([&](const DrawnFrame&) {
        const auto centre = redCentre(onScreen(*view));
        seen.push_back(centre ? centre->x() : -1.0);
    });
    QVERIFY(draws(*view, 2));
    shown.throat.X_AJ = RigidTransform::translation({kAside, 0.0, 0.0});
    QVERIFY(draws(*view, 10));

    const double moved = kAside * test::throatShare(kThroat, p_A_tongue, ThroatTissue::Airway);
    QVERIFY(moved > 0.1);
    QVERIFY(std::abs(seen.front() - column(0.0)) < kTolerance);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const bool isStill = std::abs(seen[i] - column(0.0)) < kTolerance;
        const bool isMoved = std::abs(seen[i] - column(moved)) < kTolerance;
        QVERIFY2(isMoved || (isStill && i < 2 + kSwitchFrames),
                 qPrintable(QString::number(seen[i])));
    }
}

CARINA_SCREEN_TEST(TestJawInView)

} // namespace carina::jaw_in_view_test

#include "tst_jaw_in_view.moc"
