#include "models/intubation/sent_shape.h"

#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/geometry/rotation.h"
#include "models/patient/patient_source.h"
#include "tests/support/test_class.h"

namespace carina::sent_shape_test
{
namespace
{

constexpr double kExact_m = 1e-4;

const TubeShape& ownTube()
{
    static const SharedPatientModel patient =
        patientOf(builtinPatient(BuiltinPatient::TwelveYears).value()).value();
    return patient->ownTube();
}

/// At rest, so far behind its connector.
std::vector<Vec3> heldBack(double metres)
{
    std::vector<Vec3> p_E = lineAtRest({}, ownTube());
    const Vec3 back = -metres * (p_E[1] - p_E[0]).normalized();
    for (Vec3& p : p_E)
        p += back;
    return p_E;
}

} // namespace

class TestSentShape : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// A tube that is held up lies behind the hand that pushes it, in the same curve.
    void tellsHowFarATubeIsHeldBack_data()
    {
        QTest::addColumn<double>("back_m");
        QTest::newRow("not") << 0.0;
        QTest::newRow("2 cm") << 0.02;
    }

    void tellsHowFarATubeIsHeldBack()
    {
        QFETCH(double, back_m);
        const std::vector<Vec3> p_E = heldBack(back_m);
        const StreamShape sent = toStream({}, ownTube(), p_E, SessionTime{});
        QVERIFY(std::abs(sent.heldBack - back_m) < 1e-9);
        const std::vector<Vec3> told = lineOf(sent, ownTube());
        QCOMPARE(told.size(), p_E.size());
        for (std::size_t i = 0; i < told.size(); ++i)
            QVERIFY((told[i] - p_E[i]).norm() < kExact_m);
    }
};

CARINA_TEST(TestSentShape)

} // namespace carina::sent_shape_test

#include "tst_sent_shape.moc"
