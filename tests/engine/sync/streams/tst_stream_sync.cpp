#include "engine/sync/wire/datagram_codec.h"
#include "tests/engine/sync/connection/session_world.h"
#include "tests/support/test_class.h"

#include <set>

namespace carina::stream_sync_test
{
namespace
{

using namespace std::chrono_literals;

constexpr ObjectId kTube{1};
const SimulatedLink::Path kCalm{5ms, 0ms, 0.0, 0.0};

/// A datagram that a site's client might have sent.
std::vector<std::byte> datagram(std::uint32_t connection, const WireRecord& record)
{
    return packDatagrams(std::span{&record, 1},
                         [&] {
                             BundleHeader header;
                             header.connection = connection;
                             header.sequence = 1'000'000;
                             return header;
                         })
        .front();
}

} // namespace

/// Two sites, the first of which owns the tube.
struct TubeWorld : SessionWorld {
    explicit TubeWorld(const SimulatedLink::Path& path = kCalm, int skewPpm = 0) : SessionWorld{5}
    {
        for (const std::size_t i : {0U, 1U}) {
            addSite(path, {250ms, skewPpm});
            startClient(i, i == 0 ? "anna" : "ben");
        }
        run(2s);
        shareTube();
    }
    void shareTube()
    {
        const ParticipantId owner = site(0).client->self();
        host().share(kTube, {owner, 1});
        for (const std::size_t i : {0U, 1U})
            site(i).client->share(kTube, {owner, 1});
    }
    [[nodiscard]] StreamCpo sample(std::uint16_t sequence)
    {
        StreamCpo cpo;
        cpo.object = kTube;
        cpo.sequence = sequence;
        cpo.time = site(0).client->clock().mapping()->at(site(0).clock.at(now()));
        return cpo;
    }
};

class TestStreamSync : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void samplesReachTheOthersWithinAFrame()
    {
        TubeWorld world;
        StreamTick tick;
        std::uint16_t sequence = 0;
        std::vector<Duration> sent;
        std::size_t seen = 0;
        Duration slowest{};
        world.run(10s, 1ms, [&] {
            if (tick.isDue(world.hostTime())) {
                tick.served(world.hostTime());
                sent.push_back(world.now());
                world.site(0).client->publish(StationId{}, world.sample(++sequence));
            }
            for (; seen < world.site(1).streams.size(); ++seen) {
                const auto index = world.site(1).streams[seen].cpo.sequence - 1U;
                slowest = std::max(slowest, world.now() - sent[index]);
            }
        });
        QVERIFY(sequence >= 590);
        QVERIFY(seen + 3 >= sequence);
        // Two legs of 5 ms, at most one tick of waiting at the host and 1 ms of looking.
        QVERIFY(slowest <= 10ms + StreamTick::kPeriod + 2ms);
        QVERIFY(world.site(0).streams.empty());                       // nobody hears himself
        QCOMPARE(world.host().take().streams.size(), std::size_t{0}); // taken by the pump
    }

    void newestSampleOfATickTravels()
    {
        TubeWorld world;
        world.session.station = StationId{4};
        for (std::uint16_t sequence = 1; sequence <= 3; ++sequence)
            world.site(0).client->publish(StationId{4}, world.sample(sequence));
        world.run(100ms);
        QCOMPARE(world.site(1).streams.size(), std::size_t{1});
        const StreamSample& got = world.site(1).streams[0];
        QCOMPARE(got.cpo.sequence, std::uint16_t{3});
        QCOMPARE(got.station, StationId{4});
        QCOMPARE(got.owner, world.site(0).client->self());
    }

    void samplesOfAStationWhereTheirOwnerIsNotAreDropped()
    {
        TubeWorld world;
        world.session.station = StationId{4};
        world.run(100ms, StreamTick::kPeriod,
                  [&] { world.site(0).client->publish(StationId{3}, world.sample(1)); });
        QVERIFY(world.site(1).streams.empty());
        QCOMPARE(world.host().take().streams.size(), std::size_t{0});
    }

    /// Everybody was sent what all stations stream.
    void samplesStayAtTheirStation()
    {
        TubeWorld world;
        world.addSite(kCalm);
        world.startClient(2, "carl");
        world.run(1s);
        world.site(2).client->share(kTube, {world.site(0).client->self(), 1});
        world.session.places[world.site(1).client->self()] = StationId{4};
        std::uint16_t sequence = 0;
        const auto stream = [&] {
            world.site(0).client->publish(StationId{}, world.sample(++sequence));
        };
        world.run(500ms, StreamTick::kPeriod, stream);
        QVERIFY(world.site(1).streams.empty());
        QVERIFY(world.site(2).streams.size() > 20);
        world.session.watchers.insert(world.site(1).client->self()); // as an instructor
        world.run(500ms, StreamTick::kPeriod, stream);
        QVERIFY(world.site(1).streams.size() > 20);
    }

    /// The same holds for what its owner showed of an object.
    void whatWasShownStaysAtItsStation()
    {
        TubeWorld world;
        world.session.places[world.site(1).client->self()] = StationId{4};
        const auto tell = [&] {
            world.site(0).client->tellShown({kTube, world.trueSessionTime(), {}});
        };
        world.run(1s, 250ms, tell);
        QVERIFY(world.site(1).shown.empty());
        world.session.places.clear();
        world.run(1s, 250ms, tell);
        QVERIFY(!world.site(1).shown.empty());
    }

    /// One under many objects, and another who comes later from elsewhere.
    void objectsOfOnePlaceAreNotAllThatIsStreamed()
    {
        TubeWorld world;
        const ParticipantId crowd = world.site(1).client->self();
        constexpr std::uint16_t kFirst = 100;
        constexpr std::uint16_t kObjects = 120;
        for (std::uint16_t i = 0; i < kObjects; ++i)
            world.host().share(ObjectId{static_cast<std::uint16_t>(kFirst + i)}, {crowd, 1});
        std::uint16_t sequence = 0;
        std::set<ObjectId> heard;
        const auto flood = [&] {
            ++sequence;
            for (std::uint16_t i = 0; i < kObjects; ++i) {
                StreamCpo cpo = world.sample(sequence);
                cpo.object = ObjectId{static_cast<std::uint16_t>(kFirst + i)};
                world.site(1).client->publish(StationId{}, cpo);
            }
        };
        for (std::uint16_t i = 0; i < kObjects; ++i)
            world.site(0).client->share(ObjectId{static_cast<std::uint16_t>(kFirst + i)},
                                        {crowd, 1});
        world.run(500ms, StreamTick::kPeriod, flood);
        for (const StreamSample& sample : world.site(0).streams)
            heard.insert(sample.cpo.object);
        QCOMPARE(heard.size(), StreamSlots::kMostOfStation);
        world.run(500ms, StreamTick::kPeriod, [&] {
            flood();
            world.site(0).client->publish(StationId{}, world.sample(sequence));
        });
        QVERIFY(world.site(1).streams.size() > 20); // the tube
    }

    void sequencesOnlyRiseInAStorm()
    {
        TubeWorld world{{20ms, 30ms, 0.1, 0.2}, 50};
        std::uint16_t sequence = 0;
        world.run(60s, StreamTick::kPeriod,
                  [&] { world.site(0).client->publish(StationId{}, world.sample(++sequence)); });
        const auto& got = world.site(1).streams;
        QVERIFY(got.size() > sequence / 3U);
        for (std::size_t i = 1; i < got.size(); ++i)
            QVERIFY(got[i].cpo.sequence > got[i - 1].cpo.sequence);
    }

    void hostSharesItsOwnObjects()
    {
        TubeWorld world;
        constexpr ObjectId kJaw{2};
        world.host().share(kJaw, {ParticipantId{0}, 1});
        for (const std::size_t i : {0U, 1U})
            world.site(i).client->share(kJaw, {ParticipantId{0}, 1});
        StreamSample sample{ParticipantId{0}, 1, StationId{}, {}};
        sample.cpo.object = kJaw;
        sample.cpo.time = world.trueSessionTime();
        world.host().publish(sample, world.hostTime());
        world.run(50ms);
        QCOMPARE(world.site(0).streams.size(), std::size_t{1});
        QCOMPARE(world.site(1).streams.size(), std::size_t{1});
    }

    void hostKeepsItsBeat()
    {
        TubeWorld world;
        world.host().share(ObjectId{2}, {ParticipantId{0}, 1});
        world.site(1).client->share(ObjectId{2}, {ParticipantId{0}, 1});
        const auto publish = [&](std::uint16_t sequence) {
            StreamSample sample{ParticipantId{0}, 1, StationId{}, world.sample(sequence)};
            sample.cpo.object = ObjectId{2};
            world.host().publish(sample, world.hostTime());
        };
        publish(1);
        world.run(1ms);
        publish(2); // waits for the next beat
        world.run(kCalm.delay + 2ms);
        QCOMPARE(world.site(1).streams.size(), std::size_t{1});
        world.run(StreamTick::kPeriod);
        QCOMPARE(world.site(1).streams.size(), std::size_t{2});
    }

    void nobodyMovesAnothersObject()
    {
        TubeWorld world;
        const auto connection = world.site(1).client->link().connection();
        StreamGroup forged{world.site(0).client->self(), 1, StationId{}, {}};
        forged.streams.push_back(world.sample(1));
        world.host().receive(world.site(1).address, datagram(connection, forged), world.hostTime());
        forged.owner = world.site(1).client->self();
        world.host().receive(world.site(1).address, datagram(connection, forged), world.hostTime());
        QVERIFY(world.host().take().streams.empty());
    }

    void streamsOfAnEarlierConnectionAreDropped()
    {
        TubeWorld world;
        const auto& peer = world.host().peers().at(world.site(0).address);
        StreamGroup group{peer.participant, static_cast<std::uint16_t>(peer.epoch - 1), {}, {}};
        group.streams.push_back(world.sample(1));
        const auto send = [&](std::uint32_t connection) {
            world.host().receive(world.site(0).address, datagram(connection, group),
                                 world.hostTime());
            return world.host().take().streams.size();
        };
        QCOMPARE(send(peer.link.connection()), std::size_t{0});
        group.epoch = peer.epoch;
        QCOMPARE(send(peer.link.connection() - 1), std::size_t{0});
        QCOMPARE(send(peer.link.connection()), std::size_t{1});
    }

    void restartedOwnerGoesOnAtOnce()
    {
        TubeWorld world;
        std::uint16_t sequence = 30000;
        world.run(1s, StreamTick::kPeriod,
                  [&] { world.site(0).client->publish(StationId{}, world.sample(++sequence)); });
        world.crashClient(0);
        world.startClient(0, "anna");
        world.run(1s);
        const std::size_t before = world.site(1).streams.size();
        world.site(0).client->publish(StationId{}, world.sample(1));
        world.run(100ms);
        QCOMPARE(world.site(1).streams.size(), before + 1);
        QCOMPARE(world.site(1).streams.back().cpo.sequence, std::uint16_t{1});
    }

    void olderVersionGetsAClearRefusal()
    {
        TubeWorld world;
        auto bytes = datagram(1, Goodbye{});
        bytes[2] = std::byte{1};
        world.host().receive(77, bytes, world.hostTime());
        auto output = world.host().take();
        QCOMPARE(output.datagrams.size(), std::size_t{1});
        QCOMPARE(output.datagrams[0].to, PeerAddress{77});
        const auto answer = decodeDatagram(output.datagrams[0].bytes);
        QVERIFY(answer);
        QCOMPARE(std::get<HelloRefused>(answer->records.at(0)).reason, Errc::VersionMismatch);
        // And a client that meets a newer host says so.
        SyncClient client{world.proposal("Janna"), 1, LocalTime{}};
        output.datagrams[0].bytes[2] = std::byte{kProtocolVersion + 1};
        client.receive(output.datagrams[0].bytes, LocalTime{});
        QCOMPARE(client.helloRefused()->code, Errc::VersionMismatch);
    }

    void strangersAreToldToSayHello()
    {
        TubeWorld world;
        const auto ask = [&](const std::vector<std::byte>& bytes) {
            world.host().receive(77, bytes, world.hostTime());
            return world.host().take().datagrams;
        };
        const auto answered = ask(datagram(0x1234, FactAck{}));
        QCOMPARE(answered.size(), std::size_t{1});
        const auto answer = decodeDatagram(answered[0].bytes);
        QVERIFY(std::holds_alternative<ConnectionUnknown>(answer->records.at(0)));
        QCOMPARE(answer->header.connection, 0x1234U);
        QVERIFY(answer->header.fromHost);
        QVERIFY(answered[0].bytes.size() <= datagram(0x1234, FactAck{}).size()); // no amplifier
        QVERIFY(ask(datagram(1, Goodbye{})).empty());
        QVERIFY(ask({}).empty());
        QVERIFY(ask(answered[0].bytes).empty()); // from another host
    }

    void slowestPathIsHalfTheLongestRoundTrip()
    {
        SessionWorld world{6};
        QCOMPARE(world.host().slowestPath(), Duration{});
        world.addSite({30ms, 0ms, 0.0, 0.0});
        world.addSite({5ms, 0ms, 0.0, 0.0});
        world.startClient(0, "far");
        world.startClient(1, "near");
        world.run(2s);
        QVERIFY(std::chrono::abs(world.host().slowestPath() - 30ms) < 1ms);
    }

    void receiversGetAtMost240KilobitsASecond()
    {
        // Ten streams at 60 Hz from the host, with 57 bytes of UDP, IP and DTLS per datagram.
        TubeWorld world;
        for (std::uint16_t i = 10; i < 20; ++i)
            world.host().share(ObjectId{i}, {ParticipantId{0}, 1});
        world.run(2s);
        const auto& link = world.site(1).fromHost;
        const std::size_t bytes = link.sentBytes();
        const std::size_t datagrams = link.sent();
        std::uint16_t sequence = 0;
        world.run(10s, StreamTick::kPeriod, [&] {
            ++sequence;
            for (std::uint16_t i = 10; i < 20; ++i) {
                StreamSample sample{ParticipantId{0}, 1, StationId{}, world.sample(sequence)};
                sample.cpo.object = ObjectId{i};
                world.host().publish(sample, world.hostTime());
            }
        });
        const double total = static_cast<double>(link.sentBytes() - bytes)
                             + 57.0 * static_cast<double>(link.sent() - datagrams);
        QVERIFY(total * 8.0 / 10.0 <= 240e3);
        QVERIFY(total * 8.0 / 10.0 >= 200e3);
    }
};

CARINA_TEST(TestStreamSync)

} // namespace carina::stream_sync_test

#include "tst_stream_sync.moc"
