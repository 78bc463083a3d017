#include "evaluation/intubation/motion_truth.h"

#include "engine/anatomy/airway/airway_measure.h"
#include "evaluation/intubation/motion_script.h"
#include "tests/evaluation/intubation/tube_patient.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <map>

namespace carina::motion_truth_test
{
namespace
{

using namespace std::chrono_literals;

constexpr double kMillimetre = 1e-3;
/// How far a hand's tremor and sway can take a tip from its way: six deviations.
constexpr double kTrembling = 6.0 * kMillimetre;
/// A tube that is pushed in as far as it goes has 10 mm outside, and trembles.
constexpr double kMostOutside = 10.0 * kMillimetre + kTrembling;

IntubationMotion motionOf(MotionKind kind, std::uint32_t seed = 3)
{
    const auto boy = test::boyOfTubes();
    std::mt19937 random = generatorOf(kind, seed);
    const MotionParameters parameters = drawnParameters(kind, random);
    return scriptedMotion(kind, parameters, boy, test::tubeOfBoy(), seed).value();
}

/// The boy's tube without this share of it at the connector.
TubeShape tubeWithout(double share)
{
    TubeShape tube = test::tubeOfBoy();
    const auto first = std::size_t(share * double(tube.p_E_centre.size()));
    tube.p_E_centre.erase(tube.p_E_centre.begin(), tube.p_E_centre.begin() + std::ptrdiff_t(first));
    return tube;
}

Result<IntubationMotion> motionWith(TubeShape tube, MotionKind kind)
{
    std::mt19937 random = generatorOf(kind, 1);
    return scriptedMotion(kind, drawnParameters(kind, random), test::boyOfTubes(), std::move(tube),
                          1);
}

Vec3 tipBySight(const IntubationMotion& motion, Duration t) { return motion.tubeLine(t).back(); }

std::vector<TrueStep> passagesOf(const MotionTruth& truth)
{
    std::vector<TrueStep> steps;
    for (const TrueEvent& event : truth.events)
        if (event.step < TrueStep::CuffInflated)
            steps.push_back(event.step);
    return steps;
}

const TrueEvent& lastOf(const MotionTruth& truth, TrueStep step)
{
    return *std::ranges::find(truth.events.rbegin(), truth.events.rend(), step, &TrueEvent::step);
}

using enum TrueStep;
const std::vector<TrueStep> kOneTry{BladeIn, TubePastTeeth, ThroughCords, BladeOut};
const std::vector<TrueStep> kMainstem{BladeIn, TubePastTeeth, ThroughCords, PastCarina, BladeOut};

} // namespace

class TestMotionTruth : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void endsAsItsNameSays_data()
    {
        QTest::addColumn<MotionKind>("kind");
        QTest::addColumn<TrueSeat>("outcome");
        QTest::addColumn<std::vector<TrueStep>>("passages");
        const auto row = [](const char* name, TrueSeat outcome, std::vector<TrueStep> passages) {
            const auto named = std::ranges::find(kNamedMotions, name, &NamedMotion::name);
            QTest::newRow(name) << named->kind << outcome << std::move(passages);
        };
        row("good", TrueSeat::Trachea, kOneTry);
        row("slow", TrueSeat::Trachea, kOneTry);
        row("oesophageal", TrueSeat::Oesophagus, {BladeIn, TubePastTeeth, InOesophagus, BladeOut});
        row("right_mainstem", TrueSeat::RightMain, kMainstem);
        row("left_mainstem", TrueSeat::LeftMain, kMainstem);
        row("three_attempts", TrueSeat::Trachea,
            {BladeIn, TubePastTeeth, TubeOut, BladeOut, BladeIn, TubePastTeeth, InOesophagus,
             OutOfOesophagus, TubeOut, BladeOut, BladeIn, TubePastTeeth, ThroughCords, BladeOut});
        row("dental_lever", TrueSeat::Trachea, kOneTry);
        row("too_shallow", TrueSeat::Trachea, kOneTry);
        row("neck_flexed", TrueSeat::Trachea, kOneTry);
        row("stuck_at_arytenoid", TrueSeat::Trachea, kOneTry);
        row("cuff_above_cords", TrueSeat::Trachea, kOneTry);
        row("late_recognition", TrueSeat::Trachea,
            {BladeIn, TubePastTeeth, InOesophagus, BladeOut, OutOfOesophagus, TubeOut, BladeIn,
             TubePastTeeth, ThroughCords, BladeOut});
    }
    void endsAsItsNameSays()
    {
        QFETCH(const MotionKind, kind);
        QFETCH(const TrueSeat, outcome);
        QFETCH(const std::vector<TrueStep>, passages);
        for (const std::uint32_t seed : {1U, 2U, 3U}) {
            const MotionTruth truth = truthOf(motionOf(kind, seed));
            QCOMPARE(truth.outcome, outcome);
            QCOMPARE(passagesOf(truth), passages);
            QCOMPARE(truth.attempts, int(std::ranges::count(passages, BladeIn)));
            QCOMPARE(truth.tipAboveCarina.has_value(), outcome != TrueSeat::Oesophagus);
        }
    }

    /// By the line of the tube alone, which begins at its connector.
    void hasTheTipWhereTheTruthSays()
    {
        for (const NamedMotion& named : kNamedMotions) {
            const IntubationMotion motion = motionOf(named.kind);
            for (Duration t{}; t < motion.length(); t += 217ms) {
                if (motion.headAt(t).flexion.si > 0.0)
                    break; // the tube bends with the neck from then on
                const TrueTip tip = motion.tipAt(t);
                QVERIFY((tipBySight(motion, t) - tip.p_A).norm() < 1e-9);
                const MotionMoment moment = motion.at(t);
                QVERIFY(
                    (motion.tubeLine(t).front() - moment.X_AE * motion.tube().p_E_centre[0]).norm()
                    < 1e-9);
                const TipWay& way = motion.patient().way(tip.target);
                QVERIFY((placeOnWay(motion.patient(), way, tip.along, {moment.X_AJ, {}}) - tip.p_A)
                            .norm()
                        < kTrembling);
            }
        }
    }

    /// In the patient as the surfaces are: cords and carina are where they are there, within what
    /// the jaw moves (the cords by at most a centimetre) and the tremor.
    void timesThePassagesByTheTip()
    {
        const IntubationMotion motion = motionOf(MotionKind::RightMainstem);
        const MotionTruth truth = truthOf(motion);
        const AirwayLandmarks& airway = motion.patient().airway;
        const Vec3 up = motion.patient().upper.up_A;
        const auto heightOver = [&](const Vec3& p_A, TrueStep step) {
            return up.dot(tipBySight(motion, lastOf(truth, step).at) - p_A);
        };
        QVERIFY(std::abs(heightOver(airway.p_A_glottis, ThroughCords)) < 10.0 * kMillimetre);
        QVERIFY(std::abs(heightOver(airway.p_A_carina, PastCarina)) < kTrembling);
        QVERIFY((tipBySight(motion, lastOf(truth, TubePastTeeth).at) - airway.p_A_incisors).norm()
                < kTrembling);
        QCOMPARE(lastOf(truth, ThroughCords).seat, TrueSeat::Trachea);
        QCOMPARE(lastOf(truth, PastCarina).seat, TrueSeat::RightMain);
        // Beyond by what was drawn, in proportion to the trachea.
        std::mt19937 random = generatorOf(MotionKind::RightMainstem, 3);
        const double drawn_mm =
            drawnParameters(MotionKind::RightMainstem, random)[MotionParameter::Bronchus_mm];
        const double beyond = drawn_mm * kMillimetre * motion.patient().upper.windpipeSize();
        QVERIFY(std::abs(truth.tipAboveCarina->si + beyond) < kTrembling);
    }

    /// The tube has the airway's form at rest, and is not bent where it ends: what of it is in the
    /// patient is about as long as the way.
    void tellsTheDepthAlongTheTube()
    {
        const IntubationMotion motion = motionOf(MotionKind::Good);
        const MotionTruth truth = truthOf(motion);
        const double way = teethToCarina(motion.patient().airway).si;
        const double depth = truth.depthAtTeeth.si + truth.tipAboveCarina->si;
        QVERIFY2(std::abs(depth - way) < 6.0 * kMillimetre,
                 qPrintable(QString::number(depth - way)));
        QCOMPARE(motion.depthAtTeeth({}).si, 0.0);
    }

    /// Towards the carina, as in people (Weiss et al, Br J Anaesth 2006).
    void bringsTheTipDownWhenTheNeckIsFlexed()
    {
        const IntubationMotion motion = motionOf(MotionKind::NeckFlexed);
        const Duration before = lastOf(truthOf(motion), FirstBreath).at;
        const Duration after = motion.length();
        QCOMPARE(motion.at(before).head.flexion.si, 0.0);
        QVERIFY(motion.at(after).head.flexion > degrees(14.0));
        QVERIFY(motion.tipAboveCarina(after) < motion.tipAboveCarina(before));
        QVERIFY(std::abs((motion.depthAtTeeth(after) - motion.depthAtTeeth(before)).si)
                < kTrembling);
        // The connector goes with the head.
        const NeckField neck{motion.patient().airway.p_A_glottis,
                             motion.patient().airway.p_A_incisors, motion.at(after).head};
        const RigidTransform X_UE_after = neck.X_AU().inverse() * motion.at(after).X_AE;
        QVERIFY((X_UE_after.translation() - motion.at(before).X_AE.translation()).norm()
                < kTrembling);
    }

    /// No movement of a hand is faster than 1 m/s, and none has a step.
    void movesSmoothly()
    {
        constexpr Duration kStep = 1ms;
        constexpr double kFastest = 1.0;           // m/s
        constexpr double kMostAcceleration = 60.0; // m/s^2; a polyline's bends are steps of speed
        for (const MotionKind kind : {MotionKind::ThreeAttempts, MotionKind::DentalLever}) {
            const IntubationMotion motion = motionOf(kind);
            Vec3 before = Vec3::Zero();
            Vec3 speedBefore = Vec3::Zero();
            int samples = 0;
            for (Duration t{}; t < motion.length(); t += kStep, ++samples) {
                const Vec3 blade =
                    motion.laryngoscopeAt(t) * middleOfBlade(motion.blade().form, 1.0);
                const Vec3 speed = (blade - before) / toSeconds(kStep);
                if (samples > 0)
                    QVERIFY(speed.norm() < kFastest);
                if (samples > 1)
                    QVERIFY((speed - speedBefore).norm() / toSeconds(kStep) < kMostAcceleration);
                before = blade;
                speedBefore = speed;
            }
        }
    }

    void isTheSameBitForBit()
    {
        const IntubationMotion once = motionOf(MotionKind::StuckAtArytenoid, 4);
        const IntubationMotion again = motionOf(MotionKind::StuckAtArytenoid, 4);
        const IntubationMotion other = motionOf(MotionKind::StuckAtArytenoid, 5);
        QCOMPARE(once.length(), again.length());
        QVERIFY(once.length() != other.length());
        QCOMPARE(once.commands(), again.commands());
        for (Duration t{}; t < once.length(); t += 1s) {
            QCOMPARE(once.at(t).X_AE.translation(), again.at(t).X_AE.translation());
            QCOMPARE(once.at(t).X_AL.rotation().coeffs(), again.at(t).X_AL.rotation().coeffs());
        }
    }

    /// Its connector stays in front of the teeth.
    void pushesNoDeeperThanTheTubeIsLong()
    {
        for (const MotionKind kind : {MotionKind::RightMainstem, MotionKind::LeftMainstem})
            for (const std::uint32_t seed : {1U, 2U, 3U}) {
                const IntubationMotion motion = motionOf(kind, seed);
                const Length whole = lengthOf(motion.tube().p_E_centre);
                for (Duration t{}; t < motion.length(); t += 217ms)
                    QVERIFY(motion.depthAtTeeth(t) < whole);
            }
        const IntubationMotion motion =
            motionWith(tubeWithout(0.30), MotionKind::RightMainstem).value();
        const Length whole = lengthOf(motion.tube().p_E_centre);
        const Length outside = whole - motion.depthAtTeeth(motion.length());
        QVERIFY2(outside.si > 0.0 && outside < metres(kMostOutside),
                 qPrintable(QString::number(inMillimetres(outside))));
        QVERIFY(motion.tipAboveCarina(motion.length()) > Length{});
    }

    void refusesATubeThatIsTooShort()
    {
        const auto refused = motionWith(tubeWithout(0.85), MotionKind::Good);
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, Errc::OutOfRange);
    }
};

CARINA_TEST(TestMotionTruth)

} // namespace carina::motion_truth_test

#include "tst_motion_truth.moc"
