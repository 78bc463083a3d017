#include "engine/airway/monitor/patient_ways.h"
#include "tests/engine/airway/monitor/monitored_run.h"
#include "tests/support/test_class.h"

#include <array>
#include <cmath>

namespace carina::patient_ways_test
{

namespace
{

constexpr double kExact = 1e-9;    // m
constexpr double kOfPart = 0.5e-3; // m, from a part's vertices in single precision
constexpr double kAngle = 1e-6;    // rad

double angleBetween(const Vec3& a, const Vec3& b)
{
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// A ring of vertices of a tube.
void addRing(AnatomyPart& part, const Vec3& p_A_middle, double radius)
{
    for (int i = 0; i < 8; ++i) {
        const double angle = std::numbers::pi * i / 4.0;
        const Vec3 p = p_A_middle + radius * Vec3{std::cos(angle), std::sin(angle), 0.0};
        part.levels.front().positions.push_back(p.cast<float>());
    }
}

AnatomyPart partOf(PartRole role)
{
    AnatomyPart part;
    part.role = role;
    part.levels.resize(1);
    return part;
}

} // namespace

class TestPatientWays : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void leavesTheUpperTeethWhereTheJawGoes()
    {
        const PatientWays ways = test::drawnWays();
        const Vec3 in = ways.inward_A();
        const double whole = (ways.p_A_glottis() - ways.p_A_incisors()).norm();
        QCOMPARE(shareOfJaw(ways, ways.p_A_incisors()), 0.0);
        QCOMPARE(shareOfJaw(ways, ways.p_A_incisors() - 0.01 * in), 0.0);
        QVERIFY(std::abs(shareOfJaw(ways, ways.p_A_incisors() + 0.1 * whole * in) - 0.25) < kExact);
        QCOMPARE(shareOfJaw(ways, ways.p_A_incisors() + 0.5 * whole * in), 1.0);
    }

    void bronchiHaveThePublishedAngles()
    {
        const PatientWays ways = test::drawnWays();
        const Vec3 down = -Vec3::UnitZ();
        const Vec3 right = ways.p_A_rightEnd - ways.p_A_carina();
        const Vec3 left = ways.p_A_leftEnd - ways.p_A_carina();
        QVERIFY(right.x() < 0.0 && left.x() > 0.0); // +x is the patient's left
        QVERIFY(std::abs(angleBetween(down, right) - degrees(26.9).si) < kAngle);
        QVERIFY(std::abs(angleBetween(down, left) - degrees(46.2).si) < kAngle);
        QVERIFY(std::abs(left.norm() - 2.0 * right.norm()) < kExact);
        QVERIFY(std::abs(right.norm() - 0.025 * 125.0 / 127.0) < kExact);
    }

    void bronchiAreThoseOfTheParts()
    {
        AnatomyPart bronchus = partOf(PartRole::LeftMainBronchus);
        const Vec3 end{0.030, 0.004, -0.025};
        for (int i = 1; i <= 20; ++i)
            addRing(bronchus, i / 20.0 * end, 0.005);
        const PatientWays ways =
            patientWays(test::drawnAirway(), std::nullopt, std::array{bronchus});
        const Vec3 found = ways.p_A_leftEnd - ways.p_A_carina();
        constexpr double kOfDirection = 0.08; // rad, of a mean over its end
        QVERIFY(angleBetween(found, end) < kOfDirection);
        QVERIFY(found.norm() > 0.8 * end.norm() && found.norm() < 1.1 * end.norm());
    }

    void pathIsDividedAtTheGlottis()
    {
        const AirwayLandmarks airway = test::drawnAirway();
        const PatientWays ways = test::drawnWays();
        QVERIFY((ways.p_A_incisors() - airway.p_A_incisors).norm() < kExact);
        QVERIFY((ways.p_A_glottis() - airway.p_A_glottis).norm() < kExact);
        QVERIFY((ways.overTongue.back() - airway.p_A_glottis).norm() < kExact);
        QVERIFY(ways.p_A_carina().norm() < kExact);
        QVERIFY(angleBetween(ways.up_A(), Vec3::UnitZ()) < kAngle);
        QVERIFY(std::abs(lengthOf(ways.trachea).si - 0.125) < kExact);
    }

    /// As a set that another computer sent may say: no program ends by it.
    void bothHalvesAreThereWhereverTheGlottisIs()
    {
        const AirwayLandmarks airway = test::drawnAirway();
        for (const Vec3& p_A_glottis : {airway.p_A_incisors, airway.p_A_carina}) {
            AirwayLandmarks other = airway;
            other.p_A_glottis = p_A_glottis;
            const PatientWays ways = patientWays(other, std::nullopt, {});
            QVERIFY(ways.overTongue.size() >= 2 && ways.trachea.size() >= 2);
            QVERIFY(nearestOnWay(ways.overTongue, airway.p_A_carina).along >= Length{});
        }
    }

    void oesophagusIsBehindTheTrachea()
    {
        const PatientWays ways = test::drawnWays();
        const double share = 125.0 / 127.0;
        QVERIFY(ways.p_A_notch.y() > 0.0);
        QVERIFY(ways.oesophagus.front().y() > ways.p_A_notch.y());
        for (const Vec3& p : std::span{ways.oesophagus}.subspan(1))
            QVERIFY(std::abs(p.y() - share * kTracheaToOesophagus.si) < kExact);
        QVERIFY(ways.oesophagus.back().z() < -0.03);
    }

    void oesophagusIsThatOfThePart()
    {
        AnatomyPart part = partOf(PartRole::Oesophagus);
        for (int i = 0; i < 80; ++i) // 2 mm apart, leaning to the left
            addRing(part, {0.0005 * i, 0.020, 0.120 - 0.002 * i}, 0.008);
        const PatientWays ways = patientWays(test::drawnAirway(), std::nullopt, std::array{part});
        QVERIFY(ways.oesophagus.size() > 10);
        for (const Vec3& p : std::span{ways.oesophagus}.subspan(1)) {
            QVERIFY(std::abs(p.y() - 0.020) < kOfPart);
            QVERIFY(std::abs(p.x() - 0.25 * (0.120 - p.z())) < kOfPart);
        }
    }

    void allOfItMovesWithTheTissue()
    {
        const PatientWays ways = test::drawnWays();
        const Vec3 d{0.001, 0.002, 0.003};
        const PatientWays there = moved(ways, [&d](const Vec3& p) { return Vec3{p + d}; });
        QVERIFY((there.p_A_carina() - ways.p_A_carina() - d).norm() < kExact);
        QVERIFY((there.p_A_incisors() - ways.p_A_incisors() - d).norm() < kExact);
        QVERIFY((there.p_A_notch - ways.p_A_notch - d).norm() < kExact);
        QVERIFY((there.p_A_leftEnd - ways.p_A_leftEnd - d).norm() < kExact);
        QVERIFY((there.p_A_rightEnd - ways.p_A_rightEnd - d).norm() < kExact);
        QVERIFY((there.oesophagus.back() - ways.oesophagus.back() - d).norm() < kExact);
        QVERIFY(angleBetween(there.up_A(), ways.up_A()) < kAngle);
    }

    void lineGoesOnBeyondItsEndOnly()
    {
        const std::array line{Vec3{0.0, 0.0, 0.1}, Vec3{0.0, 0.0, 0.05}, Vec3{0.0, 0.0, 0.0}};
        const auto at = [&](const Vec3& p) { return nearestOnWay(line, p); };
        QVERIFY(std::abs(at({0.003, 0.0, 0.02}).along.si - 0.08) < kExact);
        QVERIFY(std::abs(at({0.003, 0.0, 0.02}).off.si - 0.003) < kExact);
        QVERIFY(std::abs(at({0.003, 0.0, -0.02}).along.si - 0.12) < kExact);
        QVERIFY(std::abs(at({0.003, 0.0, -0.02}).off.si - 0.003) < kExact);
        QVERIFY(std::abs(at({0.0, 0.0, 0.13}).along.si) < kExact);
        QVERIFY(std::abs(at({0.0, 0.0, 0.13}).off.si - 0.03) < kExact);
    }
};

CARINA_TEST(TestPatientWays)

} // namespace carina::patient_ways_test

#include "tst_patient_ways.moc"
