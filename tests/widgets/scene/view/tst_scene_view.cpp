#include "tests/support/test_class.h"
#include "tests/widgets/scene/scene_fixture.h"
#include "widgets/scene/view/graphics.h"

namespace carina::scene_view_test
{

using namespace carina::test;

namespace
{

constexpr double kPlaceTolerance = 0.01; ///< of the picture's width or height

/// Share of the picture's width by which a point x to the side at the origin's depth is off centre.
double offCentre(double x)
{
    const double focal = 0.5 * kHeight / std::tan(0.5 * OrbitCamera::kVerticalFieldOfView);
    return focal * x / kDistance / kWidth;
}

} // namespace

class TestSceneView : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void init();
    void showsThePatientsRightOnTheLeftFromInFront();
    void showsTheHeadUpFromInFront();
    void looksOutOfTheEyeOfTheFrame();
    void showsThePoseOfTheVerySameFrame();
    void reportsWhatItDrew();
    void showsATubeInsideATranslucentTrachea();
    void movesTheSilhouetteWithTheChest_data();
    void movesTheSilhouetteWithTheChest();
    void asksForTheLevelThatItDraws();
    void drawsTwoViewsAtOnce();
    void replacesItsParts();
    void drawsOtherSettingsAndItsOwnAgain();
    void looksFromAnotherPlaceAndFromItsOwnAgain();
    void comesAndGoesTwentyTimes();
};

void TestSceneView::init()
{
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
}

void TestSceneView::showsThePatientsRightOnTheLeftFromInFront()
{
    ScenePart blue = spherePart(2, MaterialGroup::Bone, {0.1, 0.0, 0.0}, 0.05);
    blue.color = QColor(20, 20, 220);
    const auto view =
        shownView({spherePart(1, MaterialGroup::Bone, {-0.1, 0.0, 0.0}, 0.05), blue}, {});
    view->showFrom(ViewPreset::Front);
    QVERIFY(draws(*view, 3));
    const auto centre = redCentre(view->picture());
    QVERIFY(centre && centre->x() < 0.4);
}

void TestSceneView::showsTheHeadUpFromInFront()
{
    ScenePart blue = spherePart(2, MaterialGroup::Bone, {0.0, 0.0, -0.1}, 0.05);
    blue.color = QColor(20, 20, 220);
    const auto view =
        shownView({spherePart(1, MaterialGroup::Bone, {0.0, 0.0, 0.1}, 0.05), blue}, {});
    QVERIFY(draws(*view, 3));
    const auto centre = redCentre(view->picture());
    QVERIFY(centre && centre->y() < 0.4);
}

void TestSceneView::looksOutOfTheEyeOfTheFrame()
{
    const auto view = shownView({spherePart(1, MaterialGroup::Bone, {0.2, 0.0, 0.1}, 0.02)},
                                [](int, LocalTime) { return frontFrame(); });
    QVERIFY(draws(*view, 3));
    const auto centre = redCentre(view->picture());
    QVERIFY(centre);
    QVERIFY(std::abs(centre->x() - (0.5 + offCentre(0.2))) < kPlaceTolerance);
    QVERIFY(std::abs(centre->y() - (0.5 - offCentre(0.1) * kWidth / kHeight)) < kPlaceTolerance);
}

void TestSceneView::showsThePoseOfTheVerySameFrame()
{
    constexpr int kWarmUp = 5; // frames until shaders and buffers are there
    constexpr int kFrames = 40;
    int asked = 0;
    int late = 0;
    const auto side = [](int frame) { return frame % 2 == 0 ? -0.2 : 0.2; };
    const auto view = shownView(
        {spherePart(1, MaterialGroup::Tool, Vec3::Zero(), 0.05, "tube")}, [&](int, LocalTime) {
            SceneFrame frame = frontFrame();
            frame.bodies["tube"] = RigidTransform::translation({side(++asked), 0.0, 0.0});
            return frame;
        });
    view->onFrameDrawn([&](const DrawnFrame& drawn) {
        if (asked <= kWarmUp)
            return;
        const auto centre = redCentre(onScreen(*view));
        const double expected =
            0.5 + offCentre(drawn.frame.bodies.at("tube").X_AF.translation().x());
        if (!centre || std::abs(centre->x() - expected) > kPlaceTolerance)
            ++late;
    });
    QVERIFY(draws(*view, kWarmUp + kFrames));
    QCOMPARE(late, 0);
}

void TestSceneView::reportsWhatItDrew()
{
    std::vector<DrawnFrame> log;
    int asked = 0;
    const auto view =
        shownView({spherePart(1, MaterialGroup::Bone, Vec3::Zero(), 0.1)}, [&](int, LocalTime) {
            SceneFrame frame = frontFrame();
            frame.time = SessionTime{std::chrono::milliseconds{++asked}};
            frame.chest.motion[1].right.descent = 0.25;
            return frame;
        });
    view->onFrameDrawn([&](const DrawnFrame& drawn) { log.push_back(drawn); });
    QVERIFY(draws(*view, 4));
    for (std::size_t i = 0; i < log.size(); ++i) {
        QCOMPARE(log[i].frame.time.time_since_epoch().count(),
                 static_cast<std::int64_t>(i + 1) * 1'000'000);
        QCOMPARE(log[i].frame.chest.of(ChestRegion::RightUpperLung).right.descent, 0.25);
        QCOMPARE(log[i].level, 0);
        QVERIFY(log[i].asked < log[i].swapped);
        QVERIFY(i == 0 || log[i - 1].swapped <= log[i].asked);
    }
}

void TestSceneView::showsATubeInsideATranslucentTrachea()
{
    ScenePart trachea = spherePart(1, MaterialGroup::Airway, Vec3::Zero(), 0.3);
    trachea.color = QColor(170, 200, 220);
    const auto view =
        shownView({trachea, spherePart(2, MaterialGroup::Tool, {-0.1, 0.0, 0.0}, 0.05, "tube")},
                  [](int, LocalTime) {
                      SceneFrame frame = frontFrame();
                      frame.bodies["tube"] = RigidTransform();
                      return frame;
                  });
    QVERIFY(draws(*view, 3));
    const QImage picture = view->picture();
    const int row = kHeight / 2;
    const QColor tube = picture.pixelColor(static_cast<int>((0.5 + offCentre(-0.1)) * kWidth), row);
    const QColor wall = picture.pixelColor(static_cast<int>((0.5 + offCentre(0.1)) * kWidth), row);
    QVERIFY(tube.red() > tube.blue() + 20); // the red tube, through the bluish wall
    QVERIFY(wall.blue() > wall.red());
    QVERIFY(wall.blue() > 40); // and the wall itself is seen over black
}

void TestSceneView::movesTheSilhouetteWithTheChest_data()
{
    QTest::addColumn<MaterialGroup>("group");
    QTest::newRow("translucent") << MaterialGroup::Lung;
    QTest::newRow("opaque") << MaterialGroup::SoftTissue;
}

void TestSceneView::movesTheSilhouetteWithTheChest()
{
    QFETCH(MaterialGroup, group);
    ScenePart lung = spherePart(1, group, Vec3::Zero(), 0.1);
    lung.region = ChestRegion::LeftLowerLung;
    SceneFrame shown = frontFrame();
    shown.chest.field = wideChest();
    const auto view = shownView({lung}, [&](int, LocalTime) { return shown; });
    // The sphere's centre goes from 0 to 0.4 (1 - 1.5) = -0.2.
    const QPoint place(static_cast<int>((0.5 + offCentre(-0.2)) * kWidth), kHeight / 2);
    QVERIFY(draws(*view, 3));
    QCOMPARE(view->picture().pixelColor(place), QColor(Qt::black));
    shown.chest.motion[static_cast<std::size_t>(ChestRegion::LeftLowerLung)] = scaledBy(1.5);
    QVERIFY(draws(*view, 1));
    QVERIFY(view->picture().pixelColor(place).red() > 40);
}

void TestSceneView::asksForTheLevelThatItDraws()
{
    ScenePart part = spherePart(1, MaterialGroup::Bone, Vec3::Zero(), 0.1);
    part.levels.push_back(sphere(Vec3::Zero(), 0.2));
    int asked = -1;
    const auto view = shownView({part}, [&](int level, LocalTime) {
        asked = level;
        return frontFrame();
    });
    for (const int level : {0, 1, 0}) {
        view->setFixedLevel(level);
        QVERIFY(draws(*view, 3));
        QCOMPARE(asked, level);
        const double counted = static_cast<double>(view->visiblePixels()[1]);
        const double expected = discPixels(level == 0 ? 0.1 : 0.2, kDistance);
        QVERIFY(std::abs(counted - expected) < 0.02 * expected);
    }
    view->setFixedLevel(7); // the scene has two
    QCOMPARE(view->level(), 1);
}

void TestSceneView::drawsTwoViewsAtOnce()
{
    const auto side = [](double x) {
        return [x](int, LocalTime) {
            SceneFrame frame = frontFrame();
            frame.bodies["tube"] = RigidTransform::translation({x, 0.0, 0.0});
            return frame;
        };
    };
    const std::vector parts{spherePart(1, MaterialGroup::Tool, Vec3::Zero(), 0.05, "tube")};
    const auto first = shownView(parts, side(-0.2));
    const auto second = shownView(parts, side(0.2));
    second->move(kWidth + 10, 0);
    QVERIFY(draws(*first, 5));
    QVERIFY(draws(*second, 5));
    QVERIFY(redCentre(first->picture())->x() < 0.4);
    QVERIFY(redCentre(second->picture())->x() > 0.6);
}

void TestSceneView::drawsOtherSettingsAndItsOwnAgain()
{
    const auto view = shownView({spherePart(1, MaterialGroup::Bone, {-0.1, 0.0, 0.0}, 0.05),
                                 spherePart(2, MaterialGroup::Bone, {0.1, 0.0, 0.0}, 0.05)},
                                [](int, LocalTime) { return frontFrame(); });
    view->setLooks({{1, {.style = PartStyle::Hidden}}});
    view->setSection(Section{Vec3::UnitX(), 0.0});
    QVERIFY(draws(*view, 3));
    const SceneSettings own = view->settings();
    QCOMPARE(view->visiblePixels(), (std::map<std::uint16_t, std::size_t>{{1, 0}, {2, 0}}));
    view->drawInstead(SceneSettings{.section = {}, .looks = {{2, {.highlighted = true}}}});
    QVERIFY(draws(*view, 3));
    QVERIFY(view->visiblePixels()[1] > 0 && view->visiblePixels()[2] > 0);
    QVERIFY(view->settings() == own);
    view->setLooks({}); // what is changed meanwhile is seen afterwards
    view->drawInstead(std::nullopt);
    QVERIFY(draws(*view, 3));
    QVERIFY(view->visiblePixels()[1] > 0);
    QCOMPARE(view->visiblePixels()[2], std::size_t{0}); // cut away
}

void TestSceneView::looksFromAnotherPlaceAndFromItsOwnAgain()
{
    std::optional<RigidTransform> viewpoint;
    const auto view = shownView({spherePart(1, MaterialGroup::Bone, {0.1, 0.0, 0.0}, 0.05)},
                                [&viewpoint](int, LocalTime) {
                                    SceneFrame frame;
                                    frame.viewpoint = viewpoint;
                                    return frame;
                                });
    view->showFrom(ViewPreset::Left);
    QVERIFY(draws(*view, 3));
    const Vec3 own = view->sight().pose.p_A_eye;
    viewpoint = frontEye(0.4).X_AD;
    QVERIFY(draws(*view, 3));
    QVERIFY((view->sight().pose.p_A_eye - Vec3(0.4, -kDistance, 0.0)).norm() < 1e-9);
    QTest::keyClick(view->windowHandle(), Qt::Key_Left); // nobody moves it meanwhile
    viewpoint.reset();
    QVERIFY(draws(*view, 3));
    QCOMPARE(view->sight().pose.p_A_eye, own);
}

void TestSceneView::replacesItsParts()
{
    const auto view = shownView({spherePart(1, MaterialGroup::Bone, Vec3::Zero(), 0.1)},
                                [](int, LocalTime) { return frontFrame(); });
    QVERIFY(draws(*view, 3));
    view->setParts(std::vector{spherePart(2, MaterialGroup::Bone, Vec3::Zero(), 0.2)});
    QVERIFY(draws(*view, 3));
    const auto pixels = view->visiblePixels();
    QCOMPARE(pixels.size(), std::size_t{1});
    QVERIFY(static_cast<double>(pixels.at(2)) > 0.98 * discPixels(0.2, kDistance));
}

void TestSceneView::comesAndGoesTwentyTimes()
{
    for (int time = 0; time < 20; ++time) {
        const auto view = shownView({spherePart(1, MaterialGroup::Bone, Vec3::Zero(), 0.1)},
                                    [](int, LocalTime) { return frontFrame(); });
        QVERIFY(draws(*view, 2));
    }
}

CARINA_SCREEN_TEST(TestSceneView)

} // namespace carina::scene_view_test

#include "tst_scene_view.moc"
