#include "models/intubation/ways_in_patient.h"

#include "engine/airway/monitor/drawn_ways.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "models/patient/laryngoscopy.h"
#include "models/patient/patient_source.h"
#include "tests/support/test_class.h"

namespace carina::ways_in_patient_test
{
namespace
{

constexpr double kOfPlane_deg = 3.0;
constexpr double kStays_m = 1e-6;
constexpr double kLifted_m = 3e-3; ///< by which a blade lifts the glottis, at least

const PatientModel& child()
{
    static const SharedPatientModel made =
        patientOf(builtinPatient(BuiltinPatient::TwelveYears).value()).value();
    return *made;
}

} // namespace

class TestWaysInPatient : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// They are where the drawn glottis is: its line, from the notch to its middle, lies in their
    /// plane, though what is above them is moved by centimetres and what is below not at all.
    void turnsThePlaneOfTheCordsNoMoreThanTheGlottis()
    {
        const auto laryngoscopy = Laryngoscopy::of(child(), bladeOf(BladeKind::Macintosh3));
        const LaryngoscopyPose pose = laryngoscopy->pose(LaryngoscopyStep::Full, kUsualLift);
        const PatientWays ways = waysOf(child());
        const PatientWays lifted = drawnWays(ways, {}, child().throat(pose.X_AJ), pose.field);
        const auto offPlane = [](const PatientWays& of) {
            const Vec3 glottis = (of.p_A_glottis() - of.p_A_notch).normalized();
            return std::abs(inDegrees(radians(std::asin(glottis.dot(of.up_A())))));
        };
        QVERIFY(offPlane(ways) < kOfPlane_deg);
        QVERIFY(offPlane(lifted) < kOfPlane_deg);
    }

    /// Depths are read there.
    void leavesTheTeethWhereABladeTiltsTheLarynx()
    {
        const auto laryngoscopy = Laryngoscopy::of(child(), bladeOf(BladeKind::Macintosh3));
        QVERIFY(laryngoscopy);
        const LaryngoscopyPose pose = laryngoscopy->pose(LaryngoscopyStep::Full, kUsualLift);
        const FollowingThroat throat = child().throat(pose.X_AJ);
        const PatientWays ways = waysOf(child());
        const PatientWays before = drawnWays(ways, {}, throat, {});
        const PatientWays lifted = drawnWays(ways, {}, throat, pose.field);
        QVERIFY((lifted.p_A_incisors() - before.p_A_incisors()).norm() < kStays_m);
        QVERIFY((lifted.p_A_glottis() - before.p_A_glottis()).norm() > kLifted_m);
        QVERIFY((lifted.p_A_carina() - before.p_A_carina()).norm() < kStays_m);
    }
};

CARINA_TEST(TestWaysInPatient)

} // namespace carina::ways_in_patient_test

#include "tst_ways_in_patient.moc"
