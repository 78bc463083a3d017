#include "engine/session/facts/facts.h"
#include "tests/end_to_end/tool_session.h"
#include "tests/support/test_class.h"

#include <QJsonArray>

#include <algorithm>

namespace carina::console_tracker_test
{
namespace
{

constexpr int kInstructor = 0; ///< the number of who hosts
constexpr double kSpeed_mm_per_s = 30.0;
constexpr double kPlace_mm = 0.5; ///< of a moving pose that is predicted: 17 ms of its way
/// From the first sample on, until its motion is known.
constexpr double kBegin_s = 2.0;

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
        ToolSession session;
        QVERIFY(session.prepare(movingTube()));
        Program instructor = session.instructor(
            {QStringLiteral("--start"), QStringLiteral("--tracker"),
             QStringLiteral("recorded:") + session.path("tools.csv"), QStringLiteral("--site"),
             session.path("site.json"), QStringLiteral("--record"), session.path("seen.csv"),
             QStringLiteral("--script"), session.path("script")});
        instructor.start();
        QTRY_VERIFY_WITH_TIMEOUT(!instructor.shown().isEmpty(), kPatience_ms);
        Program tom =
            session.trainee("Tom", {QStringLiteral("--tracker"), QStringLiteral("simulated")});
        Program tess = session.trainee("Tess", {});
        tom.start();
        tess.start();
        QTRY_VERIFY_WITH_TIMEOUT(showsTubeOf(tess, kInstructor), kPatience_ms);
        // Beside it that of who is at work.
        QTRY_VERIFY_WITH_TIMEOUT(showsTubeOfAnother(tess, kInstructor), kPatience_ms);

        const auto seen = readAnyRecording(session.path("seen.csv").toStdString());
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
        QTRY_VERIFY_WITH_TIMEOUT(isShownFor(tess, false) && isShownFor(tom, false)
                                     && isShownFor(instructor, true),
                                 kPatience_ms);
        for (const auto& [program, isOwn] :
             {std::pair{&instructor, true}, std::pair{&tess, false}, std::pair{&tom, false}}) {
            const Compared compared = compare(*program, first, isOwn);
            QVERIFY(compared.frames > 0);
            QVERIFY2(compared.farthest_mm < kPlace_mm,
                     qPrintable(QString::number(compared.farthest_mm)));
        }

        // And no more once a person goes on without it, in the running console.
        session.work("press withoutTracker\n");
        QTRY_VERIFY_WITH_TIMEOUT(!showsTubeOf(tess, kInstructor), kPatience_ms);
        QVERIFY(showsTubeOfAnother(tess, kInstructor));
        session.useRecording();
        QTRY_VERIFY_WITH_TIMEOUT(showsTubeOf(tess, kInstructor), kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(showsTubeOf(instructor, kInstructor), kPatience_ms);
    }

    void refusesATrackerWithoutASite()
    {
        ToolSession session;
        QVERIFY(session.prepare(movingTube()));
        Program instructor = session.instructor(
            {QStringLiteral("--tracker"), QStringLiteral("recorded:") + session.path("tools.csv")});
        instructor.start();
        QTRY_VERIFY_WITH_TIMEOUT(instructor.hasEnded(), kPatience_ms);
        QCOMPARE(instructor.exitCode(), 2);
    }
};

CARINA_TEST(TestConsoleTracker)

} // namespace carina::console_tracker_test

#include "tst_console_tracker.moc"
