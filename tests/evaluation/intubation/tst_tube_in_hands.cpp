#include "engine/airway/tube/tube_size.h"
#include "engine/anatomy/airway/centreline.h"
#include "evaluation/intubation/motion_script.h"
#include "tests/evaluation/intubation/tube_patient.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::tube_in_hands_test
{
namespace
{

using namespace std::chrono_literals;

constexpr double kMillimetre = 1e-3;
constexpr double kSameLength = 0.5 * kMillimetre;
constexpr Duration kEach = 217ms;

struct Hands {
    std::shared_ptr<const MotionPatient> patient;
    TubeShape tube;

    [[nodiscard]] IntubationMotion motion(MotionKind kind) const
    {
        std::mt19937 random = generatorOf(kind, 2);
        return scriptedMotion(kind, drawnParameters(kind, random), patient, tube, 2,
                              TubeBending::Elastic)
            .value();
    }
};

/// Mouth, throat and windpipe are a round tube: the patient of tubes has none.
Hands handsOf(BuiltinPatient which, Length innerDiameter)
{
    constexpr Length kRound = millimetres(10.0); // radius
    MotionPatient patient = motionPatient(test::tubePatient(dimensionsOf(which)), {}).value();
    for (TipWay& way : patient.ways)
        way.walls = roundWalls(way.line_A, metres(way.teeth), metres(way.end), kRound);
    return {std::make_shared<const MotionPatient>(patient),
            motionTube(patient.airway, innerDiameter, tubeOfSize(innerDiameter)->length).value()};
}

Hands handsIn(bool isAdult)
{
    return isAdult ? handsOf(BuiltinPatient::Adult, millimetres(8.0))
                   : handsOf(BuiltinPatient::TwelveYears, millimetres(6.5));
}

void patients()
{
    QTest::addColumn<bool>("isAdult");
    QTest::newRow("twelve years") << false;
    QTest::newRow("adult") << true;
}

/// Where the jaw has taken a place before the larynx.
Vec3 throatAt(const Hands& hands, const MotionMoment& moment)
{
    const TipWay& way = hands.patient->way(TipTarget::Trachea);
    return placeOnWay(*hands.patient, way, way.fork, {moment.X_AJ, {}});
}

/// The length of a line from its place nearest to p on.
double lengthBehind(const std::vector<Vec3>& line, const Vec3& p)
{
    double least = 1.0;
    double before = 0.0;
    double nearest = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vec3 piece = line[i] - line[i - 1];
        const double share = std::clamp(piece.dot(p - line[i - 1]) / piece.squaredNorm(), 0.0, 1.0);
        const double distance = (line[i - 1] + share * piece - p).norm();
        if (distance < least) {
            least = distance;
            nearest = before + share * piece.norm();
        }
        before += piece.norm();
    }
    return before - nearest;
}

} // namespace

class TestTubeInHands : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// What is behind the teeth and what is in front of them are together the tube, in all motions;
    /// and in front of them it lies at its connector as at rest.
    void isAsLongAsTheTube_data() { patients(); }
    void isAsLongAsTheTube()
    {
        QFETCH(const bool, isAdult);
        const Hands hands = handsIn(isAdult);
        const double whole = lengthOf(hands.tube.p_E_centre).si;
        for (const NamedMotion& named : kNamedMotions) {
            const IntubationMotion motion = hands.motion(named.kind);
            for (Duration t{}; t < motion.length(); t += kEach) {
                if (motion.headAt(t).flexion.si > 0.0)
                    break;
                const std::vector<Vec3> line = motion.tubeLine(t);
                QVERIFY(std::abs(lengthOf(line).si - whole) < kSameLength);
                const RigidTransform X_EA = motion.at(t).X_AE.inverse();
                QVERIFY((X_EA * line[0] - hands.tube.p_E_centre[0]).norm() < 1e-9);
                const double depth = motion.depthAtTeeth(t).si;
                QVERIFY(depth < whole);
                if (depth > 0.0)
                    QVERIFY(std::abs(lengthBehind(line, hands.patient->airway.p_A_incisors) - depth)
                            < 1e-9);
            }
        }
    }

    /// While the tip is in front of the teeth, the tube is its curve at rest.
    void isRigidInFrontOfTheTeeth_data() { patients(); }
    void isRigidInFrontOfTheTeeth()
    {
        QFETCH(const bool, isAdult);
        const IntubationMotion motion = handsIn(isAdult).motion(MotionKind::Good);
        const TipWay& way = motion.patient().way(TipTarget::Trachea);
        int looks = 0;
        for (Duration t{}; motion.tipAt(t).along < way.teeth; t += kEach, ++looks) {
            const Vec3 p_A_tip = motion.at(t).X_AE * motion.tube().p_E_tip;
            QVERIFY((p_A_tip - motion.tipAt(t).p_A).norm() < 0.1 * kMillimetre);
        }
        QVERIFY(looks > 10);
    }

    /// While the tip is on its way between the walls, its connector goes in 5 ms no farther than
    /// the tip, the jaw and the turn of the tube about its walls explain.
    void goesEvenly_data() { patients(); }
    void goesEvenly()
    {
        QFETCH(const bool, isAdult);
        constexpr Duration kStep = 5ms;
        constexpr double kLever = 10.0; ///< of the connector, to the tip and the throat
        constexpr double kAnyway = 1.5 * kMillimetre;
        constexpr double kMoves = 0.1 * kMillimetre; ///< of a tip that is led on, in a step
        const Hands hands = handsIn(isAdult);
        const IntubationMotion motion = hands.motion(MotionKind::Oesophageal);
        const double teeth = hands.patient->way(TipTarget::Trachea).teeth;
        int looks = 0;
        for (Duration t{}; t < motion.length(); t += kStep) {
            const TrueTip from = motion.tipAt(t);
            const double tip = (motion.tipAt(t + kStep).p_A - from.p_A).norm();
            if (from.along < teeth || tip < kMoves)
                continue;
            const MotionMoment before = motion.at(t);
            const MotionMoment behind = motion.at(t + kStep);
            const double throat = (throatAt(hands, behind) - throatAt(hands, before)).norm();
            const double went = (behind.X_AE.translation() - before.X_AE.translation()).norm();
            QVERIFY2(went < kAnyway + kLever * (tip + throat),
                     qPrintable(QStringLiteral("%1 mm at %2 s, the tip %3 mm, the throat %4 mm")
                                    .arg(went / kMillimetre)
                                    .arg(toSeconds(t))
                                    .arg(tip / kMillimetre)
                                    .arg(throat / kMillimetre)));
            ++looks;
        }
        QVERIFY(looks > 200);
    }

    /// It bends: on its way its connector is elsewhere than that of a rigid tube with this tip.
    void bendsInTheThroat_data() { patients(); }
    void bendsInTheThroat()
    {
        QFETCH(const bool, isAdult);
        const IntubationMotion motion = handsIn(isAdult).motion(MotionKind::Oesophageal);
        double most = 0.0;
        for (Duration t{}; t < motion.length(); t += kEach)
            most = std::max(
                most, (motion.at(t).X_AE * motion.tube().p_E_tip - motion.tipAt(t).p_A).norm());
        QVERIFY2(most > 5.0 * kMillimetre, qPrintable(QString::number(most / kMillimetre)));
    }
};

CARINA_TEST(TestTubeInHands)

} // namespace carina::tube_in_hands_test

#include "tst_tube_in_hands.moc"
