#include "engine/session/facts/facts.h"
#include "tests/end_to_end/tool_session.h"
#include "tests/support/test_class.h"

#include <QJsonArray>

namespace carina::tracker_use_test
{
namespace
{

constexpr double kPlace_mm = 0.1; ///< of a shared pose, in steps of 10 micrometres, on its way

/// Ten seconds of a tube, a laryngoscope and a hand at rest.
TrackerSequence atRest()
{
    TrackerSequence sequence{{{.name = "Tube", .role = ToolRole::Tube},
                              {.name = "Laryngoscope", .role = ToolRole::Laryngoscope},
                              {.name = "Hand", .role = ToolRole::Hand}}};
    const std::array places{Vec3{0.100, 0.0, -0.050}, Vec3{0.0, 0.100, -0.050},
                            Vec3{0.050, 0.050, -0.050}};
    for (std::size_t tool = 0; tool < places.size(); ++tool)
        for (int i = 0; i < 600; ++i)
            sequence.tools[tool].samples.push_back(
                {.time = SessionTime{fromSeconds(i / 60.0)},
                 .X_FO = RigidTransform::translation(places[tool])});
    return sequence;
}

/// Where the newest frames draw an object of this kind that another one owns.
std::optional<Vec3> othersPlace_mm(const Program& program, ObjectKind kind)
{
    const QJsonArray frames = program.shown()[QStringLiteral("frames")].toArray();
    for (const QJsonValue& frame : frames)
        for (const QJsonValue& object : frame[QStringLiteral("objects")].toArray())
            if (!object[QStringLiteral("own")].toBool()
                && object[QStringLiteral("kind")].toInt() == int(kind)) {
                const QJsonArray p = object[QStringLiteral("xyz_mm")].toArray();
                return Vec3{p[0].toDouble(), p[1].toDouble(), p[2].toDouble()};
            }
    return std::nullopt;
}

bool isAt(const std::optional<Vec3>& p_mm, const Vec3& expected_mm)
{
    return p_mm && (*p_mm - expected_mm).norm() < kPlace_mm;
}

} // namespace

/// A trainee's program that is started without a tracker, and is given one while it runs.
class TestTrackerUse : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isGivenATrackerWhichOthersSeeAndRecordsIt()
    {
        ToolSession session;
        QVERIFY(session.prepare(atRest()));
        Program instructor = session.instructor({QStringLiteral("--start")});
        instructor.start();
        QTRY_VERIFY_WITH_TIMEOUT(!instructor.shown().isEmpty(), kPatience_ms);
        Program tom =
            session.trainee("Tom", {QStringLiteral("--site"), session.path("site.json"),
                                    QStringLiteral("--script"), session.path("script"),
                                    QStringLiteral("--record"), session.path("poses.igs.mha")});
        Program tess = session.trainee("Tess", {});
        tom.start();
        tess.start();
        QTRY_VERIFY_WITH_TIMEOUT(!tom.shown().isEmpty() && !tess.shown().isEmpty(), kPatience_ms);
        QVERIFY(!othersPlace_mm(tess, ObjectKind::Laryngoscope));

        session.useRecording();
        QTRY_VERIFY_WITH_TIMEOUT(
            isAt(othersPlace_mm(tess, ObjectKind::Laryngoscope), {10.0, 120.0, -20.0}),
            kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(isAt(othersPlace_mm(tess, ObjectKind::Hand), {60.0, 70.0, -20.0}),
                                 kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(isAt(othersPlace_mm(tess, ObjectKind::Tube), {110.0, 20.0, -20.0}),
                                 kPatience_ms);
        // The console draws them, too.
        QTRY_VERIFY_WITH_TIMEOUT(
            isAt(othersPlace_mm(instructor, ObjectKind::Laryngoscope), {10.0, 120.0, -20.0}),
            kPatience_ms);

        session.work("press withoutTracker\n");
        QTRY_VERIFY_WITH_TIMEOUT(!othersPlace_mm(tess, ObjectKind::Laryngoscope), kPatience_ms);

        tom.kill(); // as kill -9 does
        const auto recorded = readAnyRecording(session.path("poses.igs.mha.csv").toStdString());
        QVERIFY2(recorded.has_value(), recorded ? "" : recorded.error().detail.c_str());
        QCOMPARE(recorded->tools.size(), std::size_t{3});
        QCOMPARE(recorded->tools[1].role, ToolRole::Laryngoscope);
        QVERIFY2(recorded->tools[1].samples.size() > 3,
                 qPrintable(QString::number(recorded->tools[1].samples.size())));
        for (const PoseSample& sample : recorded->tools[1].samples)
            QVERIFY((sample.X_FO.translation() - Vec3{0.0, 0.1, -0.05}).norm() < 1e-8);
    }
};

CARINA_TEST(TestTrackerUse)

} // namespace carina::tracker_use_test

#include "tst_tracker_use.moc"
