#include "engine/sync/facts/fact_replication.h"
#include "tests/support/test_class.h"

namespace carina::fact_replication_test
{
namespace
{

using namespace std::chrono_literals;

LocalTime at(Duration t) { return LocalTime{t}; }

FactRecord fact(std::uint64_t number)
{
    FactRecord record;
    record.number = FactNumber{number};
    record.body = {std::byte{1}};
    return record;
}

ProposalRecord proposal(std::uint64_t id, std::size_t size = 1)
{
    return {ProposalId{id}, kNobody, StationId{}, std::vector<std::byte>(size, std::byte{1})};
}

std::vector<std::uint64_t> numbers(const std::vector<FactRecord>& facts)
{
    std::vector<std::uint64_t> result;
    for (const FactRecord& f : facts)
        result.push_back(f.number.value);
    return result;
}

std::vector<std::uint64_t> ids(const std::vector<ProposalRecord>& proposals)
{
    std::vector<std::uint64_t> result;
    for (const ProposalRecord& p : proposals)
        result.push_back(p.id.value);
    return result;
}

using Numbers = std::vector<std::uint64_t>;

/// First and last of what is due; empty when nothing is.
Numbers due(FactSender& sender, std::uint64_t logEnd, LocalTime now, Duration roundTrip = 0ms)
{
    const FactRange range = sender.takeDue(FactNumber{logEnd}, roundTrip, now);
    return range.first <= range.last ? Numbers{range.first.value, range.last.value} : Numbers{};
}

} // namespace

class TestFactReplication : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sendsEachFactOnceWhileItIsUnderWay()
    {
        FactSender sender{FactNumber{3}};
        QCOMPARE(due(sender, 3, at(0ms)), Numbers{});
        QCOMPARE(due(sender, 5, at(0ms)), (Numbers{4, 5}));
        QCOMPARE(due(sender, 5, at(1ms)), Numbers{});
        QCOMPARE(due(sender, 6, at(2ms)), (Numbers{6, 6}));
    }

    void repeatsFromTheFirstThatIsNotAcknowledged()
    {
        FactSender sender{FactNumber{0}};
        QCOMPARE(due(sender, 3, at(0ms), 20ms), (Numbers{1, 3}));
        sender.acknowledge(FactNumber{1}, 20ms, at(10ms));
        QCOMPARE(sender.acknowledged(), FactNumber{1});
        // 50 ms and the round trip after the acknowledgement.
        QCOMPARE(sender.nextDue(FactNumber{3}), at(80ms));
        QCOMPARE(due(sender, 3, at(80ms - 1ns), 20ms), Numbers{});
        QCOMPARE(due(sender, 3, at(80ms), 20ms), (Numbers{2, 3}));
    }

    void repeatsMoreAndMoreSlowly()
    {
        FactSender sender{FactNumber{0}};
        Duration t{};
        QCOMPARE(due(sender, 1, at(t)), (Numbers{1, 1}));
        for (const Duration wait : {50ms, 100ms, 200ms, 400ms, 800ms, 1000ms, 1000ms}) {
            QCOMPARE(sender.nextDue(FactNumber{1}), at(t + wait));
            t += wait;
            QCOMPARE(due(sender, 1, at(t)), (Numbers{1, 1}));
        }
        sender.acknowledge(FactNumber{1}, 0ms, at(t));
        QCOMPARE(sender.nextDue(FactNumber{1}), LocalTime::max());
        QCOMPARE(due(sender, 2, at(t)), (Numbers{2, 2}));
        QCOMPARE(sender.nextDue(FactNumber{2}), at(t + 50ms));
    }

    void newFactsDoNotPutOffTheRepeat()
    {
        FactSender sender{FactNumber{0}};
        QCOMPARE(due(sender, 1, at(0ms)), (Numbers{1, 1}));
        QCOMPARE(due(sender, 2, at(30ms)), (Numbers{2, 2}));
        QCOMPARE(due(sender, 2, at(50ms)), (Numbers{1, 2}));
    }

    void windowPacesALongLog()
    {
        FactSender sender{FactNumber{0}};
        QCOMPARE(due(sender, 1000, at(0ms)), (Numbers{1, 64}));
        QCOMPARE(due(sender, 1000, at(1ms)), Numbers{});
        QCOMPARE(sender.nextDue(FactNumber{1000}), at(50ms));
        sender.acknowledge(FactNumber{10}, 0ms, at(2ms));
        QCOMPARE(sender.nextDue(FactNumber{1000}), LocalTime::min());
        QCOMPARE(due(sender, 1000, at(2ms)), (Numbers{65, 74}));
        sender.acknowledge(FactNumber{74}, 0ms, at(3ms));
        QCOMPARE(due(sender, 100, at(3ms)), (Numbers{75, 100}));
    }

    void ignoresAcknowledgementsThatCannotBe()
    {
        FactSender sender{FactNumber{5}};
        QCOMPARE(due(sender, 9, at(0ms)), (Numbers{6, 9}));
        sender.acknowledge(FactNumber{10}, 0ms, at(1ms));
        QCOMPARE(sender.acknowledged(), FactNumber{5});
        sender.acknowledge(FactNumber{4}, 0ms, at(1ms));
        QCOMPARE(sender.acknowledged(), FactNumber{5});
        QCOMPARE(sender.nextDue(FactNumber{9}), at(50ms));
        sender.acknowledge(FactNumber{9}, 0ms, at(1ms));
        QCOMPARE(sender.acknowledged(), FactNumber{9});
    }

    void repeatedAcknowledgementDoesNotPutOffTheRepeat()
    {
        FactSender sender{FactNumber{0}};
        QCOMPARE(due(sender, 2, at(0ms)), (Numbers{1, 2}));
        sender.acknowledge(FactNumber{1}, 0ms, at(10ms));
        sender.acknowledge(FactNumber{1}, 0ms, at(40ms));
        QCOMPARE(sender.nextDue(FactNumber{2}), at(60ms));
    }

    void putsFactsIntoOrder()
    {
        FactReceiver receiver;
        QCOMPARE(numbers(receiver.take(fact(1))), (Numbers{1}));
        QCOMPARE(numbers(receiver.take(fact(3))), Numbers{});
        QCOMPARE(numbers(receiver.take(fact(5))), Numbers{});
        QCOMPARE(receiver.last(), FactNumber{1});
        QCOMPARE(numbers(receiver.take(fact(2))), (Numbers{2, 3}));
        QCOMPARE(receiver.last(), FactNumber{3});
        QCOMPARE(numbers(receiver.take(fact(4))), (Numbers{4, 5}));
        QCOMPARE(receiver.last(), FactNumber{5});
    }

    void takesEachFactOnce()
    {
        FactReceiver receiver;
        QCOMPARE(numbers(receiver.take(fact(1))), (Numbers{1}));
        QCOMPARE(numbers(receiver.take(fact(1))), Numbers{});
        QCOMPARE(numbers(receiver.take(fact(3))), Numbers{});
        QCOMPARE(numbers(receiver.take(fact(3))), Numbers{});
        QCOMPARE(numbers(receiver.take(fact(2))), (Numbers{2, 3}));
        QCOMPARE(numbers(receiver.take(fact(2))), Numbers{});
    }

    void keepsNoMoreThanAWindow()
    {
        FactReceiver receiver;
        QVERIFY(receiver.take(fact(64)).empty()); // the last within the window of an empty log
        QVERIFY(receiver.take(fact(65)).empty()); // the first beyond it
        for (std::uint64_t n = 1; n < 63; ++n)
            QCOMPARE(numbers(receiver.take(fact(n))), (Numbers{n}));
        QCOMPARE(numbers(receiver.take(fact(63))), (Numbers{63, 64}));
        QCOMPARE(receiver.last(), FactNumber{64});
    }

    void proposalsGoOutFromTheOldestOn()
    {
        ProposalQueue queue;
        QCOMPARE(queue.nextDue(), LocalTime::max());
        queue.add(proposal(1), at(5ms));
        QCOMPARE(queue.nextDue(), at(5ms));
        QCOMPARE(ids(queue.takeDue(1000, at(5ms))), (Numbers{1}));
        QCOMPARE(queue.nextDue(), at(105ms));
        QCOMPARE(ids(queue.takeDue(1000, at(105ms - 1ns))), Numbers{});
        queue.add(proposal(2), at(20ms));
        QCOMPARE(ids(queue.takeDue(1000, at(20ms))), (Numbers{1, 2}));
        QCOMPARE(ids(queue.takeDue(1000, at(120ms))), (Numbers{1, 2}));
    }

    void settledProposalsAreForgotten()
    {
        ProposalQueue queue;
        for (const std::uint64_t id : {1U, 2U, 3U})
            queue.add(proposal(id), at(0ms));
        QCOMPARE(queue.settle(ProposalId{2})->id, ProposalId{2});
        QVERIFY(!queue.settle(ProposalId{2}));
        QCOMPARE(ids(queue.takeDue(1000, at(0ms))), (Numbers{1, 3}));
        queue.settle(ProposalId{1});
        queue.settle(ProposalId{3});
        QVERIFY(queue.waiting().empty());
        QCOMPARE(queue.nextDue(), LocalTime::max());
        QVERIFY(queue.takeDue(1000, at(1h)).empty());
    }

    void sendsAsManyProposalsAsFit()
    {
        // 13 bytes around each body: 100 + 13 = 113.
        ProposalQueue queue;
        for (const std::uint64_t id : {1U, 2U, 3U})
            queue.add(proposal(id, 100), at(0ms));
        QCOMPARE(ids(queue.takeDue(339, at(0ms))), (Numbers{1, 2, 3}));
        QCOMPARE(ids(queue.takeDue(338, at(1s))), (Numbers{1, 2}));
        QCOMPARE(ids(queue.takeDue(10, at(2s))), (Numbers{1})); // one always goes
    }

    void aGapInSizesIsNotFilledOutOfOrder()
    {
        ProposalQueue queue;
        queue.add(proposal(1, 100), at(0ms));
        queue.add(proposal(2, 900), at(0ms));
        queue.add(proposal(3, 1), at(0ms));
        QCOMPARE(ids(queue.takeDue(500, at(0ms))), (Numbers{1}));
    }

    void anotherHostIsToldAtOnce()
    {
        ProposalQueue queue;
        queue.add(proposal(1), at(0ms));
        QCOMPARE(ids(queue.takeDue(1000, at(0ms))), (Numbers{1}));
        queue.repeatAt(at(10ms));
        QCOMPARE(ids(queue.takeDue(1000, at(10ms))), (Numbers{1}));
        queue.clear();
        QVERIFY(queue.takeDue(1000, at(1s)).empty());
    }
};

CARINA_TEST(TestFactReplication)

} // namespace carina::fact_replication_test

#include "tst_fact_replication.moc"
