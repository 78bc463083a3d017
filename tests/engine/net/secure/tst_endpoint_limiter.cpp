#include "engine/net/entry/hello_limiter.h"
#include "engine/net/secure/endpoint_limiter.h"
#include "tests/support/test_class.h"

namespace carina::endpoint_limiter_test
{
namespace
{

using namespace std::chrono_literals;

constexpr LocalTime kStart{100s};

Endpoint portOf(std::uint16_t port)
{
    return endpoint(QHostAddress{QStringLiteral("192.0.2.1")}, port);
}

int admitted(EndpointLimiter& limiter, const Endpoint& from, int tries, LocalTime now)
{
    int count = 0;
    for (int i = 0; i < tries; ++i) {
        if (!limiter.hasRoom(from, now))
            continue;
        limiter.count(from, now);
        ++count;
    }
    return count;
}

} // namespace

class TestEndpointLimiter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void letsAFewThroughAndThenTwoASecond()
    {
        EndpointLimiter limiter;
        QCOMPARE(admitted(limiter, portOf(1), 1000, kStart), 8);
        QCOMPARE(admitted(limiter, portOf(1), 1000, kStart + 499ms), 0);
        QCOMPARE(admitted(limiter, portOf(1), 1000, kStart + 500ms), 1);
        QCOMPARE(admitted(limiter, portOf(1), 1000, kStart + 1500ms), 2);
        QCOMPARE(admitted(limiter, portOf(1), 1000, kStart + 1h), 8);
    }

    void portsDoNotDisturbEachOther()
    {
        EndpointLimiter limiter;
        QCOMPARE(admitted(limiter, portOf(1), 1000, kStart), 8);
        QCOMPARE(admitted(limiter, portOf(2), 1000, kStart), 8);
    }

    void oneThatIsOnlyAskedForIsNotCounted()
    {
        const EndpointLimiter limiter;
        for (int i = 0; i < 1000; ++i)
            QVERIFY(limiter.hasRoom(portOf(1), kStart));
    }

    void onePortTakesASmallPartOfItsAddress()
    {
        QVERIFY(EndpointLimiter::kRate.burst * 16 <= HelloLimiter::kRate.burst);
        QVERIFY(EndpointLimiter::kRate.interval >= 25 * HelloLimiter::kRate.interval);
    }
};

CARINA_TEST(TestEndpointLimiter)

} // namespace carina::endpoint_limiter_test

#include "tst_endpoint_limiter.moc"
