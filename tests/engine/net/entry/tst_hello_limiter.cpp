#include "engine/net/entry/hello_limiter.h"
#include "tests/support/test_class.h"

#include <algorithm>

namespace carina::hello_limiter_test
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

int admitted(HelloLimiter& limiter, const SourcePrefix& from, int tries, LocalTime now)
{
    int count = 0;
    for (int i = 0; i < tries; ++i)
        count += limiter.admits(from, now) ? 1 : 0;
    return count;
}

} // namespace

class TestHelloLimiter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void letsABurstThroughAndThenAHundredASecond()
    {
        HelloLimiter limiter;
        QCOMPARE(admitted(limiter, source(1), 1000, kStart), 128);
        QCOMPARE(admitted(limiter, source(1), 1000, kStart + 9ms), 0);
        QCOMPARE(admitted(limiter, source(1), 1000, kStart + 10ms), 1);
        QCOMPARE(admitted(limiter, source(1), 1000, kStart + 1010ms), 100);
        QCOMPARE(admitted(limiter, source(1), 1000, kStart + 1h), 128);
    }

    void sourcesDoNotDisturbEachOther()
    {
        HelloLimiter limiter;
        QCOMPARE(admitted(limiter, source(1), 60, kStart), 60);
        QCOMPARE(admitted(limiter, source(2), 60, kStart), 60);
    }

    void allSourcesTogetherHaveABurstAndThenTwoHundredASecond()
    {
        HelloLimiter limiter;
        auto newOnes = [&, next = 0](int tries, LocalTime now) mutable {
            int count = 0;
            for (int i = 0; i < tries; ++i)
                count += limiter.admits(source(std::uint16_t(next++)), now) ? 1 : 0;
            return count;
        };
        QCOMPARE(newOnes(1000, kStart), 256);
        QCOMPARE(newOnes(1000, kStart + 4ms), 0);
        QCOMPARE(newOnes(1000, kStart + 5ms), 1);
        QCOMPARE(newOnes(1000, kStart + 1005ms), 200);
    }

    /// Who floods has what is left over, however many they are.
    void whoComesNewFindsRoomBesidesMany_data()
    {
        QTest::addColumn<int>("flooders");
        for (const int flooders : {1, 4, 40, 400})
            QTest::addRow("%d", flooders) << flooders;
    }
    void whoComesNewFindsRoomBesidesMany()
    {
        QFETCH(const int, flooders);
        HelloLimiter limiter;
        int admittedToFlooders = 0;
        std::uint16_t guest = 10'000;
        // Each of them two hundred times a second; somebody new comes four times a second.
        for (int ms = 0; ms < 20'000; ms += 5) {
            for (int i = 0; i < flooders; ++i)
                admittedToFlooders +=
                    limiter.admits(source(std::uint16_t(i)), kStart + ms * 1ms) ? 1 : 0;
            // After the first seconds, in which the flooders have their own first turns.
            if (ms >= 10'000 && ms % 250 == 0)
                QVERIFY2(limiter.admits(source(guest++), kStart + ms * 1ms),
                         qPrintable(QString::number(ms)));
        }
        QVERIFY(admittedToFlooders <= 256 + 20 * 200);
        QVERIFY(admittedToFlooders >= std::min(flooders * 50, 100) * 15); // they are not shut out
    }
};

CARINA_TEST(TestHelloLimiter)

} // namespace carina::hello_limiter_test

#include "tst_hello_limiter.moc"
