#include "engine/tracking/device_clock.h"

#include "tests/support/test_class.h"

#include <random>

namespace carina::device_clock_test
{
namespace
{

using std::chrono::milliseconds;

constexpr Duration kOffset = std::chrono::hours{400'000}; ///< about since 1970
constexpr Duration kTolerance = milliseconds{1};

} // namespace

class DeviceClockTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesTheQuickestSampleForAtOnce()
    {
        std::mt19937 random{7};
        std::exponential_distribution<double> wait{1.0 / 5e6}; // 5 ms
        DeviceClock clock;
        for (int i = 0; i < 2000; ++i) {
            const LocalTime exposed{milliseconds{20 * i}};
            const LocalTime arrived = exposed + Duration{std::int64_t(wait(random))};
            const LocalTime told = clock.local(exposed.time_since_epoch() + kOffset, arrived);
            QVERIFY(told <= arrived);
            if (i > 300)
                QVERIFY(told - exposed >= Duration{} && told - exposed < kTolerance);
        }
    }

    void beginsAnewWithAClockThatWasSet()
    {
        DeviceClock clock;
        const auto told = [&](int ms, Duration offset) {
            const LocalTime at{milliseconds{ms}};
            return clock.local(at.time_since_epoch() + offset, at) == at;
        };
        for (int i = 0; i < 50; ++i)
            QVERIFY(told(20 * i, kOffset));
        for (int i = 50; i < 100; ++i) // back, so that all delays are longer
            QVERIFY(told(20 * i, kOffset - std::chrono::hours{1}));
        for (int i = 100; i < 150; ++i) // forward
            QVERIFY(told(20 * i, kOffset));
    }
};

CARINA_TEST(DeviceClockTest)

} // namespace carina::device_clock_test

#include "tst_device_clock.moc"
