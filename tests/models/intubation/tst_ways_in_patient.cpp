#include "models/intubation/drawn_ways.h"

#include "engine/anatomy/patient/builtin_patient.h"
#include "models/patient/laryngoscopy.h"
#include "models/patient/patient_source.h"
#include "tests/support/test_class.h"

namespace carina::drawn_ways_test
{
namespace
{

constexpr double kStays_m = 1e-6;
constexpr double kLifted_m = 3e-3; ///< by which a blade lifts the glottis, at least

const PatientModel& child()
{
    static const SharedPatientModel made =
        patientOf(builtinPatient(BuiltinPatient::TwelveYears).value()).value();
    return *made;
}

} // namespace

class TestDrawnWays : public QObject
{
    Q_OBJECT

private Q_SLOTS:
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

CARINA_TEST(TestDrawnWays)

} // namespace carina::drawn_ways_test

#include "tst_drawn_ways.moc"
