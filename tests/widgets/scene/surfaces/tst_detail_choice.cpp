#include "tests/support/test_class.h"
#include "widgets/scene/surfaces/detail_choice.h"

#include <array>

namespace carina::detail_choice_test
{

using std::chrono::milliseconds;

namespace
{

constexpr Duration kBudget = milliseconds{20};
constexpr double kPerTangent = 1000.0; ///< pixels

/// A mesh of so many triangles within a sphere of radius 1 m about a centre.
std::shared_ptr<const TriangleMesh> mesh(std::size_t triangles, const Vec3& centre)
{
    auto made = std::make_shared<TriangleMesh>();
    const Vec3f c = centre.cast<float>();
    made->positions = {c - Vec3f::UnitX(), c + Vec3f::UnitX()}; // a box without height or depth
    made->triangles.assign(triangles, {0, 1, 1});
    return made;
}

/// Levels of 1000, 100 and 10 triangles, 0, 1 and 4 mm from the finest.
ScenePart part(const Vec3& centre = Vec3::Zero(), bool sharesLevel = false)
{
    ScenePart made;
    made.levels = {mesh(1000, centre), mesh(100, centre), mesh(10, centre)};
    made.deviations = {0.0, 1e-3, 4e-3};
    made.sharesLevel = sharesLevel;
    return made;
}

/// An eye from which 1 m at the near side of the part in the middle covers so many pixels.
std::array<DetailEye, 1> eyeSeeing(double pixelsPerMetre)
{
    return {DetailEye{{0.0, -(1.0 + kPerTangent / pixelsPerMetre), 0.0}, kPerTangent}};
}

void draw(DetailChoice& choice, int frames, Duration each)
{
    for (int i = 0; i < frames; ++i)
        choice.frameTook(each);
}

void drawDecided(DetailChoice& choice, Duration each)
{
    draw(choice, DetailChoice::kFramesPerDecision, each);
}

using Levels = std::vector<int>;

} // namespace

class TestDetailChoice : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesTheCoarsestWhoseDeviationIsNotSeen_data();
    void takesTheCoarsestWhoseDeviationIsNotSeen();
    void judgesByTheNearerEye();
    void judgesEachPartByItself();
    void givesSharersTheFinestThatAnyOfThemNeeds();
    void keepsTheFinestWhereNothingIsKnownOfTheOthers();
    void doesNotChangeToAndFro();
    void startsWithWhatAnyMachineDraws_data();
    void startsWithWhatAnyMachineDraws();
    void toleratesMoreOnlyAboveTheBudget();
    void toleratesLessWhenThatWillStayComfortable();
    void staysWithinItsBounds();
    void judgesTheMeanOfAWholeRun();
    void decidesSoonerWhereFramesAreSlow();
    void keepsToAFixedLevel();
    void keepsItsToleranceForOtherParts();
    void keepsItsLevelsWhileNobodyLooks();
    void restsInLevelsThatCannotBeSeenToBeCoarser();
};

void TestDetailChoice::takesTheCoarsestWhoseDeviationIsNotSeen_data()
{
    // Half a pixel is tolerated; a coarser level than the one before, only with 0.7 of that.
    QTest::addColumn<double>("pixelsPerMetre");
    QTest::addColumn<int>("level");
    QTest::newRow("1 mm is 0.36 pixels") << 360.0 << 0;
    QTest::newRow("1 mm is 0.34 pixels") << 340.0 << 1;
    QTest::newRow("4 mm are 0.36 pixels") << 90.0 << 1;
    QTest::newRow("4 mm are 0.34 pixels") << 85.0 << 2;
}

void TestDetailChoice::takesTheCoarsestWhoseDeviationIsNotSeen()
{
    QFETCH(double, pixelsPerMetre);
    QFETCH(int, level);
    const std::vector parts{part()};
    DetailChoice choice{parts, kBudget};
    QCOMPARE(choice.choose(eyeSeeing(pixelsPerMetre)), Levels{level});
    QCOMPARE(choice.sharedLevel(), level);
    QCOMPARE(choice.triangles(), (std::array<std::size_t, 3>{1000, 100, 10}[std::size_t(level)]));
}

void TestDetailChoice::judgesByTheNearerEye()
{
    const std::vector parts{part()};
    DetailChoice choice{parts, kBudget};
    const std::array eyes{eyeSeeing(10.0)[0], eyeSeeing(340.0)[0], eyeSeeing(20.0)[0]};
    QCOMPARE(choice.choose(eyes), Levels{1});
}

void TestDetailChoice::judgesEachPartByItself()
{
    // The second lies 10 m farther away: 1 m covers 1000 / (1000 / 340 + 10) = 77 pixels there.
    const std::vector parts{part(), part({0.0, 10.0, 0.0})};
    DetailChoice choice{parts, kBudget};
    QCOMPARE(choice.choose(eyeSeeing(340.0)), (Levels{1, 2}));
    QCOMPARE(choice.triangles(), std::size_t{110});
    QCOMPARE(choice.sharedLevel(), 1);
}

void TestDetailChoice::givesSharersTheFinestThatAnyOfThemNeeds()
{
    std::vector<ScenePart> parts;
    parts.push_back(part({0.0, 10.0, 0.0}));
    parts.push_back(part({0.0, 10.0, 0.0}, true));
    parts.push_back(part(Vec3::Zero(), true));
    DetailChoice choice{parts, kBudget};
    QCOMPARE(choice.choose(eyeSeeing(340.0)), (Levels{2, 1, 1}));
    QCOMPARE(choice.sharedLevel(), 1);
}

void TestDetailChoice::keepsTheFinestWhereNothingIsKnownOfTheOthers()
{
    ScenePart silent = part();
    silent.deviations = {0.0, 1e-3};
    ScenePart mute = part();
    mute.deviations = {};
    DetailChoice choice{std::vector{silent, mute}, kBudget};
    QCOMPARE(choice.choose(eyeSeeing(1e-3)), (Levels{1, 0}));
}

void TestDetailChoice::doesNotChangeToAndFro()
{
    const std::vector parts{part()};
    DetailChoice choice{parts, kBudget};
    QCOMPARE(choice.choose(eyeSeeing(340.0)), Levels{1});
    QCOMPARE(choice.choose(eyeSeeing(499.0)), Levels{1}); // 1 mm is less than half a pixel yet
    QCOMPARE(choice.choose(eyeSeeing(501.0)), Levels{0});
    QCOMPARE(choice.choose(eyeSeeing(360.0)), Levels{0});
    QCOMPARE(choice.choose(eyeSeeing(340.0)), Levels{1});
}

void TestDetailChoice::startsWithWhatAnyMachineDraws_data()
{
    QTest::addColumn<std::size_t>("finest");
    QTest::addColumn<int>("level");
    QTest::newRow("just small enough") << DetailChoice::kFirstTriangles << 0;
    QTest::newRow("just too large") << DetailChoice::kFirstTriangles + 1 << 1;
}

void TestDetailChoice::startsWithWhatAnyMachineDraws()
{
    QFETCH(std::size_t, finest);
    ScenePart large = part();
    large.levels[0] = mesh(finest, Vec3::Zero());
    DetailChoice choice{std::vector{large}, kBudget};
    choice.choose(eyeSeeing(1000.0)); // 1 mm is a pixel
    QTEST(choice.sharedLevel(), "level");
}

void TestDetailChoice::toleratesMoreOnlyAboveTheBudget()
{
    DetailChoice choice{std::vector{part()}, kBudget};
    choice.choose(eyeSeeing(400.0));
    QCOMPARE(choice.tolerance_px(), DetailChoice::kFinestTolerance_px);
    drawDecided(choice, kBudget);
    QCOMPARE(choice.tolerance_px(), DetailChoice::kFinestTolerance_px);
    draw(choice, DetailChoice::kFramesPerDecision - 1, kBudget + Duration{1});
    QCOMPARE(choice.tolerance_px(), DetailChoice::kFinestTolerance_px);
    draw(choice, 1, kBudget + Duration{1});
    QCOMPARE(choice.tolerance_px(), 0.7);                 // times 1.4
    QCOMPARE(choice.choose(eyeSeeing(400.0)), Levels{1}); // 0.4 pixels of the calm 0.49
}

void TestDetailChoice::toleratesLessWhenThatWillStayComfortable()
{
    DetailChoice choice{std::vector{part()}, kBudget};
    choice.choose(eyeSeeing(600.0));
    drawDecided(choice, milliseconds{21});
    drawDecided(choice, milliseconds{21});
    QCOMPARE(choice.choose(eyeSeeing(600.0)), Levels{1}); // 0.6 of 0.98 * 0.7 pixels
    // With 0.7 pixels it is still drawn in level 1: nothing would take longer than now.
    drawDecided(choice, milliseconds{14});
    QVERIFY(choice.tolerance_px() > 0.9);
    drawDecided(choice, milliseconds{14} - Duration{1});
    QVERIFY(std::abs(choice.tolerance_px() - 0.7) < 1e-9);
    // With 0.5 it would be drawn in level 0, of ten times as many triangles.
    choice.choose(eyeSeeing(600.0));
    drawDecided(choice, milliseconds{2});
    QVERIFY(std::abs(choice.tolerance_px() - 0.7) < 1e-9);
    drawDecided(choice, std::chrono::microseconds{1399});
    QCOMPARE(choice.tolerance_px(), DetailChoice::kFinestTolerance_px);
}

void TestDetailChoice::staysWithinItsBounds()
{
    DetailChoice choice{std::vector{part()}, kBudget};
    choice.choose(eyeSeeing(10.0));
    for (int i = 0; i < 40; ++i)
        drawDecided(choice, milliseconds{100});
    QCOMPARE(choice.tolerance_px(), DetailChoice::kCoarsestTolerance_px);
    for (int i = 0; i < 40; ++i)
        drawDecided(choice, milliseconds{1});
    QCOMPARE(choice.tolerance_px(), DetailChoice::kFinestTolerance_px);
    DetailChoice nothing{{}, kBudget};
    nothing.choose(eyeSeeing(10.0));
    drawDecided(nothing, milliseconds{100});
    QCOMPARE(nothing.sharedLevel(), 0);
    QCOMPARE(nothing.triangles(), std::size_t{0});
}

void TestDetailChoice::judgesTheMeanOfAWholeRun()
{
    DetailChoice choice{std::vector{part()}, kBudget};
    choice.choose(eyeSeeing(10.0));
    draw(choice, 1, milliseconds{300});
    draw(choice, DetailChoice::kFramesPerDecision - 1, milliseconds{5});
    QCOMPARE(choice.tolerance_px(), 0.5); // (300 + 19 * 5) / 20 = 19.75 ms
    draw(choice, 1, milliseconds{310});
    draw(choice, DetailChoice::kFramesPerDecision - 1, milliseconds{5});
    QCOMPARE(choice.tolerance_px(), 0.7); // (310 + 19 * 5) / 20 = 20.25 ms
}

void TestDetailChoice::decidesSoonerWhereFramesAreSlow()
{
    // 400 ms is what 20 frames may take: four of 99 ms are less, the fifth decides.
    DetailChoice choice{std::vector{part()}, kBudget};
    choice.choose(eyeSeeing(10.0));
    draw(choice, 4, milliseconds{99});
    QCOMPARE(choice.tolerance_px(), 0.5);
    draw(choice, 1, milliseconds{99});
    QCOMPARE(choice.tolerance_px(), 2.0); // 4.95 times too slow, of which 4 count
    draw(choice, 8, milliseconds{60});
    QCOMPARE(choice.tolerance_px(), 6.0); // three times too slow
}

void TestDetailChoice::keepsToAFixedLevel()
{
    ScenePart single = part();
    single.levels.resize(1);
    DetailChoice choice{std::vector{part(), single}, kBudget};
    choice.fix(2);
    QCOMPARE(choice.choose(eyeSeeing(1000.0)), (Levels{2, 0}));
    drawDecided(choice, milliseconds{100});
    QCOMPARE(choice.tolerance_px(), DetailChoice::kFinestTolerance_px);
    choice.fix(-3);
    QCOMPARE(choice.choose(eyeSeeing(10.0)), (Levels{0, 0}));
    choice.fix({});
    QCOMPARE(choice.choose(eyeSeeing(10.0)), (Levels{2, 0}));
}

void TestDetailChoice::keepsItsToleranceForOtherParts()
{
    DetailChoice choice{std::vector{part()}, kBudget};
    choice.choose(eyeSeeing(400.0));
    drawDecided(choice, milliseconds{21});
    choice.setParts(std::vector{part(), part()});
    QCOMPARE(choice.levels(), (Levels{0, 0}));
    QCOMPARE(choice.tolerance_px(), 0.7);
    QCOMPARE(choice.choose(eyeSeeing(400.0)), (Levels{1, 1}));
}

void TestDetailChoice::keepsItsLevelsWhileNobodyLooks()
{
    DetailChoice choice{std::vector{part()}, kBudget};
    choice.choose(eyeSeeing(340.0));
    QCOMPARE(choice.choose({}), Levels{1});
}

void TestDetailChoice::restsInLevelsThatCannotBeSeenToBeCoarser()
{
    const std::vector parts{part()};
    DetailChoice choice{parts, kBudget};
    QCOMPARE(choice.choose(eyeSeeing(3400.0)), Levels{0});
    QVERIFY(choice.isFinest());
    draw(choice, 5, 4 * kBudget); // tolerates 2 pixels
    draw(choice, 5, 4 * kBudget); // and 8: of 1 mm there are 3.4, of 4 mm 13.6
    QVERIFY(!choice.isFinest());
    QCOMPARE(choice.choose(eyeSeeing(3400.0)), Levels{1});
    QCOMPARE(choice.choose(eyeSeeing(3400.0), true), Levels{0});
    QCOMPARE(choice.choose(eyeSeeing(3400.0)), Levels{1});
}

CARINA_TEST(TestDetailChoice)

} // namespace carina::detail_choice_test

#include "tst_detail_choice.moc"
