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
    std::vector<FactRecord> log;
    for (std::uint64_t number = 1; number <= logEnd; ++number)
        log.push_back(fact(number));
    const auto range = sender.takeDue(log, roundTrip, now);
    return range.empty() ? Numbers{}
                         : Numbers{range.front().number.value, range.back().number.value};
}

/// A sender with a window that more than a thousand acknowledged facts have opened.
FactSender openSender()
{
    FactSender sender{FactNumber{0}};
    LocalTime now = at(0ms);
    while (sender.acknowledged() < FactNumber{1000}) {
        sender.acknowledge(FactNumber{due(sender, 100'000, now).at(1)}, 0ms, now);
        now += FactSender::kBurstInterval;
    }
    return sender;
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

    /// Slow start: with each acknowledged fact one more is under way.
    void windowOpensAsFactsAreAcknowledged()
    {
        FactSender sender{FactNumber{0}};
        QCOMPARE(due(sender, 1000, at(0ms)), (Numbers{1, 64}));
        QCOMPARE(due(sender, 1000, at(10ms)), Numbers{});
        QCOMPARE(sender.nextDue(FactNumber{1000}), at(50ms));
        sender.acknowledge(FactNumber{10}, 0ms, at(10ms));
        QVERIFY(sender.nextDue(FactNumber{1000}) <= at(10ms));
        QCOMPARE(due(sender, 1000, at(10ms)), (Numbers{65, 84})); // 10 + 64 + 10
        sender.acknowledge(FactNumber{84}, 0ms, at(20ms));
        QCOMPARE(due(sender, 100, at(20ms)), (Numbers{85, 100}));
    }

    void windowNeverExceedsWhatAClientKeeps()
    {
        FactSender sender{FactNumber{0}};
        LocalTime now = at(0ms);
        std::uint64_t last = 0;
        while (last < 20'000) {
            last = due(sender, 100'000, now).at(1);
            sender.acknowledge(FactNumber{last}, 0ms, now);
            now += FactSender::kBurstInterval;
        }
        const std::uint64_t acknowledged = last;
        for (Numbers next; !(next = due(sender, 100'000, now)).empty(); last = next.at(1))
            now += FactSender::kBurstInterval;
        QCOMPARE(last - acknowledged, kLargestFactWindow);
    }

    /// 40 bytes each: 819 in 32 768 bytes, every 4 ms.
    void longLogComesInBursts()
    {
        FactSender sender = openSender();
        const LocalTime now = at(1s);
        const Numbers first = due(sender, 100'000, now);
        QCOMPARE(first.at(1) - first.at(0) + 1, std::uint64_t{819});
        QCOMPARE(due(sender, 100'000, now), Numbers{});
        QCOMPARE(sender.nextDue(FactNumber{100'000}), now + 4ms);
        QCOMPARE(due(sender, 100'000, now + 4ms).at(0), first.at(1) + 1);
    }

    /// Fast recovery: nobody waits for the repeat after 50 ms.
    void lostFactIsRepeatedAtTheThirdAcknowledgementOfTheLast()
    {
        FactSender sender = openSender();
        const LocalTime now = at(1s);
        const std::uint64_t first = sender.acknowledged().value + 1;
        const std::uint64_t sent = due(sender, 100'000, now).at(1);
        for (int times = 0; times < 3; ++times)
            sender.acknowledge(FactNumber{first + 9}, 0ms, now);
        QCOMPARE(due(sender, 100'000, now), Numbers{});
        sender.acknowledge(FactNumber{first + 9}, 0ms, now);
        QCOMPARE(sender.nextDue(FactNumber{100'000}), LocalTime::min());
        QCOMPARE(due(sender, 100'000, now), (Numbers{first + 10, first + 25}));
        QCOMPARE(due(sender, 100'000, now), Numbers{});       // once
        sender.acknowledge(FactNumber{first + 99}, 0ms, now); // another gap
        QCOMPARE(due(sender, 100'000, now), (Numbers{first + 100, first + 115}));
        sender.acknowledge(FactNumber{sent}, 0ms, now); // all is repaired
        QCOMPARE(due(sender, 100'000, now + 4ms).at(0), sent + 1);
    }

    void acknowledgementOfWhatWasSentBeforeARepeatCounts()
    {
        FactSender sender{FactNumber{0}};
        QCOMPARE(due(sender, 1000, at(0ms)), (Numbers{1, 64}));
        sender.acknowledge(FactNumber{20}, 0ms, at(1ms));
        QCOMPARE(due(sender, 1000, at(4ms)), (Numbers{65, 104}));
        QCOMPARE(due(sender, 1000, at(51ms)), (Numbers{21, 84})); // all again, the window is small
        sender.acknowledge(FactNumber{104}, 0ms, at(52ms));
        QCOMPARE(sender.acknowledged(), FactNumber{104});
        QCOMPARE(due(sender, 1000, at(60ms)).at(0), std::uint64_t{105});
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
        constexpr std::uint64_t kLast = kLargestFactWindow;
        QVERIFY(receiver.take(fact(kLast)).empty()); // the last within the window of an empty log
        QVERIFY(receiver.take(fact(kLast + 1)).empty()); // the first beyond it
        for (std::uint64_t n = 1; n < kLast - 1; ++n)
            QCOMPARE(numbers(receiver.take(fact(n))), (Numbers{n}));
        QCOMPARE(numbers(receiver.take(fact(kLast - 1))), (Numbers{kLast - 1, kLast}));
        QCOMPARE(receiver.last(), FactNumber{kLast});
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
