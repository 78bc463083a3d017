#include "engine/sync/wire/datagram_codec.h"
#include "engine/sync/wire/record_codec.h"
#include "tests/engine/sync/wire/datagram_samples.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace carina::datagram_refusal_test
{
namespace
{

constexpr int kMutatedDatagrams = 100'000;

std::vector<std::byte> headerAnd(const char* recordHex)
{
    auto bytes = fromHex(kPlainHeaderHex);
    const auto record = fromHex(recordHex);
    bytes.insert(bytes.end(), record.begin(), record.end());
    return bytes;
}

bool isSoundNumber(double perMetre) { return std::abs(perMetre) < 66.0; }

bool isSound(const StreamShape& shape, SessionTime ofSample)
{
    const bool hasSize = shape.length > 0.0 && shape.thickness > 0.0;
    return shape.time <= ofSample && ofSample - shape.time < std::chrono::seconds{1}
           && (hasSize || shape.isOfPatientsTube()) && shape.length < 1.0 && shape.thickness < 0.03
           && std::ranges::all_of(shape.atRest, isSoundNumber)
           && std::ranges::all_of(shape.perMetre, isSoundNumber) && shape.heldBack >= 0.0
           && shape.heldBack < 1.0;
}

/// Everything that a node relies on after decoding.
bool isSound(const StreamCpo& stream)
{
    const bool moves =
        !stream.motion || (stream.motion->v_AO.allFinite() && stream.motion->w_AO.allFinite());
    return stream.X_AO.matrix().allFinite() && moves && stream.validity <= StreamValidity::Lost
           && stream.error >= 0.0 && stream.error <= 0.013
           && (!stream.shape || isSound(*stream.shape, stream.time))
           && std::chrono::abs(stream.time.time_since_epoch()) <= Duration{std::int64_t{1} << 61};
}

bool isSound(const EventCpo& event)
{
    const ActedPose later = evaluate(event, event.start + std::chrono::seconds{1});
    return std::abs(event.q_AO.norm() - 1.0) <= 1e-9
           && std::abs(event.axis_A.norm() - 1.0F) <= 1e-5F && std::abs(event.rate) <= 100.0F
           && event.scale > 0.0F && later.X_AO.matrix().allFinite();
}

bool isSound(const std::vector<std::byte>& body)
{
    return !body.empty() && body.size() <= kLargestFactBody;
}

struct RecordCheck {
    bool operator()(const StreamGroup& group) const
    {
        return !group.streams.empty() && group.streams.size() <= kStreamsPerGroup
               && std::ranges::all_of(group.streams, [](const auto& s) { return isSound(s); });
    }
    bool operator()(const EventCpo& event) const { return isSound(event); }
    bool operator()(const FactRecord& fact) const
    {
        return fact.number.value >= 1 && isSound(fact.body);
    }
    bool operator()(const ProposalRecord& proposal) const { return isSound(proposal.body); }
    bool operator()(const Hello& hello) const { return isSound(hello.join.body); }
    template <class Other> bool operator()(const Other&) const { return true; }
};

} // namespace

class TestDatagramRefusal : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void refusesADatagramCutAnywhere_data()
    {
        QTest::addColumn<QByteArray>("hex");
        for (const GoldenRecord& golden : goldenRecords())
            QTest::newRow(golden.name) << QByteArray{golden.hex};
    }

    void refusesADatagramCutAnywhere()
    {
        QFETCH(QByteArray, hex);
        const auto bytes = headerAnd(hex.constData());
        for (std::size_t length = 0; length < bytes.size(); ++length) {
            const auto cut = decodeDatagram(std::span{bytes}.first(length));
            // A header alone is a whole datagram.
            QCOMPARE(cut.has_value(), length == kBundleHeaderBytes);
            if (!cut)
                QCOMPARE(cut.error().code, Errc::PacketMalformed);
        }
    }

    void refusesTrailingBytes()
    {
        for (const GoldenRecord& golden : goldenRecords()) {
            auto bytes = headerAnd(golden.hex);
            bytes.push_back(std::byte{0});
            QVERIFY(!decodeDatagram(bytes));
        }
    }

    void refusesWhatIsLongerThanADatagram()
    {
        // Whole records: acknowledgements of 9 bytes and goodbyes of 1.
        auto bytes = fromHex(kPlainHeaderHex);
        while (bytes.size() < kLargestDatagram)
            bytes.push_back(std::byte{0x0B});
        QVERIFY(decodeDatagram(bytes));
        bytes.push_back(std::byte{0x0B});
        QCOMPARE(decodeDatagram(bytes).error().detail, std::string{"length"});
    }

    void tellsAnotherVersionFromNonsense()
    {
        auto bytes = fromHex(kPlainHeaderHex);
        bytes[2] = std::byte{5};
        QCOMPARE(decodeDatagram(bytes).error(), (Error{Errc::VersionMismatch, "5"}));
        bytes[2] = std::byte{200};
        QCOMPARE(decodeDatagram(bytes).error(), (Error{Errc::VersionMismatch, "200"}));
        bytes[2] = std::byte{0};
        QCOMPARE(decodeDatagram(bytes).error(), (Error{Errc::VersionMismatch, "0"}));
        // Magic and version stay where they are in every version; nothing else need.
        QCOMPARE(decodeDatagram(std::span{bytes}.first(3)).error().code, Errc::VersionMismatch);
        bytes[0] = std::byte{0};
        QCOMPARE(decodeDatagram(bytes).error(), (Error{Errc::PacketMalformed, "magic"}));
    }

    void refusesWhatBreaksARule_data()
    {
        QTest::addColumn<int>("record");
        QTest::addColumn<int>("offset"); // from the start of the record; of the header if negative
        QTest::addColumn<QByteArray>("hex");
        QTest::addColumn<QByteArray>("rule");
        const auto row = [](const char* name, int record, int offset, const char* hex,
                            const char* rule) {
            QTest::newRow(name) << record << offset << QByteArray{hex} << QByteArray{rule};
        };
        row("magic", 4, -34, "00", "magic");
        row("magic's second byte", 4, -33, "00", "magic");
        row("unknown header flag", 4, -31, "08", "header flags");
        row("last header flag", 4, -31, "80", "header flags");
        row("echo without its flag", 4, -12, "01", "clock echo");
        row("hold without its flag", 4, -1, "01", "clock echo");
        row("sent beyond the range of times", 4, -20, "01 00 00 00 00 00 00 20", "time");
        row("sent before the range of times", 4, -20, "ff ff ff ff ff ff ff df", "time");
        row("record kind zero", 4, 0, "00", "record kind");
        row("record kind above the last", 4, 0, "12", "record kind");
        row("record kind above all", 4, 0, "ff", "record kind");
        row("no streams", 0, 11, "00", "stream count");
        row("too many streams", 0, 11, "1f", "stream count");
        row("more streams than bytes", 0, 11, "03", "length");
        row("time too far on", 0, 7, "21 a1 07 00", "time");
        row("time too far back", 0, 7, "df 5e f8 ff", "time");
        row("times far apart", 0, 55, "00 00 00 80", "time");
        row("validity", 0, 16, "1e", "validity");
        row("unknown stream flag", 0, 16, "56", "stream flags");
        row("first unknown stream flag", 0, 53, "4b", "stream flags");
        row("last stream flag", 0, 16, "96", "stream flags");
        row("rotation's lowest code", 0, 22, "00 80", "rotation");
        row("rotation too long", 0, 22, "ff 7f", "rotation");
        row("position's lowest code", 0, 28, "00 00 80", "position");
        row("velocity's lowest code", 0, 37, "00 80", "velocity");
        row("angular velocity's lowest code", 0, 47, "00 80", "velocity");
        row("motion without its flag", 0, 16, "06", "motion");
        row("angular motion without its flag", 0, 80, "01", "motion");
        row("form without its bytes", 0, 53, "2b", "length");
        row("form without a thickness", 19, 50, "00", "size of a form");
        row("form without a length", 19, 51, "00 00", "size of a form");
        row("lowest code of a form at rest", 19, 53, "00 80", "form");
        row("patient's tube with a thickness", 20, 50, "01", "size of a form");
        row("patient's tube with a length", 20, 51, "01 00", "size of a form");
        row("patient's tube curved at rest", 20, 55, "01 00", "form at rest");
        row("form's lowest code", 19, 57, "00 80", "form");
        row("form's last code the lowest", 19, 71, "00 80", "form");
        row("action kind", 1, 9, "03", "action kind");
        row("event beyond the range of times", 1, 10, "01 00 00 00 00 00 00 20", "time");
        row("quaternion too long", 1, 18, "00 00 80 00 00 00 f0 3f", "rotation");
        row("quaternion too short", 1, 18, "00 00 00 ff ff ff ef 3f", "rotation");
        row("quaternion not a number", 1, 42, "00 00 00 00 00 00 f8 7f", "rotation");
        row("position infinite", 1, 50, "00 00 00 00 00 00 f0 7f", "position");
        row("position not a number", 1, 66, "00 00 00 00 00 00 f8 7f", "position");
        row("axis zero", 1, 78, "00 00 00 00", "axis");
        row("axis too long", 1, 78, "00 01 80 3f", "axis");
        row("axis not a number", 1, 74, "00 00 c0 7f", "axis");
        row("position too far", 1, 50, "01 00 00 00 80 84 2e 41", "position");
        row("rate above the fastest", 1, 86, "01 00 c8 42", "rate");
        row("rate below the fastest backwards", 1, 86, "01 00 c8 c2", "rate");
        row("rate infinite", 1, 86, "00 00 80 ff", "rate");
        row("rate not a number", 1, 86, "00 00 c0 7f", "rate");
        row("scale zero", 1, 90, "00 00 00 00", "scale");
        row("scale negative", 1, 90, "00 00 80 bf", "scale");
        row("scale infinite", 1, 90, "00 00 80 7f", "scale");
        row("scale not a number", 1, 90, "00 00 c0 7f", "scale");
        row("fact number zero", 2, 1, "00 00 00 00 00 00 00 00", "fact number");
        row("committed beyond the range of times", 2, 21, "01 00 00 00 00 00 00 20", "time");
        row("effect before the range of times", 2, 29, "ff ff ff ff ff ff ff df", "time");
        row("fact without a body", 2, 37, "00 00", "body length");
        row("fact with too long a body", 2, 37, "01 04", "body length");
        row("fact with a body cut short", 2, 37, "04 00", "length");
        row("proposal without a body", 3, 11, "00 00", "body length");
        row("proposal with the longest length", 3, 11, "ff ff", "body length");
        row("hello without a proposal", 6, 35, "00 00", "body length");
        row("hello with too long a station", 6, 39, "41", "length of a station's name");
        row("reason zero", 5, 9, "00", "reason");
        row("reason above the last", 5, 9, "15", "reason");
        row("reason above all", 8, 1, "ff", "reason");
        row("too many words", 8, 2, "c9", "length of a detail");
        row("more words than bytes", 8, 2, "01", "length");
        row("strategy above the last", 14, 1, "08", "number of a strategy");
        row("strategy without a message", 14, 2, "00", "length of a strategy's message");
        row("strategy with too long a message", 14, 2, "81", "length of a strategy's message");
        row("strategy with a message cut short", 14, 2, "04", "length");
        row("shown rotation too long", 16, 11, "00 00 80 00 00 00 f0 3f", "rotation");
        row("shown position infinite", 16, 43, "00 00 00 00 00 00 f0 7f", "position");
        row("shown size zero", 16, 67, "00 00 00 00", "scale");
        row("shown size negative", 16, 67, "00 00 80 bf", "scale");
        row("shown size infinite", 16, 67, "00 00 80 7f", "scale");
        row("shown size not a number", 16, 67, "00 00 c0 7f", "scale");
        row("clock without an error", 17, 9, "00 00 00 00 00 00 00 00", "error of a clock");
        row("clock off by more than 16 s", 17, 9, "01 a0 ac b9 03 00 00 00", "error of a clock");
        row("negative error of a clock", 17, 9, "ff ff ff ff ff ff ff ff", "error of a clock");
    }

    void refusesWhatBreaksARule()
    {
        QFETCH(int, record);
        QFETCH(int, offset);
        QFETCH(QByteArray, hex);
        QFETCH(QByteArray, rule);
        auto bytes = headerAnd(goldenRecords()[static_cast<std::size_t>(record)].hex);
        QVERIFY(decodeDatagram(bytes));
        const auto fault = fromHex(hex.constData());
        std::ranges::copy(fault, bytes.begin() + static_cast<int>(kBundleHeaderBytes) + offset);
        const auto datagram = decodeDatagram(bytes);
        QVERIFY(!datagram);
        QCOMPARE(datagram.error().code, Errc::PacketMalformed);
        QCOMPARE(QByteArray::fromStdString(datagram.error().detail), rule);
    }

    void acceptsTheLastValueWithinEachRule_data()
    {
        QTest::addColumn<int>("record");
        QTest::addColumn<int>("offset");
        QTest::addColumn<QByteArray>("hex");
        const auto row = [](const char* name, int record, int offset, const char* hex) {
            QTest::newRow(name) << record << offset << QByteArray{hex};
        };
        row("latest time", 4, -20, "00 00 00 00 00 00 00 20");
        row("earliest time", 4, -20, "00 00 00 00 00 00 00 e0");
        row("latest time of a stream", 0, 7, "20 a1 07 00");
        row("earliest time of a stream", 0, 7, "e0 5e f8 ff");
        row("half an hour after the first", 0, 55, "05 d2 49 6b");
        row("half an hour before the first", 0, 55, "05 2e b6 94");
        row("position's lowest value", 0, 28, "01 00 80");
        row("velocity's lowest value", 0, 37, "01 80");
        row("largest error", 0, 17, "ff");
        row("longest quaternion", 1, 18, "00 00 40 00 00 00 f0 3f");
        row("shortest quaternion", 1, 18, "00 00 80 ff ff ff ef 3f");
        row("form as old as may be", 19, 49, "ff");
        row("thinnest and shortest form", 19, 50, "01 01 00");
        row("form's lowest value", 19, 57, "01 80");
        row("first kind of action", 1, 9, "00");
        row("smallest scale", 1, 90, "01 00 00 00");
        row("farthest position", 1, 50, "00 00 00 00 80 84 2e 41");
        row("fastest rate", 1, 86, "00 00 c8 42");
        row("fastest rate backwards", 1, 86, "00 00 c8 c2");
        row("last strategy", 14, 1, "07");
        row("smallest size shown", 16, 67, "01 00 00 00");
        row("first fact", 2, 1, "01 00 00 00 00 00 00 00");
        row("last reason", 5, 9, "08");
    }

    void acceptsTheLastValueWithinEachRule()
    {
        QFETCH(int, record);
        QFETCH(int, offset);
        QFETCH(QByteArray, hex);
        auto bytes = headerAnd(goldenRecords()[static_cast<std::size_t>(record)].hex);
        const auto value = fromHex(hex.constData());
        std::ranges::copy(value, bytes.begin() + static_cast<int>(kBundleHeaderBytes) + offset);
        const auto datagram = decodeDatagram(bytes);
        QVERIFY2(datagram, datagram ? "" : datagram.error().detail.c_str());
    }

    void mutatedDatagramsAreRefusedOrSound()
    {
        std::vector<std::vector<std::byte>> corpus{fromHex(kGoldenHeaderHex)};
        for (const GoldenRecord& golden : goldenRecords())
            corpus.push_back(headerAnd(golden.hex));
        auto everything = fromHex(kGoldenHeaderHex);
        for (const GoldenRecord& golden : goldenRecords())
            std::ranges::copy(fromHex(golden.hex), std::back_inserter(everything));
        corpus.push_back(everything);

        std::mt19937 random{20040607};
        int accepted = 0;
        for (int i = 0; i < kMutatedDatagrams; ++i) {
            auto bytes = corpus[random() % corpus.size()];
            for (std::uint32_t changes = 1 + random() % 4; changes > 0; --changes) {
                const std::size_t at = random() % (bytes.size() + 1);
                switch (random() % 4) {
                case 0:
                    bytes.insert(bytes.begin() + static_cast<int>(at),
                                 static_cast<std::byte>(random()));
                    break;
                case 1:
                    bytes.resize(at);
                    break;
                default:
                    if (at < bytes.size())
                        bytes[at] = static_cast<std::byte>(random());
                }
            }
            const auto datagram = decodeDatagram(bytes);
            if (!datagram)
                continue;
            ++accepted;
            for (const WireRecord& record : datagram->records)
                QVERIFY(std::visit(RecordCheck{}, record));
        }
        // Neither everything nor nothing: the mutations reach behind the header.
        QVERIFY(accepted > kMutatedDatagrams / 100);
        QVERIFY(accepted < kMutatedDatagrams / 2);
    }
};

CARINA_TEST(TestDatagramRefusal)

} // namespace carina::datagram_refusal_test

#include "tst_datagram_refusal.moc"
