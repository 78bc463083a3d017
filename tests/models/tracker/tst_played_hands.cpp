#include "models/tracker/played_hands.h"

#include "engine/geometry/rotation.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <numbers>

namespace carina::played_hands_test
{
namespace
{

using test::FakeSessionNode;
using namespace std::chrono_literals;

constexpr double kExact_m = 1e-9;

/// A tube that goes up by a metre a second, and is what a trainee does with it.
PlayedMotion rising()
{
    PlayedMotion motion;
    motion.at = [](Duration t) {
        return HandledTools{.X_UE = RigidTransform::translation({0.0, 0.0, toSeconds(t)})};
    };
    motion.controls = {{2s, fact::StyletDrawn{}}, {4s, fact::CuffSet{true}}};
    return motion;
}

/// A trainee who is at work, in a session that does not run yet.
struct Work {
    FakeSessionNode node{FakeSessionNode::kTrainee};
    PlayedHands hands{node, rising()};

    void goOn(Duration time)
    {
        node.advance(time);
        hands.look(FakeSessionNode::kStation);
    }
    /// Until this is in effect.
    void turnTo(SessionPhase phase)
    {
        node.decide(fact::PhaseChanged{phase});
        goOn(kShortestLead);
    }
    [[nodiscard]] bool areAt(double height_m) const
    {
        return std::abs(hands.at(*node.now()).X_UE.translation().z() - height_m) < kExact_m;
    }
    [[nodiscard]] bool isStyletIn() const { return tube().styletInAt(*node.now()); }
    [[nodiscard]] bool isCuffInflated() const { return tube().cuffInflatedAt(*node.now()); }

private:
    [[nodiscard]] TubeTimeline tube() const
    {
        return node.state()->stations().at(FakeSessionNode::kStation).respiration.tube();
    }
};

} // namespace

class TestPlayedHands : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void waitUntilTheSessionRuns()
    {
        Work work;
        work.goOn(5s);
        QVERIFY(work.areAt(0.0));
        work.turnTo(SessionPhase::Running);
        QVERIFY(work.areAt(0.0));
        work.goOn(1500ms);
        QVERIFY(work.areAt(1.5));
    }

    void waitUntilTheirOwnerIsAtWork()
    {
        Work work;
        work.node.becomes(FakeSessionNode::kInstructor);
        work.turnTo(SessionPhase::Running);
        work.goOn(3s);
        work.node.becomes(FakeSessionNode::kTrainee);
        work.goOn(1s);
        QVERIFY(work.areAt(0.0)); // from now on
        work.goOn(1s);
        QVERIFY(work.areAt(1.0));
    }

    void pauseWithTheSession()
    {
        Work work;
        work.turnTo(SessionPhase::Running);
        work.goOn(1s);
        work.turnTo(SessionPhase::Paused);
        const double height_m = 1.0 + toSeconds(kShortestLead);
        work.goOn(10s);
        QVERIFY(work.areAt(height_m));
        QVERIFY(work.isStyletIn());
        work.turnTo(SessionPhase::Running);
        work.goOn(500ms);
        QVERIFY(work.areAt(height_m + 0.5));
    }

    void workTheControlsInTime()
    {
        Work work;
        work.turnTo(SessionPhase::Running);
        work.goOn(1900ms);
        QCOMPARE(work.node.proposed, 0);
        work.goOn(200ms);
        work.goOn(kShortestLead);
        QVERIFY(!work.isStyletIn());
        QVERIFY(!work.isCuffInflated());
        work.goOn(5s);
        work.goOn(kShortestLead);
        QVERIFY(work.isCuffInflated());
        work.goOn(5s);
        QCOMPARE(work.node.proposed, 2); // each once
    }

    /// Markers 100 mm up the shaft, whose -z points to the back.
    void holdTheStylusByItsTip()
    {
        const RigidTransform X_AP{rotationFromVector({0.5 * std::numbers::pi, 0.0, 0.0}),
                                  {0.05, -0.12, -0.1}};
        const HandMotion origin = [&X_AP](SessionTime) { return HandledTools{.X_AS = X_AP}; };
        const HandMotion tip = heldByTip(origin, RigidTransform::translation({0.0, 0.0, -0.1}));
        const Vec3 p_A_markers = tip({}).X_AS->translation();
        QVERIFY((p_A_markers - Vec3{0.05, -0.22, -0.1}).norm() < kExact_m);
        const HandMotion none = heldByTip([](SessionTime) { return HandledTools{}; }, X_AP);
        QVERIFY(!none({}).X_AS);
    }
};

CARINA_TEST(TestPlayedHands)

} // namespace carina::played_hands_test

#include "tst_played_hands.moc"
