#include "engine/tracking/igtl/igtl_codec.h"

#include "engine/tracking/igtl/igtl_checksum.h"
#include "tests/engine/tracking/igtl/igtl_samples.h"
#include "tests/support/hex.h"
#include "tests/support/test_class.h"

#include <random>

namespace carina::igtl_codec_test
{
namespace
{

using test::igtlSamples;
using test::kQuarterTurn;
using test::messageOf;
using test::streamOf;

/// The bytes of a message, with others at a place of its body and the checksum made right.
std::vector<std::byte> altered(const IgtlMessage& message, std::size_t place, const QByteArray& hex)
{
    std::vector<std::byte> bytes = encodeIgtl(message);
    std::ranges::copy(fromHex(hex), bytes.begin() + std::ptrdiff_t(IgtlHeader::kBytes + place));
    const std::uint64_t sum = igtlChecksum(std::span{bytes}.subspan(IgtlHeader::kBytes));
    for (std::size_t i = 0; i < 8; ++i)
        bytes[IgtlHeader::kBytes - 1 - i] = std::byte((sum >> (8 * i)) & 0xFFU);
    return bytes;
}

IgtlPolyData triangle()
{
    IgtlPolyData surface;
    surface.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    surface.cells[kIgtlPolygons] = {1, {3, 0, 1, 2}};
    surface.attributes = {{0, 1, 1, "age", {4}}};
    return surface;
}

} // namespace

class IgtlCodecTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The check value of CRC-64/ECMA-182 in the catalogue of parametrised CRC algorithms.
    void knowsTheChecksum()
    {
        const std::string text = "123456789";
        QCOMPARE(igtlChecksum(std::as_bytes(std::span{text})), std::uint64_t{0x6C40DF5F0B497347});
    }

    void readsWhatItWrote()
    {
        for (const IgtlMessage& message : igtlSamples()) {
            const auto bytes = encodeIgtl(message);
            const auto stream = streamOf(bytes);
            QCOMPARE(stream.messages.size(), std::size_t{1});
            const IgtlMessage& read = stream.messages[0];
            QCOMPARE(read.device, message.device);
            QCOMPARE(read.stamp, message.stamp);
            QCOMPARE(read.metadata.size(), message.metadata.size());
            QCOMPARE(read.content.index(), message.content.index());
            QCOMPARE(toHex(encodeIgtl(read)), toHex(bytes));
        }
    }

    /// Written by hand from the description of the protocol.
    void writesVersion2ByteForByte()
    {
        IgtlMessage message = messageOf(IgtlReply{"RTS_TDATA", 0}, "Carina");
        message.version = 2;
        message.stamp = 0x1'0000'0000;
        message.id = 5;
        message.metadata = {{"a", 3, "bc"}};
        const QByteArray body = "000c 000a 00000003 00000005"               // extended header
                                "00"                                        // content
                                "0001 0001 0003 00000002 61 6263";          // metadata
        const QByteArray head = "0002 5254535f5444415441000000"             // RTS_TDATA
                                "436172696e61 0000000000000000000000000000" // Carina
                                "0000000100000000 000000000000001a";
        const auto bytes = encodeIgtl(message);
        QCOMPARE(toHex(std::span{bytes}.first(50)), toHex(fromHex(head)));
        QCOMPARE(toHex(std::span{bytes}.subspan(58)), toHex(fromHex(body)));
    }

    void refusesWhatContradictsItself_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        const auto row = [](const char* name, const std::vector<std::byte>& bytes) {
            QTest::newRow(name) << QByteArray{reinterpret_cast<const char*>(bytes.data()),
                                              qsizetype(bytes.size())};
        };
        const IgtlMessage surface = messageOf(triangle());
        row("more points than there are", altered(surface, 0, "7fffffff"));
        row("more cells than there are", altered(surface, 20, "00000002"));
        row("cells of more bytes than there are", altered(surface, 24, "7ffffffc"));
        row("cells of broken words", altered(surface, 24, "0000000f"));
        row("a cell of too many corners", altered(surface, 40 + 36, "ffffffff"));
        row("a corner that is no point", altered(surface, 40 + 36 + 4, "00000003"));
        row("more attributes than there are", altered(surface, 36, "ffffffff"));
        row("more values than there are", altered(surface, 40 + 36 + 16 + 2, "ffffffff"));
        IgtlMessage extended = messageOf(IgtlTransform{kQuarterTurn});
        extended.version = 2;
        extended.metadata = {{"key", 3, "value"}};
        row("an extension that is too short", altered(extended, 0, "000b"));
        row("an extension beyond the end", altered(extended, 0, "ffff"));
        row("metadata beyond the end", altered(extended, 2, "ffff"));
        row("words beyond the end", altered(extended, 4, "ffffffff"));
        row("more metadata than there are", altered(extended, 12 + 48, "0002"));
        row("a key beyond the end", altered(extended, 12 + 48 + 2, "0009"));
        row("a value beyond the end", altered(extended, 12 + 48 + 6, "ffffffff"));
        row("a text of another length", altered(messageOf(IgtlString{3, "ab"}), 2, "0003"));
    }

    void refusesWhatContradictsItself()
    {
        QFETCH(const QByteArray, bytes);
        const auto stream =
            streamOf(std::as_bytes(std::span{bytes.constData(), std::size_t(bytes.size())}));
        QCOMPARE(stream.refused, 1);
        QVERIFY(stream.messages.empty() && !stream.isWithin && !stream.isLost);
    }

    void refusesEveryFlippedBitOfABody()
    {
        const auto good = encodeIgtl(messageOf(IgtlTransform{kQuarterTurn}));
        for (std::size_t bit = 8 * IgtlHeader::kBytes; bit < 8 * good.size(); ++bit) {
            auto bytes = good;
            bytes[bit / 8] ^= std::byte(1U << (bit % 8));
            QCOMPARE(streamOf(bytes).refused, 1);
        }
    }

    /// Not a crash, and nothing allocated that is not there (sanitizers watch).
    void survivesRandomBodiesWithTheRightChecksum()
    {
        std::mt19937 random{7};
        const auto samples = igtlSamples();
        for (int i = 0; i < 20'000; ++i) {
            const IgtlMessage& message = samples[random() % samples.size()];
            const std::size_t body = encodeIgtl(message).size() - IgtlHeader::kBytes;
            if (body == 0)
                continue;
            const auto byte = QByteArray::number(random() % 256U, 16).rightJustified(2, '0');
            const auto stream = streamOf(altered(message, random() % body, byte));
            QCOMPARE(std::size_t(stream.refused) + stream.messages.size(), std::size_t{1});
        }
    }
};

CARINA_TEST(IgtlCodecTest)

} // namespace carina::igtl_codec_test

#include "tst_igtl_codec.moc"
