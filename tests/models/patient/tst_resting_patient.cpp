#include "models/patient/resting_patient.h"

#include "engine/anatomy/patient/builtin_patient.h"
#include "models/patient/laryngoscopy.h"
#include "tests/support/test_class.h"

#include <QEventLoop>
#include <QTemporaryDir>

namespace carina::resting_patient_test
{
namespace
{

/// How much farther back an epiglottis lies that no blade lifts, metres.
constexpr double kFallenBack = 0.01;

const PatientModel& child()
{
    static const SharedPatientModel made =
        patientOf(builtinPatient(BuiltinPatient::TwelveYears).value()).value();
    return *made;
}

const QTemporaryDir& cache()
{
    static const QTemporaryDir folder;
    return folder;
}

Result<SharedPatientModel> childAtRest()
{
    return restingPatient(child().contentHash(), cache().path().toStdString());
}

UpperAirway airwayOf(const PatientModel& patient)
{
    return Laryngoscopy::of(patient, bladeOf(kUsualBlade)).value().script().airway;
}

} // namespace

class TestRestingPatient : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The same bones, and a larynx that is not held: y is to the patient's back.
    void liesAsNoBladeHoldsIt()
    {
        const auto made = childAtRest();
        QVERIFY(made.has_value());
        const PatientModel& resting = **made;
        QCOMPARE(resting.landmarks().p_A_incisors, child().landmarks().p_A_incisors);
        QCOMPARE(resting.landmarks().p_A_carina, child().landmarks().p_A_carina);
        const double held = airwayOf(child()).p_A_epiglottisTip.y();
        QVERIFY(airwayOf(resting).p_A_epiglottisTip.y() > held + kFallenBack);
    }

    /// A jaw probe tells how far the mouth is from being shut: these surfaces are.
    void hasItsMouthShut()
    {
        const auto made = childAtRest().value();
        const RigidTransform X_AJ{Quat{Eigen::AngleAxisd{0.2, Vec3::UnitX()}}, Vec3::Zero()};
        QVERIFY(made->throat(X_AJ).X_AJ.translation().isZero(0.0));
        QVERIFY(made->throat(X_AJ).X_AJ.rotation().isApprox(X_AJ.rotation(), 0.0));
        QVERIFY(!child().throat(X_AJ).X_AJ.rotation().isApprox(X_AJ.rotation(), 1e-3));
    }

    void isNotMadeTwice()
    {
        const auto first = childAtRest();
        const auto kept = childAtRest();
        QVERIFY(first && kept);
        QCOMPARE((*first)->contentHash(), (*kept)->contentHash());
        QVERIFY((*first)->contentHash() != child().contentHash());
        QCOMPARE(airwayOf(**first).p_A_epiglottisTip, airwayOf(**kept).p_A_epiglottisTip);
    }

    void isMadeBesideThisThread()
    {
        RestingPatient resting;
        QVERIFY(resting.of(child()) == nullptr);
        QEventLoop until;
        connect(&resting, &RestingPatient::made, &until, &QEventLoop::quit);
        until.exec();
        const PatientModel* made = resting.of(child());
        QVERIFY(made != nullptr && made != &child());
        QCOMPARE(resting.of(child()), made);
    }

    void isThePatientWhereNoneIsMade()
    {
        Anatomy set = builtinPatient(BuiltinPatient::TwelveYears).value();
        set.contentHash = "of a set";
        const SharedPatientModel imported = patientOf(std::move(set)).value();
        RestingPatient resting;
        QCOMPARE(resting.of(*imported), imported.get());
    }
};

CARINA_TEST(TestRestingPatient)

} // namespace carina::resting_patient_test

#include "tst_resting_patient.moc"
