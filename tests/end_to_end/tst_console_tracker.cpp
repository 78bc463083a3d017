#include "engine/net/devices/any_recording.h"
#include "engine/session/facts/facts.h"
#include "tests/end_to_end/program.h"
#include "tests/support/test_class.h"

#include <QJsonArray>
#include <QTemporaryDir>

#include <algorithm>

namespace carina::console_tracker_test
{
namespace
{

constexpr int kPatience_ms = 60'000;
constexpr int kInstructor = 0; ///< the number of who hosts
constexpr double kSpeed_mm_per_s = 30.0;
constexpr double kPlace_mm = 0.5; ///< of a moving pose that is predicted: 17 ms of its way
/// From the first sample on, until its motion is known.
constexpr double kBegin_s = 2.0;

/// A place registered by a pure shift: the patient lies 10, 20, 30 mm from the tracker's origin.
const QByteArray kSite = R"({"schema": "carina.site/2", "step": "overview",
 "catalogue": {"name": "three", "landmarks": [{"name": "a", "p_AQ_mm": [0, 0, 1]},
  {"name": "b", "p_AQ_mm": [0, 1, 0]}, {"name": "c", "p_AQ_mm": [1, 0, 0]}]},
 "registration": {"X_AM_mm": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
  "X_AT_mm": [[1, 0, 0, 10], [0, 1, 0, 20], [0, 0, 1, 30], [0, 0, 0, 1]],
  "rms_mm": 0.1, "residuals_mm": [{"name": "a", "mm": 0.1}]}})";
const Vec3 kShift_mm{10.0, 20.0, 30.0};

/// Five minutes of a tube that moves along x: longer than the programs need to start.
TrackerSequence movingTube()
{
    constexpr double kRate = 60.0;
    TrackerSequence sequence{{{.name = "Tube", .role = ToolRole::Tube}}};
    for (int i = 0; i < 300 * int(kRate); ++i)
        sequence.tools[0].samples.push_back(
            {.time = SessionTime{fromSeconds(i / kRate)},
             .X_FO =
                 RigidTransform::translation({1e-3 * kSpeed_mm_per_s * i / kRate, 0.0, -0.05})});
    return sequence;
}

bool write(const QString& path, const QByteArray& text)
{
    QFile file{path};
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
}

/// Where a frame of a journal has a tube.
struct SeenTube {
    double time_s = 0.0;
    int owner = 0;
    bool isOwn = false;
    Vec3 p_A_mm = Vec3::Zero();
};

std::vector<SeenTube> tubesIn(const QJsonObject& line)
{
    std::vector<SeenTube> tubes;
    for (const QJsonValue& frame : line[QStringLiteral("frames")].toArray())
        for (const QJsonValue& object : frame[QStringLiteral("objects")].toArray())
            if (object[QStringLiteral("kind")].toInt() == int(ObjectKind::Tube)) {
                const QJsonArray p = object[QStringLiteral("xyz_mm")].toArray();
                tubes.push_back({1e-9 * frame[QStringLiteral("session_ns")].toDouble(),
                                 object[QStringLiteral("owner")].toInt(),
                                 object[QStringLiteral("own")].toBool(),
                                 {p[0].toDouble(), p[1].toDouble(), p[2].toDouble()}});
            }
    return tubes;
}

bool showsTubeOf(const Program& program, int owner)
{
    const auto tubes = tubesIn(program.shown());
    return std::ranges::any_of(tubes,
                               [owner](const SeenTube& tube) { return tube.owner == owner; });
}

bool showsTubeOfAnother(const Program& program, int owner)
{
    const auto tubes = tubesIn(program.shown());
    return std::ranges::any_of(tubes,
                               [owner](const SeenTube& tube) { return tube.owner != owner; });
}

/// Of the instructor's tube, in all frames since the motion of the recording is known: how many
/// there are, and how far the farthest is from where the recording has it.
struct Compared {
    int frames = 0;
    double farthest_mm = 0.0;
};

/// @param first recorded sample of the tube, in the tracker's frame
Compared compare(const Program& program, const PoseSample& first, bool isOwn)
{
    const double begin_s = toSeconds(first.time.time_since_epoch());
    Compared compared;
    for (const QJsonObject& line : program.allShown())
        for (const SeenTube& tube : tubesIn(line)) {
            const double passed_s = tube.time_s - begin_s;
            if (tube.owner != kInstructor || tube.isOwn != isOwn || passed_s < kBegin_s)
                continue;
            const Vec3 p_A_mm = 1e3 * first.X_FO.translation() + kShift_mm
                                + Vec3{kSpeed_mm_per_s * passed_s, 0.0, 0.0};
            ++compared.frames;
            compared.farthest_mm = std::max(compared.farthest_mm, (tube.p_A_mm - p_A_mm).norm());
        }
    return compared;
}

} // namespace

/// An instructor who demonstrates with tools of their own.
class TestConsoleTracker : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void playsARecordingThatEverybodySees()
    {
        const QTemporaryDir folder;
        const auto inFolder = [&](const char* name) {
            return folder.filePath(QLatin1String{name});
        };
        const QString codes = inFolder("codes");
        QVERIFY(write(inFolder("site.json"), kSite));
        QVERIFY(writeAnyRecording(inFolder("tube.csv").toStdString(), movingTube()));
        Program instructor{
            QStringLiteral(CARINA_INSTRUCTOR),
            {QStringLiteral("--port"), portOfThisTest(), QStringLiteral("--data"), inFolder("host"),
             QStringLiteral("--codes"), codes, QStringLiteral("--start"),
             QStringLiteral("--tracker"), QStringLiteral("recorded:") + inFolder("tube.csv"),
             QStringLiteral("--site"), inFolder("site.json"), QStringLiteral("--record"),
             inFolder("seen.csv"), QStringLiteral("--script"), inFolder("script")},
            inFolder("instructor.jsonl")};
        instructor.start();
        QTRY_VERIFY_WITH_TIMEOUT(!instructor.shown().isEmpty(), kPatience_ms);
        const auto trainee = [&](const char* name, const QStringList& more) {
            const QString own = QLatin1String{name};
            return Program{QStringLiteral(CARINA_TRAINEE),
                           QStringList{QStringLiteral("--port"), portOfThisTest(),
                                       QStringLiteral("--as"), own, QStringLiteral("--code-file"),
                                       codes, QStringLiteral("--data"), folder.filePath(own)}
                               + more,
                           folder.filePath(own + QStringLiteral(".jsonl"))};
        };
        Program tom = trainee("Tom", {QStringLiteral("--tracker"), QStringLiteral("simulated")});
        Program tess = trainee("Tess", {});
        tom.start();
        tess.start();
        QTRY_VERIFY_WITH_TIMEOUT(showsTubeOf(tess, kInstructor), kPatience_ms);
        // Beside it that of who is at work.
        QTRY_VERIFY_WITH_TIMEOUT(showsTubeOfAnother(tess, kInstructor), kPatience_ms);

        const auto seen = readAnyRecording(inFolder("seen.csv").toStdString());
        QVERIFY2(seen.has_value(), seen ? "" : seen.error().detail.c_str());
        const PoseSample& first = seen->tools[0].samples.front();
        const double begin_s = toSeconds(first.time.time_since_epoch());
        const auto isShownFor = [&](const Program& program, bool isOwn) {
            const auto tubes = tubesIn(program.shown());
            return std::ranges::any_of(tubes, [&](const SeenTube& tube) {
                return tube.owner == kInstructor && tube.isOwn == isOwn
                       && tube.time_s > begin_s + kBegin_s + 3.0;
            });
        };
        QTRY_VERIFY_WITH_TIMEOUT(isShownFor(tess, false) && isShownFor(instructor, true),
                                 kPatience_ms);
        for (const auto& [program, isOwn] :
             {std::pair{&instructor, true}, std::pair{&tess, false}, std::pair{&tom, false}}) {
            const Compared compared = compare(*program, first, isOwn);
            QVERIFY(compared.frames > 0);
            QVERIFY2(compared.farthest_mm < kPlace_mm,
                     qPrintable(QString::number(compared.farthest_mm)));
        }

        // And no more once a person goes on without it, in the running console.
        QFile script{inFolder("script")};
        QVERIFY(script.open(QIODevice::Append));
        const auto work = [&](const QByteArray& lines) {
            script.write(lines);
            script.flush();
        };
        work("press withoutTracker\n");
        QTRY_VERIFY_WITH_TIMEOUT(!showsTubeOf(tess, kInstructor), kPatience_ms);
        QVERIFY(showsTubeOfAnother(tess, kInstructor));
        work("press connectTracker\npress source2\ntype recording " + inFolder("tube.csv").toUtf8()
             + "\npress looped\npress use\n");
        QTRY_VERIFY_WITH_TIMEOUT(showsTubeOf(tess, kInstructor), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(showsTubeOf(instructor, kInstructor), kPatience_ms);
    }

    void refusesATrackerWithoutASite()
    {
        const QTemporaryDir folder;
        const QString recording = folder.filePath(QStringLiteral("tube.csv"));
        QVERIFY(writeAnyRecording(recording.toStdString(), movingTube()));
        Program instructor{QStringLiteral(CARINA_INSTRUCTOR),
                           {QStringLiteral("--port"), portOfThisTest(), QStringLiteral("--data"),
                            folder.filePath(QStringLiteral("host")), QStringLiteral("--tracker"),
                            QStringLiteral("recorded:") + recording},
                           folder.filePath(QStringLiteral("instructor.jsonl"))};
        instructor.start();
        QTRY_VERIFY_WITH_TIMEOUT(instructor.hasEnded(), kPatience_ms);
        QCOMPARE(instructor.exitCode(), 2);
    }
};

CARINA_TEST(TestConsoleTracker)

} // namespace carina::console_tracker_test

#include "tst_console_tracker.moc"
