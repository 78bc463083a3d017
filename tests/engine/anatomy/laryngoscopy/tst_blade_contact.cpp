#include "engine/anatomy/laryngoscopy/blade_levering.h"
#include "engine/anatomy/laryngoscopy/laryngoscopy_path.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::blade_contact_test
{
namespace
{

constexpr double kLength_m = 1e-6;
constexpr double kForce_N = 1e-3;
/// Hastings et al. 1996, of the mean; and what a man of another size than the reference may have.
constexpr double kLiftForce_N = 40.0;
constexpr double kLiftTolerance_N = 6.0;

const Blade& macintosh() { return bladeOf(BladeKind::Macintosh3); }

/// The adult, with the mouth shut in the surfaces.
struct Person {
    UpperAirway airway;
    ThroatField throat;
};

const Person& adult()
{
    static const Person made = [] {
        const Anatomy anatomy =
            patientFor(parametersOf(BuiltinPatient::Adult), Posture::Rest).value();
        const AirwayLandmarks& l = anatomy.landmarks;
        return Person{upperAirwayOf(anatomy.parts, l).value(),
                      {l.p_A_carina, l.p_A_glottis, l.p_A_incisors}};
    }();
    return made;
}

/// A blade somewhere, and the places after they have followed the jaw that is held there.
struct Held {
    const Blade& blade;
    RigidTransform X_AL;
    UpperAirway moved;

    [[nodiscard]] BladeContact contact() const { return bladeContact(moved, blade, X_AL); }
    [[nodiscard]] Vec3 tip() const { return X_AL * middleOfBlade(blade.form, 1.0); }
    /// Moved along x or y of L.
    [[nodiscard]] Held shifted(const Vec3& d_L) const
    {
        return {blade, X_AL * RigidTransform::translation(d_L), moved};
    }
    [[nodiscard]] Held alongHandle(double mm) const { return shifted(1e-3 * mm * Vec3::UnitY()); }
    [[nodiscard]] Held leveredBy(double deg) const
    {
        return {blade, levered(blade.form, X_AL, moved.p_A_incisors, degrees(deg)), moved};
    }
};

Held heldIn(LaryngoscopyStep step, Length lift, const Blade& blade = macintosh())
{
    const Person& person = adult();
    const LaryngoscopyPose pose = laryngoscopyPose(person.airway, person.throat, blade, step, lift);
    return {blade, pose.X_AL, followed(person.airway, {person.throat, pose.X_AJ})};
}

/// In the vallecula, and not lifted.
Held placed() { return heldIn(LaryngoscopyStep::Full, {}); }

BladeEffort taken(LeveringWatch& watch, const Held& held)
{
    return watch.take(held.moved, held.blade, held.X_AL);
}

/// Tipped back to an angle, as it comes about.
BladeEffort leveredTo(LeveringWatch& watch, double deg)
{
    constexpr int kSteps = 200;
    BladeEffort effort;
    for (int i = 0; i <= kSteps; ++i)
        effort = taken(watch, placed().leveredBy(deg * i / kSteps));
    return effort;
}

} // namespace

class TestBladeContact : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasSpringsInNewtonsUpToALimit()
    {
        QVERIFY(std::abs(inNewtons(springForce(1000.0, millimetres(10.0))) - 10.0) < kForce_N);
        QCOMPARE(springForce(1000.0, millimetres(-10.0)), newtons(0.0));
        QCOMPARE(springForce(1000.0, metres(1.0)), kMostForce);
    }

    void touchesNothingOnItsWayIn()
    {
        for (const LaryngoscopyStep step :
             {LaryngoscopyStep::Teeth, LaryngoscopyStep::Uvula, LaryngoscopyStep::Epiglottis}) {
            const BladeContact contact = heldIn(step, kUsualLift).contact();
            QVERIFY2(contact.tongueDepth.si < kLength_m, stepName(step));
            QVERIFY(!contact.isOnEpiglottis);
        }
    }

    /// By the published force, and by 0.7 of it where it is lifted by 0.7.
    void liftsByThePublishedForceAndLeavesTheTeethFree()
    {
        LeveringWatch watch;
        for (const LaryngoscopyStep step : kLaryngoscopySteps)
            taken(watch, heldIn(step, kUsualLift));
        const BladeEffort full = taken(watch, heldIn(LaryngoscopyStep::Full, kUsualLift));
        const double full_N = inNewtons(full.contact.tongue);
        QVERIFY2(std::abs(full_N - kLiftForce_N) < kLiftTolerance_N,
                 qPrintable(QString::number(full_N)));
        const Held partial = heldIn(LaryngoscopyStep::Partial, kUsualLift);
        const double share = partial.contact().tongueDepth / full.contact.tongueDepth;
        QVERIFY(std::abs(share - 0.7) < 0.01);
        QVERIFY(full.contact.teethClearance.has_value());
        QVERIFY(std::abs(full.contact.teethClearance->si - kTeethClearance.si) < 1e-5);
        QVERIFY(full.handling == BladeHandling::Lifting);
        QVERIFY(!full.isOnTeeth);
        QCOMPARE(full.teeth, newtons(0.0));
        QCOMPARE(full.leveringShare, 0.0);
    }

    /// The teeth are left by as much as the blade is lifted.
    void liftsAlongTheHandleAwayFromTheTeeth()
    {
        LeveringWatch watch;
        const Held start = placed();
        double last_N = 0.0;
        for (int mm = 0; mm <= 20; ++mm) {
            const BladeEffort effort = taken(watch, start.alongHandle(mm));
            QVERIFY(std::abs(effort.contact.tongueDepth.si - 1e-3 * mm) < kLength_m);
            QVERIFY(std::abs(inMillimetres(*effort.contact.teethClearance)
                             - inMillimetres(kTeethClearance) - mm)
                    < 0.01);
            QVERIFY(inNewtons(effort.contact.tongue) >= last_N);
            QCOMPARE(effort.teeth, newtons(0.0));
            QCOMPARE(effort.leveringShare, 0.0);
            if (mm != 3) // that is the threshold
                QVERIFY(effort.handling
                        == (mm < 3 ? BladeHandling::Neither : BladeHandling::Lifting));
            last_N = inNewtons(effort.contact.tongue);
        }
    }

    /// Turned about its tip it meets them where the way that is free is the angle times the length
    /// of blade between them.
    void comesToTheTeethAtTheAngleOfGeometry()
    {
        constexpr double kStep_deg = 0.1;
        const Held start = placed();
        const RigidTransform X_LA = start.X_AL.inverse();
        const double arm = (X_LA * start.moved.p_A_incisors).z() + macintosh().form.reach;
        const double expected_deg = inDegrees(radians(kTeethClearance.si / arm));
        LeveringWatch watch;
        double met_deg = 0.0;
        while (met_deg < 20.0 && !taken(watch, start.leveredBy(met_deg)).isOnTeeth)
            met_deg += kStep_deg;
        QVERIFY2(std::abs(met_deg - expected_deg) < 0.2 * expected_deg,
                 qPrintable(QStringLiteral("%1, not %2").arg(met_deg).arg(expected_deg)));
        QVERIFY((start.leveredBy(met_deg).tip() - start.tip()).norm() < kLength_m);
    }

    void leversOnTheTeethWhenItIsTurnedAboutThem()
    {
        LeveringWatch watch;
        const BladeEffort effort = leveredTo(watch, 20.0);
        QVERIFY(effort.handling == BladeHandling::Levering);
        QVERIFY(effort.isOnTeeth);
        QVERIFY(effort.leveringShare > 0.95);
        QVERIFY(std::abs(effort.contact.teethClearance->si) < 1e-5);
        QVERIFY(effort.teeth <= effort.contact.tongue);
        QVERIFY(inNewtons(effort.teeth) > 0.7 * inNewtons(effort.contact.tongue));
    }

    /// The same edge, once as it was made and once as events have moved it there.
    void leversOnTheTeethWhereEventsHaveThem()
    {
        const Vec3 d_A{0.0, -6e-3, -4e-3};
        LeveringWatch watch;
        LeveringWatch watchOfMoved;
        for (int deg = 0; deg <= 20; ++deg) {
            const Held made = placed().leveredBy(deg);
            Held moved = made;
            moved.moved.p_A_incisors -= d_A;
            moved.moved.d_A_incisors = d_A;
            const BladeEffort effort = taken(watch, made);
            const BladeEffort same = taken(watchOfMoved, moved);
            QCOMPARE(same.isOnTeeth, effort.isOnTeeth);
            QVERIFY(std::abs(same.leveringShare - effort.leveringShare) < 1e-9);
        }
    }

    void pressesTheTeethMoreTheFartherItIsTurned()
    {
        LeveringWatch watch;
        Force tongue{};
        Force teeth{};
        for (int deg = 0; deg <= 20; ++deg) {
            const BladeEffort effort = leveredTo(watch, deg);
            watch.reset();
            QVERIFY(effort.contact.tongue >= tongue - newtons(kForce_N));
            QVERIFY(effort.teeth >= teeth);
            tongue = effort.contact.tongue;
            teeth = effort.teeth;
        }
        QVERIFY(inNewtons(teeth) > 10.0);
    }

    /// Half a millimetre of noise ends nothing; a clear gap does.
    void leavesTheTeethByMoreThanNoise()
    {
        LeveringWatch watch;
        const double pressed_N = inNewtons(leveredTo(watch, 15.0).teeth);
        const Held held = placed().leveredBy(15.0);
        const BladeEffort noisy = taken(watch, held.alongHandle(0.5));
        QVERIFY(noisy.handling == BladeHandling::Levering);
        QVERIFY(inNewtons(noisy.teeth) > 0.0 && inNewtons(noisy.teeth) < pressed_N);
        const BladeEffort off = taken(watch, held.alongHandle(1.5));
        QVERIFY(off.handling == BladeHandling::Lifting);
        QVERIFY(!off.isOnTeeth);
        QCOMPARE(off.teeth, newtons(0.0));
    }

    /// The mean of the largest forces on patients' incisors at 5 mm (Bucx et al. 1994).
    void pressesTeethThatWouldBeInsideIt()
    {
        const Held deep = placed().alongHandle(-inMillimetres(kTeethClearance) - 5.0);
        LeveringWatch watch;
        const BladeEffort effort = taken(watch, deep);
        QVERIFY(std::abs(inMillimetres(*effort.contact.teethClearance) + 5.0) < 0.01);
        QVERIFY(std::abs(inNewtons(effort.teeth) - 49.0) < 0.1);
        QVERIFY(effort.handling != BladeHandling::Levering);
    }

    void isNotAtTheTeethBesideThem()
    {
        QVERIFY(!placed().shifted(0.03 * Vec3::UnitX()).contact().teethClearance);
        QVERIFY(placed().shifted(0.01 * Vec3::UnitX()).contact().teethClearance.has_value());
    }

    void liftsTheEpiglottisWithAStraightBladeOnly()
    {
        const BladeContact straight =
            heldIn(LaryngoscopyStep::Full, kUsualLift, bladeOf(BladeKind::Miller2)).contact();
        QVERIFY(straight.isOnEpiglottis);
        QVERIFY(straight.epiglottis > newtons(0.0));
        QCOMPARE(straight.epiglottis, straight.tongue);
        const BladeContact curved = heldIn(LaryngoscopyStep::Full, kUsualLift).contact();
        QVERIFY(!curved.isOnEpiglottis);
        QCOMPARE(curved.epiglottis, newtons(0.0));
    }

    void tellsWhereTheTipOfACurvedBladeIsOnTheEpiglottis()
    {
        Held held = placed();
        const Vec3 p_A_middle =
            0.5 * (held.moved.p_A_epiglottisBase + held.moved.p_A_epiglottisTip);
        held.X_AL = RigidTransform::translation(p_A_middle - held.tip()) * held.X_AL;
        QVERIFY(held.contact().isOnEpiglottis);
        held.X_AL = RigidTransform::translation(-0.02 * held.moved.forward_A()) * held.X_AL;
        QVERIFY(!held.contact().isOnEpiglottis);
    }
};

CARINA_TEST(TestBladeContact)

} // namespace carina::blade_contact_test

#include "tst_blade_contact.moc"
