#include "ui/tracker/record_button.h"

#include "engine/net/devices/any_recording.h"
#include "tests/support/test_class.h"

#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>

namespace carina::record_button_test
{
namespace
{

std::optional<SessionTime> noTime() { return std::nullopt; }

PoseSample sampleAt(int ms)
{
    return {.time = SessionTime{std::chrono::milliseconds{ms}},
            .X_FO = RigidTransform::translation({1e-3 * ms, 0.0, -1.0})};
}

} // namespace

class RecordButtonTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void recordsFromOnePressToTheNext()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("poses.igs.mha"));
        PoseRecording recording{noTime};
        RecordButton button{recording};
        auto& press = *button.findChild<QPushButton*>(QStringLiteral("record"));
        const auto& text = *button.findChild<QLabel*>(QStringLiteral("recording"));
        QVERIFY(!press.isEnabled()); // there are no tools
        PoseHistory history;
        recording.follow({{"Tube", ToolRole::Tube, &history}}, {});
        QVERIFY(press.isEnabled());
        button.beginTo(file);
        QVERIFY(text.text().contains(QStringLiteral("poses.igs.mha.csv")));
        history.push(sampleAt(1));
        history.push(sampleAt(2));
        press.click();
        QVERIFY(!recording.isUnderWay());
        QTRY_VERIFY(!recording.isBeingWritten());
        QCOMPARE(text.text(), QString{});
        for (const QString& each : {file, file + QStringLiteral(".csv")}) {
            const auto sequence = readAnyRecording(each.toStdString());
            QVERIFY2(sequence.has_value(), sequence ? "" : sequence.error().detail.c_str());
            QCOMPARE(sequence->tools[0].samples.size(), std::size_t{2});
        }
    }

    void saysWhyItCannotRecord()
    {
        PoseRecording recording{noTime};
        RecordButton button{recording};
        button.beginTo(QStringLiteral("/nowhere/poses.csv"));
        const auto& text = *button.findChild<QLabel*>(QStringLiteral("recording"));
        QVERIFY(text.text().contains(QStringLiteral("/nowhere/poses.csv")));
        button.beginTo(QStringLiteral("/tmp/poses.bin"));
        QVERIFY(text.text().contains(QStringLiteral("poses.bin")));
    }
};

CARINA_SCREEN_TEST(RecordButtonTest)

} // namespace carina::record_button_test

#include "tst_record_button.moc"
