#include "engine/geometry/rotation.h"
#include "engine/sync/wire/cpo_codec.h"
#include "engine/sync/wire/datagram_codec.h"
#include "engine/sync/wire/record_codec.h"
#include "tests/engine/sync/wire/datagram_samples.h"
#include "tests/support/test_class.h"

#include <limits>
#include <random>

namespace carina::datagram_layout_test
{
namespace
{

// Half the steps that docs/protocol.md states, with room for the arithmetic.
constexpr double kTimeTolerance = 0.5e-6 + 1e-12;
// A component off by half a step h (1.08e-5) in each of the three sent moves the fourth by 3 h
// where all are 1/2: |dq| = sqrt(12) h, an angle of twice that, 0.0043 deg.
constexpr double kRotationTolerance = 7.5e-5;
constexpr double kPositionTolerance = 0.5e-5 + 1e-12;
constexpr double kVelocityTolerance = 0.5e-4 + 1e-12;
constexpr double kAngularTolerance = 0.01 * 3.1415926535897932 / 180.0 + 1e-12;
constexpr double kErrorTolerance = 2.5e-5 + 1e-12;
constexpr double kFormTimeTolerance = 1e-3 + 0.5e-6 + 1e-12; // cut off, and that of its sample
constexpr double kThicknessTolerance = 0.5e-4 + 1e-12;
constexpr double kCurvatureTolerance = 1e-3 + 1e-12;

std::vector<std::byte> encoded(const WireRecord& record)
{
    std::vector<std::byte> bytes;
    ByteWriter out{bytes};
    writeRecord(out, record);
    return bytes;
}

StreamCpo randomStream(std::mt19937& random, SessionTime around)
{
    std::uniform_real_distribution<double> unit{-1.0, 1.0};
    std::normal_distribution<double> normal;
    const auto vector = [&](double length) {
        return Vec3{length * unit(random), length * unit(random), length * unit(random)};
    };
    StreamCpo stream;
    stream.object.value = static_cast<std::uint16_t>(random());
    stream.sequence = static_cast<std::uint16_t>(random());
    stream.time = around + fromSeconds(1799.0 * unit(random));
    const Quat q{normal(random), normal(random), normal(random), normal(random)};
    stream.X_AO = RigidTransform{q, vector(83.8)};
    stream.motion = StreamMotion{vector(3.27), vector(11.4)};
    stream.error = 0.006 * (1.0 + unit(random));
    return stream;
}

double largestDifference(const Vec3& a, const Vec3& b) { return (a - b).cwiseAbs().maxCoeff(); }

bool arrivedWithinSteps(const StreamCpo& got, const StreamCpo& sent)
{
    return got.object == sent.object && got.sequence == sent.sequence
           && std::abs(toSeconds(got.time - sent.time)) <= kTimeTolerance
           && angleBetween(got.X_AO.rotation(), sent.X_AO.rotation()).si <= kRotationTolerance
           && largestDifference(got.X_AO.translation(), sent.X_AO.translation())
                  <= kPositionTolerance
           && got.motion.has_value()
           && largestDifference(got.motion->v_AO, sent.motion->v_AO) <= kVelocityTolerance
           && largestDifference(got.motion->w_AO, sent.motion->w_AO) <= kAngularTolerance
           && std::abs(got.error - sent.error) <= kErrorTolerance;
}

} // namespace

class TestDatagramLayout : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void writesEachRecordAsDocumented_data()
    {
        QTest::addColumn<std::size_t>("index");
        std::size_t index = 0;
        for (const GoldenRecord& golden : goldenRecords())
            QTest::newRow(golden.name) << index++;
    }

    void writesEachRecordAsDocumented()
    {
        QFETCH(std::size_t, index);
        const GoldenRecord golden = goldenRecords()[index];
        QCOMPARE(toHex(encoded(golden.record)), toHex(fromHex(golden.hex)));
    }

    void readsEachRecordAsDocumented_data() { writesEachRecordAsDocumented_data(); }

    void readsEachRecordAsDocumented()
    {
        QFETCH(std::size_t, index);
        const GoldenRecord golden = goldenRecords()[index];
        auto bytes = fromHex(kPlainHeaderHex);
        const auto record = fromHex(golden.hex);
        bytes.insert(bytes.end(), record.begin(), record.end());
        const auto datagram = decodeDatagram(bytes);
        QVERIFY(datagram);
        QCOMPARE(datagram->records.size(), std::size_t{1});
        QCOMPARE(datagram->records[0].index(), golden.record.index());
        // The layout has no two ways to say one thing, so what was read writes the same bytes.
        QCOMPARE(toHex(encoded(datagram->records[0])), toHex(record));
    }

    void headerIsAsDocumented()
    {
        QCOMPARE(toHex(encodeHeader(goldenHeader())), toHex(fromHex(kGoldenHeaderHex)));
        const auto datagram = decodeDatagram(fromHex(kGoldenHeaderHex));
        QVERIFY(datagram);
        QVERIFY(datagram->header == goldenHeader());
        QVERIFY(datagram->records.empty());
    }

    void headerFlagsAreIndependent()
    {
        BundleHeader header;
        header.connection = 1;
        header.sequence = 2;
        QCOMPARE(toHex(encodeHeader(header)), toHex(fromHex(kPlainHeaderHex)));
        header.answerNow = true;
        const auto bytes = encodeHeader(header);
        QCOMPARE(bytes[3], std::byte{0x04});
        QVERIFY(decodeDatagram(bytes)->header == header);
    }

    void readsEveryFieldOfAStream()
    {
        auto bytes = fromHex(kPlainHeaderHex);
        const auto record = fromHex(goldenRecords()[0].hex);
        bytes.insert(bytes.end(), record.begin(), record.end());
        const auto datagram = decodeDatagram(bytes);
        QVERIFY(datagram);
        const auto& group = std::get<StreamGroup>(datagram->records[0]);
        QCOMPARE(group.owner, ParticipantId{2});
        QCOMPARE(group.epoch, std::uint16_t{0x0405});
        QCOMPARE(group.station, StationId{6});
        QCOMPARE(group.streams.size(), std::size_t{2});
        QVERIFY(arrivedWithinSteps(group.streams[0], goldenStream()));
        QCOMPARE(group.streams[0].validity, StreamValidity::PartlyOccluded);
        QCOMPARE(group.streams[1].time, goldenLostStream().time);
        QCOMPARE(group.streams[1].validity, StreamValidity::Lost);
        QVERIFY(!group.streams[1].motion);
        QVERIFY(group.streams[1].X_AO.matrix().isIdentity(0.0));
    }

    void readsEveryFieldOfFactHelloAndWelcome()
    {
        auto bytes = fromHex(kPlainHeaderHex);
        for (const std::size_t index : {2U, 6U, 7U, 5U})
            std::ranges::copy(fromHex(goldenRecords()[index].hex), std::back_inserter(bytes));
        const auto datagram = decodeDatagram(bytes);
        QVERIFY(datagram);
        QCOMPARE(datagram->records.size(), std::size_t{4});
        QVERIFY(std::get<FactRecord>(datagram->records[0]) == goldenFact());
        const auto& hello = std::get<Hello>(datagram->records[1]);
        QVERIFY(hello.session == goldenKey());
        QCOMPARE(hello.lastFact, FactNumber{9});
        QVERIFY(hello.join == goldenProposal());
        const auto& welcome = std::get<Welcome>(datagram->records[2]);
        QVERIFY(welcome.session == goldenKey());
        QCOMPARE(welcome.participant, ParticipantId{5});
        QCOMPARE(welcome.epoch, std::uint16_t{0x0203});
        QCOMPARE(welcome.lastFact, FactNumber{10});
        const auto& refused = std::get<ProposalRefused>(datagram->records[3]);
        QCOMPARE(refused.proposal, ProposalId{3});
        QCOMPARE(refused.reason, Errc::NotPermitted);
    }

    void eventsArriveToTheBit()
    {
        std::mt19937 random{7};
        std::normal_distribution<double> normal;
        for (int i = 0; i < 1000; ++i) {
            EventCpo event = goldenEvent();
            event.kind = static_cast<ActionKind>(i % 3);
            event.q_AO = Quat{normal(random), normal(random), normal(random), normal(random)};
            event.q_AO.normalize();
            event.p_AO = Vec3{normal(random), normal(random), normal(random)};
            event.axis_A =
                Vec3{normal(random), normal(random), normal(random)}.normalized().cast<float>();
            event.rate = static_cast<float>(normal(random));
            auto bytes = encodeHeader({});
            std::ranges::copy(encoded(event), std::back_inserter(bytes));
            const auto datagram = decodeDatagram(bytes);
            QVERIFY(datagram);
            const auto& got = std::get<EventCpo>(datagram->records[0]);
            QVERIFY(got.object == event.object && got.epoch == event.epoch
                    && got.action == event.action && got.kind == event.kind
                    && got.start == event.start);
            QVERIFY(got.q_AO.coeffs() == event.q_AO.coeffs());
            QVERIFY(got.p_AO == event.p_AO);
            QVERIFY(got.axis_A == event.axis_A);
            QVERIFY(got.rate == event.rate && got.scale == event.scale);
        }
    }

    void streamsArriveWithinTheDocumentedSteps_data()
    {
        QTest::addColumn<std::int64_t>("epoch");
        QTest::newRow("before the epoch") << std::int64_t{-5'000'000'000'000};
        QTest::newRow("around the epoch") << std::int64_t{0};
        QTest::newRow("where 32 bits of microseconds wrap") << std::int64_t{0x1'0000'0000} * 1000;
        QTest::newRow("a year on") << std::int64_t{365} * 86400 * 1'000'000'000;
    }

    void streamsArriveWithinTheDocumentedSteps()
    {
        QFETCH(std::int64_t, epoch);
        std::mt19937 random{11};
        for (int round = 0; round < 200; ++round) {
            StreamGroup group{ParticipantId{1}, 2, StationId{3}, {}};
            const SessionTime around{Duration{epoch}};
            group.streams.push_back(randomStream(random, around));
            group.streams[0].time = around;
            while (group.streams.size() < kStreamsPerGroup)
                group.streams.push_back(randomStream(random, around));
            auto bytes = encodeHeader({});
            std::ranges::copy(encoded(group), std::back_inserter(bytes));
            QVERIFY(bytes.size() <= kLargestDatagram);
            const auto datagram = decodeDatagram(bytes);
            QVERIFY(datagram);
            const auto& got = std::get<StreamGroup>(datagram->records[0]);
            QCOMPARE(got.streams.size(), kStreamsPerGroup);
            for (std::size_t i = 0; i < kStreamsPerGroup; ++i)
                QVERIFY(arrivedWithinSteps(got.streams[i], group.streams[i]));
        }
    }

    void formsArriveWithinTheDocumentedSteps()
    {
        std::mt19937 random{12};
        std::uniform_real_distribution<double> unit{-1.0, 1.0};
        for (int round = 0; round < 200; ++round) {
            StreamCpo sent = randomStream(random, SessionTime{});
            StreamShape& form = sent.shape.emplace();
            form.time = sent.time - fromSeconds(0.12 * (1.0 + unit(random)));
            form.length = 0.325 * (1.0 + unit(random)) + 1e-4;
            form.thickness = 0.0125 * (1.0 + unit(random)) + 2e-4;
            for (double& perMetre : form.atRest)
                perMetre = 65.5 * unit(random);
            for (double& perMetre : form.perMetre)
                perMetre = 65.5 * unit(random);
            form.heldBack = 0.325 * (1.0 + unit(random));
            auto bytes = encodeHeader({});
            const auto record = encoded(StreamGroup{ParticipantId{1}, 2, StationId{3}, {sent}});
            QCOMPARE(record.size(), 1 + kStreamGroupHeaderBytes + bytesOf(sent));
            std::ranges::copy(record, std::back_inserter(bytes));
            const auto datagram = decodeDatagram(bytes);
            QVERIFY(datagram);
            const StreamCpo& got = std::get<StreamGroup>(datagram->records[0]).streams.front();
            QVERIFY(arrivedWithinSteps(got, sent) && got.shape);
            QVERIFY(std::abs(toSeconds(got.shape->time - form.time)) <= kFormTimeTolerance);
            QVERIFY(std::abs(got.shape->length - form.length) <= kPositionTolerance);
            QVERIFY(std::abs(got.shape->heldBack - form.heldBack) <= kPositionTolerance);
            QVERIFY(std::abs(got.shape->thickness - form.thickness) <= kThicknessTolerance);
            for (std::size_t i = 0; i < form.atRest.size(); ++i)
                QVERIFY(std::abs(got.shape->atRest[i] - form.atRest[i]) <= kCurvatureTolerance);
            for (std::size_t i = 0; i < form.perMetre.size(); ++i)
                QVERIFY(std::abs(got.shape->perMetre[i] - form.perMetre[i]) <= kCurvatureTolerance);
        }
    }

    /// Rather than another one.
    void aFormOutOfItsRangeIsNotSent_data()
    {
        QTest::addColumn<qint64>("age_us");
        QTest::addColumn<double>("length_m");
        QTest::addColumn<double>("thickness_m");
        QTest::addColumn<double>("perMetre");
        QTest::addColumn<double>("heldBack_m");
        QTest::newRow("too old") << qint64{256'000} << 0.3 << 0.01 << 1.0 << 0.0;
        QTest::newRow("of later than its sample") << qint64{-1} << 0.3 << 0.01 << 1.0 << 0.0;
        QTest::newRow("without length") << qint64{0} << 0.0 << 0.01 << 1.0 << 0.0;
        QTest::newRow("curved at rest without both") << qint64{0} << 0.0 << 0.0 << 1.0 << 0.0;
        QTest::newRow("too long") << qint64{0} << 0.66 << 0.01 << 1.0 << 0.0;
        QTest::newRow("without thickness") << qint64{0} << 0.3 << 0.0 << 1.0 << 0.0;
        QTest::newRow("too thick") << qint64{0} << 0.3 << 0.0256 << 1.0 << 0.0;
        QTest::newRow("too curved") << qint64{0} << 0.3 << 0.01 << 65.6 << 0.0;
        QTest::newRow("not a number")
            << qint64{0} << 0.3 << 0.01 << std::numeric_limits<double>::quiet_NaN() << 0.0;
        QTest::newRow("too far behind") << qint64{0} << 0.3 << 0.01 << 1.0 << 0.66;
        QTest::newRow("in front of its pose") << qint64{0} << 0.3 << 0.01 << 1.0 << -0.001;
    }

    void aFormOutOfItsRangeIsNotSent()
    {
        QFETCH(qint64, age_us);
        QFETCH(double, length_m);
        QFETCH(double, thickness_m);
        QFETCH(double, perMetre);
        QFETCH(double, heldBack_m);
        StreamCpo stream = goldenStream();
        const auto plain = encoded(StreamGroup{ParticipantId{1}, 2, StationId{3}, {stream}});
        stream.shape = StreamShape{stream.time - std::chrono::microseconds{age_us},
                                   length_m,
                                   thickness_m,
                                   {7.0, 7.0},
                                   {1.0, perMetre},
                                   heldBack_m};
        QCOMPARE(bytesOf(stream), kStreamCpoBytes);
        QCOMPARE(toHex(encoded(StreamGroup{ParticipantId{1}, 2, StationId{3}, {stream}})),
                 toHex(plain));
    }

    void largestFactFitsIntoOneDatagram()
    {
        FactRecord fact = goldenFact();
        fact.body.assign(kLargestFactBody, std::byte{0x5A});
        auto bytes = encodeHeader({});
        std::ranges::copy(encoded(fact), std::back_inserter(bytes));
        QVERIFY(bytes.size() <= kLargestDatagram);
        const auto datagram = decodeDatagram(bytes);
        QVERIFY(datagram);
        QVERIFY(std::get<FactRecord>(datagram->records[0]) == fact);
    }

    void everyReasonThatTravelsArrives()
    {
        std::uint8_t number = 1;
        for (const Errc reason : {Errc::NotPermitted,    Errc::SessionEnded,  Errc::NameTaken,
                                  Errc::OutOfRange,      Errc::StoreFailed,   Errc::PacketMalformed,
                                  Errc::VersionMismatch, Errc::NotFinite,     Errc::OwnerChanged,
                                  Errc::NameUnclear,     Errc::SessionFull,   Errc::TooMuchSent,
                                  Errc::Muted,           Errc::Removed,       Errc::Banned,
                                  Errc::SessionLocked,   Errc::UsedElsewhere, Errc::StationUnknown,
                                  Errc::StationOccupied, Errc::StationCount}) {
            auto bytes = encodeHeader({});
            std::ranges::copy(encoded(HelloRefused{reason, {}}), std::back_inserter(bytes));
            QCOMPARE(bytes[bytes.size() - 2], std::byte{number++});
            const auto datagram = decodeDatagram(bytes);
            QVERIFY(datagram);
            QCOMPARE(std::get<HelloRefused>(datagram->records[0]).reason, reason);
        }
    }

    void anyOtherReasonArrivesAsNotPermitted()
    {
        QCOMPARE(toHex(encoded(HelloRefused{Errc::TrackerFailed, {}})), QByteArray{"09 01 00"});
    }

    void recordsKeepTheirOrder()
    {
        const auto datagram = decodeDatagram(
            fromHex((std::string{kPlainHeaderHex} + "0a 0b 05 02 01 00 00 00 00 00 00").c_str()));
        QVERIFY(datagram);
        QCOMPARE(datagram->records.size(), std::size_t{3});
        QVERIFY(std::holds_alternative<ConnectionUnknown>(datagram->records[0]));
        QVERIFY(std::holds_alternative<Goodbye>(datagram->records[1]));
        QCOMPARE(std::get<FactAck>(datagram->records[2]).last, FactNumber{0x0102});
    }

    void documentedSizesHold()
    {
        QCOMPARE(kBundleHeaderBytes, fromHex(kPlainHeaderHex).size());
        // The architecture's limits: about 40 bytes for a stream, at most 96 for an event.
        const StreamGroup one{{}, 0, {}, {goldenStream()}};
        const StreamGroup two{{}, 0, {}, {goldenStream(), goldenStream()}};
        QCOMPARE(encoded(two).size() - encoded(one).size(), std::size_t{37});
        QCOMPARE(encoded(goldenEvent()).size(), std::size_t{94});
    }
};

CARINA_TEST(TestDatagramLayout)

} // namespace carina::datagram_layout_test

#include "tst_datagram_layout.moc"
