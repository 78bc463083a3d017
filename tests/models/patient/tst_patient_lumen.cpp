#include "engine/airway/lumen/measured_lumen.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "models/patient/patient_lumen.h"
#include "models/patient/patient_source.h"
#include "tests/support/test_class.h"

#include <QEventLoop>

namespace carina::patient_lumen_test
{
namespace
{

const Anatomy& anatomy()
{
    static const Anatomy made = builtinPatient(BuiltinPatient::TwelveYears).value();
    return made;
}

const PatientModel& child()
{
    static const SharedPatientModel made = patientOf(anatomy()).value();
    return *made;
}

void measure(const PatientLumen& lumen)
{
    QEventLoop until;
    QObject::connect(&lumen, &PatientLumen::measured, &until, &QEventLoop::quit);
    until.exec();
}

} // namespace

class TestPatientLumen : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// As the engine measures it at once; not again for the same tube.
    void measuresBesideThisThread()
    {
        PatientLumen lumen;
        QVERIFY(!lumen.lumen());
        lumen.want(child());
        QVERIFY(!lumen.lumen());
        measure(lumen);
        QVERIFY(lumen.lumen() != nullptr);
        const auto there = lumen.lumen();
        const Length radius = 0.5 * child().tube().outerDiameter;
        const auto atOnce = measuredLumen(anatomy().parts, anatomy().landmarks, radius);
        QVERIFY(atOnce.has_value());
        QCOMPARE(there->tubeRadius, radius);
        QCOMPARE(there->glottis, atOnce->glottis);
        const auto& one = there->way(AirwayWay::Trunk);
        const auto& other = atOnce->way(AirwayWay::Trunk);
        QCOMPARE(one.size(), other.size());
        for (std::size_t i = 0; i < one.size(); ++i)
            QCOMPARE(one[i].p_A_centre, other[i].p_A_centre);
        lumen.want(child());
        QCOMPARE(lumen.lumen(), there);
    }

    void leavesThatOfAnotherTube()
    {
        PatientLumen lumen;
        lumen.want(child());
        const Length thick = millimetres(11.0);
        lumen.want(child().withTube(child().tube().p_E_centre, thick));
        measure(lumen);
        QVERIFY(lumen.lumen() != nullptr);
        QCOMPARE(lumen.lumen()->tubeRadius, 0.5 * thick);
    }
};

CARINA_TEST(TestPatientLumen)

} // namespace carina::patient_lumen_test

#include "tst_patient_lumen.moc"
