#include "engine/anatomy/patient/patient_build.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::patient_build_test
{
namespace
{

PatientBuild adult(double weight_kg) { return {metres(1.75), weight_kg, 30.0, Sex::Male}; }

bool isAbout(double is, double ought) { return std::abs(is - ought) < 1e-3 * ought; }

} // namespace

/// Volumes of the lungs by height and weight.
class TestPatientBuild : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// 16, 30 and 80 ml/kg of 77 kg (Pulse RespiratoryMethodology).
    void adultHasPulsesVolumes()
    {
        const LungVolumes volumes = lungVolumesOf(adult(77.0));
        QVERIFY(isAbout(inMillilitres(volumes.residual), 1232.0));
        QVERIFY(isAbout(inMillilitres(volumes.functionalResidual), 2310.0));
        QVERIFY(isAbout(inMillilitres(volumes.totalCapacity), 6160.0));
    }

    void slimHasTheLungsOfTheUsualWeight()
    {
        QVERIFY(isAbout(lungWeight(adult(55.0)), usualWeight(adult(55.0))));
        QVERIFY(isAbout(usualWeight(adult(55.0)), 77.0));
        QVERIFY(isAbout(inMillilitres(lungVolumesOf(adult(55.0)).functionalResidual), 2310.0));
    }

    /// 11 ml/kg at 127 kg (Benumof), of 79.6 kg without fat; the reserve alone falls.
    void fatTakesTheReserve()
    {
        const LungVolumes volumes = lungVolumesOf(adult(127.0));
        QVERIFY(isAbout(lungWeight(adult(127.0)), 26.0 * 1.75 * 1.75));
        QVERIFY(std::abs(inMillilitres(volumes.functionalResidual) / 127.0 - 11.0) < 0.05);
        QVERIFY(isAbout(inMillilitres(volumes.residual), 16.0 * 26.0 * 1.75 * 1.75));
        QVERIFY(isAbout(inMillilitres(volumes.totalCapacity), 80.0 * 26.0 * 1.75 * 1.75));
    }

    void lungsGrowUpToABodyMassIndexOf26()
    {
        QVERIFY(isAbout(lungWeight(adult(78.5)), 78.5));
        const double half = usualWeight({metres(0.5 * 1.75), 20.0, 30.0, Sex::Male});
        QVERIFY(isAbout(half, 0.25 * 77.0));
    }
};

CARINA_TEST(TestPatientBuild)

} // namespace carina::patient_build_test

#include "tst_patient_build.moc"
