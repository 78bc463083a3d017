#include "engine/sync/strategies/drift.h"
#include "engine/sync/streams/stream_table.h"
#include "engine/sync/streams/stream_tick.h"
#include "engine/sync/wire/datagram_codec.h"
#include "engine/sync/wire/record_codec.h"
#include "engine/sync/wire/sequence.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::stream_table_test
{
namespace
{

using namespace std::chrono_literals;

constexpr SessionTime kNow{1000s};
constexpr ParticipantId kOwner{2};

StreamSample sample(std::uint16_t epoch, std::uint16_t sequence, ParticipantId owner = kOwner)
{
    StreamSample s{owner, epoch, StationId{}, {}};
    s.cpo.object = ObjectId{7};
    s.cpo.sequence = sequence;
    s.cpo.time = kNow;
    return s;
}

StreamTable tableWithObject7()
{
    StreamTable table;
    table.share(ObjectId{7}, kOwner);
    return table;
}

} // namespace

class TestStreamTable : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void newestWins()
    {
        StreamTable table = tableWithObject7();
        QVERIFY(table.accept(sample(1, 10), kNow));
        QVERIFY(!table.accept(sample(1, 10), kNow)); // twice
        QVERIFY(!table.accept(sample(1, 9), kNow));  // overtaken
        QVERIFY(table.accept(sample(1, 12), kNow));
        QVERIFY(!table.accept(sample(1, 11), kNow));
    }

    void sequencesWrap()
    {
        StreamTable table = tableWithObject7();
        QVERIFY(table.accept(sample(1, 0xFFFF), kNow));
        QVERIFY(table.accept(sample(1, 0), kNow));
        QVERIFY(!table.accept(sample(1, 0xFFFF), kNow));
        QVERIFY(table.accept(sample(1, 0x7FFF), kNow));
        QVERIFY(!table.accept(sample(1, 0xFFFF), kNow));
    }

    void laterEpochBeginsAnew()
    {
        StreamTable table = tableWithObject7();
        QVERIFY(table.accept(sample(5, 1000), kNow));
        QVERIFY(table.accept(sample(6, 1), kNow));
        QVERIFY(!table.accept(sample(5, 1001), kNow));
        QVERIFY(table.accept(sample(6, 2), kNow));
    }

    void epochsWrap()
    {
        StreamTable table = tableWithObject7();
        QVERIFY(table.accept(sample(0xFFFF, 5), kNow));
        QVERIFY(table.accept(sample(0, 0), kNow));
        QVERIFY(!table.accept(sample(0xFFFF, 6), kNow));
    }

    void onlyTheOwnerWrites()
    {
        StreamTable table = tableWithObject7();
        QVERIFY(!table.accept(sample(9, 1, ParticipantId{3}), kNow));
        QVERIFY(table.accept(sample(1, 1), kNow));
        table.share(ObjectId{7}, ParticipantId{3});
        QVERIFY(!table.accept(sample(1, 2), kNow));
        QVERIFY(table.accept(sample(0, 0, ParticipantId{3}), kNow));
    }

    void sharingAgainKeepsTheNewest()
    {
        StreamTable table = tableWithObject7();
        QVERIFY(table.accept(sample(1, 5), kNow));
        table.share(ObjectId{7}, kOwner);
        QVERIFY(!table.accept(sample(1, 4), kNow));
    }

    void unknownObjectsAreDropped()
    {
        StreamTable table;
        QVERIFY(!table.accept(sample(1, 1), kNow));
        table = tableWithObject7();
        table.clear();
        QVERIFY(!table.accept(sample(1, 1), kNow));
    }

    void posesOfAnotherTimeAreDropped()
    {
        StreamTable table = tableWithObject7();
        StreamSample s = sample(1, 1);
        s.cpo.time = kNow - 10s - 1ns;
        QVERIFY(!table.accept(s, kNow));
        s.cpo.time = kNow + 10s + 1ns;
        QVERIFY(!table.accept(s, kNow));
        s.cpo.time = kNow - 10s;
        QVERIFY(table.accept(s, kNow));
        s.cpo.sequence = 2;
        s.cpo.time = kNow + 10s;
        QVERIFY(table.accept(s, kNow));
    }

    void groupsByOwnerEpochAndStation()
    {
        std::vector<StreamSample> samples{sample(1, 1), sample(1, 2), sample(2, 3),
                                          sample(1, 4, ParticipantId{3}), sample(1, 5)};
        samples.push_back(sample(1, 6));
        samples.back().station = StationId{1};
        const auto groups = groupStreams(samples);
        QCOMPARE(groups.size(), std::size_t{4});
        QCOMPARE(groups[0].owner, kOwner);
        QCOMPARE(groups[0].epoch, std::uint16_t{1});
        QCOMPARE(groups[0].streams.size(), std::size_t{3});
        QCOMPARE(groups[0].streams[2].sequence, std::uint16_t{5});
        QCOMPARE(groups[1].epoch, std::uint16_t{2});
        QCOMPARE(groups[2].owner, ParticipantId{3});
        QCOMPARE(groups[3].station, StationId{1});
    }

    void splitsAGroupThatIsTooLong()
    {
        const auto groups =
            groupStreams(std::vector<StreamSample>(2 * kStreamsPerGroup + 1, sample(1, 1)));
        QCOMPARE(groups.size(), std::size_t{3});
        QCOMPARE(groups[0].streams.size(), kStreamsPerGroup);
        QCOMPARE(groups[1].streams.size(), kStreamsPerGroup);
        QCOMPARE(groups[2].streams.size(), std::size_t{1});
        QVERIFY(groupStreams({}).empty());
    }

    /// Forms are long: as many bytes go together as of samples without.
    void splitsAGroupOfLongSamples()
    {
        StreamSample bent = sample(1, 1);
        bent.cpo.shape = StreamShape{bent.cpo.time, 0.3, 0.01, {}, {}};
        const auto groups = groupStreams(std::vector<StreamSample>(kStreamsPerGroup, bent));
        QCOMPARE(groups.size(), std::size_t{2});
        for (const StreamGroup& group : groups) {
            std::vector<std::byte> bytes;
            ByteWriter out{bytes};
            writeRecord(out, group);
            QVERIFY(bytes.size() + kBundleHeaderBytes <= kLargestDatagram);
        }
        QCOMPARE(groups[0].streams.size() + groups[1].streams.size(), kStreamsPerGroup);
    }

    void afterIsLessThanHalfTheRangeAhead()
    {
        QVERIFY(isAfter<std::uint16_t>(1, 0));
        QVERIFY(!isAfter<std::uint16_t>(0, 0));
        QVERIFY(!isAfter<std::uint16_t>(0, 1));
        QVERIFY(isAfter<std::uint16_t>(0x7FFF, 0));
        QVERIFY(!isAfter<std::uint16_t>(0x8000, 0));
        QVERIFY(isAfter<std::uint32_t>(5, 0xFFFF'FFF0));
        QVERIFY(!isAfter<std::uint32_t>(0xFFFF'FFF0, 5));
    }

    void tickKeepsItsBeat()
    {
        StreamTick tick;
        LocalTime now{1s};
        QVERIFY(tick.isDue(now));
        tick.served(now);
        QCOMPARE(tick.next(), now + StreamTick::kPeriod);
        QVERIFY(!tick.isDue(now + StreamTick::kPeriod - 1ns));
        QVERIFY(tick.isDue(now + StreamTick::kPeriod));
        // Served late, the next comes all the earlier: the average holds.
        tick.served(now + StreamTick::kPeriod + 5ms);
        QCOMPARE(tick.next(), now + 2 * StreamTick::kPeriod);
        // Served far too late, nothing is caught up.
        tick.served(now + 10s);
        QCOMPARE(tick.next(), now + 10s + StreamTick::kPeriod);
    }

    void sixtyTicksASecond()
    {
        StreamTick tick;
        int ticks = 0;
        for (LocalTime t{1s}; t < LocalTime{11s}; t += 1ms)
            if (tick.isDue(t)) {
                tick.served(t);
                ++ticks;
            }
        QVERIFY(std::abs(ticks - 600) <= 1);
    }

    void driftIsAngleAndDistance()
    {
        constexpr double kTolerance = 1e-12;
        const double half = 0.05;
        const RigidTransform X_AO_sent{Quat{1.0, 0.0, 0.0, 0.0}, Vec3{0.1, 0.2, 0.3}};
        const RigidTransform X_AO_shown{Quat{-std::cos(half), 0.0, std::sin(half), 0.0},
                                        Vec3{0.1, 0.203, 0.296}};
        const Drift drift = driftBetween(X_AO_sent, X_AO_shown);
        QVERIFY(std::abs(drift.rotation.si - 0.1) < kTolerance);
        QVERIFY(std::abs(inMillimetres(drift.position) - 5.0) < 1e-9);
        QCOMPARE(driftBetween(X_AO_sent, X_AO_sent).rotation.si, 0.0);
    }
};

CARINA_TEST(TestStreamTable)

} // namespace carina::stream_table_test

#include "tst_stream_table.moc"
