#include "engine/net/devices/any_recording.h"

#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <QFile>
#include <QTemporaryDir>

namespace carina::any_recording_test
{
namespace
{

TrackerSequence tubeAndBlade()
{
    TrackerSequence sequence{{{.name = "Tube", .role = ToolRole::Tube},
                              {.name = "Blade", .role = ToolRole::Laryngoscope}}};
    for (RecordedTool& tool : sequence.tools)
        for (int i = 0; i < 3; ++i)
            tool.samples.push_back({.time = SessionTime{std::chrono::milliseconds{20 * i}},
                                    .X_FO = RigidTransform::translation({0.1 * i, 0.0, -1.5})});
    return sequence;
}

} // namespace

class AnyRecordingTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsEveryFormThatItWrites_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"poses.csv", "poses.igs.mha", "Tube.tum"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }

    void readsEveryFormThatItWrites()
    {
        QFETCH(const QString, name);
        const QTemporaryDir folder;
        const std::string file = folder.filePath(name).toStdString();
        QVERIFY(writeAnyRecording(file, tubeAndBlade()));
        const auto sequence = readAnyRecording(file);
        QVERIFY2(sequence.has_value(), sequence ? "" : sequence.error().detail.c_str());
        QCOMPARE(sequence->tools[0].name, std::string{"Tube"});
        QCOMPARE(sequence->tools[0].role, ToolRole::Tube);
        QCOMPARE(sequence->tools[0].samples.size(), std::size_t{3});
        QVERIFY((sequence->tools[0].samples[2].X_FO.translation() - Vec3{0.2, 0.0, -1.5}).norm()
                < 1e-9);
    }

    void writesATrajectoryForEachTool()
    {
        const QTemporaryDir folder;
        QVERIFY(writeAnyRecording(folder.filePath(QStringLiteral("all.tum")).toStdString(),
                                  tubeAndBlade()));
        QVERIFY(QFile::exists(folder.filePath(QStringLiteral("all-2.tum"))));
    }

    /// Nobody was asked about them.
    void keepsFilesThatAreWhereFurtherTrajectoriesWouldGo()
    {
        const QTemporaryDir folder;
        QFile other{folder.filePath(QStringLiteral("all-2.tum"))};
        QVERIFY(other.open(QIODevice::ReadWrite) && other.write("of another day") > 0);
        QVERIFY(other.flush());
        QVERIFY(writeAnyRecording(folder.filePath(QStringLiteral("all.tum")).toStdString(),
                                  tubeAndBlade()));
        QVERIFY(other.seek(0));
        QCOMPARE(other.readAll(), QByteArray{"of another day"});
        QVERIFY(QFile::exists(folder.filePath(QStringLiteral("all-3.tum"))));
    }

    void refusesOtherFiles()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("poses.bin"));
        QFile file{path};
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("nothing of the kind") > 0);
        file.close();
        QCOMPARE(readAnyRecording(path.toStdString()).error().code, Errc::UnknownFormat);
        QCOMPARE(writeAnyRecording(path.toStdString(), tubeAndBlade()).error().code,
                 Errc::UnknownFormat);
        QCOMPARE(readAnyRecording("nowhere.csv").error().code, Errc::FileNotFound);
    }

    /// 8 poses in the recording, the first at (-214.00, 98.90, -1581.80) mm.
    void playsAConversationThatOthersRecorded()
    {
        const auto file = test::testData("tracker/ndi-recordings/polaris_stream_07_13_2005.txt");
        if (!file)
            QSKIP("there is no such recording");
        const auto sequence = readAnyRecording(*file);
        QVERIFY2(sequence.has_value(), sequence ? "" : sequence.error().detail.c_str());
        const auto tool = std::ranges::find(sequence->tools, "Port 01", &RecordedTool::name);
        QVERIFY(tool != sequence->tools.end());
        const Vec3 p_mm = 1e3 * tool->samples.front().X_FO.translation();
        QVERIFY((p_mm - Vec3{-214.00, 98.90, -1581.80}).norm() < 1e-6);
    }
};

CARINA_TEST(AnyRecordingTest)

} // namespace carina::any_recording_test

#include "tst_any_recording.moc"
