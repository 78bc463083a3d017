#include "apps/lab/drift/live_evaluation.h"

#include "engine/core/units.h"
#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

namespace carina::lab::live_evaluation_test
{
namespace
{

using namespace std::chrono_literals;

constexpr int kActions = 4;
constexpr std::uint32_t kSeed = 3;
constexpr double kTolerance = 1e-9; ///< m, s
constexpr double kOfFloats = 1e-6;  ///< rad, m: an action's axis and rate are floats
const double kSpeed = degrees(100.0).si;
constexpr double kMetresPerSecond = 0.1;
const ActionScript::Settings kSettings{kActions, kSpeed, kMetresPerSecond};
/// Of the first action, and of the host's session clock against the machine's.
constexpr LocalTime kBegin{1000s};
constexpr Duration kSession = 5000s;
constexpr Duration kSampled = 200us;
constexpr Duration kDelay = 40ms;

const ActionScript& script()
{
    static const ActionScript it{kSettings, kSeed};
    return it;
}

/// Where the moved object is then, by the event in force.
Vec3 movedTo(Duration t)
{
    const int action = std::clamp(int(t / ActionScript::kActionTime), 0, script().actions() - 1);
    const Duration since = std::max(t - ActionScript::startOf(action), Duration{0});
    return evaluateAfter(script().translation(action), since).X_AO.translation();
}

/// The poses so long after the first action's start; still after the last.
LiveSample truthAt(Duration t)
{
    const Duration known = std::min(t, ActionScript::startOf(kActions));
    // The script turns on for ever after its last action.
    return {.machine = kBegin + t,
            .session = SessionTime{(kBegin + t).time_since_epoch() + kSession},
            .X_AO_turned = RigidTransform{script().q_AO(known), Vec3::Zero()},
            .X_AO_moved = RigidTransform::translation(movedTo(known))};
}

/// What somebody shows who hears of each action late.
LiveSample lateAt(Duration t)
{
    LiveSample sample = truthAt(t);
    const auto action = static_cast<int>(std::max(t, 0ns) / ActionScript::kActionTime);
    const Duration since = t - ActionScript::startOf(action);
    if (t < 0ns || since >= kDelay || action > kActions)
        return sample;
    if (action == 0)
        return {sample.machine, sample.session, RigidTransform{}, RigidTransform{}};
    const EventCpo turned = script().rotation(action - 1);
    const EventCpo moved = script().translation(action - 1);
    const double seconds = toSeconds(ActionScript::kActionTime + since);
    sample.X_AO_turned = RigidTransform{
        rotationFromVector(seconds * kSpeed * turned.axis_A.cast<double>()) * turned.q_AO,
        Vec3::Zero()};
    sample.X_AO_moved = RigidTransform::translation(
        moved.p_AO + seconds * kMetresPerSecond * moved.axis_A.cast<double>());
    return sample;
}

/// The first action that is not about the axis of the one before.
int otherAxis()
{
    int action = 1;
    while (script().changeOfAngularVelocity(action) < 1.0)
        ++action;
    return action;
}

/// What somebody shows to whom that action does not come.
LiveSample withoutOneAt(Duration t)
{
    const int lost = otherAxis();
    LiveSample sample = truthAt(t);
    if (t < ActionScript::startOf(lost) || t >= ActionScript::startOf(lost + 1))
        return sample;
    const EventCpo before = script().rotation(lost - 1);
    const double seconds = toSeconds(t - ActionScript::startOf(lost - 1));
    sample.X_AO_turned = RigidTransform{
        rotationFromVector(seconds * kSpeed * before.axis_A.cast<double>()) * before.q_AO,
        Vec3::Zero()};
    return sample;
}

template <class Shown> LiveLog logOf(Shown shown)
{
    LiveLog log;
    for (Duration t = -100ms; t <= ActionScript::startOf(kActions) + 500ms; t += kSampled)
        log.samples.push_back(shown(t));
    return log;
}

LiveLog actorsLog()
{
    LiveLog log = logOf(truthAt);
    for (int action = 0; action <= kActions; ++action) {
        const LocalTime start = kBegin + ActionScript::startOf(action);
        const LiveSample truth = truthAt(ActionScript::startOf(action));
        log.actions.push_back(
            {start, start, start, truth.X_AO_turned->rotation(), truth.X_AO_moved->translation()});
    }
    return log;
}

LiveRun runWith(const LiveLog& viewer)
{
    return {kSettings, kSeed, logOf(truthAt), {actorsLog(), viewer}, [](std::size_t, Duration) {
                return kDelay;
            }};
}

double meanChange()
{
    double sum = 0.0;
    for (int action = 0; action < kActions; ++action)
        sum += script().changeOfAngularVelocity(action) / kActions;
    return sum;
}

} // namespace

class LiveEvaluationTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingIsApartWhereAllShowTheTruth()
    {
        const auto figures = evaluateLive(runWith(logOf(truthAt)));
        QVERIFY(figures);
        QVERIFY(figures->drift.timeAverage < kOfFloats);
        QVERIFY(figures->drift.atEvent < kOfFloats);
        QVERIFY(figures->drift.p95 < kOfFloats);
        QVERIFY(figures->drift.position < kOfFloats);
        QVERIFY(*figures->drift.clockError < kTolerance);
        QVERIFY(figures->isEndStateSame);
        QCOMPARE(figures->drift.actions.size(), std::size_t{kActions});
        QVERIFY(std::abs(toSeconds(figures->gapP95 - kSampled)) < kTolerance);
    }

    // An error that grows as |dw| u for u up to d: |dw| d^2 / (2 T) on average.
    void lateNewsCostsWhatPhysicsSays()
    {
        const auto figures = evaluateLive(runWith(logOf(lateAt)));
        QVERIFY(figures);
        const double d = toSeconds(kDelay);
        const double expected = meanChange() * d * d / (2.0 * toSeconds(ActionScript::kActionTime));
        constexpr double kSamplingError = 0.02; // 200 samples of 40 ms, and sin x for x
        QVERIFY(std::abs(figures->drift.timeAverage / expected - 1.0) < kSamplingError);
        QVERIFY(std::abs(figures->drift.limit / expected - 1.0) < kTolerance);
        QVERIFY(std::abs(figures->drift.position / figures->drift.positionLimit - 1.0)
                < kSamplingError);
        QVERIFY(figures->drift.atEvent < kOfFloats);
        QVERIFY(figures->isEndStateSame);
    }

    void clockThatIsOffShowsAtTheEvent()
    {
        constexpr Duration kOff = 3ms;
        const auto figures = evaluateLive(runWith(logOf([&](Duration t) {
            LiveSample sample = truthAt(t - kOff);
            sample.machine += kOff;
            return sample;
        })));
        QVERIFY(figures);
        QVERIFY(std::abs(figures->drift.atEvent - kSpeed * toSeconds(kOff)) < kOfFloats);
        for (const ActionDrift& action : figures->drift.actions) {
            QVERIFY(std::abs(action.angle - kSpeed * toSeconds(kOff)) < kOfFloats);
            QVERIFY(std::abs(action.rawAngle - action.angle) < kOfFloats);
            QVERIFY(std::abs(action.distance - kMetresPerSecond * toSeconds(kOff)) < kOfFloats);
        }
        // The actor's has no error.
        QVERIFY(std::abs(*figures->drift.clockError - toSeconds(kOff) / 2.0) < kTolerance);
    }

    void lostActionIsCountedAndDoesNotHideTheRest()
    {
        const auto figures = evaluateLive(runWith(logOf(withoutOneAt)));
        QVERIFY(figures);
        QCOMPARE(figures->drift.lost, 1.0);
        QVERIFY(figures->drift.timeAverage > degrees(10.0).si);
        QVERIFY(*figures->drift.timeAverageShown < kOfFloats);

        const auto late = evaluateLive(runWith(logOf(lateAt)));
        QCOMPARE(late->drift.lost, 0.0);
        QVERIFY(std::abs(*late->drift.timeAverageShown / late->drift.timeAverage - 1.0) < 1e-3);
    }

    void truthIsWhatTheActorDeclared()
    {
        // All of it happens later than planned, by the machine's clock alone.
        constexpr Duration kLate = 70ms;
        LiveRun run = runWith(logOf([&](Duration t) {
            LiveSample sample = truthAt(t);
            sample.machine += kLate;
            return sample;
        }));
        for (DeclaredAction& action : run.participants[0].actions) {
            action.called += kLate;
            action.turnedSince += kLate;
            action.movedSince += kLate;
        }
        const auto figures = evaluateLive(run);
        QVERIFY(figures);
        QVERIFY(figures->drift.timeAverage < kOfFloats);
        QVERIFY(figures->drift.position < kOfFloats);
        QVERIFY(std::abs(*figures->drift.clockError - toSeconds(kLate) / 2.0) < kTolerance);
    }

    void anotherStrategyIsSeen_data()
    {
        QTest::addColumn<bool>("ofTheHost");
        QTest::newRow("of the host") << true;
        QTest::newRow("of a viewer") << false;
    }
    void anotherStrategyIsSeen()
    {
        QFETCH(bool, ofTheHost);
        LiveRun run = runWith(logOf(truthAt));
        run.strategy = StrategyKind::Event;
        run.host.strategy = StrategyKind::Event;
        for (LiveLog& log : run.participants)
            log.strategy = StrategyKind::Event;
        QVERIFY(evaluateLive(run));
        (ofTheHost ? run.host : run.participants[1]).strategy = StrategyKind::SessionClock;
        const auto figures = evaluateLive(run);
        QVERIFY(!figures);
        QCOMPARE(figures.error().code, Errc::FileMalformed);
    }

    void anotherEndIsSeen_data()
    {
        QTest::addColumn<bool>("turned");
        QTest::newRow("of the turned object") << true;
        QTest::newRow("of the moved object") << false;
    }
    void anotherEndIsSeen()
    {
        QFETCH(bool, turned);
        LiveLog viewer = logOf(truthAt);
        auto& X = turned ? viewer.samples.back().X_AO_turned : viewer.samples.back().X_AO_moved;
        X = RigidTransform{X->rotation(), X->translation() + Vec3{0.0, 1e-12, 0.0}};
        const auto figures = evaluateLive(runWith(viewer));
        QVERIFY(figures);
        QVERIFY(!figures->isEndStateSame);
    }

    void handshakesAreOfTheParticipants()
    {
        LiveRun run = runWith(logOf(truthAt));
        run.host.handshake = 1h;
        run.participants[0].handshake = 100ms;
        run.participants[1].handshake = 300ms;
        const auto figures = evaluateLive(run);
        QVERIFY(figures->handshakeMean == 200ms && figures->handshakeMax == 300ms);
    }

    void incompleteLogsAreRefused_data()
    {
        QTest::addColumn<int>("what");
        QTest::addColumn<QByteArray>("who");
        QTest::newRow("nothing of the host") << 0 << QByteArray{"the host"};
        QTest::newRow("nothing of a viewer") << 1 << QByteArray{"participant 2"};
        QTest::newRow("begins late") << 2 << QByteArray{"participant 2"};
        QTest::newRow("ends early") << 3 << QByteArray{"participant 2"};
        QTest::newRow("object unknown at the end") << 4 << QByteArray{"participant 2"};
        QTest::newRow("an action too few") << 5 << QByteArray{"participant 1"};
        QTest::newRow("an action without a start") << 6 << QByteArray{"participant 1"};
    }
    void incompleteLogsAreRefused()
    {
        QFETCH(int, what);
        QFETCH(QByteArray, who);
        LiveRun run = runWith(logOf(truthAt));
        std::vector<LiveSample>& seen = run.participants[1].samples;
        if (what == 0)
            run.host.samples.clear();
        if (what == 1)
            seen.clear();
        if (what == 2)
            std::erase_if(seen, [](const auto& sample) { return sample.machine <= kBegin; });
        if (what == 3)
            std::erase_if(seen, [](const auto& sample) {
                return sample.machine >= kBegin + ActionScript::startOf(kActions);
            });
        if (what == 4)
            seen.back().X_AO_moved.reset();
        if (what == 5)
            run.participants[0].actions.pop_back();
        if (what == 6)
            run.participants[0].actions[2].movedSince = {};
        const auto figures = evaluateLive(run);
        QVERIFY(!figures);
        QCOMPARE(figures.error().code, Errc::FileMalformed);
        QVERIFY(figures.error().detail.find(who.toStdString()) != std::string::npos);
    }
};

CARINA_TEST(LiveEvaluationTest)

} // namespace carina::lab::live_evaluation_test

#include "tst_live_evaluation.moc"
