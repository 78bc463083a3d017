#include "ui/tracker/recording_end.h"

#include "engine/net/devices/any_recording.h"
#include "tests/support/test_class.h"
#include "tests/ui/access/control_walk.h"

#include <QAbstractButton>
#include <QApplication>
#include <QMessageBox>
#include <QTemporaryDir>
#include <QTimer>

namespace carina::recording_end_test
{
namespace
{

std::optional<SessionTime> noTime() { return std::nullopt; }

/// A recording of a tube, under way.
struct UnderWay {
    explicit UnderWay(const QString& file, const std::string& secondTool = {})
    {
        std::vector<TrackedTool> tools{{"Tube", ToolRole::Tube, &history}};
        if (!secondTool.empty())
            tools.push_back({secondTool, ToolRole::Other, &history});
        recording.follow(tools, {});
        QVERIFY(recording.begin(file));
        for (int ms : {1, 2})
            history.push({.time = SessionTime{std::chrono::milliseconds{ms}},
                          .X_FO = RigidTransform::translation({1e-3 * ms, 0.0, -1.0})});
    }

    PoseHistory history;
    PoseRecording recording{noTime};
};

QMessageBox* boxNow() { return qobject_cast<QMessageBox*>(QApplication::activeModalWidget()); }

} // namespace

class RecordingEndTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void showsThatItIsWritten()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("poses.igs.mha"));
        UnderWay its{file};
        QString shown;
        QStringList faults;
        QTimer::singleShot(0, this, [&] {
            shown = boxNow() ? boxNow()->text() : QString{};
            faults = boxNow() ? test::faultsOfControls(*boxNow()) : QStringList{};
        });
        finishRecording(its.recording);
        QVERIFY2(shown.contains(QStringLiteral("poses.igs.mha")), qPrintable(shown));
        QCOMPARE(faults, QStringList{});
        QVERIFY(!its.recording.isBeingWritten());
        QVERIFY(readAnyRecording(file.toStdString()));
    }

    void canBeCancelledAndKeepsTheRecord()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("poses.igs.mha"));
        UnderWay its{file};
        QTimer::singleShot(0, this, [] { boxNow()->buttons().constFirst()->click(); });
        finishRecording(its.recording);
        QVERIFY(readAnyRecording((file + QStringLiteral(".csv")).toStdString()));
    }

    /// Two tools whose names are one in a sequence.
    void tellsWhatKeptItFromBeingWritten()
    {
        const QTemporaryDir folder;
        UnderWay its{folder.filePath(QStringLiteral("poses.igs.mha")), "Tu be"};
        QString told;
        QStringList faults;
        QTimer closing;
        connect(&closing, &QTimer::timeout, this, [&] {
            if (boxNow() == nullptr || boxNow()->objectName() != QLatin1StringView{"unwritten"})
                return;
            told = boxNow()->text();
            faults = test::faultsOfControls(*boxNow());
            boxNow()->reject();
        });
        closing.start(1);
        finishRecording(its.recording);
        QVERIFY(!told.isEmpty());
        QCOMPARE(faults, QStringList{});
    }

    void saysNothingWhereThereIsNothingToWrite()
    {
        const QTemporaryDir folder;
        UnderWay its{folder.filePath(QStringLiteral("poses.csv"))};
        finishRecording(its.recording); // else it waits for a person here
        QVERIFY(!its.recording.isUnderWay());
    }
};

CARINA_SCREEN_TEST(RecordingEndTest)

} // namespace carina::recording_end_test

#include "tst_recording_end.moc"
