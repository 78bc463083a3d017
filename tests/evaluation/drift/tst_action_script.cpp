#include "evaluation/drift/action_script.h"

#include "engine/core/units.h"
#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <set>

namespace carina::action_script_test
{
namespace
{

using namespace std::chrono_literals;

const double kSpeed = degrees(97.3).si;

ActionScript scriptOf(int actions, std::uint32_t seed = 1,
                      ActionScript::Axes axes = ActionScript::Axes::Cartesian)
{
    return ActionScript{{.actions = actions, .angularSpeed = kSpeed, .speed = 0.25, .axes = axes},
                        seed};
}

double degreesBetween(const Quat& a, const Quat& b) { return inDegrees(angleBetween(a, b)); }

/// Where the moved object is, from the directions and speeds of all moves until then.
Vec3 movedTo(const ActionScript& script, Duration t)
{
    Vec3 p = Vec3::Zero();
    for (int action = 0; action < script.actions() && ActionScript::startOf(action) < t; ++action) {
        const EventCpo move = script.translation(action);
        const bool isLast = action + 1 == script.actions();
        const Duration until = isLast ? t : std::min(t, ActionScript::startOf(action + 1));
        p += toSeconds(until - ActionScript::startOf(action)) * double{move.rate}
             * move.axis_A.cast<double>();
    }
    return p;
}

} // namespace

class ActionScriptTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void turnsAtTheSpeedAskedAboutOneAxisPerAction()
    {
        const ActionScript script = scriptOf(20);
        for (int action = 0; action < 20; ++action) {
            const Duration start = ActionScript::startOf(action);
            const Quat q0 = script.q_AO(start);
            const Quat half = script.q_AO(start + 600ms) * q0.conjugate();
            const Quat whole = script.q_AO(start + 1200ms - 1ns) * q0.conjugate();
            QVERIFY(std::abs(inDegrees(angleOf(half)) - 97.3 * 0.6) < 1e-9);
            QVERIFY(std::abs(inDegrees(angleOf(whole)) - 97.3 * 1.2) < 1e-6);
            const Vec3 axis = rotationVector(half).normalized();
            QVERIFY(rotationVector(whole).normalized().isApprox(axis, 1e-9));
            QVERIFY(std::abs(axis.lpNorm<Eigen::Infinity>() - 1.0) < 1e-9);
            // The other object moves along the same axis.
            const Vec3 moved = movedTo(script, start + 600ms) - movedTo(script, start);
            QVERIFY(moved.isApprox(0.25 * 0.6 * axis, 1e-6));
        }
    }

    void isContinuousFromActionToAction()
    {
        const ActionScript script = scriptOf(20);
        for (int action = 1; action <= 20; ++action) {
            const Duration end = ActionScript::startOf(action);
            QVERIFY(degreesBetween(script.q_AO(end - 1ns), script.q_AO(end)) < 1e-6);
            QVERIFY((movedTo(script, end) - movedTo(script, end - 1ns)).norm() < 1e-7);
        }
    }

    void isAtRestBeforeTheFirst()
    {
        const ActionScript script = scriptOf(3);
        QVERIFY(degreesBetween(script.q_AO(-5s), Quat::Identity()) == 0.0);
        QVERIFY(movedTo(script, -5s).norm() == 0.0);
        QCOMPARE(script.rotation(-1).rate, 0.0F);
        QCOMPARE(script.rotation(-1).action, 0U);
        QCOMPARE(script.translation(-1).rate, 0.0F);
    }

    void eventsSayTheSameAsTheTruth()
    {
        // Axis and rate pass through single precision.
        const ActionScript script = scriptOf(20, 4, ActionScript::Axes::Random);
        for (int action = 0; action < 20; ++action) {
            const EventCpo turn = script.rotation(action);
            const EventCpo move = script.translation(action);
            QCOMPARE(turn.object, ActionScript::kTurned);
            QCOMPARE(move.object, ActionScript::kMoved);
            QCOMPARE(turn.action, static_cast<std::uint32_t>(action + 1));
            const Duration t = ActionScript::startOf(action) + 1s;
            QVERIFY(degreesBetween(evaluateAfter(turn, 1s).X_AO.rotation(), script.q_AO(t)) < 1e-4);
            QVERIFY((evaluateAfter(move, 1s).X_AO.translation() - movedTo(script, t)).norm()
                    < 1e-6);
        }
    }

    void cartesianAxesAreDrawnEvenly()
    {
        // 6000 actions, each axis 1000 times within four standard deviations.
        const ActionScript script = scriptOf(6000);
        std::map<std::tuple<int, int, int>, int> counts;
        for (int action = 0; action < 6000; ++action) {
            const Vec3f axis = script.rotation(action).axis_A;
            ++counts[{int(axis.x()), int(axis.y()), int(axis.z())}];
        }
        QCOMPARE(counts.size(), 6U);
        for (const auto& [axis, count] : counts)
            QVERIFY(std::abs(count - 1000) < 4 * 29);
    }

    void angularVelocityChangesAsMuchAsItMust_data()
    {
        QTest::addColumn<int>("axes");
        QTest::addColumn<double>("mean");
        // Of two of the six axes: 1/6 the same, 1/6 opposite, 4/6 at right angles. On the sphere:
        // the mean chord, 4/3.
        QTest::newRow("cartesian")
            << int(ActionScript::Axes::Cartesian) << (2.0 + 4.0 * std::numbers::sqrt2) / 6.0;
        QTest::newRow("random") << int(ActionScript::Axes::Random) << 4.0 / 3.0;
    }
    void angularVelocityChangesAsMuchAsItMust()
    {
        QFETCH(int, axes);
        QFETCH(double, mean);
        const ActionScript script = scriptOf(10001, 2, static_cast<ActionScript::Axes>(axes));
        QVERIFY(std::abs(script.changeOfAngularVelocity(0) - kSpeed) < 1e-12);
        double sum = 0.0;
        for (int action = 1; action <= 10000; ++action)
            sum += script.changeOfAngularVelocity(action) / kSpeed;
        QVERIFY(std::abs(sum / 10000.0 - mean) < 0.03);
    }

    void seedsGiveOtherAxes()
    {
        QVERIFY(scriptOf(20, 1).q_AO(10s).coeffs() == scriptOf(20, 1).q_AO(10s).coeffs());
        QVERIFY(scriptOf(20, 1).q_AO(10s).coeffs() != scriptOf(20, 2).q_AO(10s).coeffs());
    }
};

CARINA_TEST(ActionScriptTest)

} // namespace carina::action_script_test

#include "tst_action_script.moc"
