#include "engine/sync/streams/host_streams.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace carina::host_streams_test
{
namespace
{

using namespace std::chrono_literals;

constexpr StationId kHere{1};
constexpr StationId kThere{2};
constexpr SessionTime kNow{1000s};
constexpr LocalTime kStart{1h};

/// Each object has an owner of its own.
ParticipantId ownerOf(ObjectId object)
{
    return ParticipantId{static_cast<std::uint16_t>(1000 + object.value)};
}

StreamSample sampleOf(ObjectId object, std::uint16_t sequence, StationId station)
{
    StreamSample sample{ownerOf(object), 1, station, {}};
    sample.cpo.object = object;
    sample.cpo.sequence = sequence;
    sample.cpo.time = kNow;
    return sample;
}

StreamSource from(ParticipantId owner, bool isFirst = false) { return {{0, owner}, isFirst}; }

std::size_t countSamples(const std::vector<WireRecord>& records)
{
    std::size_t samples = 0;
    for (const WireRecord& record : records)
        samples += std::get<StreamGroup>(record).streams.size();
    return samples;
}

/// Objects 1 to a number at a station, each sampled before each tick.
struct Crowd {
    HostStreams streams;
    std::uint16_t objects;
    std::vector<StationId> readers;
    std::uint16_t tick = 0;
    std::map<ObjectId, int> sent;
    std::map<ObjectId, int> lastSent; ///< at which tick
    int longestWait = 0;              ///< in ticks
    std::size_t samples = 0;          ///< that went out, to all readers
    std::size_t mostAtOnce = 0;       ///< to one of them

    Crowd(std::uint16_t number, std::size_t readersHere) : objects{number}
    {
        readers.assign(readersHere, kHere);
        for (std::uint16_t i = 1; i <= objects; ++i)
            streams.share(ObjectId{i}, ownerOf(ObjectId{i}));
    }
    /// @param first the object that comes first
    void turn(ObjectId first = {})
    {
        ++tick;
        for (std::uint16_t i = 1; i <= objects; ++i) {
            const ObjectId object{i};
            streams.take(sampleOf(object, tick, kHere), from(ownerOf(object), object == first),
                         kNow);
        }
        const LocalTime now = kStart + tick * StreamTick::kPeriod;
        streams.gather(readers, now);
        const auto records = streams.dueTo({kNobody, kHere});
        samples += countSamples(records) * readers.size();
        mostAtOnce = std::max(mostAtOnce, countSamples(records));
        for (const WireRecord& record : records)
            for (const StreamCpo& cpo : std::get<StreamGroup>(record).streams) {
                ++sent[cpo.object];
                if (lastSent.contains(cpo.object))
                    longestWait = std::max(longestWait, tick - lastSent[cpo.object]);
                lastSent[cpo.object] = tick;
            }
        streams.served(now);
    }
};

} // namespace

/// To whom the host forwards samples, and how often where there are many.
class TestHostStreams : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Everybody was sent the streams of all stations.
    void samplesGoToThoseAtTheStationAndToWhoWatchesAll()
    {
        HostStreams streams;
        for (const ObjectId object : {ObjectId{1}, ObjectId{2}})
            streams.share(object, ownerOf(object));
        QVERIFY(streams.take(sampleOf(ObjectId{1}, 1, kHere), from(ownerOf(ObjectId{1})), kNow));
        QVERIFY(streams.take(sampleOf(ObjectId{2}, 1, kThere), from(ownerOf(ObjectId{2})), kNow));
        streams.gather(std::array{kHere, kThere, kAllStations}, kStart);
        const auto here = streams.dueTo({ParticipantId{7}, kHere});
        QCOMPARE(here.size(), std::size_t{1});
        QCOMPARE(std::get<StreamGroup>(here[0]).station, kHere);
        QCOMPARE(countSamples(streams.dueTo({ParticipantId{7}, kThere})), std::size_t{1});
        QCOMPARE(countSamples(streams.dueTo({ParticipantId{7}, kAllStations})), std::size_t{2});
        QVERIFY(streams.dueTo({ParticipantId{7}, StationId{3}}).empty());
        QVERIFY(streams.dueTo({ownerOf(ObjectId{1}), kHere}).empty()); // nobody hears himself
        streams.served(kStart);
        QVERIFY(streams.dueTo({ParticipantId{7}, kAllStations}).empty());
        QCOMPARE(streams.nextDue(), LocalTime::max());
    }

    /// Three people with five objects each, whom 230 watch: everything is sent.
    void wholeClassIsNotThinned()
    {
        Crowd crowd{15, 230};
        for (int i = 0; i < 10; ++i)
            crowd.turn();
        QCOMPARE(crowd.sent.size(), std::size_t{15});
        for (const auto& [object, times] : crowd.sent)
            QCOMPARE(times, 10);
    }

    /// 64 objects that 180 watch would be 26 MB in a second.
    void manyTakeTurnsAndTheFirstDoNot()
    {
        constexpr int kTicks = 480;
        const ObjectId first{5};
        Crowd crowd{64, 180};
        for (int i = 0; i < kTicks; ++i)
            crowd.turn(first);
        QCOMPARE(crowd.sent.size(), std::size_t{64});
        for (const auto& [object, times] : crowd.sent)
            if (object == first)
                QCOMPARE(times, kTicks);
            else // at every third or fourth tick, as 8 MB are 20 of them at each
                QVERIFY2(times >= kTicks / 4 - 1 && times <= kTicks / 3 + 1,
                         qPrintable(QString::number(times)));
        QVERIFY(crowd.longestWait <= 4);
        const double bytes_s =
            37.0 * double(crowd.samples) / (kTicks * toSeconds(StreamTick::kPeriod));
        QVERIFY2(bytes_s <= 1.01 * HostStreams::kMostBytes, qPrintable(QString::number(bytes_s)));
    }

    /// Two such stations' worth at one: more than may go out, but nobody waits for longer.
    void nobodyWaitsForLongerThanTheLongestWait()
    {
        Crowd crowd{64, 500};
        for (int i = 0; i < 240; ++i)
            crowd.turn();
        QCOMPARE(crowd.sent.size(), std::size_t{64});
        for (const auto& [object, times] : crowd.sent)
            QVERIFY(times >= 240 / 4 - 1);
        QVERIFY(crowd.longestWait <= 4);
        QVERIFY(crowd.mostAtOnce <= 64 / 4 + 8); // they have turns
    }

    /// A host that is late serves every second tick alone.
    void waitIsOneOfTimeNotOfTicks()
    {
        Crowd crowd{64, 500};
        for (int i = 0; i < 240; ++i) {
            ++crowd.tick;
            crowd.turn();
        }
        for (const auto& [object, times] : crowd.sent)
            QVERIFY(times >= 480 / 4 - 1);
        QVERIFY(crowd.longestWait <= 4);
    }

    /// The newest of what had to wait.
    void whatWaitsIsTheNewest()
    {
        Crowd crowd{64, 180};
        crowd.turn();
        QVERIFY(crowd.streams.isDue(kStart + 1s)); // others wait
        for (int i = 0; i < 4; ++i)
            crowd.turn();
        QCOMPARE(crowd.sent.size(), std::size_t{64});
        crowd.streams.gather(crowd.readers, kStart + 6 * StreamTick::kPeriod);
        for (const WireRecord& record : crowd.streams.dueTo({kNobody, kHere}))
            for (const StreamCpo& cpo : std::get<StreamGroup>(record).streams)
                QCOMPARE(cpo.sequence, std::uint16_t{5});
    }

    void whatOneWhoLeftHadWaitingDoesNotGoOut()
    {
        Crowd crowd{64, 180};
        crowd.turn();
        QVERIFY(crowd.streams.nextDue() < LocalTime::max());
        for (std::uint16_t i = 1; i <= 64; ++i)
            crowd.streams.leave(ownerOf(ObjectId{i}));
        QCOMPARE(crowd.streams.nextDue(), LocalTime::max());
    }

    void moreObjectsThanAStationHasAreNotTaken()
    {
        HostStreams streams;
        std::size_t taken = 0;
        for (std::uint16_t i = 1; i <= 200; ++i) {
            streams.share(ObjectId{i}, ownerOf(ObjectId{i}));
            const StreamSource crowd{{1, kNobody}, false};
            taken += streams.take(sampleOf(ObjectId{i}, 1, kHere), crowd, kNow) ? 1 : 0;
        }
        QCOMPARE(taken, StreamSlots::kMostOfStation);
        const ObjectId tube{201};
        streams.share(tube, ownerOf(tube));
        QVERIFY(streams.take(sampleOf(tube, 1, kHere), from(ownerOf(tube), true), kNow));
    }
};

CARINA_TEST(TestHostStreams)

} // namespace carina::host_streams_test

#include "tst_host_streams.moc"
