#include "engine/geometry/rotation.h"
#include "engine/tracking/record/pose_record.h"
#include "engine/tracking/record/pose_recorder.h"
#include "engine/tracking/tum_file.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

#include <sstream>

namespace carina::pose_record_test
{
namespace
{

constexpr double kRounding_m = 1e-9; ///< of the record: a millionth of a millimetre
constexpr double kRounding_rad = 1e-7;

SessionTime at(double seconds) { return SessionTime{fromSeconds(seconds)}; }

PoseSample sampleAt(double seconds)
{
    return {.time = at(seconds),
            .X_FO = {rotationFromVector({0.1, seconds, -0.2}), {0.1 * seconds, -0.02, 1.5}},
            .error = 0.00025};
}

/// Two tools seen at the same times; one of them is lost in between, and partly seen once.
TrackerSequence twoTools()
{
    RecordedTool tube{.name = "The \"blue\" tube, 7.5", .role = ToolRole::Tube};
    RecordedTool blade{.name = "Laryngoscope", .role = ToolRole::Laryngoscope};
    for (int i = 0; i < 6; ++i) {
        tube.samples.push_back(sampleAt(10.0 + i / 60.0));
        blade.samples.push_back(sampleAt(10.0 + i / 60.0));
    }
    blade.samples[2].validity = Validity::Lost;
    blade.samples[2].X_FO = blade.samples[1].X_FO;
    blade.samples[4].validity = Validity::PartlyOccluded;
    return {{std::move(tube), std::move(blade)}};
}

std::string recordOf(const TrackerSequence& sequence)
{
    std::string text = pose_record::beginning();
    for (std::size_t i = 0; i < sequence.tools[0].samples.size(); ++i)
        for (const RecordedTool& tool : sequence.tools)
            text += pose_record::line(tool, tool.samples[i]);
    return text;
}

Result<TrackerSequence> read(const std::string& text)
{
    std::istringstream input{text};
    return pose_record::read(input, "record");
}

bool isSamePose(const PoseSample& a, const PoseSample& b)
{
    return (a.X_FO.translation() - b.X_FO.translation()).norm() < kRounding_m
           && a.X_FO.rotation().angularDistance(b.X_FO.rotation()) < kRounding_rad;
}

} // namespace

class PoseRecordTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isReadAsItWasWritten()
    {
        const TrackerSequence written = twoTools();
        const auto sequence = read(recordOf(written));
        QVERIFY2(sequence.has_value(), sequence ? "" : sequence.error().detail.c_str());
        QCOMPARE(sequence->tools.size(), std::size_t{2});
        for (std::size_t tool = 0; tool < 2; ++tool) {
            QCOMPARE(sequence->tools[tool].name, written.tools[tool].name);
            QCOMPARE(sequence->tools[tool].role, written.tools[tool].role);
            QCOMPARE(sequence->tools[tool].samples.size(), std::size_t{6});
            for (std::size_t i = 0; i < 6; ++i) {
                const PoseSample& before = written.tools[tool].samples[i];
                const PoseSample& after = sequence->tools[tool].samples[i];
                QCOMPARE(after.time, before.time);
                QCOMPARE(after.validity, before.validity);
                QVERIFY(isSamePose(after, before));
                QVERIFY(std::abs(after.error - before.error) < kRounding_m);
            }
        }
    }

    /// A program that is killed stops within a line.
    void isReadUpToWhereTheProgramWasKilled()
    {
        const std::string text = recordOf(twoTools());
        const std::size_t lastLine = text.rfind('\n', text.size() - 2) + 1;
        for (std::size_t end = lastLine; end < text.size(); ++end) {
            const auto sequence = read(text.substr(0, end));
            QVERIFY2(sequence.has_value(), sequence ? "" : sequence.error().detail.c_str());
            QCOMPARE(sequence->tools[0].samples.size(), std::size_t{6});
            QCOMPARE(sequence->tools[1].samples.size(), std::size_t{5});
        }
    }

    void refusesWhatIsNoRecord_data()
    {
        QTest::addColumn<std::string>("line");
        QTest::addColumn<int>("code");
        const auto row = [](const char* name, const char* line, Errc code) {
            QTest::newRow(name) << std::string{line} << int(code);
        };
        row("too few numbers", "1,2,3", Errc::FileMalformed);
        row("a word", "x,0,0,0,0,0,0,1,0,tracked,tube,\"T\"", Errc::FileMalformed);
        row("not finite", "1,nan,0,0,0,0,0,1,0,tracked,tube,\"T\"", Errc::NotFinite);
        row("no rotation", "1,0,0,0,0,0,0,2,0,tracked,tube,\"T\"", Errc::NotARotation);
        row("another state", "1,0,0,0,0,0,0,1,0,seen,tube,\"T\"", Errc::FileMalformed);
        row("another role", "1,0,0,0,0,0,0,1,0,tracked,spoon,\"T\"", Errc::FileMalformed);
        row("no quotation mark", "1,0,0,0,0,0,0,1,0,tracked,tube,T", Errc::FileMalformed);
        row("half a quotation", "1,0,0,0,0,0,0,1,0,tracked,tube,\"a\"b\"", Errc::FileMalformed);
        row("a kilometre", "1,0,-2e6,0,0,0,0,1,0,tracked,tube,\"T\"", Errc::OutOfRange);
        row("a tabulator", "1,0,0,0,0,0,0,1,0,tracked,tube,\"a\tb\"", Errc::FileMalformed);
        row("a century", "4e9,0,0,0,0,0,0,1,0,tracked,tube,\"T\"", Errc::OutOfRange);
    }

    void refusesWhatIsNoRecord()
    {
        QFETCH(const std::string, line);
        QFETCH(const int, code);
        const auto sequence = read(pose_record::beginning() + line + '\n');
        QVERIFY(!sequence);
        QCOMPARE(int(sequence.error().code), code);
        QVERIFY(sequence.error().detail.starts_with("record: line 3: "));
    }

    void refusesSamplesThatGoBackInTime()
    {
        const RecordedTool tool{.name = "Tube", .role = ToolRole::Tube};
        const auto sequence = read(pose_record::beginning() + pose_record::line(tool, sampleAt(2.0))
                                   + pose_record::line(tool, sampleAt(1.0)));
        QVERIFY(!sequence);
        QCOMPARE(sequence.error().code, Errc::FileMalformed);
    }

    void isTheSameAsASequenceOfPlus()
    {
        const TrackerSequence written = twoTools();
        std::istringstream input{*sequenceText(written)};
        const auto sequence = readSequence(input, "sequence");
        QVERIFY2(sequence.has_value(), sequence ? "" : sequence.error().detail.c_str());
        QCOMPARE(sequence->tools.size(), std::size_t{2});
        QCOMPARE(sequence->tools[0].name, std::string{"Thebluetube75"});
        QCOMPARE(sequence->tools[1].role, ToolRole::Laryngoscope);
        for (std::size_t i = 0; i < 6; ++i) {
            QVERIFY(isSamePose(sequence->tools[1].samples[i], written.tools[1].samples[i]));
            QCOMPARE(sequence->tools[1].samples[i].validity == Validity::Lost, i == 2);
            QCOMPARE(sequence->tools[1].samples[i].time, written.tools[1].samples[i].time);
        }
    }

    /// A sequence keeps letters and digits of a name alone.
    void refusesASequenceOfTwoToolsThatWouldBeOne_data()
    {
        QTest::addColumn<QString>("first");
        QTest::addColumn<QString>("second");
        QTest::newRow("equal names") << QStringLiteral("Tube") << QStringLiteral("Tube");
        QTest::newRow("equal letters") << QStringLiteral("Tube 1") << QStringLiteral("Tube-1");
        QTest::newRow("the word of its role") << QStringLiteral("tube") << QStringLiteral("管");
    }
    void refusesASequenceOfTwoToolsThatWouldBeOne()
    {
        QFETCH(const QString, first);
        QFETCH(const QString, second);
        TrackerSequence sequence = twoTools();
        sequence.tools[0].name = first.toStdString();
        sequence.tools[1].name = second.toStdString();
        sequence.tools[1].role = ToolRole::Tube;
        const auto text = sequenceText(sequence);
        QVERIFY(!text);
        QCOMPARE(text.error().code, Errc::NameUnclear);
        QVERIFY(text.error().detail.find("ube") != std::string::npos);
    }

    void writesNoSequenceThatIsStopped()
    {
        QCOMPARE(sequenceText(twoTools(), [](double) { return false; }).error().code,
                 Errc::Cancelled);
    }

    void isTheSameAsATrajectoryWithoutWhatIsLost()
    {
        const RecordedTool blade = twoTools().tools[1];
        std::istringstream input{tumText(blade)};
        const auto samples = readTum(input, "trajectory");
        QVERIFY2(samples.has_value(), samples ? "" : samples.error().detail.c_str());
        QCOMPARE(samples->size(), std::size_t{5});
        QVERIFY(isSamePose((*samples)[2], blade.samples[3]));
    }

    void recordsWhatATrackerDelivers()
    {
        const QTemporaryDir folder;
        const std::string file = folder.filePath(QStringLiteral("poses.csv")).toStdString();
        PoseHistory history;
        history.push(sampleAt(1.0));
        std::size_t written = 0;
        {
            // Without a clock its thread does nothing: what is written here is written at the end.
            const auto recorder =
                PoseRecorder::begin(file, [] { return std::optional<SessionTime>{}; });
            QVERIFY(recorder);
            (*recorder)->follow({{"Tube", ToolRole::Tube, &history}}, {});
            history.push(sampleAt(1.1));
            history.push(sampleAt(1.2));
            PoseHistory another;
            (*recorder)->follow({{"Blade", ToolRole::Laryngoscope, &another}}, {});
            history.push(sampleAt(1.3));
            another.push(sampleAt(1.4));
            (*recorder)->follow({}, {});
            written = (*recorder)->count();
        }
        QCOMPARE(written, std::size_t{3});
        std::ifstream input{file};
        const auto sequence = pose_record::read(input, file);
        QVERIFY(sequence);
        QCOMPARE(sequence->tools.size(), std::size_t{2});
        QCOMPARE(sequence->tools[0].samples.size(), std::size_t{2});
        QCOMPARE(sequence->tools[0].samples[0].time, at(1.1));
        QCOMPARE(sequence->tools[1].name, std::string{"Blade"});
    }

    void saysThatItCannotBeWritten()
    {
        const auto recorder =
            PoseRecorder::begin("/nowhere/poses.csv", [] { return std::optional<SessionTime>{}; });
        QVERIFY(!recorder);
        QCOMPARE(recorder.error().code, Errc::FileUnwritable);
    }
};

CARINA_TEST(PoseRecordTest)

} // namespace carina::pose_record_test

#include "tst_pose_record.moc"
