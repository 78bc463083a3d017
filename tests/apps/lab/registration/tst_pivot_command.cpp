#include "apps/lab/command/help.h"
#include "apps/lab/commands.h"
#include "engine/geometry/rigid_transform.h"
#include "engine/geometry/rotation.h"
#include "tests/apps/lab/registration/stylus_poses.h"
#include "tests/engine/tracking/sequence_text.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"

#include <QJsonArray>

#include <numbers>

namespace carina::lab::pivot_command_test
{

using namespace test;

namespace
{

std::string matrixText(const RigidTransform& X_mm, const char* between)
{
    std::string text;
    const Mat4 matrix = X_mm.matrix();
    for (int i = 0; i < 16; ++i)
        text += digits(matrix(i / 4, i % 4)) + (i % 4 == 3 ? "\n" : between);
    return text;
}

std::string inOneLine(std::string text)
{
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

} // namespace

class TestPivotCommand : public QObject
{
    Q_OBJECT

private:
    test::ScratchFolder m_folder;

    static Result<QJsonObject> pivot(const QString& path) { return pivotCommand().run({path}); }
    static void verifyFound(const Result<QJsonObject>& object, int outliers = 0)
    {
        QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
        QCOMPARE(object->value(QStringLiteral("schema")).toString(),
                 QStringLiteral("carina.pivot/1"));
        QVERIFY(near(object->value(QStringLiteral("tip_mm")), kTip_S_mm));
        QVERIFY(near(object->value(QStringLiteral("pivot_mm")), kDivot_mm));
        QVERIFY(object->value(QStringLiteral("rms_mm")).toDouble(1.0) < kTolerance_mm);
        QCOMPARE(object->value(QStringLiteral("poses")).toInt(), kPoses);
        QCOMPARE(object->value(QStringLiteral("outliers")).toInt(-1), outliers);
    }

private Q_SLOTS:
    void readsARecording()
    {
        test::SequenceText text;
        int frame = 0;
        for (const RigidTransform& pose : swung())
            text.frame(std::to_string(frame++)).tool("Pen", inOneLine(matrixText(pose, " ")));
        text.frame(std::to_string(frame)).tool("Pen", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", "MISSING");
        verifyFound(pivot(m_folder.write("pen.igs.mha", text.text())));
    }

    /// The divot is fixed to the reference, and both are carried about before the tracker.
    void readsARecordingInTheFrameOfItsReference()
    {
        test::SequenceText text;
        int frame = 0;
        for (const RigidTransform& pose : swung()) {
            const RigidTransform X_TR =
                RigidTransform{rotationFromVector({0.0, 0.0, 0.02 * frame}), Vec3::Zero()} * kX_TR;
            text.frame(std::to_string(frame++))
                .tool("Probe", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1")
                .tool("Stylus", inOneLine(matrixText(X_TR * pose, " ")))
                .tool("Reference", inOneLine(matrixText(X_TR, " ")));
        }
        text.frame(std::to_string(frame))
            .tool("Stylus", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1")
            .tool("Reference", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", "OUT_OF_VIEW");
        verifyFound(pivot(m_folder.write("reference.igs.mha", text.text())));
    }

    void readsATable()
    {
        std::string text = "time,qw,qx,qy,qz,tx,ty,tz\n";
        for (const RigidTransform& pose : swung()) {
            const Quat& q = pose.rotation();
            text += "0";
            for (const double number :
                 {2.0 * q.w(), 2.0 * q.x(), 2.0 * q.y(), 2.0 * q.z(), pose.translation().x(),
                  pose.translation().y(), pose.translation().z()})
                text += ',' + digits(number);
            text += '\n';
        }
        verifyFound(pivot(m_folder.write("poses.CSV", text)));
    }

    void readsAFolderOfMatrices()
    {
        int file = 0;
        for (const RigidTransform& pose : swung()) {
            ++file;
            m_folder.write(("poses/" + std::to_string(file) + ".txt").c_str(),
                           matrixText(pose, file % 2 == 0 ? " " : ", "));
        }
        m_folder.write("poses/readme.md", "not a pose");
        verifyFound(pivot(m_folder.filePath("poses")));
    }

    void leavesOutliersOut()
    {
        auto poses = swung();
        poses[7] = RigidTransform::translation({0.0, 0.0, 40.0}) * poses[7];
        verifyFound(pivot(m_folder.write("outlier.csv", tableOf(poses))), 1);
    }

    void refusesWhatTellsNoTip_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("text");
        QTest::addColumn<Errc>("code");
        QTest::addColumn<QString>("sentence");
        const QString head = QStringLiteral("tx,ty,tz,qx,qy,qz,qw\n");
        const QString table = QStringLiteral("bad.csv");
        QTest::newRow("too few poses")
            << table << head + QStringLiteral("1,2,3,0,0,0,1\n") << Errc::TooFewPoses
            << QStringLiteral("does not determine the tip: 1 poses");
        QTest::newRow("no rotation")
            << table << head + QStringLiteral("1,2,3,0,0,0,0\n") << Errc::NotFinite
            << QStringLiteral("pose 1 is not a valid pose.");
        QTest::newRow("no number")
            << table << head + QStringLiteral("1,2,nan,0,0,0,1\n") << Errc::NotFinite
            << QStringLiteral("pose 1 is not a valid pose.");
        QTest::newRow("a column missing")
            << table << QStringLiteral("tx,ty,tz,qx,qy,qz\n") << Errc::FileMalformed
            << QStringLiteral("has no column \"qw\".");
        QTest::newRow("no recording") << QStringLiteral("bad.igs.mha") << QStringLiteral("poses")
                                      << Errc::FileMalformed << QStringLiteral("no '='");
        const QString matrix = QStringLiteral("bad/1.txt");
        QTest::newRow("12 numbers")
            << matrix << QStringLiteral("1 0 0 1 0 1 0 2 0 0 1 3") << Errc::FileMalformed
            << QStringLiteral("does not have the 16 numbers of a pose.");
        QTest::newRow("a mirror") << matrix << QStringLiteral("1 0 0 1 0 1 0 2 0 0 -1 3 0 0 0 1")
                                  << Errc::NotARotation << QStringLiteral("mirrors.");
        QTest::newRow("a word") << matrix << QStringLiteral("1 0 0 1 0 1 0 2 0 0 one 3 0 0 0 1")
                                << Errc::FileMalformed
                                << QStringLiteral("does not have the 16 numbers of a pose.");
    }

    void refusesWhatTellsNoTip()
    {
        QFETCH(QString, name);
        QFETCH(QString, text);
        QFETCH(Errc, code);
        QFETCH(QString, sentence);
        const QString path = m_folder.write(name.toLatin1().constData(), text.toStdString());
        const QString folder = path.left(path.lastIndexOf(QLatin1Char{'/'}));
        const auto object = pivot(name.contains(QLatin1Char{'/'}) ? folder : path);
        QVERIFY(!object);
        const QString detail = QString::fromStdString(object.error().detail);
        QVERIFY2(object.error().code == code, qPrintable(detail));
        QVERIFY2(detail.startsWith(path) && detail.contains(sentence), qPrintable(detail));
    }

    void refusesAFolderWithoutPoses()
    {
        QTemporaryDir empty;
        const auto object = pivot(empty.path());
        QVERIFY(!object);
        QCOMPARE(object.error().code, Errc::NothingRecognised);
    }

    void refusesARecordingOfSeveralToolsNoneOfThemTheStylus()
    {
        test::SequenceText text;
        text.frame("0").toolAt("One", "0", "0", "0").toolAt("Two", "0", "0", "0");
        const auto object = pivot(m_folder.write("two.igs.mha", text.text()));
        QVERIFY(!object);
        QCOMPARE(object.error().code, Errc::NothingRecognised);
    }

    void refusesAnotherCommandLine()
    {
        QVERIFY(!pivotCommand().run({}));
        QVERIFY(!pivotCommand().run({QStringLiteral("a"), QStringLiteral("b")}));
        QCOMPARE(pivot(m_folder.filePath("absent.igs.mha")).error().code, Errc::FileNotFound);
    }

    void helpNamesEveryKeyAndColumn()
    {
        for (const char* name : {"FILE.igs.mha",  "FILE.csv",       "DIR",
                                 "tx,ty,tz",      "qx,qy,qz,qw",    "schema",
                                 "tip_mm",        "pivot_mm",       "rms_mm",
                                 "poses",         "outliers",       "--limit-mm",
                                 "--spin",        "uncertainty_mm", "coverage",
                                 "direction",     "turn_deg",       "least_turned",
                                 "carina.spin/1", "axis",           "axis_point_mm",
                                 "wobble_deg",    "uncertainty_deg"})
            QVERIFY2(pageOf(pivotCommand()).contains(QLatin1StringView{name}), name);
    }
};

CARINA_TEST(TestPivotCommand)

} // namespace carina::lab::pivot_command_test

#include "tst_pivot_command.moc"
