#include "engine/sync/strategies/playout_buffer.h"
#include "tests/support/test_class.h"

namespace carina::playout_buffer_test
{
namespace
{

using namespace std::chrono_literals;

constexpr double kTolerance_m = 1e-12;
constexpr Duration kPeriod = PlayoutBuffer::kPeriod;

ActedPose atX(double x, double scale = 1.0)
{
    return {RigidTransform::translation(Vec3{x, 0.0, 0.0}), scale};
}

double drawnX(const PlayoutBuffer& buffer, LocalTime t)
{
    return buffer.at(t).X_AO.translation().x();
}

} // namespace

class TestPlayoutBuffer : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void drawsOnePeriodLateOnASteadyPath()
    {
        // 1 m/s, sent every period by a clock 5 s behind, 40 ms on the way.
        PlayoutBuffer buffer;
        for (int i = 0; i < 100; ++i)
            buffer.add(SessionTime{i * kPeriod}, atX(toSeconds(i * kPeriod)),
                       LocalTime{5s + i * kPeriod + 40ms});
        QCOMPARE(buffer.playout(), 5s + 40ms + kPeriod);
        const LocalTime t{5s + 99 * kPeriod + 40ms};
        QVERIFY(std::abs(drawnX(buffer, t) - toSeconds(98 * kPeriod)) < kTolerance_m);
        QVERIFY(std::abs(drawnX(buffer, t + 10ms) - toSeconds(98 * kPeriod + 10ms)) < kTolerance_m);
    }

    void standsStillBeyondTheNewestAndBeforeTheOldest()
    {
        PlayoutBuffer buffer;
        buffer.add(SessionTime{1s}, atX(1.0), LocalTime{1s});
        buffer.add(SessionTime{1s + kPeriod}, atX(2.0), LocalTime{1s + kPeriod});
        QCOMPARE(drawnX(buffer, LocalTime{9s}), 2.0);
        QCOMPARE(drawnX(buffer, LocalTime{500ms}), 1.0);
    }

    void interpolatesTheSizeByItsRatio()
    {
        PlayoutBuffer buffer;
        buffer.add(SessionTime{}, atX(0.0, 1.0), LocalTime{});
        buffer.add(SessionTime{2 * kPeriod}, atX(0.0, 4.0), LocalTime{2 * kPeriod});
        QVERIFY(std::abs(buffer.at(LocalTime{2 * kPeriod}).scale - 2.0) < 1e-9);
    }

    void sortsWhatWasOvertaken()
    {
        PlayoutBuffer buffer;
        const LocalTime now{2 * kPeriod};
        buffer.add(SessionTime{}, atX(0.0), LocalTime{});
        buffer.add(SessionTime{2 * kPeriod}, atX(2.0), now);
        buffer.add(SessionTime{kPeriod}, atX(1.5), now);
        const Duration back = buffer.playout() - kPeriod;
        QVERIFY(std::abs(drawnX(buffer, now + back) - 1.5) < kTolerance_m);
    }

    void growsWithTheJitterButOnlyATenthOfTheTime()
    {
        // 10 ms at first; then every tenth snapshot is 30 ms later, so the 95th percentile is too.
        PlayoutBuffer buffer;
        for (int i = 0; i < 120; ++i)
            buffer.add(SessionTime{i * kPeriod}, atX(0.0), LocalTime{i * kPeriod + 10ms});
        QCOMPARE(buffer.playout(), 10ms + kPeriod);
        Duration last = buffer.playout();
        for (int i = 120; i < 360; ++i) {
            const LocalTime now{i * kPeriod + (i % 10 == 0 ? 40ms : 10ms)};
            buffer.add(SessionTime{i * kPeriod}, atX(0.0), now);
            QVERIFY(buffer.playout() - last <= (kPeriod + 30ms) / 10);
            last = buffer.playout();
        }
        QCOMPARE(buffer.playout(), 40ms + kPeriod);
    }
};

CARINA_TEST(TestPlayoutBuffer)

} // namespace carina::playout_buffer_test

#include "tst_playout_buffer.moc"
