#include "tests/support/test_class.h"
#include "tests/widgets/scene/scene_fixture.h"
#include "widgets/scene/view/graphics.h"

namespace carina::section_test
{

using namespace carina::test;

namespace
{

constexpr double kCountTolerance = 0.02; ///< of the analytic area

bool isClose(std::size_t counted, double expected)
{
    const bool agrees =
        std::abs(static_cast<double>(counted) - expected) <= kCountTolerance * expected;
    if (!agrees)
        qInfo("counted %zu, expected %.0f", counted, expected);
    return agrees;
}

/// A disc of that radius at right angles to the line of sight covers this many pixels.
double flatDiscPixels(double radius, double distance)
{
    const double focal = 0.5 * kHeight / std::tan(0.5 * OrbitCamera::kVerticalFieldOfView);
    return std::numbers::pi * focal * focal * radius * radius / (distance * distance);
}

std::map<std::uint16_t, std::size_t> countedIn(const std::vector<ScenePart>& parts,
                                               const std::optional<Section>& section)
{
    const auto view = shownView(parts, [](int, LocalTime) { return frontFrame(); });
    view->setSection(section);
    return draws(*view, 3) ? view->visiblePixels() : std::map<std::uint16_t, std::size_t>{};
}

/// Takes away all that is nearer to the eye than y.
Section openedTo(double y, Cut cut = Cut::All) { return {-Vec3::UnitY(), -y, cut}; }

} // namespace

class TestSection : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void init();
    void takesAwayWhatLiesBeyondThePlane();
    void showsTheInsideOfWhatIsCutOpen_data();
    void showsTheInsideOfWhatIsCutOpen();
    void uncoversWhatLiesBehind();
    void cutsWhereBreathingHasMovedIt();
    void leavesToolsAndFluidsWhole();
    void leavesTheAirwayWholeWhereAsked_data();
    void leavesTheAirwayWholeWhereAsked();
    void closesAgain();
};

void TestSection::init()
{
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
}

void TestSection::takesAwayWhatLiesBeyondThePlane()
{
    const std::vector parts{spherePart(1, MaterialGroup::Bone, {-0.2, 0.0, 0.0}, 0.1),
                            spherePart(2, MaterialGroup::Bone, {0.2, 0.0, 0.0}, 0.1)};
    auto pixels = countedIn(parts, Section{Vec3::UnitX(), 0.05, Cut::All});
    QCOMPARE(pixels[2], std::size_t{0});
    QVERIFY(pixels[1] > 0);
}

void TestSection::showsTheInsideOfWhatIsCutOpen_data()
{
    QTest::addColumn<MaterialGroup>("group");
    QTest::newRow("bone") << MaterialGroup::Bone;
    QTest::newRow("lung") << MaterialGroup::Lung;
    QTest::newRow("skin") << MaterialGroup::Skin;
}

void TestSection::showsTheInsideOfWhatIsCutOpen()
{
    // Cut through its middle the ball is a bowl: its edge a disc at right angles to the sight.
    QFETCH(MaterialGroup, group);
    auto pixels = countedIn({spherePart(1, group, Vec3::Zero(), 0.2)}, openedTo(0.0));
    QVERIFY(isClose(pixels[1], flatDiscPixels(0.2, kDistance)));
}

void TestSection::uncoversWhatLiesBehind()
{
    auto pixels = countedIn({spherePart(1, MaterialGroup::Bone, {0.0, -0.5, 0.0}, 0.2),
                             spherePart(2, MaterialGroup::SoftTissue, {0.0, 0.5, 0.0}, 0.1)},
                            openedTo(0.0));
    QCOMPARE(pixels[1], std::size_t{0});
    QVERIFY(isClose(pixels[2], discPixels(0.1, kDistance + 0.5)));
}

void TestSection::cutsWhereBreathingHasMovedIt()
{
    // Grown by two about x = 0.4, the ball at 0.3 comes to lie about 0.2, from 0.1 to 0.3.
    ScenePart lung = spherePart(1, MaterialGroup::Bone, {0.3, 0.0, 0.0}, 0.05);
    lung.region = ChestRegion::RightUpperLung;
    SceneFrame frame = frontFrame();
    frame.chest.field = wideChest();
    frame.chest.motion[static_cast<std::size_t>(ChestRegion::RightUpperLung)] = scaledBy(2.0);
    const auto view = shownView({lung}, [&](int, LocalTime) { return frame; });
    view->setSection(Section{Vec3::UnitX(), 0.31, Cut::All});
    QVERIFY(draws(*view, 3));
    const auto whole = static_cast<double>(view->visiblePixels()[1]);
    view->setSection(Section{Vec3::UnitX(), 0.2, Cut::All});
    QVERIFY(draws(*view, 3));
    QVERIFY(std::abs(static_cast<double>(view->visiblePixels()[1]) / whole - 0.5)
            < 0.1); // its far half is seen askew
    view->setSection(Section{Vec3::UnitX(), 0.09, Cut::All});
    QVERIFY(draws(*view, 3));
    QCOMPARE(view->visiblePixels()[1], std::size_t{0});
}

void TestSection::leavesToolsAndFluidsWhole()
{
    for (const MaterialGroup group : {MaterialGroup::Tool, MaterialGroup::Fluid}) {
        auto pixels = countedIn({spherePart(1, group, Vec3::Zero(), 0.1)}, openedTo(0.5));
        QVERIFY(isClose(pixels[1], discPixels(0.1, kDistance)));
    }
}

void TestSection::leavesTheAirwayWholeWhereAsked_data()
{
    QTest::addColumn<Cut>("cut");
    QTest::addColumn<bool>("airway");
    QTest::newRow("everything is cut") << Cut::All << false;
    QTest::newRow("what lies around it is cut") << Cut::AllButAirway << true;
}

void TestSection::leavesTheAirwayWholeWhereAsked()
{
    QFETCH(Cut, cut);
    QFETCH(bool, airway);
    auto pixels = countedIn({spherePart(1, MaterialGroup::Airway, Vec3::Zero(), 0.1),
                             spherePart(2, MaterialGroup::Bone, Vec3::Zero(), 0.2)},
                            openedTo(0.5, cut));
    QCOMPARE(pixels[2], std::size_t{0});
    QCOMPARE(pixels[1] > 0, airway);
}

void TestSection::closesAgain()
{
    const auto view = shownView({spherePart(1, MaterialGroup::Bone, Vec3::Zero(), 0.1)},
                                [](int, LocalTime) { return frontFrame(); });
    view->setSection(openedTo(0.5));
    QVERIFY(draws(*view, 3));
    QCOMPARE(view->visiblePixels()[1], std::size_t{0});
    view->setSection({});
    QVERIFY(draws(*view, 3));
    QVERIFY(isClose(view->visiblePixels()[1], discPixels(0.1, kDistance)));
}

CARINA_SCREEN_TEST(TestSection)

} // namespace carina::section_test

#include "tst_section.moc"
