#include "engine/session/respiration/patient_run.h"

#include "tests/engine/session/facts/sample_session.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <numbers>

namespace carina::test::patient_run_test
{

namespace
{

/// A session in which much happens to its patient.
LogWriter eventfulSession()
{
    LogWriter writer = sampleSession();
    writer.add(atSeconds(1.0), fact::PhaseChanged{SessionPhase::Running});
    writer.add(atSeconds(1.0), fact::PatientBuildSet{{metres(1.75), 77.0, 40.0, Sex::Male}});
    writer.add(atSeconds(3.0), fact::BreathingRateSet{perMinute(14.0)});
    for (int i = 0; i < 6; ++i)
        writer.add(atSeconds(4.0 + 3.1 * i), fact::ManikinBreathed{atSeconds(3.85 + 3.1 * i)});
    writer.add(atSeconds(20.5003), fact::PhaseChanged{SessionPhase::Paused});
    writer.add(atSeconds(25.1), fact::TubePlaced{{TubeSeat::Trachea, millimetres(7.5)}});
    writer.add(atSeconds(26.0), fact::PhaseChanged{SessionPhase::Running});
    writer.add(atSeconds(27.0), fact::BodyPositionSet{BodyPosition::LeftLateral});
    fact::VentilatorSet ventilator;
    ventilator.settings.mode = VentilationMode::VolumeControl;
    writer.add(atSeconds(28.0), ventilator);
    writer.add(atSeconds(29.0), fact::TidalVolumeSet{millilitres(500.0)});
    writer.add(atSeconds(30.0), fact::LungConditionsSet{{{ConditionKind::TensionPneumothorax, 0.8,
                                                          ConditionSide::Right}}});
    return writer;
}

PatientRun ranTo(const SessionState& state, double seconds)
{
    PatientRun run{timelineOf(state), atSeconds(seconds)};
    run.advanceTo(timelineOf(state), atSeconds(seconds));
    return run;
}

} // namespace

class TestPatientRun : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void restsUntilTheSessionRuns();
    void takesOneStepEveryTwoMilliseconds();
    void standsStillInAPause();
    void takesEverySettingAtItsTime();
    void locksToTheManikin();
    void doesNotDependOnHowOftenItIsAsked();
    void goesOnFromACheckpoint_data();
    void goesOnFromACheckpoint();
    void doesNotBelieveOldOrFutureBreaths();
    void keepsCheckpointsInOrder();
    void keepsTheLatestCheckpoints();
    void tellsDosesOfLongAgo();
    void keepsTheSettingsSinceTheFirstCheckpoint();
    void keepsTheBreathsSinceTheFirstCheckpoint();
    void saysFromWhenOnNewDecisionsHaveAnEffect();
    void namesTheNextChange();
};

void TestPatientRun::restsUntilTheSessionRuns()
{
    const SessionState state = stateOf(eventfulSession());
    const PatientRun run = ranTo(state, 1.0);
    QCOMPARE(run.fold().state().steps, std::int64_t{0});
    QCOMPARE(ranTo(state, 1.0019).fold().state().steps, std::int64_t{0});
    QCOMPARE(ranTo(state, 1.002).fold().state().steps, std::int64_t{1});
    QVERIFY(ranTo(state, 1.002).at() == atSeconds(1.002));
}

void TestPatientRun::takesOneStepEveryTwoMilliseconds()
{
    const SessionState state = stateOf(eventfulSession());
    QCOMPARE(ranTo(state, 11.0).fold().state().steps, std::int64_t{5000});
    QCOMPARE(ranTo(state, 11.0).fold().settings().pattern.rate, perMinute(14.0));
}

/// From the step in which it pauses to the moment it goes on.
void TestPatientRun::standsStillInAPause()
{
    const SessionState state = stateOf(eventfulSession());
    const std::int64_t paused = ranTo(state, 20.51).fold().state().steps;
    QCOMPARE(paused, std::int64_t{9751}); // 19.5003 s
    QCOMPARE(ranTo(state, 25.9).fold().state().steps, paused);
    QCOMPARE(ranTo(state, 26.0).fold().state().steps, paused);
    QCOMPARE(ranTo(state, 26.01).fold().state().steps, paused + 5);
    QVERIFY(ranTo(state, 26.01).at() == atSeconds(26.01));
}

void TestPatientRun::takesEverySettingAtItsTime()
{
    const SessionState state = stateOf(eventfulSession());
    const auto settingsAt = [&](double seconds) { return ranTo(state, seconds).fold().settings(); };
    QVERIFY(settingsAt(2.0).build == (PatientBuild{metres(1.75), 77.0, 40.0, Sex::Male}));
    QCOMPARE(settingsAt(2.0).pattern.rate, BreathingPattern{}.rate);
    QCOMPARE(settingsAt(26.5).tube, millimetres(7.5));
    QCOMPARE(settingsAt(26.9).position, BodyPosition::Supine);
    QCOMPARE(settingsAt(27.1).position, BodyPosition::LeftLateral);
    QVERIFY(settingsAt(27.9).ventilator.mode == VentilationMode::Spontaneous);
    QVERIFY(settingsAt(28.1).ventilator.mode == VentilationMode::VolumeControl);
    QCOMPARE(settingsAt(29.1).pattern.tidalVolume, millilitres(500.0));
    QVERIFY(settingsAt(29.9).conditions.empty());
    QVERIFY(settingsAt(30.1).conditions.front().kind == ConditionKind::TensionPneumothorax);
    QVERIFY(ranTo(state, 60.0).fold().content()[0].trapped.si > 0.0);

    LogWriter untold = sampleSession();
    untold.add(atSeconds(0.0), fact::PhaseChanged{SessionPhase::Running});
    const SessionState plain = stateOf(untold);
    QVERIFY(ranTo(plain, 1.0).fold().settings().build
            == (PatientBuild{metres(1.5), 40.0, 12.0, Sex::Female}));
}

/// Breaths every 3.1 s; the last one heard of began at 19.35 s.
void TestPatientRun::locksToTheManikin()
{
    const SessionState state = stateOf(eventfulSession());
    const BreathClock::State clock = ranTo(state, 20.4).fold().state().clock;
    QVERIFY(std::abs(inPerMinute(clock.measured) - 60.0 / 3.1) < 0.05);
    const double phase = clock.breaths - (20.4 - 19.35) * clock.rate.si;
    QVERIFY2(std::abs(phase - std::round(phase)) < 0.05, qPrintable(QString::number(phase)));
}

void TestPatientRun::doesNotDependOnHowOftenItIsAsked()
{
    const SessionState state = stateOf(eventfulSession());
    PatientRun often{timelineOf(state), atSeconds(0.0)};
    for (double seconds = 0.0; seconds < 40.0; seconds += 0.0166)
        often.advanceTo(timelineOf(state), atSeconds(seconds));
    often.advanceTo(timelineOf(state), atSeconds(40.0));
    const PatientRun once = ranTo(state, 40.0);
    QVERIFY(once.at() == often.at());
    QVERIFY(once.fold().state() == often.fold().state());
}

void TestPatientRun::goesOnFromACheckpoint_data()
{
    QTest::addColumn<double>("seconds");
    QTest::newRow("before it runs") << 0.5;
    QTest::newRow("as a breath is heard") << 10.2;
    QTest::newRow("just after one is heard") << 10.202;
    QTest::newRow("in the pause") << 22.0;
    QTest::newRow("under the ventilator") << 33.3;
}

/// Who joins late and finds a checkpoint comes to the same state as who was there.
void TestPatientRun::goesOnFromACheckpoint()
{
    QFETCH(const double, seconds);
    LogWriter writer = eventfulSession();
    const PatientRun there = ranTo(stateOf(writer), seconds);
    for (const FactBody& part : there.checkpoint())
        writer.add(atSeconds(35.0), part);
    const SessionState state = stateOf(writer);
    PatientRun late{timelineOf(state), atSeconds(38.0)};
    QVERIFY(late.at() == there.at());
    late.advanceTo(timelineOf(state), atSeconds(40.0));
    const PatientRun whole = ranTo(stateOf(eventfulSession()), 40.0);
    QVERIFY(late.at() == whole.at());
    QVERIFY(late.fold().state() == whole.fold().state());
    QVERIFY(late.body().state() == whole.body().state());
}

void TestPatientRun::doesNotBelieveOldOrFutureBreaths()
{
    LogWriter writer = sampleSession();
    writer.add(atSeconds(10.0), fact::ManikinBreathed{atSeconds(10.1)});
    writer.add(atSeconds(11.0), fact::ManikinBreathed{atSeconds(5.9)});
    writer.add(atSeconds(12.0), fact::ManikinBreathed{atSeconds(7.0)});
    writer.add(atSeconds(13.0), fact::ManikinBreathed{atSeconds(13.0)});
    writer.add(atSeconds(12.5), fact::ManikinBreathed{atSeconds(12.4)}); // heard out of order
    const SessionState state = stateOf(writer);
    const auto breaths = timelineOf(state).breaths();
    QCOMPARE(breaths.size(), std::size_t{2});
    QVERIFY(breaths[0].began == atSeconds(7.0) && breaths[0].heard == atSeconds(12.0));
    QVERIFY(breaths[1].began == atSeconds(13.0));
}

void TestPatientRun::keepsCheckpointsInOrder()
{
    RespirationTimeline timeline;
    QVERIFY(timeline.checkpointBefore(SessionTime::max()) == nullptr);
    RespiratoryState state;
    for (const double seconds : {10.0, 20.0, 20.0, 15.0}) {
        ++state.steps;
        timeline.addCheckpoint({atSeconds(seconds), state});
    }
    QVERIFY(timeline.checkpointBefore(atSeconds(9.9)) == nullptr);
    QCOMPARE(timeline.checkpointBefore(atSeconds(10.0))->state.steps, std::int64_t{1});
    QCOMPARE(timeline.checkpointBefore(atSeconds(19.9))->state.steps, std::int64_t{1});
    QCOMPARE(timeline.checkpointBefore(atSeconds(99.0))->state.steps, std::int64_t{2});
}

void TestPatientRun::keepsTheLatestCheckpoints()
{
    RespirationTimeline timeline;
    constexpr int kCheckpoints = 1000;
    for (int i = 1; i <= kCheckpoints; ++i)
        timeline.addCheckpoint({atSeconds(10.0 * i), RespiratoryState{.steps = i}});
    constexpr int kOldest = kCheckpoints - int(RespirationTimeline::kMostCheckpoints) + 1;
    QVERIFY(timeline.checkpointBefore(atSeconds(10.0 * kOldest - 0.1)) == nullptr);
    for (int i = kOldest; i <= kCheckpoints; ++i)
        QCOMPARE(timeline.checkpointBefore(atSeconds(10.0 * i))->state.steps, std::int64_t{i});
}

/// A try lasts longer than checkpoints are kept; who gives without end makes no copy longer.
void TestPatientRun::tellsDosesOfLongAgo()
{
    constexpr int kCheckpoints = 30;
    constexpr int kBetween = 10;
    const auto all = [](const RespirationTimeline& timeline) {
        return timeline.dosesWithin(SessionTime::min(), SessionTime::max());
    };
    RespirationTimeline once;
    RespirationTimeline often;
    once.give(atSeconds(1.0), {DrugKind::Propofol, 80.0});
    for (int i = 1; i <= kCheckpoints; ++i) {
        for (int dose = 0; dose < kBetween; ++dose)
            often.give(atSeconds(10.0 * i - 5.0 + 0.1 * dose), {DrugKind::Fentanyl, 0.01});
        once.addCheckpoint({atSeconds(10.0 * i), RespiratoryState{.steps = i}});
        often.addCheckpoint({atSeconds(10.0 * i), RespiratoryState{.steps = i}});
    }
    QCOMPARE(all(once).size(), std::size_t{1});
    QVERIFY(all(often).size() >= RespirationTimeline::kMostDosesTold);
    QVERIFY(all(often).size() <= RespirationTimeline::kMostDosesTold + kBetween);
    QCOMPARE(all(often).back().from, atSeconds(10.0 * kCheckpoints - 5.0 + 0.1 * (kBetween - 1)));
}

/// An instructor who changed a setting without end made each copy of the session longer.
void TestPatientRun::keepsTheSettingsSinceTheFirstCheckpoint()
{
    constexpr int kCheckpoints = 100;
    constexpr int kOldest = kCheckpoints - int(RespirationTimeline::kMostCheckpoints) + 1;
    const auto rateOf = [](int i) { return perMinute(10.0 + i % 7); };
    RespirationTimeline timeline;
    timeline.setRunning(atSeconds(1.0), true);
    for (int i = 1; i <= kCheckpoints; ++i) {
        timeline.setRate(atSeconds(10.0 * i - 5.0), rateOf(i));
        timeline.addCheckpoint({atSeconds(10.0 * i), RespiratoryState{.steps = i}});
    }
    QVERIFY(timeline.changeAfter(SessionTime::min()) >= atSeconds(1.0));
    QVERIFY(timeline.changeAfter(atSeconds(1.0)) == atSeconds(10.0 * kOldest - 5.0));
    for (int i = kOldest; i <= kCheckpoints; ++i) {
        QCOMPARE(timeline.settingsAt(atSeconds(10.0 * i)).pattern.rate.si, rateOf(i).si);
        QVERIFY(timeline.runsAt(atSeconds(10.0 * i)));
    }
}

/// A manikin breathes for hours.
void TestPatientRun::keepsTheBreathsSinceTheFirstCheckpoint()
{
    constexpr int kCheckpoints = 100;
    constexpr int kOldest = kCheckpoints - int(RespirationTimeline::kMostCheckpoints) + 1;
    RespirationTimeline timeline;
    for (int i = 1; i <= kCheckpoints; ++i) {
        for (const double after : {1.0, 4.0, 7.0})
            timeline.addBreath({atSeconds(10.0 * i + after), atSeconds(10.0 * i + after - 0.2)});
        timeline.addCheckpoint({atSeconds(10.0 * i), RespiratoryState{.steps = i}});
    }
    QVERIFY(timeline.breaths().size() <= 3 * (RespirationTimeline::kMostCheckpoints + 1));
    const auto kept =
        timeline.breathsHeard(atSeconds(10.0 * kOldest), atSeconds(10.0 * kCheckpoints + 4.0));
    QCOMPARE(kept.size(), 3 * RespirationTimeline::kMostCheckpoints - 1);
    QVERIFY(kept.front().heard == atSeconds(10.0 * kOldest + 1.0));
    QVERIFY(kept.back().heard == atSeconds(10.0 * kCheckpoints + 4.0));
}

void TestPatientRun::saysFromWhenOnNewDecisionsHaveAnEffect()
{
    RespirationTimeline timeline;
    timeline.setRate(atSeconds(5.0), perMinute(12.0));
    const std::size_t known = timeline.decisions();
    QVERIFY(timeline.effectSince(known) == SessionTime::max());
    timeline.setRate(atSeconds(9.0), perMinute(13.0));
    timeline.setRate(atSeconds(7.0), perMinute(14.0));
    QVERIFY(timeline.effectSince(known) == atSeconds(7.0));
    QVERIFY(timeline.effectSince(known + 2) == SessionTime::max());
    QVERIFY(timeline.effectSince(known + 3) == SessionTime::min()); // of another patient
    for (std::size_t i = 0; i < RespirationTimeline::kMostDecisions; ++i)
        timeline.setRate(atSeconds(10.0), perMinute(15.0));
    QCOMPARE(timeline.decisions(), known + 2 + RespirationTimeline::kMostDecisions);
    QVERIFY(timeline.effectSince(known) == SessionTime::min()); // not all are kept
    QVERIFY(timeline.effectSince(known + 2) == atSeconds(10.0));
}

void TestPatientRun::namesTheNextChange()
{
    const SessionState state = stateOf(eventfulSession());
    const RespirationTimeline& timeline = timelineOf(state);
    QVERIFY(timeline.changeAfter(atSeconds(0.0)) == atSeconds(1.0));
    QVERIFY(timeline.changeAfter(atSeconds(1.0)) == atSeconds(3.0));
    QVERIFY(timeline.changeAfter(atSeconds(20.5003)) == atSeconds(25.1));
    QVERIFY(timeline.changeAfter(atSeconds(25.1)) == atSeconds(26.0));
    QVERIFY(timeline.changeAfter(atSeconds(30.0)) == SessionTime::max());
    QVERIFY(timeline.changeAfter(atSeconds(3.0)) == atSeconds(20.5003));
    QVERIFY(timeline.changeAfter(atSeconds(26.0)) == atSeconds(27.0));
    QVERIFY(timeline.changeAfter(atSeconds(27.0)) == atSeconds(28.0));
    QVERIFY(timeline.changeAfter(atSeconds(28.0)) == atSeconds(29.0));
    QVERIFY(timeline.changeAfter(atSeconds(29.0)) == atSeconds(30.0));
    QVERIFY(timeline.runsAt(atSeconds(20.5)));
    QVERIFY(!timeline.runsAt(atSeconds(20.5003)));
}

CARINA_TEST(TestPatientRun)

} // namespace carina::test::patient_run_test

#include "tst_patient_run.moc"
