#include "apps/lab/network/loopback_round_trip.h"
#include "engine/core/monotonic_clock.h"
#include "tests/support/test_class.h"

namespace carina::lab::loopback_round_trip_test
{

class LoopbackRoundTripTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// 400 exchanges fit into the time that all took, half of them take the median or longer.
    void isWithinTheTimeItTook()
    {
        const LocalTime begin = monotonicNow();
        const auto measured = loopbackRoundTrip();
        const Duration passed = monotonicNow() - begin;
        QVERIFY2(measured, measured ? "" : measured.error().detail.c_str());
        QVERIFY(measured->median > Duration{0});
        QVERIFY(measured->p95 >= measured->median);
        QVERIFY(200 * measured->median <= passed);
        QVERIFY(20 * measured->p95 <= passed);
    }
};

CARINA_TEST(LoopbackRoundTripTest)

} // namespace carina::lab::loopback_round_trip_test

#include "tst_loopback_round_trip.moc"
