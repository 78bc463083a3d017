#include "models/station/flown_endoscope.h"

#include "engine/airway/monitor/drawn_ways.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "models/intubation/ways_in_patient.h"
#include "models/patient/laryngoscopy.h"
#include "models/patient/patient_source.h"
#include "tests/models/lacking_patient.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::flown_endoscope_test
{
namespace
{

constexpr Length kEachWay = millimetres(2.0);
constexpr Length kAhead = millimetres(12.0); ///< of the way, that the camera is turned to

const PatientModel& patientBy(BuiltinPatient who)
{
    static const SharedPatientModel adult =
        patientOf(builtinPatient(BuiltinPatient::Adult).value()).value();
    static const SharedPatientModel child =
        patientOf(builtinPatient(BuiltinPatient::TwelveYears).value()).value();
    return who == BuiltinPatient::Adult ? *adult : *child;
}

/// A patient whose airway is changed by events, and whose head lies so, with an endoscope in front
/// of the mouth.
struct Flight {
    explicit Flight(const PatientModel& who, const AirwayEvents& events = {},
                    const HeadPosition& position = {})
        : patient{who}
    {
        lie(events, position);
    }
    void lie(const AirwayEvents& events, const HeadPosition& position = {})
    {
        Laryngoscopy laryngoscopy = Laryngoscopy::of(patient, bladeOf(kUsualBlade)).value();
        laryngoscopy.changeAirway(events);
        throat = patient.throat(std::nullopt, position, events);
        ways = drawnWays(made, laryngoscopy.changes(), throat, {});
        scope.follow(patient, laryngoscopy.changes(), throat, {});
    }
    [[nodiscard]] Centreline toCarina() const
    {
        Centreline line = ways.overTongue;
        line.insert(line.end(), ways.trachea.begin() + 1, ways.trachea.end());
        return line;
    }
    [[nodiscard]] Vec3 p_A() const { return scope.pose()->translation(); }
    /// As a person who sees where the way leads: turns to it, goes on, until the end is near or it
    /// comes no farther.
    void along(const Centreline& line)
    {
        constexpr int kMostMoves = 400;
        for (int i = 0; i < kMostMoves; ++i) {
            const Length at = nearestOnWay(line, p_A()).along;
            if (at > lengthOf(line) - kAhead)
                return;
            const Vec3 seen = scope.pose()->inverse() * pointAlong(line, at + kAhead);
            scope.turn(radians(std::atan2(seen.x(), -seen.z())),
                       radians(std::atan2(seen.y(), std::hypot(seen.x(), seen.z()))));
            scope.advance(kEachWay);
        }
    }
    [[nodiscard]] Length pastTeeth() { return scope.place()->pastTeeth; }
    /// Along the way, from the cords; below 0 above them.
    [[nodiscard]] Length pastGlottis() { return pastTeeth() - lengthOf(ways.overTongue); }

    const PatientModel& patient;
    PatientWays made = waysOf(patient);
    PatientWays ways = made;
    FollowingThroat throat;
    FlownEndoscope scope;
};

} // namespace

class TestFlownEndoscope : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void beginsInFrontOfTheMouthLookingIn();
    void reachesTheCarina_data();
    void reachesTheCarina();
    void isStoppedByShutCords();
    void comesBackInFrontOfTheMouth();
    void isNotFlownWithoutAnAirway();
    void tellsHowDeepItIs();
};

void TestFlownEndoscope::beginsInFrontOfTheMouthLookingIn()
{
    Flight flight{patientBy(BuiltinPatient::Adult)};
    QVERIFY(std::abs(inMillimetres(flight.pastTeeth()) + 30.0) < 3.0);
    const Quat& turned = flight.scope.pose()->rotation();
    QVERIFY((turned * Vec3{0.0, 0.0, -1.0}).dot(flight.ways.inward_A()) > 0.999);
    QVERIFY((turned * Vec3::UnitX()).x() < -0.99); // the patient's right is to the right
    QVERIFY(!flight.scope.place()->isAtWall);
}

void TestFlownEndoscope::reachesTheCarina_data()
{
    QTest::addColumn<BuiltinPatient>("who");
    QTest::newRow("adult") << BuiltinPatient::Adult;
    QTest::newRow("child") << BuiltinPatient::TwelveYears;
}

void TestFlownEndoscope::reachesTheCarina()
{
    constexpr double kNear = 0.015; // metres
    QFETCH(const BuiltinPatient, who);
    Flight flight{patientBy(who)};
    flight.along(flight.toCarina());
    QVERIFY((flight.p_A() - flight.ways.p_A_carina()).norm() < kNear);
}

void TestFlownEndoscope::isStoppedByShutCords()
{
    constexpr Length kBelow = millimetres(5.0);
    Flight flight{patientBy(BuiltinPatient::Adult), {{AirwayEventKind::Laryngospasm, 1.0}}};
    flight.along(flight.toCarina());
    QVERIFY(flight.pastGlottis() < kBelow);
    // Once they open, it passes from where it was.
    flight.lie({});
    flight.along(flight.toCarina());
    QVERIFY(flight.pastGlottis() > millimetres(50.0));
}

void TestFlownEndoscope::comesBackInFrontOfTheMouth()
{
    Flight flight{patientBy(BuiltinPatient::Adult)};
    const RigidTransform before = *flight.scope.pose();
    flight.scope.roll(degrees(40.0));
    flight.along(flight.toCarina());
    flight.scope.goBack();
    QVERIFY((flight.scope.pose()->matrix() - before.matrix()).norm() < 1e-9);
}

void TestFlownEndoscope::isNotFlownWithoutAnAirway()
{
    QVERIFY(FlownEndoscope::hasAirway(patientBy(BuiltinPatient::TwelveYears)));
    QVERIFY(!FlownEndoscope::hasAirway(*test::childWithout(PartRole::Trachea)));
    QVERIFY(!FlownEndoscope::hasAirway(*test::landmarksOf("adult")));
    FlownEndoscope scope;
    scope.advance(kEachWay); // nowhere
    QVERIFY(!scope.pose() && !scope.place());
}

void TestFlownEndoscope::tellsHowDeepItIs()
{
    QCOMPARE(endoscopeText({.pastTeeth = millimetres(84.4), .isAtWall = false}),
             QStringLiteral("Camera 84 mm past the teeth"));
    QCOMPARE(endoscopeText({.pastTeeth = millimetres(84.4), .isAtWall = true}),
             QStringLiteral("Camera 84 mm past the teeth · at the wall"));
    QCOMPARE(endoscopeText({.pastTeeth = millimetres(-30.0), .isAtWall = false}),
             QStringLiteral("Camera 30 mm in front of the teeth"));
}

CARINA_TEST(TestFlownEndoscope)

} // namespace carina::flown_endoscope_test

#include "tst_flown_endoscope.moc"
