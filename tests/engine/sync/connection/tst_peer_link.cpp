#include "engine/sync/connection/peer_link.h"
#include "engine/sync/wire/datagram_codec.h"
#include "tests/support/test_class.h"

namespace carina::peer_link_test
{
namespace
{

using namespace std::chrono_literals;

constexpr Duration kHostOffset = 100h;

LocalTime at(Duration t) { return LocalTime{t}; }

} // namespace

class TestPeerLink : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void measuresTheRoundTripWithoutTheHold()
    {
        PeerLink client{9, 0s, at(0s)};
        PeerLink host{9, kHostOffset, at(0s)};
        const BundleHeader question = client.nextHeader(at(10s));
        QCOMPARE(question.connection, 9U);
        QCOMPARE(question.sequence, 1U);
        QCOMPARE(question.sentAt, Duration{10s});
        QVERIFY(!question.echo);
        QVERIFY(!host.heard(question, at(10s + 4ms)));

        const BundleHeader answer = host.nextHeader(at(10s + 104ms));
        QCOMPARE(answer.sentAt, Duration{10s + 104ms + kHostOffset});
        QCOMPARE(*answer.echo, (ClockEcho{10s, 100ms}));
        const auto trip = client.heard(answer, at(10s + 110ms));
        QVERIFY(trip);
        QCOMPARE(trip->sent, at(10s));
        QCOMPARE(trip->peerSent, Duration{10s + 104ms + kHostOffset});
        QCOMPARE(trip->hold, Duration{100ms});
        QCOMPARE(trip->length, Duration{10ms});
        // The host measures in the same way, against its own clock.
        const auto back = host.heard(client.nextHeader(at(10s + 120ms)), at(10s + 125ms));
        QVERIFY(back);
        QCOMPARE(back->sent, at(10s + 104ms));
        QCOMPARE(back->length, Duration{11ms}); // 21 ms less 10 ms of hold
    }

    void echoesTheNewestDatagram()
    {
        PeerLink client{9, 0s, at(0s)};
        PeerLink host{9, 0s, at(0s)};
        const BundleHeader first = client.nextHeader(at(1s));
        const BundleHeader second = client.nextHeader(at(2s));
        host.heard(second, at(3s));
        host.heard(first, at(4s)); // overtaken
        QCOMPARE(*host.nextHeader(at(5s)).echo, (ClockEcho{2s, 2s}));
        QCOMPARE(host.lastHeard(), at(4s));
        QCOMPARE(host.lastSent(), at(5s));
    }

    void anOvertakenDatagramMeasuresNothing()
    {
        PeerLink client{9, 0s, at(0s)};
        PeerLink host{9, 0s, at(0s)};
        host.heard(client.nextHeader(at(1s)), at(1s));
        const BundleHeader first = host.nextHeader(at(1s));
        const BundleHeader second = host.nextHeader(at(1s));
        QVERIFY(client.heard(second, at(2s)));
        QVERIFY(!client.heard(first, at(2s)));
        QVERIFY(!client.heard(second, at(2s)));
    }

    void onlyTheFirstAnswerToADatagramCounts()
    {
        PeerLink client{9, 0s, at(0s)};
        BundleHeader header;
        const auto answered = [&](Duration sent, Duration now) {
            ++header.sequence;
            header.echo = ClockEcho{sent, 0s};
            return client.heard(header, at(now)).has_value();
        };
        QVERIFY(answered(10s, 10s + 20ms));
        QVERIFY(!answered(10s, 10s + 60ms));
        QVERIFY(!answered(10s - 1ns, 10s + 80ms)); // sent before it
        QCOMPARE(client.longestRoundTrip(), std::optional{Duration{20ms}});
        QVERIFY(!answered(10s + 1ns, 10s)); // impossible, so no answer
        QVERIFY(answered(10s + 1ns, 10s + 100ms));
    }

    void anOldEchoIsLeftOut()
    {
        PeerLink host{9, 0s, at(0s)};
        BundleHeader header;
        header.sequence = 1;
        host.heard(header, at(1s));
        QVERIFY(host.nextHeader(at(1s) + kLongestHold).echo);
        QVERIFY(!host.nextHeader(at(1s) + kLongestHold + 1ns).echo);
    }

    void impossibleEchoesMeasureNothing()
    {
        PeerLink client{9, 0s, at(0s)};
        BundleHeader header;
        Duration past{};
        const auto echoed = [&](Duration sent, Duration hold) {
            ++header.sequence;
            past += 1min; // each is of another datagram
            header.echo = ClockEcho{past + sent, hold};
            return client.heard(header, at(past + 20s)).has_value();
        };
        QVERIFY(!echoed(20s + 1ns, 0s)); // from the future
        QVERIFY(!echoed(19s, 1s + 1ns)); // held longer than it was away
        QVERIFY(!echoed(10s - 1ns, 0s)); // away for more than ten seconds
        QVERIFY(!client.shortestRoundTrip());
        QVERIFY(!client.longestRoundTrip());
        QVERIFY(echoed(20s, 0s));
        QVERIFY(echoed(10s, 0s));
        QCOMPARE(*client.shortestRoundTrip(), Duration{0s});
        QCOMPARE(*client.longestRoundTrip(), Duration{10s});
    }

    /// Nothing was sent then, so that nobody can echo it.
    void echoFromBeforeTheConnectionMeasuresNothing()
    {
        PeerLink host{9, kHostOffset, at(20s)};
        BundleHeader header;
        header.sequence = 1;
        header.echo = ClockEcho{kHostOffset + 20s - 1ns, 0s};
        QVERIFY(!host.heard(header, at(20s + 5ms)));
        QVERIFY(!host.longestRoundTrip());
        header.sequence = 2;
        header.echo = ClockEcho{kHostOffset + 20s, 0s};
        QVERIFY(host.heard(header, at(20s + 5ms)));
    }

    void tellsTheNewestRoundTrip()
    {
        PeerLink client{9, 0s, at(0s)};
        QVERIFY(!client.newestRoundTrip());
        BundleHeader header;
        for (const Duration length : {4ms, 9ms, 6ms}) {
            const Duration sent = ++header.sequence * 1s;
            header.echo = ClockEcho{sent, 0s};
            client.heard(header, at(sent + length));
            QCOMPARE(client.newestRoundTrip(), std::optional{length});
        }
    }

    void countsWhatDidNotArriveEvenIfItMeasuresNothing()
    {
        PeerLink client{9, 0s, at(0s)};
        PeerLink host{9, 0s, at(0s)};
        for (int i = 0; i < 128; ++i) {
            const BundleHeader header = host.nextHeader(at(1s));
            if (i % 4 != 1)
                client.heard(header, at(1s));
        }
        QCOMPARE(client.loss(), std::optional{0.25});
        QVERIFY(!host.loss());
    }

    void remembersTheLastSixtyFourRoundTrips()
    {
        PeerLink client{9, 0s, at(0s)};
        BundleHeader header;
        const auto echoed = [&](Duration length) {
            const Duration sent = ++header.sequence * 1s;
            header.echo = ClockEcho{sent, 0s};
            client.heard(header, at(sent + length));
        };
        echoed(1ms);
        echoed(9ms);
        for (int i = 0; i < 62; ++i)
            echoed(5ms);
        QCOMPARE(*client.shortestRoundTrip(), Duration{1ms});
        echoed(5ms);
        QCOMPARE(*client.shortestRoundTrip(), Duration{5ms});
        QCOMPARE(*client.longestRoundTrip(), Duration{9ms});
        echoed(5ms);
        QCOMPARE(*client.longestRoundTrip(), Duration{5ms});
    }

    void packsRecordsInOrder()
    {
        std::vector<WireRecord> records;
        for (std::uint64_t n = 1; n <= 300; ++n)
            records.emplace_back(FactAck{FactNumber{n}});
        PeerLink link{9, 0s, at(0s)};
        const auto datagrams = packDatagrams(records, [&] { return link.nextHeader(at(1s)); });
        // (1160 - 34) / 9 = 125 records each.
        QCOMPARE(datagrams.size(), std::size_t{3});
        std::uint64_t expected = 0;
        std::uint32_t sequence = 0;
        for (const auto& bytes : datagrams) {
            QVERIFY(bytes.size() <= kLargestDatagram);
            const auto datagram = decodeDatagram(bytes);
            QVERIFY(datagram);
            QCOMPARE(datagram->header.sequence, ++sequence);
            for (const WireRecord& record : datagram->records)
                QCOMPARE(std::get<FactAck>(record).last.value, ++expected);
        }
        QCOMPARE(expected, std::uint64_t{300});
        QCOMPARE(decodeDatagram(datagrams[0])->records.size(), std::size_t{125});
    }

    void fillsADatagramToTheLastByte()
    {
        // 34 + 1063 + 63 = 1160 bytes: facts of 1024 and of 24, each with its 39 around it.
        FactRecord large;
        large.number = FactNumber{1};
        large.body.assign(1024, std::byte{1});
        FactRecord small = large;
        small.body.assign(14, std::byte{1});
        const auto header = [] { return BundleHeader{}; };
        QCOMPARE(packDatagrams(std::vector<WireRecord>{large, small}, header).front().size(),
                 kLargestDatagram - 10);
        small.body.assign(24, std::byte{1});
        QCOMPARE(packDatagrams(std::vector<WireRecord>{large, small}, header).size(),
                 std::size_t{1});
        small.body.assign(25, std::byte{1});
        QCOMPARE(packDatagrams(std::vector<WireRecord>{large, small}, header).size(),
                 std::size_t{2});
    }

    void nothingToSayIsAHeader()
    {
        const auto datagrams = packDatagrams({}, [] { return BundleHeader{}; });
        QCOMPARE(datagrams.size(), std::size_t{1});
        QCOMPARE(datagrams[0].size(), kBundleHeaderBytes);
    }
};

CARINA_TEST(TestPeerLink)

} // namespace carina::peer_link_test

#include "tst_peer_link.moc"
