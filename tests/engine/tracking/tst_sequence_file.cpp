#include "engine/tracking/sequence_file.h"

#include "tests/engine/tracking/sequence_text.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <fstream>
#include <sstream>

namespace carina::sequence_file_test
{
namespace
{

using namespace std::chrono_literals;
using test::SequenceText;

constexpr const char* kIdentity = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1";

Result<TrackerSequence> read(const std::string& text)
{
    std::istringstream input{text};
    return readSequence(input, "take.igs.mha");
}

SequenceText oneFrame() { return SequenceText{}.frame("1.5").toolAt("Stylus", "1", "2", "3"); }

} // namespace

/// The reader of .igs.mha on sequences written here.
class SequenceFileTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsPosesInMetresAndTimesInSeconds()
    {
        const Result<TrackerSequence> sequence =
            read(SequenceText{}
                     .frame("280.25")
                     .tool("Stylus", "0 -1 0 100 1 0 0 -25.5 0 0 1 7 0 0 0 1")
                     .frame("280.5")
                     .tool("Stylus", "1 0 0 0 0 1 0 0 0 0 1 -1000 -0 0 -0 1 ")
                     .text());
        QVERIFY(sequence);
        QCOMPARE(sequence->tools.size(), std::size_t{1});
        const RecordedTool& stylus = sequence->tools.front();
        QCOMPARE(stylus.name, std::string{"Stylus"});
        QCOMPARE(stylus.role, ToolRole::Stylus);
        QCOMPARE(stylus.samples.size(), std::size_t{2});
        QCOMPARE(stylus.samples[0].time, SessionTime{280'250ms});
        QCOMPARE(stylus.samples[1].time, SessionTime{280'500ms});
        QVERIFY((stylus.samples[0].X_FO.translation() - Vec3{0.1, -0.0255, 0.007}).norm() < 1e-15);
        const Vec3 turned = stylus.samples[0].X_FO.rotation() * Vec3::UnitX();
        QVERIFY((turned - Vec3::UnitY()).norm() < 1e-12); // x of S is y of T: read row by row
        QCOMPARE(stylus.samples[1].X_FO.translation(), Vec3(0.0, 0.0, -1.0));
        QCOMPARE(stylus.samples[1].validity, Validity::Tracked);
    }

    void listsToolsAsTheyAppearAndGivesThemRoles()
    {
        SequenceText text;
        text.frame("0");
        const std::vector<std::pair<std::string, ToolRole>> expected{
            {"Stylus", ToolRole::Stylus},   {"Reference", ToolRole::Other},
            {"Head", ToolRole::Head},       {"Hmd", ToolRole::Head},
            {"Jaw", ToolRole::Jaw},         {"Chin", ToolRole::Jaw},
            {"Tube", ToolRole::Tube},       {"Ett", ToolRole::Tube},
            {"Manikin", ToolRole::Manikin}, {"stylus", ToolRole::Stylus}};
        for (const auto& [name, role] : expected)
            text.tool(name, kIdentity);
        const Result<TrackerSequence> sequence = read(text.text());
        QVERIFY(sequence);
        QCOMPARE(sequence->tools.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            QCOMPARE(sequence->tools[i].name, expected[i].first);
            QCOMPARE(sequence->tools[i].role, expected[i].second);
        }
    }

    void carriesTheLastPoseWhileAToolIsLost_data()
    {
        QTest::addColumn<std::string>("status");
        for (const char* status :
             {"MISSING", "INVALID", "OUT_OF_VIEW", "OUT_OF_VOLUME", "REQ_TIMEOUT"})
            QTest::newRow(status) << std::string{status};
    }
    void carriesTheLastPoseWhileAToolIsLost()
    {
        QFETCH(std::string, status);
        const Result<TrackerSequence> sequence = read(SequenceText{}
                                                          .frame("0")
                                                          .tool("Stylus", kIdentity, status)
                                                          .frame("1")
                                                          .toolAt("Stylus", "5", "0", "0")
                                                          .frame("2")
                                                          .tool("Stylus", "nonsense", status)
                                                          .text());
        QVERIFY(sequence);
        const RecordedTool& stylus = sequence->tools.front();
        QCOMPARE(stylus.neverSeenYet, std::size_t{1});
        QCOMPARE(stylus.samples.size(), std::size_t{2});
        QCOMPARE(stylus.samples[0].validity, Validity::Tracked);
        QCOMPARE(stylus.samples[1].validity, Validity::Lost);
        QCOMPARE(stylus.samples[1].X_FO.translation(), stylus.samples[0].X_FO.translation());
    }

    void passesOverOtherFieldsWindowsLineEndsAndPixels()
    {
        std::string text = oneFrame()
                               .field("FrameNumber", "332203")
                               .field("ProbeToReferenceTransform", "1 2 3")
                               .field("ImageStatus", "INVALID")
                               .text();
        for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
            text.insert(at, 1, '\r');
        const Result<TrackerSequence> sequence =
            read(text + std::string{"\x00\xff no field\n", 12});
        QVERIFY(sequence);
        QCOMPARE(sequence->tools.size(), std::size_t{1});
        QCOMPARE(sequence->tools.front().samples.size(), std::size_t{1});
    }

    void acceptsFramesOfTheSameTime()
    {
        QVERIFY(read(oneFrame().frame("1.5").toolAt("Stylus", "1", "2", "3").text()));
    }

    void refusesWhatIsWrong_data()
    {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<Errc>("code");
        QTest::addColumn<std::string>("said");
        const auto row = [](const char* name, const std::string& text, Errc code,
                            const char* said) {
            QTest::newRow(name) << text << code << std::string{said};
        };
        const auto framed = [](const std::string& field, const std::string& value) {
            return SequenceText{}.frame("0").field(field, value).text();
        };
        const auto posed = [](const std::string& matrix) {
            return SequenceText{}.frame("0").tool("Stylus", matrix).text();
        };
        const auto timed = [](const std::string& time) {
            return SequenceText{}.frame(time).tool("Stylus", kIdentity).text();
        };
        const std::string whole = oneFrame().text();
        using enum Errc;
        row("nothing", "", FileEmpty, "empty");
        row("no field", "once upon a time\n" + whole, FileMalformed, "no '='");
        row("cut off", whole.substr(0, whole.find("ElementDataFile")), FileMalformed,
            "ends before");
        row("fewer frames", oneFrame().textClaiming("2"), FileMalformed, "frames, 1");
        row("countless", oneFrame().textClaiming("99999999999999999999"), FileMalformed, "DimSize");
        row("no frames", SequenceText{}.text(), FileMalformed, "no transform");
        row("no tool", SequenceText{}.frame("0").text(), FileMalformed, "no transform");
        row("frame skipped", "Seq_Frame0000_Timestamp = 1\nSeq_Frame0002_Timestamp = 2\n",
            FileMalformed, "frame 2 comes where frame 1 is expected");
        row("frame unnumbered", "Seq_FrameX_Timestamp = 1\n", FileMalformed, "no frame number");
        row("frame without field", "Seq_Frame0000 = 1\n", FileMalformed, "no frame number");
        row("not from frame 0", "Seq_Frame0001_Timestamp = 1\n", FileMalformed,
            "frame 1 comes where frame 0 is expected");
        row("largest frame", "Seq_Frame18446744073709551615_Timestamp = 1\n", FileMalformed,
            "expected");
        row("status only", framed("StylusToTrackerTransformStatus", "OK"), FileMalformed, "16");
        row("pose only", framed("StylusToTrackerTransform", kIdentity), FileMalformed, "status");
        row("strange status", SequenceText{}.frame("0").tool("Stylus", kIdentity, "FINE").text(),
            FileMalformed, "frame 0: Stylus has no known status");
        row("15 numbers", posed("1 0 0 0 0 1 0 0 0 0 1 0 0 0 0"), FileMalformed, "16");
        row("17 numbers", posed("1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 0"), FileMalformed, "16");
        row("a word", posed("1 0 0 0 0 1 0 O 0 0 1 0 0 0 0 1"), FileMalformed, "16");
        row("NaN pose", posed("1 0 0 nan 0 1 0 0 0 0 1 0 0 0 0 1"), NotFinite, "frame 0: Stylus");
        row("scaled", posed("2 0 0 0 0 2 0 0 0 0 2 0 0 0 0 1"), NotARotation, "frame 0: Stylus");
        row("mirrored", posed("1 0 0 0 0 1 0 0 0 0 -1 0 0 0 0 1"), NotARotation, "Stylus");
        row("a tool twice",
            SequenceText{}.frame("0").tool("Stylus", kIdentity).tool("Stylus", kIdentity).text(),
            FileMalformed, "frame 0: it has two transforms of Stylus");
        row("no time", timed(""), FileMalformed, "frame 0: its Timestamp");
        row("a word as time", timed("noon"), FileMalformed, "Timestamp");
        row("NaN time", timed("nan"), NotFinite, "Timestamp");
        row("infinite time", timed("-inf"), NotFinite, "Timestamp");
        row("after a century", timed("3000000001"), OutOfRange, "Timestamp");
        row("before a century", timed("-3e300"), OutOfRange, "Timestamp");
        row("back in time", oneFrame().frame("1.499999999").tool("Stylus", kIdentity).text(),
            FileMalformed, "frame 1: its Timestamp is before");
    }
    void refusesWhatIsWrong()
    {
        QFETCH(std::string, text);
        QFETCH(Errc, code);
        QFETCH(std::string, said);
        const Result<TrackerSequence> sequence = read(text);
        QVERIFY(!sequence);
        QCOMPARE(sequence.error().code, code);
        QVERIFY2(sequence.error().detail.starts_with("take.igs.mha: "),
                 sequence.error().detail.c_str());
        QVERIFY2(sequence.error().detail.find(said) != std::string::npos,
                 sequence.error().detail.c_str());
    }

    void readsAFileAndSaysWhereThereIsNone()
    {
        const QTemporaryDir folder;
        const std::filesystem::path path = folder.path().toStdString() + "/take.igs.mha";
        QCOMPARE(readSequenceFile(path).error().code, Errc::FileNotFound);
        QCOMPARE(readSequenceFile(path.parent_path()).error().code, Errc::FileUnreadable);
        std::ofstream{path};
        QCOMPARE(readSequenceFile(path).error().code, Errc::FileEmpty);
        QVERIFY(readSequenceFile(path).error().detail.starts_with(path.string()));
        std::ofstream{path} << oneFrame().text();
        QCOMPARE(readSequenceFile(path)->tools.front().samples.size(), std::size_t{1});
    }
};

CARINA_TEST(SequenceFileTest)

} // namespace carina::sequence_file_test

#include "tst_sequence_file.moc"
