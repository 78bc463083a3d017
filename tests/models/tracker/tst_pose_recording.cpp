#include "models/tracker/pose_recording.h"

#include "engine/net/devices/any_recording.h"
#include "tests/support/test_class.h"

#include <QFile>
#include <QTemporaryDir>

namespace carina::pose_recording_test
{
namespace
{

std::optional<SessionTime> noTimeYet() { return std::nullopt; }

PoseSample atMillisecond(int ms)
{
    return {.time = SessionTime{std::chrono::milliseconds{ms}},
            .X_FO = RigidTransform::translation({1e-3 * ms, 0.0, -1.0})};
}

} // namespace

class TestPoseRecording : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Another tracker is connected while it records.
    void goesOnThroughOneTrackerAfterAnother()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("poses.csv"));
        PoseRecording recording{noTimeYet};
        {
            PoseHistory first;
            recording.follow({{"Tube", ToolRole::Tube, &first}}, {});
            QVERIFY(recording.begin(file));
            first.push(atMillisecond(1));
            first.push(atMillisecond(2));
            recording.follow({}, {});
        }
        PoseHistory second;
        recording.follow({{"Tube", ToolRole::Tube, &second}}, {});
        QVERIFY(recording.isUnderWay());
        second.push(atMillisecond(3));
        recording.end();
        QVERIFY(!recording.isBeingWritten()); // it has the form of the record
        const auto sequence = readAnyRecording(file.toStdString());
        QVERIFY2(sequence, sequence ? "" : sequence.error().detail.c_str());
        QCOMPARE(sequence->tools.size(), std::size_t{1});
        QCOMPARE(sequence->tools[0].samples.size(), std::size_t{3});
    }

    /// The person was asked for poses.igs.mha, and not whether poses.igs.mha.csv may be replaced.
    void replacesNoRecordThatNobodyWasAskedFor()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("poses.igs.mha"));
        QFile before{file + QStringLiteral(".csv")};
        QVERIFY(before.open(QIODevice::WriteOnly));
        QVERIFY(before.write("of yesterday") > 0);
        before.close();
        PoseRecording recording{noTimeYet};
        PoseHistory history;
        recording.follow({{"Tube", ToolRole::Tube, &history}}, {});
        QVERIFY(recording.begin(file));
        history.push(atMillisecond(1));
        QVERIFY(recording.text().contains(QStringLiteral("poses.igs.mha-2.csv")));
        recording.end();
        QVERIFY(recording.isBeingWritten());
        QTRY_VERIFY(!recording.isBeingWritten());
        QVERIFY(!recording.problem());
        QVERIFY(before.open(QIODevice::ReadOnly));
        QCOMPARE(before.readAll(), QByteArray{"of yesterday"});
        QVERIFY(readAnyRecording(file.toStdString()));
    }

    /// Two tools whose names are one in a sequence: the record has both.
    void tellsWhatCannotBeWrittenInAnotherForm()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("poses.igs.mha"));
        PoseRecording recording{noTimeYet};
        PoseHistory first;
        PoseHistory second;
        recording.follow({{"Tube 1", ToolRole::Tube, &first}, {"Tube-1", ToolRole::Tube, &second}},
                         {});
        QVERIFY(recording.begin(file));
        first.push(atMillisecond(1));
        second.push(atMillisecond(1));
        recording.end();
        QTRY_VERIFY(!recording.isBeingWritten());
        QCOMPARE(recording.problem().value().code, Errc::NameUnclear);
        QVERIFY(!QFile::exists(file));
        const auto record = readAnyRecording((file + QStringLiteral(".csv")).toStdString());
        QCOMPARE(record->tools.size(), std::size_t{2});
    }

    void writesTheOtherFormAlsoWhereTheProgramEnds()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("poses.tum"));
        {
            PoseHistory history;
            PoseRecording recording{noTimeYet};
            recording.follow({{"Tube", ToolRole::Tube, &history}}, {});
            QVERIFY(recording.begin(file));
            history.push(atMillisecond(1));
        }
        QVERIFY(readAnyRecording(file.toStdString()));
    }
};

CARINA_TEST(TestPoseRecording)

} // namespace carina::pose_recording_test

#include "tst_pose_recording.moc"
