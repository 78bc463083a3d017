#include "engine/anatomy/airway/airway_measure.h"
#include "engine/geometry/rotation.h"
#include "tests/evaluation/intubation/tube_patient.h"
#include "tests/support/test_class.h"

namespace carina::motion_patient_test
{
namespace
{

constexpr double kMillimetre = 1e-3;
/// A way leaves the others in the middle of a piece of their line, one end of which it leaves out.
constexpr double kCutCorner = 0.05 * kMillimetre;
constexpr double kFromAxis = 2.5 * kMillimetre;

double distanceFromRod(const AirwayRod& rod, const Vec3& p)
{
    const Vec3 axis = (rod.p_W_to - rod.p_W_from).normalized();
    const Vec3 from = p - rod.p_W_from;
    return (from - from.dot(axis) * axis).norm();
}

} // namespace

class TestMotionPatient : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void leadsIntoTheMiddleOfEachMainBronchus()
    {
        const PatientDimensions boy = dimensionsOf(BuiltinPatient::TwelveYears);
        const auto patient = test::boyOfTubes();
        for (const Side side : {Side::Right, Side::Left}) {
            const TipWay& way =
                patient->way(side == Side::Right ? TipTarget::RightMain : TipTarget::LeftMain);
            const AirwayRod own = test::mainBronchusOf(boy, side);
            const AirwayRod other =
                test::mainBronchusOf(boy, side == Side::Right ? Side::Left : Side::Right);
            for (double beyond = 10.0; beyond <= 25.0; beyond += 5.0) {
                const Vec3 p = pointAlong(way.line_A, metres(way.carina + beyond * kMillimetre));
                QVERIFY2(distanceFromRod(own, p) < kFromAxis,
                         qPrintable(QString::number(distanceFromRod(own, p))));
                QVERIFY(distanceFromRod(other, p) > distanceFromRod(own, p));
            }
            // The level of the carina, which is the origin.
            const Vec3 up = windpipeInAnatomy().rotation() * Vec3::UnitZ();
            const double level = up.dot(pointAlong(way.line_A, metres(way.carina)));
            QVERIFY(std::abs(level) < 0.5 * kMillimetre);
        }
    }

    void leadsBehindTheLarynxIntoTheOesophagus()
    {
        const auto patient = test::boyOfTubes();
        const TipWay& way = patient->way(TipTarget::Oesophagus);
        const Vec3 atCords = pointAlong(way.line_A, metres(way.gate));
        const Vec3 up = patient->upper.up_A;
        QVERIFY(std::abs(up.dot(atCords - patient->airway.p_A_glottis)) < 0.5 * kMillimetre);
        QVERIFY(patient->upper.forward_A().dot(atCords - patient->upper.p_A_notch) < 0.0);
        // Below the top of the tube it is in its middle.
        const RigidTransform X_WA = windpipeInAnatomy().inverse();
        for (double along = way.gate + 0.06; along < way.gate + 0.12; along += 0.01) {
            const Vec3 p_W = X_WA * pointAlong(way.line_A, metres(along));
            QVERIFY(std::abs(p_W.x()) < kFromAxis);
            QVERIFY(std::abs(p_W.y() - test::kBehindTrachea) < kFromAxis);
        }
    }

    void hasOneBeginningForAllWays()
    {
        const auto patient = test::boyOfTubes();
        const TipWay& trachea = patient->way(TipTarget::Trachea);
        QVERIFY(std::abs(trachea.teeth - kPathInFrontOfTeethAsKnown) < kMillimetre);
        for (const TipTarget target : kTipTargets) {
            const TipWay& way = patient->way(target);
            QCOMPARE(way.teeth, trachea.teeth);
            for (double along = 0.0; along < trachea.fork; along += 0.003)
                QVERIFY((pointAlong(way.line_A, metres(along))
                         - pointAlong(trachea.line_A, metres(along)))
                            .norm()
                        < kCutCorner);
        }
        QVERIFY(std::abs(trachea.carina - trachea.teeth - teethToCarina(patient->airway).si)
                < 1e-9);
        const Vec3 p_A_end = patient->way(TipTarget::Arytenoid).line_A.back();
        QVERIFY(p_A_end.x() < 0.0); // the patient's right
        QVERIFY((p_A_end - patient->upper.p_A_notch).norm() < 6.0 * kMillimetre);
    }

    void followsNeckAndJaw()
    {
        const auto patient = test::boyOfTubes();
        const TipWay& way = patient->way(TipTarget::Trachea);
        const HeldTissue still{patient->held, {}};
        for (double along = 0.0; along < way.end; along += 0.01)
            QVERIFY(
                (placeOnWay(*patient, way, along, still) - pointAlong(way.line_A, metres(along)))
                    .norm()
                < 1e-12);
        const HeldTissue open{{rotationFromVector(0.3 * Vec3::UnitX()), {0.0, -0.01, -0.02}}, {}};
        QVERIFY(
            (placeOnWay(*patient, way, way.teeth, open) - pointAlong(way.line_A, metres(way.teeth)))
                .norm()
            < 1e-12);
        QVERIFY((placeOnWay(*patient, way, way.carina, open)
                 - pointAlong(way.line_A, metres(way.carina)))
                    .norm()
                < 1e-9); // S is 0 there
        const NeckField bent{
            patient->airway.p_A_glottis, patient->airway.p_A_incisors, {degrees(30.0), {}}};
        QVERIFY((placeOnWay(*patient, way, way.teeth, {patient->held, bent})
                 - bent.placed(pointAlong(way.line_A, metres(way.teeth))))
                    .norm()
                < 1e-12);
        const double whole = lengthOfWay(*patient, way, way.teeth, way.carina, still).si;
        QVERIFY(std::abs(whole - teethToCarina(patient->airway).si) < 0.2 * kMillimetre);
        QCOMPARE(lengthOfWay(*patient, way, way.carina, way.teeth, still).si, -whole);
    }

    void saysWhatIsMissing()
    {
        for (const PartRole role :
             {PartRole::RightMainBronchus, PartRole::Oesophagus, PartRole::Epiglottis}) {
            Anatomy patient = test::tubePatient(dimensionsOf(BuiltinPatient::TwelveYears));
            std::erase_if(patient.parts,
                          [role](const AnatomyPart& part) { return part.role == role; });
            const auto refused = motionPatient(patient, {});
            QVERIFY(!refused);
            QCOMPARE(refused.error().code, Errc::NoAirway);
        }
    }

private:
    static constexpr double kPathInFrontOfTeethAsKnown = 0.1; ///< metres (airway_path.h)
};

CARINA_TEST(TestMotionPatient)

} // namespace carina::motion_patient_test

#include "tst_motion_patient.moc"
