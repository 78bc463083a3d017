#include "tests/support/test_class.h"
#include "tests/widgets/scene/scene_fixture.h"
#include "widgets/scene/view/graphics.h"

namespace carina::visible_pixels_test
{

using namespace carina::test;

namespace
{

constexpr double kCountTolerance = 0.02; ///< of the analytic area

bool close(std::size_t counted, double expected)
{
    const bool agrees =
        std::abs(static_cast<double>(counted) - expected) <= kCountTolerance * expected;
    if (!agrees)
        qInfo("counted %zu, expected %.0f", counted, expected);
    return agrees;
}

std::map<std::uint16_t, std::size_t> countedIn(const std::vector<ScenePart>& parts,
                                               const SceneFrame& frame = frontFrame())
{
    const auto view = shownView(parts, [frame](int, LocalTime) { return frame; });
    return draws(*view, 3) ? view->visiblePixels() : std::map<std::uint16_t, std::size_t>{};
}

} // namespace

class TestVisiblePixels : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void init();
    void countsTheDiscOfASphere_data();
    void countsTheDiscOfASphere();
    void tellsManyPartsApart();
    void hidesOpaqueBehindOpaque();
    void seesATubeThroughTheTracheaAroundIt();
    void seesOneTranslucentGroupThroughALaterOne();
    void hidesALaterGroupBehindAnEarlierOne();
    void hidesTheFartherOfOneTranslucentGroup();
    void countsNothingOfABodyThatIsNotThere();
    void placesABodyAtItsPose();
    void growsEachRegionByItsOwnMotion();
    void countsInTheSizeOfTheWindow();
    void isZeroForAllWhileNotShown();
};

void TestVisiblePixels::init()
{
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
}

void TestVisiblePixels::countsTheDiscOfASphere_data()
{
    QTest::addColumn<MaterialGroup>("group");
    QTest::addColumn<double>("radius");
    QTest::newRow("opaque, small") << MaterialGroup::Bone << 0.05;
    QTest::newRow("opaque, large") << MaterialGroup::Tool << 0.4;
    QTest::newRow("airway") << MaterialGroup::Airway << 0.2;
    QTest::newRow("lung") << MaterialGroup::Lung << 0.2;
    QTest::newRow("cage") << MaterialGroup::Veil << 0.2;
    QTest::newRow("skin") << MaterialGroup::Skin << 0.2;
}

void TestVisiblePixels::countsTheDiscOfASphere()
{
    QFETCH(MaterialGroup, group);
    QFETCH(double, radius);
    auto pixels = countedIn({spherePart(9, group, Vec3::Zero(), radius)});
    QVERIFY(close(pixels[9], discPixels(radius, kDistance)));
}

void TestVisiblePixels::tellsManyPartsApart()
{
    // Ids on both sides of a byte, in one merged surface, side by side.
    const std::vector<std::uint16_t> ids{0, 1, 255, 256, 4711, 65535};
    std::vector<ScenePart> parts;
    for (std::size_t i = 0; i < ids.size(); ++i)
        parts.push_back(spherePart(ids[i], MaterialGroup::Bone,
                                   {0.2 * static_cast<double>(i) - 0.5, 0.0, 0.0}, 0.05));
    auto pixels = countedIn(parts);
    QCOMPARE(pixels.size(), ids.size());
    for (const std::uint16_t id : ids)
        QVERIFY2(static_cast<double>(pixels[id]) > 0.9 * discPixels(0.05, kDistance),
                 qPrintable(QString::number(id)));
}

void TestVisiblePixels::hidesOpaqueBehindOpaque()
{
    auto pixels = countedIn({spherePart(1, MaterialGroup::Bone, Vec3::Zero(), 0.2),
                             spherePart(2, MaterialGroup::Tool, {0.0, 0.5, 0.0}, 0.1)});
    QCOMPARE(pixels[2], std::size_t{0});
    QVERIFY(close(pixels[1], discPixels(0.2, kDistance)));
}

void TestVisiblePixels::seesATubeThroughTheTracheaAroundIt()
{
    auto pixels = countedIn({spherePart(1, MaterialGroup::Airway, Vec3::Zero(), 0.2),
                             spherePart(2, MaterialGroup::Tool, Vec3::Zero(), 0.1)});
    QVERIFY(close(pixels[1], discPixels(0.2, kDistance)));
    QVERIFY(close(pixels[2], discPixels(0.1, kDistance)));
}

void TestVisiblePixels::seesOneTranslucentGroupThroughALaterOne()
{
    auto pixels = countedIn({spherePart(1, MaterialGroup::Airway, Vec3::Zero(), 0.1),
                             spherePart(2, MaterialGroup::Lung, Vec3::Zero(), 0.2),
                             spherePart(3, MaterialGroup::Skin, Vec3::Zero(), 0.3)});
    QVERIFY(close(pixels[1], discPixels(0.1, kDistance)));
    QVERIFY(close(pixels[2], discPixels(0.2, kDistance)));
    QVERIFY(close(pixels[3], discPixels(0.3, kDistance)));
}

void TestVisiblePixels::hidesALaterGroupBehindAnEarlierOne()
{
    auto pixels = countedIn({spherePart(1, MaterialGroup::Airway, Vec3::Zero(), 0.1),
                             spherePart(2, MaterialGroup::Lung, {0.0, 0.5, 0.0}, 0.2)});
    QVERIFY(close(pixels[1], discPixels(0.1, kDistance)));
    QVERIFY(close(pixels[2], discPixels(0.2, kDistance + 0.5) - discPixels(0.1, kDistance)));
}

void TestVisiblePixels::hidesTheFartherOfOneTranslucentGroup()
{
    auto pixels = countedIn({spherePart(1, MaterialGroup::Lung, {0.0, 0.5, 0.0}, 0.1),
                             spherePart(2, MaterialGroup::Lung, Vec3::Zero(), 0.2)});
    QCOMPARE(pixels[1], std::size_t{0});
    QVERIFY(close(pixels[2], discPixels(0.2, kDistance)));
}

void TestVisiblePixels::countsNothingOfABodyThatIsNotThere()
{
    auto pixels = countedIn({spherePart(1, MaterialGroup::Tool, Vec3::Zero(), 0.1, "tube"),
                             spherePart(2, MaterialGroup::Bone, {0.0, 0.5, 0.0}, 0.1)});
    QCOMPARE(pixels[1], std::size_t{0});
    QVERIFY(close(pixels[2], discPixels(0.1, kDistance + 0.5)));
}

void TestVisiblePixels::placesABodyAtItsPose()
{
    // The sphere is off the body's origin; a half turn about z and a shift bring it to (0, 1, 0).
    SceneFrame frame = frontFrame();
    frame.bodies["jaw"] = RigidTransform(Quat(0.0, 0.0, 0.0, 1.0), Vec3(0.2, 1.0, 0.0));
    auto pixels =
        countedIn({spherePart(1, MaterialGroup::Bone, {0.2, 0.0, 0.0}, 0.1, "jaw")}, frame);
    QVERIFY(close(pixels[1], discPixels(0.1, kDistance + 1.0)));
}

void TestVisiblePixels::growsEachRegionByItsOwnMotion()
{
    // Both come to lie in the middle of the picture: 0.4 + k (x - 0.4) = 0.
    ScenePart right = spherePart(1, MaterialGroup::Lung, {0.2, 0.0, 0.0}, 0.1);
    right.region = ChestRegion::RightUpperLung;
    ScenePart left = spherePart(2, MaterialGroup::Lung, {-0.4, 0.0, 0.0}, 0.1);
    left.region = ChestRegion::LeftUpperLung;
    SceneFrame frame = frontFrame();
    frame.chest.field = wideChest();
    frame.chest.motion[static_cast<std::size_t>(ChestRegion::RightUpperLung)] = scaledBy(2.0);
    frame.chest.motion[static_cast<std::size_t>(ChestRegion::LeftUpperLung)] = scaledBy(0.5);
    auto pixels = countedIn({right}, frame);
    QVERIFY(close(pixels[1], discPixels(0.2, kDistance)));
    pixels = countedIn({left}, frame);
    QVERIFY(close(pixels[2], discPixels(0.05, kDistance)));
}

void TestVisiblePixels::countsInTheSizeOfTheWindow()
{
    const auto view = shownView({spherePart(1, MaterialGroup::Bone, Vec3::Zero(), 0.1)},
                                [](int, LocalTime) { return frontFrame(); });
    QVERIFY(draws(*view, 3));
    const double before = static_cast<double>(view->visiblePixels()[1]);
    view->resize(kWidth, kHeight / 2);
    QVERIFY(draws(*view, 5));
    QVERIFY(close(view->visiblePixels()[1], before / 4.0));
    view->resize(kWidth, kHeight);
    QVERIFY(draws(*view, 5));
    QVERIFY(close(view->visiblePixels()[1], before));
}

void TestVisiblePixels::isZeroForAllWhileNotShown()
{
    SceneView view;
    view.setParts(std::vector{spherePart(1, MaterialGroup::Bone, Vec3::Zero(), 0.1)});
    QCOMPARE(view.visiblePixels(), (std::map<std::uint16_t, std::size_t>{{1, 0}}));
    QVERIFY(view.picture().isNull());
}

CARINA_SCREEN_TEST(TestVisiblePixels)

} // namespace carina::visible_pixels_test

#include "tst_visible_pixels.moc"
