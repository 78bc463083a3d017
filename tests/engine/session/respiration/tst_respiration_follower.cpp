#include "engine/session/respiration/respiration_follower.h"

#include "tests/engine/session/facts/sample_session.h"
#include "tests/support/test_class.h"

#include <random>

namespace carina::test::respiration_follower_test
{

/// Truth is a run from the first moment that nobody asks in between.
class TestRespirationFollower : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void answersAsARunOfItsOwnDoes();
    void takesOnlyTheStepsOfAFrame();
    void goesBackWhenAskedForBefore();
    void makesGoodADecisionThatComesLate_data();
    void makesGoodADecisionThatComesLate();
    void standsOnTheNewestCheckpoint();
    void forgetsACheckpointThatADecisionMakesVoid();
    void breathesNoMoreThanAMinuteOfAGap();
    void meetsAPatientAsItWasDecidedBeforeTheStart();
};

namespace
{

LogWriter runningSession()
{
    LogWriter writer = sampleSession();
    writer.add(atSeconds(1.0), fact::PhaseChanged{SessionPhase::Running});
    writer.add(atSeconds(6.0), fact::BreathingRateSet{perMinute(26.0)});
    writer.add(atSeconds(8.0), fact::LungConditionsSet{{{ConditionKind::Asthma, 0.6, {}}}});
    return writer;
}

RespiratoryState stateAt(const RespirationTimeline& timeline, double seconds)
{
    PatientRun run{timeline, SessionTime::min()};
    run.advanceTo(timeline, atSeconds(seconds));
    return run.fold().state();
}

RespiratoryState followed(RespirationFollower& follower, const RespirationTimeline& timeline,
                          double seconds)
{
    return follower.at(timeline, atSeconds(seconds)).fold().state();
}

} // namespace

void TestRespirationFollower::answersAsARunOfItsOwnDoes()
{
    const SessionState state = stateOf(runningSession());
    RespirationFollower follower;
    std::mt19937 random{7};
    std::uniform_real_distribution<double> frame{0.0, 0.1};
    for (double seconds = 0.0; seconds < 15.0; seconds += frame(random))
        followed(follower, timelineOf(state), seconds);
    QVERIFY(followed(follower, timelineOf(state), 15.0) == stateAt(timelineOf(state), 15.0));
}

void TestRespirationFollower::takesOnlyTheStepsOfAFrame()
{
    const SessionState state = stateOf(runningSession());
    RespirationFollower follower;
    const PatientRun& run = follower.at(timelineOf(state), atSeconds(10.0));
    const PatientRun* place = &run;
    QCOMPARE(run.fold().state().steps, std::int64_t{4500});
    const PatientRun& next = follower.at(timelineOf(state), atSeconds(10.016));
    QCOMPARE(&next, place);
    QCOMPARE(next.fold().state().steps, std::int64_t{4508});
    QVERIFY(next.at() == atSeconds(10.016));
}

void TestRespirationFollower::goesBackWhenAskedForBefore()
{
    const SessionState state = stateOf(runningSession());
    RespirationFollower follower;
    for (double seconds = 2.0; seconds < 12.0; seconds += 0.02)
        followed(follower, timelineOf(state), seconds);
    for (const double seconds : {11.9, 11.2, 7.0, 1.5, 0.5, 12.5})
        QVERIFY(followed(follower, timelineOf(state), seconds)
                == stateAt(timelineOf(state), seconds));
}

void TestRespirationFollower::makesGoodADecisionThatComesLate_data()
{
    QTest::addColumn<double>("from");
    QTest::newRow("by a frame") << 10.985;
    QTest::newRow("by more than the older run is behind") << 9.0;
    QTest::newRow("before the session runs") << 0.5;
    QTest::newRow("not at all") << 11.0;
}

void TestRespirationFollower::makesGoodADecisionThatComesLate()
{
    QFETCH(const double, from);
    LogWriter writer = runningSession();
    SessionState state = stateOf(writer);
    RespirationFollower follower;
    for (double seconds = 0.0; seconds <= 11.0; seconds += 1.0 / 64)
        followed(follower, timelineOf(state), seconds);
    state.apply(writer.add(atSeconds(from), fact::TidalVolumeSet{millilitres(150.0)}));
    QVERIFY(followed(follower, timelineOf(state), 11.02) == stateAt(timelineOf(state), 11.02));
    QVERIFY(followed(follower, timelineOf(state), 14.0) == stateAt(timelineOf(state), 14.0));
}

/// The host's figures count: here those of a breath that nobody else computed.
void TestRespirationFollower::standsOnTheNewestCheckpoint()
{
    LogWriter writer = runningSession();
    SessionState state = stateOf(writer);
    RespirationFollower follower;
    followed(follower, timelineOf(state), 10.02);
    PatientRun run{timelineOf(state), SessionTime::min()};
    run.advanceTo(timelineOf(state), atSeconds(10.0));
    auto [first, capnograph, body] = run.checkpoint();
    auto& checkpoint = std::get<fact::RespirationCheckpoint>(first);
    checkpoint.state.content[0].gas = checkpoint.state.content[0].gas + millilitres(1.0);
    for (const FactBody& part : {first, capnograph}) {
        state.apply(writer.add(atSeconds(10.0), part));
        QVERIFY(!timelineOf(state).checkpointBefore(atSeconds(20.0))); // the body is to come
    }
    state.apply(writer.add(atSeconds(10.0), body));
    RespiratoryFold fold{timelineOf(state).settingsAt(atSeconds(10.0)), checkpoint.state};
    for (int i = 0; i < 20; ++i)
        fold.step();
    QVERIFY(followed(follower, timelineOf(state), 10.04) == fold.state());
}

// A night after the checkpoint, a minute is breathed from it; what was decided in the night counts.
void TestRespirationFollower::breathesNoMoreThanAMinuteOfAGap()
{
    LogWriter writer = runningSession();
    SessionState state = stateOf(writer);
    PatientRun run{timelineOf(state), SessionTime::min()};
    run.advanceTo(timelineOf(state), atSeconds(10.0));
    for (const FactBody& part : run.checkpoint())
        state.apply(writer.add(atSeconds(10.0), part));
    const auto minuteAfter = [&](RespiratoryState from, double seconds) {
        RespiratoryFold fold{timelineOf(state).settingsAt(atSeconds(seconds)), from};
        for (int i = 0; i < 30'000; ++i)
            fold.step();
        return fold.state();
    };
    RespirationFollower follower;
    const RespiratoryState morning = minuteAfter(run.fold().state(), 10.0);
    QVERIFY(followed(follower, timelineOf(state), 36'000.0) == morning);

    state.apply(writer.add(atSeconds(18'000.0), fact::PhaseChanged{SessionPhase::Paused}));
    RespirationFollower late;
    QVERIFY(followed(late, timelineOf(state), 36'000.0) == morning);
}

void TestRespirationFollower::forgetsACheckpointThatADecisionMakesVoid()
{
    LogWriter writer = runningSession();
    SessionState state = stateOf(writer);
    PatientRun run{timelineOf(state), SessionTime::min()};
    run.advanceTo(timelineOf(state), atSeconds(10.0));
    for (const FactBody& part : run.checkpoint())
        state.apply(writer.add(atSeconds(10.0), part));
    QVERIFY(timelineOf(state).checkpointBefore(atSeconds(20.0)));
    state.apply(writer.add(atSeconds(10.0), fact::TidalVolumeSet{millilitres(150.0)}));
    QVERIFY(timelineOf(state).checkpointBefore(atSeconds(20.0)));
    state.apply(writer.add(atSeconds(9.0), fact::TidalVolumeSet{millilitres(160.0)}));
    QVERIFY(!timelineOf(state).checkpointBefore(atSeconds(20.0)));
}

void TestRespirationFollower::meetsAPatientAsItWasDecidedBeforeTheStart()
{
    LogWriter writer = sampleSession();
    const PatientBuild adult{metres(1.75), 77.0, 40.0, Sex::Male};
    writer.add(atSeconds(0.5), fact::PatientBuildSet{adult});
    writer.add(atSeconds(0.6), fact::LungConditionsSet{{{ConditionKind::Copd, 0.9, {}}}});
    const SessionState prepared = stateOf(writer);
    RespirationFollower follower;
    RespiratorySettings settings;
    settings.build = adult;
    settings.conditions = {{ConditionKind::Copd, 0.9, {}}};
    QVERIFY(followed(follower, timelineOf(prepared), 0.9) == RespiratoryFold{settings}.state());
    writer.add(atSeconds(1.0), fact::PhaseChanged{SessionPhase::Running});
    const SessionState running = stateOf(writer);
    RespiratoryFold fold{settings};
    fold.step();
    QVERIFY(followed(follower, timelineOf(running), 1.002) == fold.state());
}

CARINA_TEST(TestRespirationFollower)

} // namespace carina::test::respiration_follower_test

#include "tst_respiration_follower.moc"
