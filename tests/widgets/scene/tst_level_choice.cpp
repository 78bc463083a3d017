#include "widgets/scene/frame_statistics.h"
#include "widgets/scene/level_choice.h"

#include <QTest>

using namespace carina;
using std::chrono::milliseconds;

namespace
{

constexpr Duration kBudget = milliseconds{20};

void draw(LevelChoice& choice, int frames, Duration each)
{
    for (int i = 0; i < frames; ++i)
        choice.frameTook(each);
}

} // namespace

class TestLevelChoice : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void startsWithTheFinestLevelOfModestSize_data();
    void startsWithTheFinestLevelOfModestSize();
    void goesCoarserOnlyAboveTheBudget();
    void goesFinerWhenThatWillStayComfortable();
    void doesNotLeaveTheLastLevels();
    void judgesTheMeanOfAWholeRun();
    void measuresFramesPerSecondAndDrawing();
    void forgetsFramesBeyondThoseKept();
    void statesNothingBeforeAFrame();
};

void TestLevelChoice::startsWithTheFinestLevelOfModestSize_data()
{
    QTest::addColumn<std::vector<std::size_t>>("triangles");
    QTest::addColumn<int>("level");
    using Levels = std::vector<std::size_t>;
    QTest::newRow("nothing to draw") << Levels{} << 0;
    QTest::newRow("one level, large") << Levels{2'000'000} << 0;
    QTest::newRow("just small enough") << Levels{150'000, 10} << 0;
    QTest::newRow("just too large") << Levels{150'001, 10} << 1;
    QTest::newRow("none small enough") << Levels{900'000, 500'000, 300'000} << 2;
}

void TestLevelChoice::startsWithTheFinestLevelOfModestSize()
{
    QFETCH(std::vector<std::size_t>, triangles);
    QTEST(LevelChoice(triangles, kBudget).level(), "level");
}

void TestLevelChoice::goesCoarserOnlyAboveTheBudget()
{
    LevelChoice choice({100'000, 50'000, 10'000}, kBudget);
    draw(choice, LevelChoice::kFramesPerDecision, kBudget);
    QCOMPARE(choice.level(), 0);
    draw(choice, LevelChoice::kFramesPerDecision - 1, kBudget + Duration{1});
    QCOMPARE(choice.level(), 0);
    draw(choice, 1, kBudget + Duration{1});
    QCOMPARE(choice.level(), 1);
}

void TestLevelChoice::goesFinerWhenThatWillStayComfortable()
{
    // Twice the triangles are expected to take twice as long; comfort is 0.6 of 20 ms.
    LevelChoice choice({400'000, 200'000, 100'000}, kBudget);
    QCOMPARE(choice.level(), 2);
    draw(choice, LevelChoice::kFramesPerDecision, milliseconds{6});
    QCOMPARE(choice.level(), 2);
    draw(choice, LevelChoice::kFramesPerDecision, milliseconds{6} - Duration{1});
    QCOMPARE(choice.level(), 1);
    draw(choice, LevelChoice::kFramesPerDecision, milliseconds{12});
    QCOMPARE(choice.level(), 1);
}

void TestLevelChoice::doesNotLeaveTheLastLevels()
{
    LevelChoice choice({100, 50}, kBudget);
    draw(choice, 2 * LevelChoice::kFramesPerDecision, milliseconds{100});
    QCOMPARE(choice.level(), 1);
    draw(choice, 2 * LevelChoice::kFramesPerDecision, milliseconds{1});
    QCOMPARE(choice.level(), 0);
    LevelChoice nothing({}, kBudget);
    draw(nothing, LevelChoice::kFramesPerDecision, milliseconds{100});
    QCOMPARE(nothing.level(), 0);
}

void TestLevelChoice::judgesTheMeanOfAWholeRun()
{
    LevelChoice choice({100'000, 50'000}, kBudget);
    draw(choice, 1, milliseconds{300});
    draw(choice, LevelChoice::kFramesPerDecision - 1, milliseconds{5});
    QCOMPARE(choice.level(), 0); // (300 + 19 * 5) / 20 = 19.75 ms
    draw(choice, 1, milliseconds{310});
    draw(choice, LevelChoice::kFramesPerDecision - 1, milliseconds{5});
    QCOMPARE(choice.level(), 1); // (310 + 19 * 5) / 20 = 20.25 ms
}

void TestLevelChoice::measuresFramesPerSecondAndDrawing()
{
    FrameTimes times;
    for (int i = 0; i < 5; ++i) {
        const LocalTime asked{milliseconds{100 + 20 * i}};
        times.add(asked, asked + milliseconds{i == 3 ? 9 : 4});
    }
    const FrameStatistics statistics = times.statistics();
    QCOMPARE(statistics.framesPerSecond, 50.0);
    QCOMPARE(statistics.medianDrawing.count(), Duration(milliseconds{4}).count());
    QCOMPARE(statistics.worstDrawing.count(), Duration(milliseconds{9}).count());
    QCOMPARE(statistics.frames, std::size_t{5});
}

void TestLevelChoice::forgetsFramesBeyondThoseKept()
{
    FrameTimes times;
    LocalTime swapped{};
    times.add(swapped, swapped); // a second before the others
    swapped += milliseconds{1000};
    for (std::size_t i = 0; i < FrameTimes::kKept; ++i, swapped += milliseconds{10})
        times.add(swapped, swapped);
    QCOMPARE(times.statistics().framesPerSecond, 100.0);
    QCOMPARE(times.statistics().frames, FrameTimes::kKept + 1);
}

void TestLevelChoice::statesNothingBeforeAFrame()
{
    FrameTimes times;
    QCOMPARE(times.statistics().framesPerSecond, 0.0);
    QCOMPARE(times.statistics().frames, std::size_t{0});
    times.add(LocalTime{}, LocalTime{milliseconds{3}});
    QCOMPARE(times.statistics().framesPerSecond, 0.0);
    QCOMPARE(times.statistics().frames, std::size_t{1});
}

QTEST_GUILESS_MAIN(TestLevelChoice)
#include "tst_level_choice.moc"
