#include "apps/lab/anatomy/sweep_report.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::lab::sweep_report_test
{
namespace
{

constexpr const char* kSheet = "Sheet"; ///< the part in place of the child's
constexpr double kTolerance = 0.2; ///< of a determinant: the sheet is as wide as a few millimetres

/// Two triangles with a corner in common. The far edge of the second passes the first, or runs
/// through it: it is folded back.
TriangleMesh sheetAt(const Vec3& p_A, bool isFoldedBack)
{
    const float height = isFoldedBack ? -1.0F : 1.0F;
    TriangleMesh mesh{.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 2, 1}, {2, 1, height}},
                      .normals = std::vector<Vec3f>(5, Vec3f::UnitZ()),
                      .triangles = {{0, 1, 2}, {0, 3, 4}}};
    for (Vec3f& p : mesh.positions)
        p = p_A.cast<float>() + 1e-3F * p;
    return mesh;
}

const Anatomy& child()
{
    static const Anatomy made = builtinPatient(BuiltinPatient::TwelveYears).value();
    return made;
}

/// At shares of the way from incisors to glottis from the latter.
Vec3 fromGlottis(const Vec3& shares)
{
    const AirwayLandmarks& marks = child().landmarks;
    return marks.p_A_glottis + (marks.p_A_incisors - marks.p_A_glottis).norm() * shares;
}

/// Half way along the neck, which bends there and folds nothing.
Vec3 inNeck() { return fromGlottis({0.0, 0.0, -0.38}); }

/// At half the height of the neck, too, but so far in front of it that flexion turns the order of
/// places over (NeckField).
Vec3 farInFront() { return fromGlottis({0.0, -1.75, -1.04}); }

/// The determinant at farInFront, 1 + a S' m: S' is 1.5 half way along the ramp of 0.92, and m from
/// the hinge, 0.25 behind and 0.30 below the glottis, across a neck that leans by 20 degrees.
double expectedInFront()
{
    const double lean = degrees(20.0).si;
    const double m = (std::sin(lean) * (-1.04 + 0.30) + std::cos(lean) * (-1.75 - 0.25)) / 0.92;
    return 1.0 + kMostFlexion.si * 1.5 * m;
}

/// What is told of a sheet in the child, alone, with a flexed neck.
QJsonObject reported(const TriangleMesh& sheet)
{
    Anatomy patient = child();
    const DeformationSweep sweep = DeformationSweep::of(patient, {}).value();
    patient.parts = {{kSheet, PartRole::Muscle, {}, {sheet}}};
    const DeformationCombination flexed{.head = {kMostFlexion, {}}};
    SweepReport report;
    report.add(flexed, sweep.deformedBy(flexed));
    return report.object();
}

/// The entry of the sheet in a list of parts; empty without one.
QJsonObject ofSheet(const QJsonValue& list)
{
    for (const QJsonValue entry : list.toArray())
        if (entry[QStringLiteral("part")].toString() == QLatin1String{kSheet})
            return entry.toObject();
    return {};
}

} // namespace

class TestSweepReport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void acceptsASheetThatTheNeckBends()
    {
        const QJsonObject report = reported(sheetAt(inNeck(), false));
        const QJsonObject sheet = ofSheet(report[QStringLiteral("parts")]);
        QCOMPARE(sheet[QStringLiteral("self_intersecting")].toInt(-1), 0);
        QVERIFY(sheet[QStringLiteral("least_determinant")].toDouble() > 0.0);
        QVERIFY(ofSheet(report[QStringLiteral("bad")]).isEmpty());
        QCOMPARE(report[QStringLiteral("self_intersecting")].toInt(), 0);
        QCOMPARE(report[QStringLiteral("folded")].toInt(), 0);
        QCOMPARE(report[QStringLiteral("acceptable")].toBool(), true);
    }

    void tellsOfASheetThatIsFoldedByHand()
    {
        const QJsonObject report = reported(sheetAt(inNeck(), true));
        const QJsonObject fault = ofSheet(report[QStringLiteral("bad")]);
        QCOMPARE(fault[QStringLiteral("pairs")].toInt(), 1);
        QVERIFY(fault[QStringLiteral("determinant")].toDouble() > 0.0);
        const QJsonValue flexion =
            fault[QStringLiteral("parameters")][QStringLiteral("neck_flexion_deg")];
        QVERIFY(std::abs(flexion.toDouble() - 35.0) < 1e-9);
        QCOMPARE(
            ofSheet(report[QStringLiteral("parts")])[QStringLiteral("self_intersecting")].toInt(),
            1);
        QCOMPARE(report[QStringLiteral("self_intersecting")].toInt(), 1);
        QCOMPARE(report[QStringLiteral("folded")].toInt(), 0);
        QCOMPARE(report[QStringLiteral("acceptable")].toBool(), false);
    }

    /// No triangle runs through another, but all face the other way.
    void tellsOfASheetThatADeformationTurnsOver()
    {
        const QJsonObject report = reported(sheetAt(farInFront(), false));
        const QJsonObject fault = ofSheet(report[QStringLiteral("bad")]);
        QCOMPARE(fault[QStringLiteral("pairs")].toInt(-1), 0);
        const double determinant = fault[QStringLiteral("determinant")].toDouble();
        QVERIFY(std::abs(determinant - expectedInFront()) < kTolerance);
        const QJsonValue least = report[QStringLiteral("least_determinant")];
        QCOMPARE(least[QStringLiteral("part")].toString(), QLatin1String{kSheet});
        QCOMPARE(least[QStringLiteral("determinant")].toDouble(), determinant);
        QCOMPARE(report[QStringLiteral("self_intersecting")].toInt(), 0);
        QCOMPARE(report[QStringLiteral("folded")].toInt(), 1);
        QCOMPARE(report[QStringLiteral("acceptable")].toBool(), false);
    }
};

CARINA_TEST(TestSweepReport)

} // namespace carina::lab::sweep_report_test

#include "tst_sweep_report.moc"
