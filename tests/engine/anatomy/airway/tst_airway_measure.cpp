#include "engine/anatomy/airway/airway_measure.h"

#include "engine/anatomy/airway/airway_path.h"
#include "engine/anatomy/patient/body_plan.h"
#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <array>
#include <cmath>
#include <numbers>

namespace carina::airway_measure_test
{

namespace
{

constexpr double kExact = 1e-9;      // m
constexpr double kPolyline = 0.1e-3; // m, of a curve drawn by pieces of 2 mm

AirwayLandmarks airwayOf(const PatientParameters& who)
{
    return bodyPlanOf(dimensionsFor(who).value(), Posture::Rest).landmarks;
}

} // namespace

class TestAirwayMeasure : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void patientsAreAsLongAsTheirFiguresSay()
    {
        PatientParameters who = parametersOf(BuiltinPatient::Adult);
        QVERIFY(std::abs(teethToCarina(airwayOf(who)).si - 0.24013) < kPolyline);
        for (const double asked : {0.206, 0.225, 0.258, 0.275}) {
            who.teethToCarina = metres(asked);
            QVERIFY(std::abs(teethToCarina(airwayOf(who)).si - asked) < kPolyline);
        }
    }

    /// The same three places give the same length, wherever on the path they were found.
    void threePlacesOfAPatientGiveThePatientsLength()
    {
        for (const BuiltinPatient which : {BuiltinPatient::Adult, BuiltinPatient::TwelveYears}) {
            const AirwayLandmarks airway = airwayOf(parametersOf(which));
            const auto length =
                teethToCarina(airway.p_A_incisors, airway.p_A_glottis, airway.p_A_carina);
            QVERIFY(length && std::abs(length->si - teethToCarina(airway).si) < kExact);
        }
    }

    void airwayMadeLargerIsLongerByThatShare()
    {
        const AirwayLandmarks airway = airwayOf(parametersOf(BuiltinPatient::Adult));
        const auto larger = teethToCarina(1.1 * airway.p_A_incisors, 1.1 * airway.p_A_glottis,
                                          1.1 * airway.p_A_carina);
        QVERIFY(larger && std::abs(larger->si / teethToCarina(airway).si - 1.1) < 1e-4);
    }

    void placesTooNearHaveNoLength()
    {
        QVERIFY(!teethToCarina({0.0, 0.0, 0.139}, {0.0, 0.0, 0.12}, Vec3::Zero()));
        QVERIFY(!teethToCarina({0.0, -0.1, 0.15}, {0.0, 0.0, 0.019}, Vec3::Zero()));
        QVERIFY(teethToCarina({0.0, -0.1, 0.15}, {0.0, 0.0, 0.021}, Vec3::Zero()));
    }

    void distanceIsToTheNearestPieceOfALine()
    {
        const std::array line{Vec3{0.0, 0.0, 0.0}, Vec3{0.0, 0.0, 0.1}, Vec3{0.1, 0.0, 0.1}};
        const auto from = [&](const Vec3& p) { return distanceFrom(line, p).si; };
        QVERIFY(std::abs(from({0.0, 0.03, 0.05}) - 0.03) < kExact); // a piece
        QVERIFY(std::abs(from({0.0, 0.0, -0.02}) - 0.02) < kExact); // the end
        QVERIFY(std::abs(from({-0.01, 0.0, 0.11}) - 0.01 * std::numbers::sqrt2) < kExact); // corner
        QVERIFY(std::abs(from({0.05, 0.0, 0.1})) < kExact);                                // on it
        QVERIFY(std::abs(distanceFrom(std::span{line}.first(1), {0.3, 0.0, 0.4}).si - 0.5)
                < kExact);
    }
};

CARINA_TEST(TestAirwayMeasure)

} // namespace carina::airway_measure_test

#include "tst_airway_measure.moc"
