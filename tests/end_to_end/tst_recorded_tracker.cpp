#include "models/station/frame_log.h"
#include "tests/end_to_end/program.h"
#include "tests/support/test_class.h"

#include <QTemporaryDir>

namespace carina::recorded_tracker_test
{
namespace
{

constexpr double kPlace = 1e-6; ///< metres; the frames are logged in double precision

/// A place registered by a pure shift: the patient lies 10, 20, 30 mm from the tracker's origin.
/// @param more of the registration @param beside it
QByteArray siteText(const char* more, const char* beside)
{
    // moc does not read a raw string that ends within quotes.
    return QByteArray{R"({"schema": "carina.site/3", "step": "overview",
 "catalogue": {"name": "three", "landmarks": [{"name": "a", "p_AQ_mm": [0, 0, 1]},
  {"name": "b", "p_AQ_mm": [0, 1, 0]}, {"name": "c", "p_AQ_mm": [1, 0, 0]}]},
 "registration": {"X_AM_mm": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
  "X_AT_mm": [[1, 0, 0, 10], [0, 1, 0, 20], [0, 0, 1, 30], [0, 0, 0, 1]],
  "rms_mm": 0.1, "residuals_mm": [{"name": "a", "mm": 0.1}] MORE} BESIDE})"}
        .replace("MORE", more)
        .replace("BESIDE", beside);
}

/// A point at the origin of the patient was touched 4.2 mm above it.
constexpr const char* kNotGood = R"(, "verification": {"verdict": "not good",
 "at": "2026-11-01T10:00:00Z", "points": [{"name": "p", "p_AQ_mm": [0, 0, 0],
 "p_TQ_mm": [-10, -20, -25.8], "error_mm": 4.2, "bound_mm": 3.0}]})";

/// A minute of a tube at rest, 100, 0, -50 mm from the tracker's origin, at 20 samples per second.
QByteArray recording()
{
    constexpr int kFrames = 1200;
    QByteArray text =
        "ObjectType = Image\nNDims = 3\nDimSize = 0 0 " + QByteArray::number(kFrames) + "\n";
    for (int i = 0; i < kFrames; ++i) {
        const QByteArray frame = "Seq_Frame" + QByteArray::number(i).rightJustified(4, '0');
        text += frame + "_TubeToTrackerTransform = 1 0 0 100 0 1 0 0 0 0 1 -50 0 0 0 1\n" + frame
                + "_TubeToTrackerTransformStatus = OK\n" + frame
                + "_Timestamp = " + QByteArray::number(5.0 + 0.05 * i, 'f', 2) + '\n';
    }
    return text + "ElementDataFile = LOCAL\n";
}

bool write(const QString& path, const QByteArray& text)
{
    QFile file{path};
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
}

} // namespace

/// A trainee whose tracker is a recording.
class TestRecordedTracker : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// And says in both windows how far its place can be relied on.
    void drawsTheRecordedTubeWhereTheSitePutsIt_data()
    {
        QTest::addColumn<QByteArray>("site");
        QTest::addColumn<QString>("known");
        QTest::addColumn<QString>("notice");
        const auto row = [](const char* name, const QByteArray& site, const char* known,
                            const char* notice) {
            QTest::newRow(name) << site << QString::fromUtf8(known) << QString::fromUtf8(notice);
        };
        row("nobody verified it", siteText("", ""), "▲ unverified",
            "The registration is not verified");
        row("judged not good", siteText("", kNotGood), "▲ not good: 4.2\u00a0mm at check",
            "judged not good, 4.2\u00a0mm off at a check");
        row("the manikin was moved", siteText(R"(, "stale": "manikin" )", ""),
            "▲ stale: manikin moved", "because the manikin was moved");
    }
    void drawsTheRecordedTubeWhereTheSitePutsIt()
    {
        QFETCH(const QByteArray, site);
        QFETCH(const QString, known);
        QFETCH(const QString, notice);
        const QTemporaryDir folder;
        const QString port = portOfThisTest();
        const QString codes = folder.filePath(QStringLiteral("codes"));
        QVERIFY(write(folder.filePath(QStringLiteral("site.json")), site));
        QVERIFY(write(folder.filePath(QStringLiteral("tube.igs.mha")), recording()));
        Program instructor{QStringLiteral(CARINA_INSTRUCTOR),
                           {QStringLiteral("--port"), port, QStringLiteral("--data"),
                            folder.filePath(QStringLiteral("host")), QStringLiteral("--codes"),
                            codes, QStringLiteral("--start")},
                           folder.filePath(QStringLiteral("instructor.jsonl"))};
        instructor.start();
        QTRY_VERIFY_WITH_TIMEOUT(!instructor.shown().isEmpty(), kPatience_ms);
        Program trainee{
            QStringLiteral(CARINA_TRAINEE),
            {QStringLiteral("--port"), port, QStringLiteral("--as"), QStringLiteral("Trainee"),
             QStringLiteral("--code-file"), codes, QStringLiteral("--data"),
             folder.filePath(QStringLiteral("trainee")), QStringLiteral("--site"),
             folder.filePath(QStringLiteral("site.json")), QStringLiteral("--tracker"),
             QStringLiteral("recorded:") + folder.filePath(QStringLiteral("tube.igs.mha")),
             QStringLiteral("--measure"), folder.path(), QStringLiteral("--seconds"),
             QStringLiteral("8")},
            folder.filePath(QStringLiteral("trainee.jsonl"))};
        trainee.start();
        // The console reads it at once.
        QTRY_COMPARE_WITH_TIMEOUT(instructor.shown()[QStringLiteral("registrations")].toObject(),
                                  (QJsonObject{{QStringLiteral("Trainee"), known}}), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(trainee.hasEnded(), kPatience_ms);
        const QString told = trainee.shown()[QStringLiteral("notice")].toString();
        QVERIFY2(told.contains(notice), qPrintable(told));
        QCOMPARE(trainee.exitCode(), 0);
        const auto frames = readFrames(folder.filePath(QStringLiteral("trainee_frames.csv")));
        QVERIFY2(frames.has_value(), frames ? "" : frames.error().detail.c_str());
        int drawn = 0;
        for (const LoggedFrame& frame : *frames) {
            if (!frame.X_AE)
                continue;
            ++drawn;
            QVERIFY((frame.X_AE->translation() - Vec3{0.110, 0.020, -0.020}).norm() < kPlace);
        }
        QVERIFY(drawn > 0);
    }
};

CARINA_TEST(TestRecordedTracker)

} // namespace carina::recorded_tracker_test

#include "tst_recorded_tracker.moc"
