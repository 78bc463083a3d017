#include "engine/tracking/ndi/ndi_command.h"
#include "engine/tracking/ndi/ndi_error.h"
#include "engine/tracking/ndi/ndi_reply.h"
#include "tests/engine/tracking/ndi/wire_bytes.h"
#include "tests/support/test_class.h"

#include <set>

namespace carina::ndi_reply_test
{
namespace
{

// Recorded from a Polaris: a reply to BX with two tools, both missing.
const std::string kHeader{"\xC4\xA5\x17\x00\"\xE3", 6};
const std::string kBody{"\x02\x01\x02\x31\x00\x00\x00\x00\x00\x00\x00\x02\x02\x31\x00\x00\x00\x00"
                        "\x00\x00\x00\x00\x00",
                        23};
const std::string kBinary = kHeader + kBody + "\xB1\x37";

std::string detailOf(const std::optional<Result<NdiReply>>& reply)
{
    return !reply ? "nothing" : *reply ? "a reply" : (*reply).error().detail;
}

} // namespace

class NdiReplyTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    // From recorded conversations.
    void computesRecordedChecksums_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("checksum");
        const auto row = [](const char* text, const char* checksum) {
            QTest::newRow(text) << QByteArray{text} << QByteArray{checksum};
        };
        row("RESET", "BE6F");
        row("INIT:", "E3A5");
        row("OKAY", "A896");
        row("COMM:00000", "0084");
        row("COMM:50000", "0048");
        row("PHSR:00", "20FF");
        row("PHSR:02", "E17E");
        row("TX:0001", "031A");
        row("BX:0001", "C26D");
        row("TSTART:", "5423");
        row("TSTOP:", "2C14");
    }

    void computesRecordedChecksums()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, checksum);
        QCOMPARE(QByteArray::fromStdString(ndiChecksumText(text.toStdString())), checksum);
    }

    void writesAndReadsCommands()
    {
        QCOMPARE(encoded({"TX", "0001"}), std::string{"TX:0001031A\r"});
        QCOMPARE(readNdiCommand("TX:0001031A\r").value(), (NdiCommand{"TX", "0001"}));
        QCOMPARE(readNdiCommand("INIT:E3A5").value(), (NdiCommand{"INIT", ""}));
        QCOMPARE(readNdiCommand("PINIT 1\r").value(), (NdiCommand{"PINIT", "1"}));
    }

    void refusesDamagedCommands_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("nothing") << QByteArray{};
        QTest::newRow("no name") << QByteArray{":0001031A"};
        QTest::newRow("no end of the name") << QByteArray{"TX"};
        QTest::newRow("small letters") << QByteArray{"tx:0001031A"};
        QTest::newRow("one bit off") << QByteArray{"TX:0003031A"};
        QTest::newRow("a small digit") << QByteArray{"TX:0001031a"};
        QTest::newRow("no checksum") << QByteArray{"TX:"};
    }

    void refusesDamagedCommands()
    {
        QFETCH(QByteArray, bytes);
        const auto command = readNdiCommand(bytes.toStdString());
        QVERIFY(!command);
        QCOMPARE(command.error().code, Errc::DeviceReplyDamaged);
    }

    void findsRepliesInPiecesOfAnySize_data()
    {
        QTest::addColumn<int>("piece");
        for (const int piece : {1, 2, 3, 5, 7, 64})
            QTest::addRow("%d bytes", piece) << piece;
    }

    void findsRepliesInPiecesOfAnySize()
    {
        QFETCH(int, piece);
        const std::string stream = "RESETBE6F\r" + kBinary + "OKAYA896\r" + kBinary;
        NdiReplyReader reader;
        std::vector<NdiReply> replies;
        for (std::size_t at = 0; at < stream.size(); at += std::size_t(piece)) {
            reader.take(std::string_view{stream}.substr(at, std::size_t(piece)));
            while (const auto reply = reader.next()) {
                QVERIFY(*reply);
                replies.push_back(**reply);
            }
        }
        const NdiReply binary{NdiReply::Form::Binary, kBody};
        QCOMPARE(
            replies,
            (std::vector<NdiReply>{
                {NdiReply::Form::Text, "RESET"}, binary, {NdiReply::Form::Text, "OKAY"}, binary}));
        QVERIFY(reader.isEmpty());
    }

    void readsTheLongHeader()
    {
        const test::WireBytes header =
            test::WireBytes{}.u16(0xA5C8).u32(std::uint32_t(kBody.size()));
        NdiReplyReader reader;
        reader.take(header.text());
        reader.take(test::WireBytes{}.u16(ndiChecksum(header.text())).text());
        reader.take(kBody + "\xB1\x37");
        const auto reply = reader.next();
        QVERIFY(reply && *reply);
        QCOMPARE((*reply)->bytes, kBody);
    }

    void refusesWhatIsDamagedAndGoesOn_data()
    {
        QTest::addColumn<QByteArray>("damaged");
        QTest::addColumn<QByteArray>("detail");
        const auto row = [](const char* name, const std::string& bytes, const char* detail) {
            QTest::newRow(name) << QByteArray::fromStdString(bytes) << QByteArray{detail};
        };
        row("a text", "OKAZA896\r", "wrong checksum");
        row("a short text", "OK\r", "shorter than a checksum");
        std::string body = kBinary;
        body[10] ^= 1;
        row("a body", body, "wrong checksum");
        std::string tail = kBinary;
        tail.back() ^= 1;
        row("the checksum of a body", tail, "wrong checksum");
        const test::WireBytes longer = test::WireBytes{}.u16(0xA5C8).u32(0x7FFFFFFF);
        row("a length beyond any reply",
            longer.text() + test::WireBytes{}.u16(ndiChecksum(longer.text())).text(),
            "longer than any reply");
    }

    void refusesWhatIsDamagedAndGoesOn()
    {
        QFETCH(QByteArray, damaged);
        QFETCH(QByteArray, detail);
        NdiReplyReader reader;
        reader.take("OKAYA896\r" + damaged.toStdString() + "RESETBE6F\r");
        QCOMPARE((*reader.next())->bytes, std::string{"OKAY"});
        QCOMPARE(QByteArray::fromStdString(detailOf(reader.next())), detail);
        QCOMPARE((*reader.next())->bytes, std::string{"RESET"});
        QVERIFY(!reader.next());
    }

    void aDamagedHeaderIsNotTrustedWithItsLength()
    {
        std::string header = kHeader;
        header[2] = '\x7F';
        NdiReplyReader reader;
        reader.take(header);
        QCOMPARE(detailOf(reader.next()), std::string{"wrong checksum of a header"});
        reader.clear(); // as after waiting in vain
        reader.take("OKAYA896\r");
        QCOMPARE((*reader.next())->bytes, std::string{"OKAY"});
    }

    void keepsNoMoreThanTheLongestReply()
    {
        NdiReplyReader reader;
        const std::string silence(kLongestNdiReply, 'X');
        reader.take(silence);
        QVERIFY(!reader.next());
        reader.take("YYY");
        QCOMPARE(detailOf(reader.next()), std::string{"longer than any reply"});
        QVERIFY(reader.isEmpty());
        reader.take("OKAYA896\r");
        QCOMPARE((*reader.next())->bytes, std::string{"OKAY"});
    }

    void readsErrorCodes()
    {
        const auto text = [](const char* bytes) { return NdiReply{NdiReply::Form::Text, bytes}; };
        QCOMPARE(errorCode(text("ERROR2B")), std::optional<std::uint8_t>{0x2B});
        QVERIFY(!errorCode(text("ERROR2")));
        QVERIFY(!errorCode(text("ERROR2G")));
        QVERIFY(!errorCode(text("OKAY")));
        QVERIFY(!errorCode(NdiReply{NdiReply::Form::Binary, "ERROR2B"}));
    }

    /// The codes of NDI's list, and words that it has in each row; reserved ones are not in it.
    void tellsWhatAnErrorMeans_data()
    {
        QTest::addColumn<int>("code");
        QTest::addColumn<QByteArray>("words");
        const auto row = [](int code, const char* words) {
            QTest::addRow("%02X", unsigned(code)) << code << QByteArray{words};
        };
        row(0x01, "command");
        row(0x04, "damaged");
        row(0x0C, "mode");
        row(0x0D, "no tool");
        row(0x12, "start tracking");
        row(0x13, "tool could not be initialised");
        row(0x15, "device could not be initialised");
        row(0x1F, "written");
        row(0x23, "parameter is out of range");
        row(0x28, "too many tools");
        row(0x2B, "a port handle that is not allocated");
        row(0x2D, "all port handles");
        row(0x33, "feature");
        row(0x39, "permitted");
        row(0x40, "definition of the tool is damaged");
        row(0x42, "not connected");
        row(0xF1, "infrared");
        row(0xF4, "erased");
        row(0xF5, "written");
        row(0xF6, "read");
        row(0x26, "error 26"); // reserved
        row(0x43, "error 43");
        row(0xFF, "error FF");
    }

    void tellsWhatAnErrorMeans()
    {
        QFETCH(const int, code);
        QFETCH(const QByteArray, words);
        const std::string meaning = errorMeaning(std::uint8_t(code));
        QVERIFY2(meaning.find(words.toStdString()) != std::string::npos, meaning.c_str());
    }

    void everyErrorOfTheListHasWordsOfItsOwn()
    {
        const std::set<int> reserved{0x26, 0x27, 0x29, 0x31, 0x3A, 0x3E, 0x3F};
        std::vector<int> codes{0xF1, 0xF4, 0xF5, 0xF6};
        for (int code = 0x01; code <= 0x42; ++code)
            if (!reserved.contains(code))
                codes.push_back(code);
        std::set<std::string> meanings;
        for (const int code : codes) {
            const std::string meaning = errorMeaning(std::uint8_t(code));
            QVERIFY2(!meaning.starts_with("error "), meaning.c_str());
            QVERIFY2(meanings.insert(meaning).second, meaning.c_str());
        }
    }
};

CARINA_TEST(NdiReplyTest)

} // namespace carina::ndi_reply_test

#include "tst_ndi_reply.moc"
