#include "engine/tracking/igtl/igtl_reader.h"

#include "tests/engine/tracking/igtl/igtl_samples.h"
#include "tests/support/test_class.h"

namespace carina::igtl_reader_test
{
namespace
{

using test::igtlSamples;
using test::kQuarterTurn;
using test::messageOf;
using test::streamOf;

void append(std::vector<std::byte>& all, const std::vector<std::byte>& bytes)
{
    all.insert(all.end(), bytes.begin(), bytes.end());
}

/// A message of a type that is not read; its body is not looked at.
std::vector<std::byte> image(std::size_t bodyBytes)
{
    auto bytes = encodeIgtl(messageOf(IgtlQuery{"IMAGE"}));
    for (std::size_t i = 0; i < 8; ++i)
        bytes[42 + i] = std::byte((std::uint64_t{bodyBytes} >> (56 - 8 * i)) & 0xFFU);
    bytes.resize(bytes.size() + bodyBytes, std::byte{0x55});
    return bytes;
}

} // namespace

class IgtlReaderTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsAStreamHoweverItIsCut_data()
    {
        QTest::addColumn<int>("piece");
        for (const int piece : {1, 7, 57, 58, 59, 1000, 1 << 20})
            QTest::addRow("%d bytes at once", piece) << piece;
    }

    void readsAStreamHoweverItIsCut()
    {
        QFETCH(const int, piece);
        std::vector<std::byte> all;
        for (const IgtlMessage& message : igtlSamples()) {
            append(all, encodeIgtl(message));
            append(all, image(100));
        }
        const auto stream = streamOf(all, std::size_t(piece));
        QCOMPARE(stream.messages.size(), 2 * igtlSamples().size());
        QVERIFY(stream.refused == 0 && !stream.isWithin && !stream.isLost);
        std::vector<std::byte> again;
        for (const IgtlMessage& message : stream.messages) {
            if (std::holds_alternative<IgtlSkipped>(message.content))
                append(again, image(100));
            else
                append(again, encodeIgtl(message));
        }
        QVERIFY(again == all);
    }

    void goesOnBehindADamagedMessage()
    {
        auto bytes = encodeIgtl(messageOf(IgtlTransform{kQuarterTurn}));
        bytes.back() ^= std::byte{1};
        append(bytes, encodeIgtl(messageOf(IgtlStatus{})));
        const auto stream = streamOf(bytes);
        QCOMPARE(stream.refused, 1);
        QCOMPARE(stream.messages.size(), std::size_t{1});
        QVERIFY(std::holds_alternative<IgtlStatus>(stream.messages[0].content));
    }

    void goesOnBehindAMessageThatIsTooLong()
    {
        IgtlPolyData surface;
        surface.points.resize(20'000);
        auto bytes = encodeIgtl(messageOf(surface));
        append(bytes, encodeIgtl(messageOf(IgtlStatus{})));
        IgtlReader reader{64 * 1024};
        reader.take(bytes);
        QVERIFY(!reader.next().value());
        QVERIFY(reader.next().value().has_value());
        QVERIFY(!reader.next() && !reader.isWithin());
    }

    void givesUpWhereNoHeaderIs_data()
    {
        QTest::addColumn<int>("place");
        QTest::addColumn<int>("value");
        QTest::newRow("version 0") << 1 << 0;
        QTest::newRow("version 3") << 1 << 3;
        QTest::newRow("no type") << 2 << 0;
        QTest::newRow("a type that does not print") << 3 << 200;
        QTest::newRow("a body of four exabytes") << 42 << 0x40;
        QTest::newRow("a body of 512 MiB") << 46 << 0x20;
    }

    void givesUpWhereNoHeaderIs()
    {
        QFETCH(const int, place);
        QFETCH(const int, value);
        auto bytes = encodeIgtl(messageOf(IgtlStatus{}));
        bytes[std::size_t(place)] = std::byte(value);
        append(bytes, encodeIgtl(messageOf(IgtlStatus{})));
        const auto stream = streamOf(bytes);
        QVERIFY(stream.isLost && stream.messages.empty());
        QCOMPARE(stream.refused, 1);
    }
};

CARINA_TEST(IgtlReaderTest)

} // namespace carina::igtl_reader_test

#include "tst_igtl_reader.moc"
