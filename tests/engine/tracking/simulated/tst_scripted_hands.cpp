#include "engine/geometry/rotation.h"
#include "engine/tracking/simulated/scripted_hands.h"
#include "engine/tracking/working_volume.h"

#include "tests/engine/tracking/airway_walk.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace carina::scripted_hands_test
{
namespace
{

using namespace std::chrono_literals;

constexpr double kTolerance = 1e-9; // m or rad
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr Duration kPeriod = 20s;
constexpr std::array kTools{ToolRole::Head, ToolRole::Jaw, ToolRole::Tube, ToolRole::Stylus};

SessionTime at(Duration t) { return SessionTime{t}; }

double distanceToLine(const Vec3& p, const std::vector<Vec3>& line)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vec3 piece = line[i] - line[i - 1];
        const double share =
            std::clamp((p - line[i - 1]).dot(piece) / piece.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (line[i - 1] + share * piece - p).norm());
    }
    return nearest;
}

constexpr double kToTeeth = 0.1;     // m of a straight path
constexpr double kBendRadius = 0.06; // m, of a tube that is bent to five sixths of a circle

/// The point of that tube which is so far from its tip along it, in E.
Vec3 onBentTube(double fromTip)
{
    const double turn = fromTip / kBendRadius;
    return kBendRadius * Vec3{0.0, std::sin(turn), std::cos(turn)};
}

/// That tube goes 23 cm past the incisors, straight to the back.
HandScript scriptOfBentTube()
{
    constexpr double kPiece = 2e-4; // m, of the tube
    HandScript script;
    script.path_A = {Vec3{0.0, -kToTeeth, 0.0}, Vec3::Zero(), Vec3{0.0, 0.26, 0.0}};
    for (double s = 5.0 / 3.0 * std::numbers::pi * kBendRadius; s > 0.0; s -= kPiece)
        script.p_E_centre.push_back(onBentTube(s));
    script.p_E_centre.push_back(onBentTube(0.0));
    return script;
}

/// The hands, with the patient at the tracker's origin so that poses come out in A.
class Hands
{
public:
    explicit Hands(HandScript script = test::scriptOfWalk()) : m_script{std::move(script)}
    {
        m_script.X_TA = RigidTransform{};
        m_hands = ScriptedHands::make(m_script);
    }

    [[nodiscard]] const HandScript& script() const { return m_script; }
    [[nodiscard]] RigidTransform closedJaw() const { return m_hands->closedJaw(); }
    [[nodiscard]] RigidTransform X_A(ToolRole tool, Duration t) const
    {
        return (*m_hands)(tool, at(t)).value();
    }
    [[nodiscard]] Vec3 p_A_tip(Duration t) const
    {
        return X_A(ToolRole::Tube, t) * m_script.p_E_centre.back();
    }

private:
    HandScript m_script;
    Result<ScriptedHands> m_hands = fail(Errc::OutOfRange);
};

} // namespace

/// The scripted hands around a walked airway.
class ScriptedHandsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void keepsTheTipOnThePath()
    {
        const Hands hands;
        for (Duration t = 0s; t < kPeriod; t += 50ms)
            QVERIFY(distanceToLine(hands.p_A_tip(t), hands.script().path_A) < kTolerance);
    }

    /// Of a jaw half as large the condyles are half as far away, and it comes half as far forward.
    void movesASmallJawInProportion()
    {
        const Vec3 p_A_incisors{0.0, -0.05, 0.07};
        const Angle rise = degrees(26.0);
        const Vec3 p_A_condyles =
            p_A_incisors + 0.044 * Vec3{0.0, std::cos(rise.si), std::sin(rise.si)};
        const RigidTransform opened = movedJaw(p_A_incisors, degrees(20.0), {}, 0.5);
        QVERIFY((opened * p_A_condyles - p_A_condyles).norm() < kTolerance);
        const RigidTransform forward = movedJaw(p_A_incisors, {}, millimetres(10.0), 0.5);
        QVERIFY((forward * p_A_incisors - p_A_incisors + Vec3{0.0, 5e-3, 0.0}).norm() < kTolerance);
        const RigidTransform whole = movedJaw(p_A_incisors, degrees(20.0), millimetres(10.0));
        QVERIFY(whole.matrix()
                == movedJaw(p_A_incisors, degrees(20.0), millimetres(10.0), 1.0).matrix());
    }

    void holdsTheTubeOutsideAndThenInPlaceAboveTheCarina_data()
    {
        QTest::addColumn<double>("restMm");
        QTest::newRow("3 cm above, the usual depth") << 30.0;
        QTest::newRow("5 cm above") << 50.0;
    }
    void holdsTheTubeOutsideAndThenInPlaceAboveTheCarina()
    {
        QFETCH(double, restMm);
        const Hands hands{test::scriptOfWalk(millimetres(restMm))};
        for (const Duration t : {0ms, 1000ms, 2000ms})
            QVERIFY((hands.p_A_tip(t) - hands.script().path_A.front()).norm() < kTolerance);
        for (const Duration t : {10'000ms, 12'000ms, 14'000ms}) {
            QVERIFY((hands.p_A_tip(t) - Vec3{0.0, 0.0, restMm * 1e-3}).norm() < kTolerance);
            const Vec3 dir_A = hands.X_A(ToolRole::Tube, t).rotation() * Vec3::UnitY();
            QVERIFY((dir_A + Vec3::UnitZ()).norm() < kTolerance); // along the trachea
        }
        QCOMPARE(test::scriptOfWalk().restAboveCarina, metres(0.03));
    }

    void pointsTheTipAlongThePathWithItsCurveInTheSagittalPlane()
    {
        const Hands hands;
        for (Duration t = 0s; t < kPeriod; t += 50ms) {
            const Quat turn = hands.X_A(ToolRole::Tube, t).rotation();
            QVERIFY((turn * Vec3::UnitX() - Vec3::UnitX()).norm() < kTolerance);
        }
        const Vec3 outside = hands.X_A(ToolRole::Tube, 0s).rotation() * Vec3::UnitY();
        const Vec3 along{0.0, std::cos(degrees(20.0).si), std::sin(degrees(20.0).si)};
        QVERIFY((outside - along).norm() < kTolerance);
    }

    /// While the tip is in the patient, the centreline runs through the path's point at the
    /// incisors.
    void slidesThroughTheMouth()
    {
        constexpr double kBetweenPoints = 1e-4; // m, the centreline's pieces are straight
        const Hands hands;
        for (Duration t = 0s; t < kPeriod; t += 50ms) {
            const RigidTransform X_AE = hands.X_A(ToolRole::Tube, t);
            const Vec3& incisors = hands.script().p_A_incisors;
            if ((hands.p_A_tip(t) - incisors).y() < 0.04)
                continue; // its second point is not at the teeth yet
            const Vec3 p_E_incisors = X_AE.inverse() * incisors;
            QVERIFY(distanceToLine(p_E_incisors, hands.script().p_E_centre) < kBetweenPoints);
        }
    }

    /// Bent to most of a circle, it comes nearer to its tip again. The point that is as far from
    /// the tip along it as the incisors are along the straight path lies on that path, at the
    /// chord of that arc.
    void laysATubeThatTurnsBackByItsLength()
    {
        constexpr double kOfPieces = 1e-6; // m, the centreline's pieces are straight
        const Hands hands{scriptOfBentTube()};
        double farthest = 0.0;
        for (Duration t = 0s; t < kPeriod; t += 50ms) {
            const RigidTransform X_AE = hands.X_A(ToolRole::Tube, t);
            const Vec3 p_A_tip = hands.p_A_tip(t);
            const double past = p_A_tip.y();
            if (past < 0.04)
                continue; // its second point is not at the teeth yet
            farthest = std::max(farthest, past);
            const double chord = 2.0 * kBendRadius * std::sin(0.5 * past / kBendRadius);
            const Vec3 p_A_expected = p_A_tip - chord * Vec3::UnitY();
            QVERIFY((X_AE * onBentTube(past) - p_A_expected).norm() < kOfPieces);
            QVERIFY((X_AE.rotation() * Vec3::UnitX() - Vec3::UnitX()).norm() < kTolerance);
        }
        QVERIFY(farthest > std::numbers::pi * kBendRadius); // where it comes nearer again
    }

    void liesAlongThePathInItsPlace()
    {
        const Hands hands;
        const RigidTransform X_AE = hands.X_A(ToolRole::Tube, 12s);
        for (const Vec3& p_E : hands.script().p_E_centre)
            QVERIFY(distanceToLine(X_AE * p_E, hands.script().path_A) < kTolerance);
    }

    void repeatsItselfEveryPeriod()
    {
        const Hands hands;
        for (const ToolRole tool : kTools) {
            for (Duration t = 0s; t < kPeriod; t += 700ms) {
                const RigidTransform now = hands.X_A(tool, t);
                for (const Duration other : {t + kPeriod, t + 1000 * kPeriod, t - 3 * kPeriod}) {
                    const RigidTransform then = hands.X_A(tool, other);
                    QVERIFY((now.translation() - then.translation()).norm() < kTolerance);
                    QVERIFY(angleBetween(now.rotation(), then.rotation()).si < kTolerance);
                }
            }
        }
    }

    void movesContinuouslyAtTheSpeedOfHands()
    {
        constexpr Duration kStep = 1ms;
        constexpr double kFastest = 0.3;  // m/s
        constexpr double kQuickest = 1.5; // rad/s
        const Hands hands;
        for (const ToolRole tool : kTools) {
            for (Duration t = 0s; t <= kPeriod; t += kStep) {
                const RigidTransform before = hands.X_A(tool, t);
                const RigidTransform after = hands.X_A(tool, t + kStep);
                const double way = (after.translation() - before.translation()).norm();
                const Angle turn = angleBetween(after.rotation(), before.rotation());
                QVERIFY(way < kFastest * toSeconds(kStep));
                QVERIFY(turn.si < kQuickest * toSeconds(kStep));
            }
        }
    }

    void startsAndStopsGently()
    {
        constexpr double kSlow = 0.005; // m/s, within 20 ms of rest
        const Hands hands;
        for (const Duration rest : {2000ms, 10'000ms, 14'000ms, 20'000ms}) {
            for (const Duration t : {rest - 20ms, rest + 10ms}) {
                const double way = (hands.X_A(ToolRole::Tube, t + 10ms).translation()
                                    - hands.X_A(ToolRole::Tube, t).translation())
                                       .norm();
                QVERIFY(way < kSlow * 0.01);
            }
        }
    }

    void opensTheMouthAboutTheCondyles_data()
    {
        QTest::addColumn<int>("time");
        QTest::addColumn<double>("openingDeg");
        QTest::newRow("outside") << 0 << 0.0;
        QTest::newRow("on the way in") << 6000 << 20.0;
        QTest::newRow("arrived") << 10'000 << 20.0;
        QTest::newRow("in place") << 12'250 << 8.0;
        QTest::newRow("on the way out") << 16'000 << 20.0;
    }
    void opensTheMouthAboutTheCondyles()
    {
        QFETCH(int, time);
        QFETCH(double, openingDeg);
        const Hands hands;
        const RigidTransform X_AJ = hands.X_A(ToolRole::Jaw, time * 1ms);
        const RigidTransform motion_A = X_AJ * hands.closedJaw().inverse();
        QVERIFY(std::abs(inDegrees(angleOf(X_AJ.rotation())) - openingDeg) < 1e-6);
        const Vec3 p_A_condyles =
            hands.script().p_A_incisors
            + 0.088 * Vec3{0.0, std::cos(degrees(26.0).si), std::sin(degrees(26.0).si)};
        QVERIFY((motion_A * p_A_condyles - p_A_condyles).norm() < kTolerance);
        const Vec3 chin = X_AJ.translation() - hands.closedJaw().translation();
        QCOMPARE(chin.z() < -0.005, openingDeg > 0.0); // down the body
        QCOMPARE(chin.y() > 0.002, openingDeg > 0.0);  // and back
    }

    void looksAtTheFaceFromBehindTheHead()
    {
        const Hands hands;
        Vec3 lowest = Vec3::Constant(1.0);
        Vec3 highest = Vec3::Constant(-1.0);
        for (Duration t = 0s; t < kPeriod; t += 100ms) {
            const RigidTransform X_AH = hands.X_A(ToolRole::Head, t);
            const Vec3 p_H_incisors = X_AH.inverse() * hands.script().p_A_incisors;
            QVERIFY(p_H_incisors.head<2>().norm() < kTolerance); // straight ahead
            QVERIFY(p_H_incisors.z() < -0.35 && p_H_incisors.z() > -0.50);
            QVERIFY((X_AH.rotation() * Vec3::UnitY()).y() < -0.5); // up is anterior
            QVERIFY((X_AH.rotation() * Vec3::UnitX()).x() < -0.9); // its right the patient's
            QVERIFY(X_AH.translation().z() > hands.script().p_A_incisors.z() + 0.2);
            lowest = lowest.cwiseMin(X_AH.translation());
            highest = highest.cwiseMax(X_AH.translation());
        }
        const Vec3 sway = highest - lowest;
        QVERIFY(sway.maxCoeff() > 0.02 && sway.maxCoeff() < 0.06);
    }

    void givesPosesInTheTrackersFrameInsideItsVolume()
    {
        const HandScript script = test::scriptOfWalk();
        const Result<ScriptedHands> hands = ScriptedHands::make(script);
        const Hands inA;
        for (const ToolRole tool : kTools) {
            for (Duration t = 0s; t < kPeriod; t += 100ms) {
                const RigidTransform X_TO = (*hands)(tool, at(t)).value();
                const RigidTransform expected = script.X_TA * inA.X_A(tool, t);
                QVERIFY((X_TO.translation() - expected.translation()).norm() < kTolerance);
                QVERIFY(angleBetween(X_TO.rotation(), expected.rotation()).si < kTolerance);
                QVERIFY(WorkingVolume{}.contains(X_TO.translation()));
            }
        }
        QVERIFY(!(*hands)(ToolRole::Manikin, at(0s)));
        QVERIFY(!(*hands)(ToolRole::Other, at(0s)));
    }

    void refusesAScriptThatCannotBePlayed_data()
    {
        QTest::addColumn<HandScript>("script");
        QTest::addColumn<Errc>("code");
        const auto row = [](const char* name, Errc code, auto&& change) {
            HandScript script = test::scriptOfWalk();
            change(script);
            QTest::newRow(name) << script << code;
        };
        using enum Errc;
        row("no path", OutOfRange, [](HandScript& s) { s.path_A.clear(); });
        row("a point", OutOfRange, [](HandScript& s) { s.path_A.resize(1); });
        row("too short", OutOfRange, [](HandScript& s) { s.path_A.resize(30); });
        row("sideways", OutOfRange, [](HandScript& s) {
            s.path_A = {Vec3{0.3, 0.0, 0.0}, Vec3{0.0, 0.0, 0.0}};
        });
        row("there and back", OutOfRange, [](HandScript& s) {
            s.path_A = {Vec3{0.0, 0.0, 0.3}, Vec3{0.0, 0.0, 0.0}, Vec3{0.0, 0.0, 0.3}};
        });
        row("beyond the carina", OutOfRange,
            [](HandScript& s) { s.restAboveCarina = millimetres(-1.0); });
        row("no tube", OutOfRange, [](HandScript& s) { s.p_E_centre.clear(); });
        row("a tube too short for the mouth", OutOfRange, [](HandScript& s) {
            s.p_E_centre.erase(s.p_E_centre.begin(), s.p_E_centre.end() - 100);
        });
        row("a tube along x", OutOfRange, [](HandScript& s) {
            s.p_E_centre = {Vec3::Zero(), 0.3 * Vec3::UnitX()};
        });
        row("no period", OutOfRange, [](HandScript& s) { s.period = 0s; });
        row("NaN in the path", NotFinite, [](HandScript& s) { s.path_A[5].y() = kNaN; });
        row("NaN incisors", NotFinite, [](HandScript& s) { s.p_A_incisors.x() = kNaN; });
        row("NaN in the tube", NotFinite, [](HandScript& s) { s.p_E_centre[5].x() = kNaN; });
        row("NaN depth", NotFinite, [](HandScript& s) { s.restAboveCarina = metres(kNaN); });
        row("NaN placement", NotFinite, [](HandScript& s) {
            s.X_TA = RigidTransform::translation({kNaN, 0.0, 0.0});
        });
    }
    void refusesAScriptThatCannotBePlayed()
    {
        QFETCH(HandScript, script);
        QFETCH(Errc, code);
        const Result<ScriptedHands> hands = ScriptedHands::make(script);
        QVERIFY(!hands);
        QCOMPARE(hands.error().code, code);
        QVERIFY(!hands.error().detail.empty());
    }
};

CARINA_TEST(ScriptedHandsTest)

} // namespace carina::scripted_hands_test

#include "tst_scripted_hands.moc"
