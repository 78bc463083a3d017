#include "engine/display/time_of_light.h"
#include "tests/support/test_class.h"

#include <limits>

namespace carina::time_of_light_test
{

using std::chrono::microseconds;
using std::chrono::milliseconds;

namespace
{

constexpr LocalTime kBegun{std::chrono::seconds{100}};
constexpr double kHertz = 100.0; // half a refresh is 5 ms

TimeOfLight after(std::initializer_list<int> drawing_ms)
{
    TimeOfLight time;
    for (const int each : drawing_ms)
        time.frameTook(milliseconds{each});
    return time;
}

/// From the beginning of a frame to its light.
Duration ahead(TimeOfLight time, double refreshRate = kHertz)
{
    return time.of(kBegun, refreshRate) - kBegun;
}

} // namespace

class TestTimeOfLight : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isHalfARefreshBeforeAnythingWasDrawn();
    void addsTheMedianFrame();
    void forgetsOldFrames();
    void looksNoFurtherAheadThanItCan();
    void takesSixtyHertzWhereTheScreenDoesNotKnow_data();
    void takesSixtyHertzWhereTheScreenDoesNotKnow();
    void neverRunsBackwards();
};

void TestTimeOfLight::isHalfARefreshBeforeAnythingWasDrawn()
{
    QCOMPARE(ahead(TimeOfLight{}), milliseconds{5});
}

void TestTimeOfLight::addsTheMedianFrame()
{
    QCOMPARE(ahead(after({7})), milliseconds{12});
    QCOMPARE(ahead(after({7, 900, 8})), milliseconds{13}); // not the mean, not the longest
    QCOMPARE(ahead(after({1, 2, 30, 4, 30})), milliseconds{9});
}

void TestTimeOfLight::forgetsOldFrames()
{
    TimeOfLight time;
    for (std::size_t i = 0; i < TimeOfLight::kKept; ++i)
        time.frameTook(milliseconds{30});
    for (std::size_t i = 0; i < TimeOfLight::kKept / 2; ++i)
        time.frameTook(milliseconds{10});
    QCOMPARE(ahead(time), milliseconds{35}); // 16 of 31 are old
    time.frameTook(milliseconds{10});
    QCOMPARE(ahead(time), milliseconds{15});
}

void TestTimeOfLight::looksNoFurtherAheadThanItCan()
{
    QCOMPARE(ahead(after({45})), milliseconds{50});
    QCOMPARE(ahead(after({46})), milliseconds{50});
    QCOMPARE(ahead(after({100'000})), TimeOfLight::kFarthest);
}

void TestTimeOfLight::takesSixtyHertzWhereTheScreenDoesNotKnow_data()
{
    QTest::addColumn<double>("refreshRate");
    QTest::addColumn<qint64>("half_ns");
    QTest::newRow("90 Hz") << 90.0 << qint64{5'555'556};
    QTest::newRow("20 Hz") << 20.0 << qint64{25'000'000};
    QTest::newRow("1000 Hz") << 1000.0 << qint64{500'000};
    for (const double rate : {0.0, -60.0, 19.9, 1000.1, std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()})
        QTest::addRow("%g Hz", rate) << rate << qint64{8'333'333};
}

void TestTimeOfLight::takesSixtyHertzWhereTheScreenDoesNotKnow()
{
    QFETCH(double, refreshRate);
    QFETCH(qint64, half_ns);
    QCOMPARE(qint64(ahead(TimeOfLight{}, refreshRate).count()), half_ns);
}

void TestTimeOfLight::neverRunsBackwards()
{
    TimeOfLight time = after({40});
    QCOMPARE(time.of(kBegun, kHertz), kBegun + milliseconds{45});
    for (int i = 0; i < 2; ++i)
        time.frameTook(milliseconds{1});
    QCOMPARE(time.of(kBegun + milliseconds{2}, kHertz), kBegun + milliseconds{45});
    QCOMPARE(time.of(kBegun + milliseconds{60}, kHertz), kBegun + milliseconds{66});
}

CARINA_TEST(TestTimeOfLight)

} // namespace carina::time_of_light_test

#include "tst_time_of_light.moc"
