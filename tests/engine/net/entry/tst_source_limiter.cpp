#include "engine/net/entry/source_limiter.h"
#include "tests/support/test_class.h"

namespace carina::source_limiter_test
{
namespace
{

using namespace std::chrono_literals;

constexpr LocalTime kStart{100s};

SourcePrefix source(std::uint16_t number)
{
    SourcePrefix prefix{};
    prefix[0] = std::uint8_t(number >> 8);
    prefix[1] = std::uint8_t(number & 0xFF);
    return prefix;
}

int admitted(SourceLimiter& limiter, const SourcePrefix& from, int tries, LocalTime now)
{
    int count = 0;
    for (int i = 0; i < tries; ++i)
        count += limiter.admits(from, now) ? 1 : 0;
    return count;
}

} // namespace

class TestSourceLimiter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void letsABurstThroughAndThenFiftyASecond()
    {
        SourceLimiter limiter;
        QCOMPARE(admitted(limiter, source(1), 1000, kStart), 128);
        QCOMPARE(admitted(limiter, source(1), 1000, kStart + 19ms), 0);
        QCOMPARE(admitted(limiter, source(1), 1000, kStart + 20ms), 1);
        QCOMPARE(admitted(limiter, source(1), 1000, kStart + 1020ms), 50);
        QCOMPARE(admitted(limiter, source(1), 1000, kStart + 1h), 128);
    }

    void sourcesDoNotDisturbEachOther()
    {
        SourceLimiter limiter;
        QCOMPARE(admitted(limiter, source(1), 1000, kStart), 128);
        QCOMPARE(admitted(limiter, source(2), 1000, kStart), 128);
    }

    void letsThroughAtTheRateThatIsGiven()
    {
        SourceLimiter limiter{BurstRate{10, 250ms}};
        QCOMPARE(admitted(limiter, source(1), 1000, kStart), 10);
        QCOMPARE(admitted(limiter, source(1), 1000, kStart + 1s), 4);
        QCOMPARE(admitted(limiter, source(2), 1000, kStart + 1s), 10);
    }

    void countlessSourcesShareOneAllowance()
    {
        SourceLimiter limiter;
        for (std::uint16_t i = 0; i < SourceLimiter::kMostSources; ++i)
            QVERIFY(limiter.admits(source(i), kStart));
        int others = 0;
        for (std::uint16_t i = 0; i < 500; ++i)
            others += limiter.admits(source(std::uint16_t(5000 + i)), kStart) ? 1 : 0;
        QCOMPARE(others, 128);
        QVERIFY(limiter.admits(source(0), kStart)); // one that is known
        // Those who fell quiet make room.
        QCOMPARE(admitted(limiter, source(9000), 1000, kStart + 1s), 128);
    }
};

CARINA_TEST(TestSourceLimiter)

} // namespace carina::source_limiter_test

#include "tst_source_limiter.moc"
