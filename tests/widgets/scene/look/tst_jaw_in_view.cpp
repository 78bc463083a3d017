#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"
#include "tests/support/throat_motion.h"
#include "tests/widgets/scene/scene_fixture.h"
#include "widgets/scene/labels/visible_places.h"
#include "widgets/scene/view/graphics.h"

#include <numbers>

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

/// In heights of the picture from its top.
double row(const Vec3& p_A)
{
    const double perHeight = 2.0 * std::tan(0.5 * OrbitCamera::kVerticalFieldOfView);
    return 0.5 - p_A.z() / (kDistance + p_A.y()) / perHeight;
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
    void followsAHeadThatBeginsToMove_data();
    void followsAHeadThatBeginsToMove();
    void bendsWhatLiesInABody();
    void bendsWhatLiesAlongALine();
    void movesGumsOfTheJawWithItAlone();
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

void TestJawInView::followsAHeadThatBeginsToMove_data()
{
    QTest::addColumn<std::string>("bends");
    QTest::newRow("of this body") << std::string{"patient"};
    QTest::newRow("of another body") << std::string{"other"};
}

/// A neck bends the parts of its body, and no others.
void TestJawInView::followsAHeadThatBeginsToMove()
{
    QFETCH(std::string, bends);
    const Vec3 p_A_incisors{0.0, -0.3, 0.0};
    const NeckField neck{{0.0, 0.0, -0.2}, p_A_incisors, {degrees(30.0), {}}};
    const ScenePart tooth = spherePart(1, MaterialGroup::Bone, p_A_incisors, kRadius, "patient");
    SceneFrame shown = frontFrame();
    shown.bodies["patient"] = PlacedBody{};
    shown.bends = bends;
    double seen = -1.0;
    const auto view = shownView({tooth}, [&](int, LocalTime) { return shown; });
    view->onFrameDrawn([&](const DrawnFrame&) {
        const auto centre = redCentre(onScreen(*view));
        seen = centre ? centre->y() : -1.0;
    });
    QVERIFY(draws(*view, 5));
    QVERIFY(std::abs(seen - row(p_A_incisors)) < kTolerance);
    shown.throat.neck = neck;
    QVERIFY(draws(*view, 10));
    const bool isBent = bends == tooth.body;
    const Vec3 p_A_drawn = isBent ? neck.X_AU() * p_A_incisors : p_A_incisors;
    QVERIFY(std::abs(row(neck.X_AU() * p_A_incisors) - row(p_A_incisors)) > 0.1);
    QVERIFY2(std::abs(seen - row(p_A_drawn)) < kTolerance, qPrintable(QString::number(seen)));
    // And so it is named where it is drawn.
    QVERIFY((drawnAt(tooth, p_A_incisors, shown).value() - p_A_drawn).norm() < 1e-12);
}

/// As a tube that goes with the head while its tip lies in the trunk, which stays.
void TestJawInView::bendsWhatLiesInABody()
{
    const NeckField neck{{0.0, 0.0, 0.1}, {0.0, -0.2, 0.25}, {degrees(30.0), {}}};
    const Vec3 p_A_tip{0.0, -0.25, -0.22};
    QCOMPARE(neck.placed(p_A_tip), p_A_tip);
    const RigidTransform X_AF = RigidTransform::translation({0.0, -0.05, 0.2});
    const Vec3 p_F_tip = X_AF.inverse() * p_A_tip;
    const ScenePart tip = spherePart(1, MaterialGroup::Tool, p_F_tip, kRadius, "tube");
    SceneFrame shown = frontFrame();
    shown.bodies["patient"] = PlacedBody{};
    shown.bodies["tube"] = neck.X_AU() * X_AF;
    shown.bends = "patient";
    shown.throat.neck = neck;
    double seen = -1.0;
    const auto view = shownView({tip}, [&](int, LocalTime) { return shown; });
    view->onFrameDrawn([&](const DrawnFrame&) {
        const auto centre = redCentre(onScreen(*view));
        seen = centre ? centre->y() : -1.0;
    });
    QVERIFY(draws(*view, 10));
    const Vec3 p_A_rigid = neck.X_AU() * p_A_tip;
    QVERIFY(std::abs(row(p_A_rigid) - row(p_A_tip)) > 2.0 * kTolerance);
    QVERIFY2(std::abs(seen - row(p_A_rigid)) < kTolerance, qPrintable(QString::number(seen)));
    shown.bentInPlace["tube"] = X_AF;
    QVERIFY(draws(*view, 10));
    QVERIFY2(std::abs(seen - row(p_A_tip)) < kTolerance, qPrintable(QString::number(seen)));
    QVERIFY((drawnAt(tip, p_F_tip, shown).value() - p_A_tip).norm() < 1e-12);
}

/// As a tube whose rod has turned aside, and back again.
void TestJawInView::bendsWhatLiesAlongALine()
{
    const std::vector<Vec3> rest{Vec3::Zero(), {0.0, 0.0, -0.1}, {0.0, 0.0, -0.2}};
    const std::vector<Vec3> aside{Vec3::Zero(), {0.0, 0.0, -0.1}, {0.1, 0.0, -0.1}};
    const Vec3 p_F_tip = rest.back();
    const ScenePart tip = spherePart(1, MaterialGroup::Tool, p_F_tip, kRadius, "tube");
    SceneFrame shown = frontFrame();
    shown.bodies["tube"] = RigidTransform{};
    double seen = -1.0;
    const auto view = shownView({tip}, [&](int, LocalTime) { return shown; });
    view->onFrameDrawn([&](const DrawnFrame&) {
        const auto centre = redCentre(onScreen(*view));
        seen = centre ? centre->y() : -1.0;
    });
    QVERIFY(draws(*view, 10));
    QVERIFY(std::abs(row(aside.back()) - row(p_F_tip)) > 2.0 * kTolerance);
    QVERIFY2(std::abs(seen - row(p_F_tip)) < kTolerance, qPrintable(QString::number(seen)));
    shown.bentAlong["tube"] = std::make_shared<const LineBend>(rest, aside);
    QVERIFY(draws(*view, 10));
    QVERIFY2(std::abs(seen - row(aside.back())) < kTolerance, qPrintable(QString::number(seen)));
    QVERIFY((drawnAt(tip, p_F_tip, shown).value() - aside.back()).norm() < 1e-12);
    shown.bentAlong.clear();
    QVERIFY(draws(*view, 10));
    QVERIFY2(std::abs(seen - row(p_F_tip)) < kTolerance, qPrintable(QString::number(seen)));
}

/// Tissue whose body is the mandible goes where that does, and not on from there: neither the jaw
/// nor a blade moves it, which would take tissue of the patient to the side of the picture.
void TestJawInView::movesGumsOfTheJawWithItAlone()
{
    ScenePart gum = spherePart(1, MaterialGroup::SoftTissue, p_A_tongue, kRadius, "mandible");
    gum.region = ChestRegion::Throat;
    SceneFrame shown = frontFrame();
    shown.bends = "patient";
    shown.throat = {kThroat, RigidTransform::translation({kAside, 0.0, 0.0})};
    shown.bodies["mandible"] = shown.throat.X_AJ;
    const BladeForm blade;
    const Vec3 p_A_blade = p_A_tongue + Vec3{kAside, 0.0, 0.5 * blade.reach}; // its middle aside
    const Quat handleAside = rotationFromVector({0.0, 0.0, -0.5 * std::numbers::pi});
    shown.blade = {blade, RigidTransform{handleAside, p_A_blade}};
    QVERIFY(bladePush<double>(shown.blade.frame(), p_A_tongue).d.x() > 0.5 * kAside);
    double seen = -1.0;
    const auto view = shownView({gum}, [&](int, LocalTime) { return shown; });
    view->onFrameDrawn([&](const DrawnFrame&) {
        const auto centre = redCentre(onScreen(*view));
        seen = centre ? centre->x() : -1.0;
    });
    QVERIFY(draws(*view, 10));
    QVERIFY(test::throatShare(kThroat, p_A_tongue, ThroatTissue::Airway) > 0.3);
    QVERIFY2(std::abs(seen - column(kAside)) < kTolerance, qPrintable(QString::number(seen)));
    const Vec3 p_A_drawn = p_A_tongue + Vec3{kAside, 0.0, 0.0};
    QVERIFY((drawnAt(gum, p_A_tongue, shown).value() - p_A_drawn).norm() < 1e-12);
}

CARINA_SCREEN_TEST(TestJawInView)

} // namespace carina::jaw_in_view_test

#include "tst_jaw_in_view.moc"
