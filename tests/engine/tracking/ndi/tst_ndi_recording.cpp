#include "engine/tracking/ndi/ndi_conversation.h"

#include "engine/tracking/ndi/ndi_reply.h"
#include "tests/engine/tracking/ndi/ndi_samples.h"
#include "tests/engine/tracking/ndi/written_poses.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <sstream>

namespace carina::ndi_recording_test
{
namespace
{

constexpr double kTolerance = 1e-9; // m

Result<std::vector<NdiExchange>> read(const std::string& text)
{
    std::istringstream input{text};
    return readNdiRecording(input, "polaris.txt");
}

std::string folderOf(const char* file) { return std::string{"tracker/ndi-recordings/"} + file; }

/// Whether a recording is read, without a fault in it.
bool isWhole(const std::string& recorded)
{
    const auto recording = read(recorded);
    return recording && decode(*recording).replies > 0 && decode(*recording).refused.empty();
}

bool isWhole(const test::NdiSample& sample)
{
    using Reader = test::NdiSample::Reader;
    const auto bytes = std::as_bytes(std::span{sample.bytes});
    const auto tells = [](const Result<NdiFrame>& frame) {
        return frame && !frame->refusedPose && frame->tools.size() + frame->p_TStrays.size() > 0;
    };
    switch (sample.reader) {
    case Reader::Tx:
        return tells(decodeTx(sample.bytes, sample.options));
    case Reader::Bx:
        return tells(decodeBx(bytes, sample.options));
    case Reader::Bx2:
        return tells(decodeBx2(bytes));
    case Reader::Recording:
        return isWhole(sample.bytes);
    case Reader::Stream:
        break;
    }
    NdiReplyReader reader;
    reader.take(sample.bytes);
    int replies = 0;
    for (auto reply = reader.next(); reply && *reply; reply = reader.next())
        ++replies;
    return replies == 3 && reader.isEmpty();
}

} // namespace

class NdiRecordingTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// What a fuzzer begins with is read to its end.
    void theSamplesHaveNoFault()
    {
        const auto samples = test::ndiSamples();
        for (std::size_t i = 0; i < samples.size(); ++i)
            QVERIFY2(isWhole(samples[i]), qPrintable(QString::number(i)));
    }

    void readsNumberedLines()
    {
        const auto recording = read("recv:0001 = RESETBE6F\n"
                                    "sent:0002 = TX:0001031A\n"
                                    "recv:0002 = 0101MISSING00000031000003A3\n00005A49\n");
        QVERIFY(recording);
        QCOMPARE(recording->size(), std::size_t{2});
        QVERIFY((*recording)[0].command.empty());
        QCOMPARE((*recording)[0].reply, std::string{"RESETBE6F\r"});
        QCOMPARE((*recording)[1].command, std::string{"TX:0001031A\r"});
        QCOMPARE((*recording)[1].reply, std::string{"0101MISSING00000031000003A3\n00005A49\r"});
        QCOMPARE((*recording)[1].line, std::size_t{2});
        QVERIFY(!(*recording)[1].seconds);
    }

    void readsEscapedBytesWithTheirTimes()
    {
        const auto recording =
            read("1127242654.18 : (DEBUG) # recorded\n"
                 "1127242654.20 : (INFO) 41. command[12] BX:0001C26D\\x0D\n"
                 "1127242654.25 : (INFO) 41. receive[6] \\xC4\\xA5\\x17\\x00\"\\xE3\n"
                 "1127242654.50 : (INFO) 41. receive[2] \\\\1\n");
        QVERIFY(recording);
        QCOMPARE(recording->size(), std::size_t{1});
        const NdiExchange& exchange = recording->front();
        QCOMPARE(exchange.command, std::string{"BX:0001C26D\r"});
        QCOMPARE(exchange.reply, (std::string{"\xC4\xA5\x17\x00\"\xE3\\1", 8}));
        QCOMPARE(exchange.seconds.value(), 1127242654.50);
        QCOMPARE(exchange.line, std::size_t{2});
    }

    void readsBytesAsTheyWere()
    {
        const auto recording =
            read("# recorded\n\n0. receive[10] RESETBE6F\r\n1. command[3] \n\r\n\n1. receive[2] "
                 + std::string{"\x00\x01\n", 3});
        QVERIFY(recording);
        QCOMPARE(recording->size(), std::size_t{2});
        QCOMPARE((*recording)[0].reply, std::string{"RESETBE6F\r"});
        QCOMPARE((*recording)[1].command, std::string{"\n\r\n"});
        QCOMPARE((*recording)[1].reply, (std::string{"\x00\x01", 2}));
    }

    void putsACarriageReturnBackThatAnEditorChanged()
    {
        const auto recording = read("0. receive[10] RESETBE6F\n1. command[10] INIT:E3A5\n");
        QVERIFY(recording);
        QCOMPARE((*recording)[0].reply, std::string{"RESETBE6F\r"});
        QCOMPARE((*recording)[1].command, std::string{"INIT:E3A5\r"});
    }

    void refusesWhatIsNoRecording_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("code");
        QTest::newRow("nothing") << QByteArray{} << int(Errc::FileEmpty);
        QTest::newRow("remarks only") << QByteArray{"# recorded\n"} << int(Errc::FileEmpty);
        QTest::newRow("cut") << QByteArray{"0. receive[10] RESET"} << int(Errc::FileMalformed);
        QTest::newRow("no number")
            << QByteArray{"sent:x = INIT:E3A5\n"} << int(Errc::FileMalformed);
        QTest::newRow("a byte too few")
            << QByteArray{"1.5 : (INFO) 1. receive[9] OKAYA896\n"} << int(Errc::FileMalformed);
        QTest::newRow("a half byte")
            << QByteArray{"1.5 : (INFO) 1. receive[1] \\xA\n"} << int(Errc::FileMalformed);
    }

    void refusesWhatIsNoRecording()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, code);
        const auto recording = read(text.toStdString());
        QVERIFY(!recording);
        QCOMPARE(int(recording.error().code), code);
    }

    void damagedRepliesAreRefusedOneByOne()
    {
        const std::string good = "sent:0001 = TX:0001031A\nrecv:0001 = 0101+07003+07110-00250+"
                                 "00572-021400+009890-158180+0110600000031000003AD\n0000D166\n";
        std::string damaged = good;
        damaged[60] = '9'; // a digit of a number
        const auto recording = read(good + damaged + good);
        QVERIFY(recording);
        const NdiConversation conversation = decode(*recording);
        QCOMPARE(conversation.commands, std::size_t{3});
        QCOMPARE(conversation.replies, std::size_t{3});
        QCOMPARE(conversation.checksumErrors, std::size_t{1});
        QCOMPARE(conversation.frames.size(), std::size_t{2});
        QCOMPARE(conversation.refused.size(), std::size_t{1});
        QCOMPARE(conversation.refused[0].line, std::size_t{4});
    }

    void aReplyOfTheWrongFormIsRefused()
    {
        const auto recording = read("sent:0001 = BX:0001C26D\nrecv:0001 = OKAYA896\n"
                                    "sent:0002 = TX:0001031A\nrecv:0002 = ERROR0C\n");
        QVERIFY(recording);
        const NdiConversation conversation = decode(*recording);
        QVERIFY(conversation.frames.empty());
        QCOMPARE(conversation.refused.size(), std::size_t{2});
    }

    // Counts of commands and replies by SOURCE.txt and grep.
    void decodesEveryReplyOfTheRecordings_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("frames");
        QTest::newRow("07_13") << "polaris_stream_07_13_2005.txt" << 10;
        QTest::newRow("03_31") << "polaris_stream_03_31_2005_1.txt" << 1000;
        QTest::newRow("11_05") << "polaris_stream_11_05_2005.txt" << 9;
        QTest::newRow("08_31, escaped")
            << "polaris_stream_08_31_2005_NDICommandInterpreter.txt" << 302;
        QTest::newRow("08_31, bytes")
            << "polaris_stream_08_31_2005_NDICommandInterpreter.bin" << 302;
        QTest::newRow("08_18, bytes") << "polaris_stream_08_18_2005.bin" << -1;
    }

    void decodesEveryReplyOfTheRecordings()
    {
        QFETCH(QString, file);
        QFETCH(int, frames);
        const auto path = test::testData(folderOf(file.toUtf8().constData()));
        if (!path)
            QSKIP("no recordings of a Polaris");
        const auto recording = readNdiRecordingFile(*path);
        QVERIFY2(recording, recording ? "" : recording.error().detail.c_str());
        const NdiConversation conversation = decode(*recording);
        for (const RefusedNdiReply& refused : conversation.refused)
            qWarning("line %zu: %s", refused.line, refused.error.detail.c_str());
        QVERIFY(conversation.refused.empty());
        QCOMPARE(conversation.checksumErrors, std::size_t{0});
        if (frames >= 0)
            QCOMPARE(int(conversation.frames.size()), frames);
    }

    void agreesWithThePosesWrittenInAFile_data()
    {
        QTest::addColumn<QString>("file");
        QTest::newRow("07_13") << "polaris_stream_07_13_2005.txt";
        QTest::newRow("03_31") << "polaris_stream_03_31_2005_1.txt";
    }

    void agreesWithThePosesWrittenInAFile()
    {
        QFETCH(QString, file);
        const auto path = test::testData(folderOf(file.toUtf8().constData()));
        if (!path)
            QSKIP("no recordings of a Polaris");
        const auto written = test::posesWrittenIn(QString::fromStdString(*path));
        QVERIFY(!written.empty());
        const auto recording = readNdiRecordingFile(*path);
        QVERIFY(recording);
        std::vector<NdiTool> tools;
        for (const RecordedNdiFrame& recorded : decode(*recording).frames)
            for (const NdiTool& tool : recorded.frame.tools)
                if (tool.X_TO)
                    tools.push_back(tool);
        QCOMPARE(tools.size(), written.size());
        for (std::size_t i = 0; i < tools.size(); ++i) {
            QCOMPARE(int(tools[i].handle), written[i].handle);
            QCOMPARE(tools[i].frameNumber, written[i].frame);
            QVERIFY((1e3 * tools[i].X_TO->translation() - written[i].p_mm).norm() < 1e-6);
            QVERIFY(std::abs(tools[i].error - 1e-3 * written[i].error_mm) < kTolerance);
        }
    }

    /// As read from the file by eye: recv 0101+07003+07110-00250+00572-021400+009890-158180+01106,
    /// state 00000031, frame 000003AD. Places in hundredths of a millimetre, the quaternion and the
    /// error in ten-thousandths, w first.
    void tellsTheFirstPoseOfHandleOne()
    {
        const auto path = test::testData(folderOf("polaris_stream_07_13_2005.txt"));
        if (!path)
            QSKIP("no recordings of a Polaris");
        const auto recording = readNdiRecordingFile(*path);
        QVERIFY(recording);
        const NdiConversation conversation = decode(*recording);
        for (const RecordedNdiFrame& recorded : conversation.frames) {
            for (const NdiTool& tool : recorded.frame.tools) {
                if (tool.handle != 1 || !tool.X_TO)
                    continue;
                QCOMPARE(tool.frameNumber, 0x3ADU);
                const Vec3 p_mm = 1e3 * tool.X_TO->translation();
                QVERIFY((p_mm - Vec3{-214.00, 98.90, -1581.80}).norm() < 1e-6);
                QVERIFY(std::abs(1e3 * tool.error - 0.1106) < 1e-6);
                const Quat turn = Quat{0.7003, 0.7110, -0.0250, 0.0572}.normalized();
                QVERIFY(std::abs(tool.X_TO->rotation().dot(turn)) > 1.0 - 1e-9);
                return;
            }
        }
        QFAIL("no pose of handle 1");
    }

    void bothFormsOfOneConversationTellTheSame()
    {
        const auto text =
            test::testData(folderOf("polaris_stream_08_31_2005_NDICommandInterpreter.txt"));
        const auto bytes =
            test::testData(folderOf("polaris_stream_08_31_2005_NDICommandInterpreter.bin"));
        if (!text || !bytes)
            QSKIP("no recordings of a Polaris");
        const auto one = readNdiRecordingFile(*text);
        const auto other = readNdiRecordingFile(*bytes);
        QVERIFY(one && other);
        QCOMPARE(one->size(), other->size());
        for (std::size_t i = 0; i < one->size(); ++i) {
            QCOMPARE((*one)[i].command, (*other)[i].command);
            QCOMPARE((*one)[i].reply, (*other)[i].reply);
        }
    }
};

CARINA_TEST(NdiRecordingTest)

} // namespace carina::ndi_recording_test

#include "tst_ndi_recording.moc"
