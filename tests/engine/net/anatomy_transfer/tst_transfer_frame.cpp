#include "engine/net/anatomy_transfer/transfer_frame.h"

#include "engine/io/anatomy_set/set_hash.h"
#include "tests/engine/net/anatomy_transfer/frame_samples.h"
#include "tests/support/test_class.h"

#include <random>

namespace carina::transfer_frame_test
{
namespace
{

using namespace transfer;

constexpr int kMutated = 100'000;

std::span<const std::byte> bytesOf(const std::string& text)
{
    return std::as_bytes(std::span{text});
}

std::string textOf(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The frame that is all of the bytes.
std::optional<Frame> whole(const std::string& text)
{
    auto bytes = bytesOf(text);
    const auto frame = takeFrame(bytes);
    return frame && bytes.empty() ? *frame : std::nullopt;
}

bool isRefused(const std::string& text)
{
    auto bytes = bytesOf(text);
    const auto frame = takeFrame(bytes);
    return !frame && frame.error().code == Errc::PacketMalformed;
}

std::string frameOf(char kind, const std::string& body)
{
    const auto length = static_cast<std::uint32_t>(body.size());
    std::string text{kind};
    for (int byte = 0; byte < 4; ++byte)
        text += static_cast<char>(length >> (8 * byte));
    return text + body;
}

/// Everything that a program relies on after decoding.
struct FrameCheck {
    bool operator()(const Want& want) const
    {
        return want.version == kVersion ? isSetHash(want.contentHash) : want.contentHash.empty();
    }
    bool operator()(const Offer& offer) const
    {
        return isSetHash(offer.digest) && offer.licence.size() <= 1024;
    }
    bool operator()(const Refusal& refusal) const
    {
        return refusal.reason >= Reason::NotNamed && refusal.reason <= Reason::Busy;
    }
    bool operator()(const Get&) const { return true; }
    bool operator()(const Chunk& chunk) const
    {
        return !chunk.bytes.empty() && chunk.bytes.size() <= 65'536;
    }
};

} // namespace

class TestTransferFrame : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void laysEveryFrameOutAsDocumented()
    {
        const auto golden = test::goldenFrames();
        const std::string chunk{"\0\1\2\xff", 4};
        const std::vector<Frame> frames{Want{1, test::kContentHash},
                                        Offer{0x05060708, test::kDigest, "CC0"},
                                        Offer{1, test::kDigest, {}},
                                        Refusal{Reason::Withdrawn},
                                        Get{65'536},
                                        Chunk{bytesOf(chunk)}};
        const std::array places{0, 2, 3, 4, 5, 6};
        for (std::size_t i = 0; i < frames.size(); ++i)
            QCOMPARE(textOf(encode(frames[i])), golden[std::size_t(places[i])].bytes);
    }

    void readsWhatWasWritten()
    {
        const auto golden = test::goldenFrames();
        QCOMPARE(std::get<Want>(*whole(golden[0].bytes)).contentHash, test::kContentHash);
        const auto later = std::get<Want>(*whole(golden[1].bytes));
        QCOMPARE(later.version, std::uint8_t{2});
        QCOMPARE(later.contentHash, std::string{});
        const auto offer = std::get<Offer>(*whole(golden[2].bytes));
        QCOMPARE(offer.bytes, std::uint64_t{0x05060708});
        QCOMPARE(offer.digest, test::kDigest);
        QCOMPARE(offer.licence, std::string{"CC0"});
        QCOMPARE(std::get<Offer>(*whole(golden[3].bytes)).licence, std::string{});
        QVERIFY(std::get<Refusal>(*whole(golden[4].bytes)).reason == Reason::Withdrawn);
        QCOMPARE(std::get<Get>(*whole(golden[5].bytes)).offset, std::uint64_t{65'536});
        QCOMPARE(textOf(std::get<Chunk>(*whole(golden[6].bytes)).bytes),
                 (std::string{"\0\1\2\xff", 4}));
    }

    void waitsForAFrameThatIsNotThereWhole()
    {
        for (const test::GoldenFrame& golden : test::goldenFrames())
            for (std::size_t length = 0; length < golden.bytes.size(); ++length) {
                const std::string cut = golden.bytes.substr(0, length);
                auto bytes = bytesOf(cut);
                const auto frame = takeFrame(bytes);
                QVERIFY2(frame && !*frame && bytes.size() == length, golden.name);
            }
    }

    void takesFramesOneAfterTheOther()
    {
        std::string stream;
        for (const test::GoldenFrame& golden : test::goldenFrames())
            stream += golden.bytes;
        auto bytes = bytesOf(stream);
        for (const std::size_t place : {0, 0, 1, 1, 2, 3, 4}) {
            const auto frame = takeFrame(bytes);
            QVERIFY(frame && *frame);
            QCOMPARE((*frame)->index(), place);
        }
        QVERIFY(bytes.empty());
    }

    void refusesByTheHeaderAlone_data()
    {
        QTest::addColumn<QByteArray>("header");
        QTest::newRow("kind 0") << QByteArray::fromHex("0001000000");
        QTest::newRow("kind 6") << QByteArray::fromHex("0601000000");
        QTest::newRow("a byte too long") << QByteArray::fromHex("0501000100");
        QTest::newRow("as long as can be said") << QByteArray::fromHex("05ffffffff");
    }
    void refusesByTheHeaderAlone()
    {
        QFETCH(const QByteArray, header);
        QVERIFY(isRefused(header.toStdString()));
    }

    void refusesABodyThatBreaksARule_data()
    {
        QTest::addColumn<QByteArray>("frame");
        const auto row = [](const char* name, char kind, const std::string& body) {
            QTest::newRow(name) << QByteArray::fromStdString(frameOf(kind, body));
        };
        using test::raw;
        const std::string bytes = raw("\1\0\0\0\0\0\0\0");
        row("want with other first bytes", 1, raw("CT\1") + test::kContentHash);
        row("want without a version", 1, "CS");
        row("want with a hash in capitals", 1, raw("CS\1") + std::string(64, 'F'));
        row("want with a name for a hash", 1, raw("CS\1") + "../" + std::string(61, 'a'));
        row("want with more", 1, raw("CS\1") + std::string(65, 'a'));
        row("offer with a digest in capitals", 2, bytes + std::string(64, 'A') + raw("\0\0"));
        row("offer with a licence that is too long", 2,
            bytes + test::kDigest + raw("\1\4") + std::string(1025, 'x'));
        row("offer with less licence than said", 2, bytes + test::kDigest + raw("\2\0x"));
        row("offer with more", 2, bytes + test::kDigest + raw("\1\0xx"));
        row("refusal for no reason", 3, raw("\0"));
        row("refusal for a reason of its own", 3, raw("\5"));
        row("refusal without a word", 3, {});
        row("get with seven bytes", 4, raw("\0\0\0\0\0\0\0"));
        row("get with nine bytes", 4, raw("\0\0\0\0\0\0\0\0\0"));
        row("chunk of nothing", 5, {});
    }
    void refusesABodyThatBreaksARule()
    {
        QFETCH(const QByteArray, frame);
        QVERIFY(isRefused(frame.toStdString()));
    }

    void takesWhatJustKeepsToTheRules()
    {
        const std::string bytes = test::raw("\1\0\0\0\0\0\0\0");
        QVERIFY(
            whole(frameOf(2, bytes + test::kDigest + test::raw("\0\4") + std::string(1024, 'x'))));
        QVERIFY(whole(frameOf(3, "\1")));
        QVERIFY(whole(frameOf(3, "\4")));
        QVERIFY(whole(frameOf(5, std::string(65'536, 'x'))));
        QVERIFY(whole(frameOf(5, "x")));
    }

    void whateverComesIsTakenApartSoundlyOrRefused()
    {
        std::mt19937 random{7};
        const auto below = [&](std::size_t n) { return std::size_t(random() % n); };
        int taken = 0;
        for (int i = 0; i < kMutated; ++i) {
            const auto golden = test::goldenFrames();
            std::string stream =
                golden[below(golden.size())].bytes + golden[below(golden.size())].bytes;
            for (std::size_t n = below(4); n > 0; --n)
                stream[below(stream.size())] = static_cast<char>(random());
            stream.resize(below(stream.size()) + 1);
            auto bytes = bytesOf(stream);
            while (true) {
                const std::size_t before = bytes.size();
                const auto frame = takeFrame(bytes);
                if (!frame || !*frame) {
                    QCOMPARE(bytes.size(), before);
                    break;
                }
                QVERIFY(std::visit(FrameCheck{}, **frame));
                QVERIFY(bytes.size() < before);
                ++taken;
            }
        }
        QVERIFY(taken > kMutated / 10);
    }
};

CARINA_TEST(TestTransferFrame)

} // namespace carina::transfer_frame_test

#include "tst_transfer_frame.moc"
