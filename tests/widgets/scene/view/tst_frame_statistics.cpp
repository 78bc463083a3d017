#include "tests/support/test_class.h"
#include "widgets/scene/view/frame_statistics.h"

namespace carina::frame_statistics_test
{

using std::chrono::milliseconds;

class TestFrameStatistics : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void measuresFramesPerSecondAndDrawing();
    void forgetsFramesBeyondThoseKept();
    void statesNothingBeforeAFrame();
};

void TestFrameStatistics::measuresFramesPerSecondAndDrawing()
{
    FrameTimes times;
    for (int i = 0; i < 5; ++i) {
        const LocalTime asked{milliseconds{100 + 20 * i}};
        times.add(asked, asked + milliseconds{i == 3 ? 9 : 4});
    }
    const FrameStatistics statistics = times.statistics();
    QCOMPARE(statistics.framesPerSecond, 50.0);
    QCOMPARE(statistics.medianDrawing.count(), Duration(milliseconds{4}).count());
    QCOMPARE(statistics.frames, std::size_t{5});
}

void TestFrameStatistics::forgetsFramesBeyondThoseKept()
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

void TestFrameStatistics::statesNothingBeforeAFrame()
{
    FrameTimes times;
    QCOMPARE(times.statistics().framesPerSecond, 0.0);
    QCOMPARE(times.statistics().frames, std::size_t{0});
    times.add(LocalTime{}, LocalTime{milliseconds{3}});
    QCOMPARE(times.statistics().framesPerSecond, 0.0);
    QCOMPARE(times.statistics().frames, std::size_t{1});
}

CARINA_TEST(TestFrameStatistics)

} // namespace carina::frame_statistics_test

#include "tst_frame_statistics.moc"
