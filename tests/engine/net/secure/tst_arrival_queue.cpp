#include "engine/net/secure/arrival_queue.h"
#include "tests/support/test_class.h"

namespace carina::arrival_queue_test
{
namespace
{

Endpoint source(std::uint16_t port)
{
    return endpoint(QHostAddress{QHostAddress::LocalHost}, port);
}

RawDatagram numbered(std::uint16_t from, int number)
{
    return {QByteArray::number(number), QHostAddress{QHostAddress::LocalHost}, from, {}};
}

void add(ArrivalQueue& queue, std::uint16_t from, int number, bool isKnown = true)
{
    queue.add(source(from), numbered(from, number), isKnown);
}

} // namespace

class TestArrivalQueue : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void oneWhoSendsManyDelaysOnlyItsOwn()
    {
        ArrivalQueue queue;
        for (int i = 0; i < 200; ++i)
            add(queue, 1, i);
        add(queue, 2, 0);
        add(queue, 3, 0);
        QVERIFY(queue.next()->port == 1);
        QVERIFY(queue.next()->port == 2);
        QVERIFY(queue.next()->port == 3);
        for (int i = 1; i < 200; ++i) {
            const auto datagram = queue.next();
            QVERIFY(datagram && datagram->port == 1);
            QCOMPARE(datagram->bytes.toInt(), i); // in their order
        }
        QVERIFY(queue.empty());
        QVERIFY(!queue.next());
    }

    void ofOneSourceTheOldestAreDropped()
    {
        ArrivalQueue queue;
        constexpr int kTooMany = 100;
        add(queue, 2, 7);
        for (int i = 0; i < int(ArrivalQueue::kMostOfOne) + kTooMany; ++i)
            add(queue, 1, i);
        QCOMPARE(queue.next()->bytes.toInt(), 7);
        for (int i = kTooMany; i < int(ArrivalQueue::kMostOfOne) + kTooMany; ++i)
            QCOMPARE(queue.next()->bytes.toInt(), i);
        QVERIFY(!queue.next());
    }

    void whoSendsMostLosesWhereAllAreTooMany()
    {
        ArrivalQueue queue;
        for (std::uint16_t from = 1; from <= 40; ++from)
            for (int i = 0; i < 200; ++i)
                add(queue, from, i);
        add(queue, 99, 0);
        std::size_t size = 0;
        bool isHeard = false;
        while (const auto datagram = queue.next()) {
            ++size;
            isHeard = isHeard || datagram->port == 99;
        }
        QCOMPARE(size, ArrivalQueue::kMost);
        QVERIFY(isHeard);
    }

    /// Forged addresses are as many as their sender likes.
    void strangersBeyondANumberStandInOnePlace()
    {
        ArrivalQueue queue;
        for (std::uint16_t from = 1000; from < 3000; ++from)
            add(queue, from, 0, false);
        add(queue, 7, 0, true);
        std::size_t before = 0;
        while (queue.next()->port != 7)
            ++before;
        QVERIFY(before <= ArrivalQueue::kMostStrangers + 1);
    }

    void isEmptyOnceItIsCleared()
    {
        ArrivalQueue queue;
        add(queue, 1, 0, false);
        queue.clear();
        QVERIFY(queue.empty() && !queue.next());
        add(queue, 1, 5, false);
        QCOMPARE(queue.next()->bytes.toInt(), 5);
    }
};

CARINA_TEST(TestArrivalQueue)

} // namespace carina::arrival_queue_test

#include "tst_arrival_queue.moc"
