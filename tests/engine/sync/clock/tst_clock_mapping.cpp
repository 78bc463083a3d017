#include "engine/sync/clock/clock_mapping.h"
#include "tests/support/test_class.h"

namespace carina::clock_mapping_test
{
namespace
{

using namespace std::chrono_literals;

constexpr Duration kOffset = 3h;

LocalTime at(Duration t) { return LocalTime{t}; }

/// A clock that works off a correction from 10 s on.
ClockMapping correctedBy(Duration correction)
{
    ClockMapping mapping{at(0s), kOffset};
    mapping.slewTo(kOffset + correction, at(10s));
    return mapping;
}

} // namespace

class TestClockMapping : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void correctionsAreSlewedNotStepped()
    {
        const ClockMapping mapping = correctedBy(2ms);
        QCOMPARE(mapping.at(at(10s)).time_since_epoch(), Duration{10s + kOffset});
        QCOMPARE(mapping.toGo(at(10s)), Duration{2ms});
        // 500 ppm: 0.5 ms after a second, all of it after four.
        QCOMPARE(mapping.at(at(11s)).time_since_epoch(), Duration{11s + kOffset + 500us});
        QCOMPARE(mapping.at(at(14s)).time_since_epoch(), Duration{14s + kOffset + 2ms});
        QCOMPARE(mapping.at(at(19s)).time_since_epoch(), Duration{19s + kOffset + 2ms});
        QCOMPARE(mapping.toGo(at(19s)), Duration{});
        // The past is not rewritten.
        QCOMPARE(mapping.at(at(9s)).time_since_epoch(), Duration{9s + kOffset});
    }

    void isInvertedToANanosecond()
    {
        for (const ClockMapping& mapping :
             {correctedBy(40ms), correctedBy(-40ms), ClockMapping{at(5s), kOffset, 80e-6}})
            for (LocalTime t = at(0s); t < at(200s); t += 777ms) {
                const Duration error = mapping.localAt(mapping.at(t)) - t;
                QVERIFY(error >= -1ns && error <= 1ns);
            }
    }

    void correctionsTheOtherWayNeverRunBackwards()
    {
        const ClockMapping mapping = correctedBy(-40ms);
        SessionTime last = mapping.at(at(9s));
        for (LocalTime t = at(9s); t < at(100s); t += 7ms) {
            QVERIFY(mapping.at(t + 7ms) > last);
            last = mapping.at(t + 7ms);
        }
        QCOMPARE(mapping.at(at(90s)).time_since_epoch(), Duration{90s + kOffset - 40ms});
    }

    void skewRunsBesideTheCorrection()
    {
        ClockMapping mapping{at(0s), kOffset};
        mapping.slewTo(kOffset + 1ms, at(0s), 100e-6);
        QCOMPARE(mapping.at(at(1s)).time_since_epoch(), Duration{1s + kOffset + 600us});
        QCOMPARE(mapping.at(at(10s)).time_since_epoch(), Duration{10s + kOffset + 2ms});
    }

    void newCorrectionGoesOnFromTheOld()
    {
        ClockMapping mapping{at(0s), kOffset};
        mapping.slewTo(kOffset + 2ms, at(0s));
        mapping.slewTo(kOffset - 1ms, at(2s)); // half of it done
        QCOMPARE(mapping.at(at(2s)).time_since_epoch(), Duration{2s + kOffset + 1ms});
        QCOMPARE(mapping.toGo(at(2s)), Duration{-2ms});
        QCOMPARE(mapping.at(at(3s)).time_since_epoch(), Duration{3s + kOffset + 500us});
        QCOMPARE(mapping.at(at(10s)).time_since_epoch(), Duration{10s + kOffset - 1ms});
    }
};

CARINA_TEST(TestClockMapping)

} // namespace carina::clock_mapping_test

#include "tst_clock_mapping.moc"
