#include "engine/sync/wire/datagram_codec.h"
#include "engine/sync/wire/record_codec.h"
#include "tests/engine/sync/wire/datagram_samples.h"
#include "tests/support/test_class.h"

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
    return shape.time <= ofSample && ofSample - shape.time < std::chrono::seconds{1}
           && shape.length > 0.0 && shape.length < 1.0 && shape.thickness > 0.0
           && shape.thickness < 0.03 && std::ranges::all_of(shape.atRest, isSoundNumber)
           && std::ranges::all_of(shape.perMetre, isSoundNumber);
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
        row("form's lowest code", 19, 57, "00 80", "form");
        row("form's last code the lowest", 19, 71, "00 80", "form");
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
