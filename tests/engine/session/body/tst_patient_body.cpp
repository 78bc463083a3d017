#include "engine/session/respiration/patient_run.h"
#include "engine/session/respiration/respiration_follower.h"
#include "tests/engine/session/facts/sample_session.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::test::patient_body_test
{

namespace
{

constexpr Length kTubeSize = millimetres(7.5);

void note(LogWriter& writer, double seconds, IntubationStep step, TubeSeat seat)
{
    writer.add(
        atSeconds(seconds),
        fact::IntubationNoted{{.step = step, .at = atSeconds(seconds), .seat = seat}, kTubeSize});
}

LogWriter runningAdult()
{
    LogWriter writer = sampleSession();
    writer.add(atSeconds(0.5), fact::PatientBuildSet{{metres(1.75), 77.0, 40.0, Sex::Male}});
    writer.add(atSeconds(1.0), fact::PhaseChanged{SessionPhase::Running});
    return writer;
}

/// Oxygen by a mask, an induction, a bag, a tube that goes into the oesophagus first and then too
/// deep; and a pause meanwhile.
LogWriter intubation()
{
    LogWriter writer = runningAdult();
    writer.add(atSeconds(3.0), fact::GasSupplySet{{1.0, true, true}});
    writer.add(atSeconds(8.001), fact::DrugGiven{{DrugKind::Fentanyl, 0.2}});
    writer.add(atSeconds(9.0), fact::DrugGiven{{DrugKind::Propofol, 150.0}});
    writer.add(atSeconds(9.0), fact::DrugGiven{{DrugKind::Suxamethonium, 100.0}});
    writer.add(atSeconds(12.0), fact::BagSqueezed{{perMinute(15.0), millilitres(450.0)}});
    writer.add(atSeconds(20.5003), fact::PhaseChanged{SessionPhase::Paused});
    writer.add(atSeconds(22.0), fact::DrugGiven{{DrugKind::Ephedrine, 10.0}});
    writer.add(atSeconds(26.0), fact::PhaseChanged{SessionPhase::Running});
    note(writer, 28.0, IntubationStep::BladeIn, TubeSeat::None);
    note(writer, 30.0, IntubationStep::TubePastTeeth, TubeSeat::None);
    note(writer, 32.0, IntubationStep::InOesophagus, TubeSeat::Oesophagus);
    note(writer, 40.0, IntubationStep::OutOfOesophagus, TubeSeat::None);
    note(writer, 42.0, IntubationStep::ThroughCords, TubeSeat::Trachea);
    note(writer, 43.0, IntubationStep::PastCarina, TubeSeat::RightMain);
    note(writer, 44.0, IntubationStep::BladeOut, TubeSeat::RightMain);
    writer.add(atSeconds(45.0), fact::CuffSet{true});
    return writer;
}

PatientRun ranTo(const SessionState& state, double seconds)
{
    PatientRun run{timelineOf(state), atSeconds(seconds)};
    run.advanceTo(timelineOf(state), atSeconds(seconds));
    return run;
}

/// All that is in the body of a drug but its effect site.
double amountOf(const PatientRun& run, DrugKind kind)
{
    const DrugAmounts& drug = run.body().state().drugs[static_cast<std::size_t>(kind)];
    return drug.vein_mg + drug.central_mg + drug.fast_mg + drug.slow_mg;
}

} // namespace

class TestPatientBody : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesOneStepEveryTwentyMilliseconds();
    void standsStillInAPause();
    void givesEachDoseAtItsTime();
    void givesWhatWasDecidedBeforeTheStart();
    void isAnotherPatientAtOneTimeHoweverOftenItIsAsked();
    void takesGasTubeAndBladeAtTheirTimes();
    void breathesAloneWhileTheTubeIsInTheOesophagus();
    void letsTheConsoleOverrideTheMonitor();
    void losesItsOwnBreathingByDrugs();
    void coughsAgainstATubeInTooLightASleep();
    void doesNotCoughByDrugsThatAreNoAnaesthetics();
    void doesNotDependOnHowOftenItIsAsked();
    void isTheSameForALateJoiner_data();
    void isTheSameForALateJoiner();
    void waitsForAllPartsOfACheckpoint();
    void isMadeGoodAfterADoseThatComesLate();
};

void TestPatientBody::takesOneStepEveryTwentyMilliseconds()
{
    const SessionState state = stateOf(runningAdult());
    QCOMPARE(ranTo(state, 1.0).body().state().steps, std::int64_t{0});
    QCOMPARE(ranTo(state, 1.019).body().state().steps, std::int64_t{0});
    QCOMPARE(ranTo(state, 1.02).body().state().steps, std::int64_t{1});
    QCOMPARE(ranTo(state, 11.0).body().state().steps, std::int64_t{500});
}

void TestPatientBody::standsStillInAPause()
{
    const SessionState state = stateOf(intubation());
    const std::int64_t paused = ranTo(state, 20.51).body().state().steps;
    QCOMPARE(paused, std::int64_t{975}); // 19.5003 s
    QVERIFY(ranTo(state, 25.9).vitals() == ranTo(state, 20.51).vitals());
    QCOMPARE(ranTo(state, 26.5).body().state().steps, paused + 25);
}

void TestPatientBody::givesEachDoseAtItsTime()
{
    const SessionState state = stateOf(intubation());
    QCOMPARE(amountOf(ranTo(state, 8.0), DrugKind::Fentanyl), 0.0);
    const double given = amountOf(ranTo(state, 8.01), DrugKind::Fentanyl);
    QVERIFY2(std::abs(given - 0.2) < 1e-3, qPrintable(QString::number(given))); // mg
    QCOMPARE(amountOf(ranTo(state, 9.0), DrugKind::Propofol), 0.0);
    QVERIFY(amountOf(ranTo(state, 9.01), DrugKind::Propofol) > 149.0);
    QVERIFY(amountOf(ranTo(state, 9.01), DrugKind::Suxamethonium) > 99.0);
    QVERIFY(amountOf(ranTo(state, 26.01), DrugKind::Ephedrine) > 9.9); // given in the pause
    QCOMPARE(amountOf(ranTo(state, 60.0), DrugKind::Rocuronium), 0.0);
}

/// Also where the patient is another one after the dose.
void TestPatientBody::givesWhatWasDecidedBeforeTheStart()
{
    LogWriter writer = sampleSession();
    writer.add(atSeconds(0.2), fact::DrugGiven{{DrugKind::Propofol, 150.0}});
    writer.add(atSeconds(0.5), fact::PatientBuildSet{{metres(1.75), 77.0, 40.0, Sex::Male}});
    writer.add(atSeconds(1.0), fact::PhaseChanged{SessionPhase::Running});
    const SessionState state = stateOf(writer);
    RespirationFollower follower;
    for (double seconds = 0.0; seconds < 1.1; seconds += 0.07)
        follower.at(timelineOf(state), atSeconds(seconds));
    const PatientRun& run = follower.at(timelineOf(state), atSeconds(1.1));
    const double given = amountOf(run, DrugKind::Propofol);
    QVERIFY2(given > 149.0 && given < 150.01, qPrintable(QString::number(given))); // once
    QVERIFY(run.body().state() == ranTo(state, 1.1).body().state());
}

/// In a pause, and back again: the blood of another patient holds other amounts.
void TestPatientBody::isAnotherPatientAtOneTimeHoweverOftenItIsAsked()
{
    LogWriter writer = runningAdult();
    const PatientBuild infant{metres(0.75), 10.0, 1.0, Sex::Female};
    writer.add(atSeconds(5.0), fact::PhaseChanged{SessionPhase::Paused});
    writer.add(atSeconds(6.0), fact::PatientBuildSet{infant});
    writer.add(atSeconds(7.0), fact::PatientBuildSet{{metres(1.75), 77.0, 40.0, Sex::Male}});
    writer.add(atSeconds(8.0), fact::PhaseChanged{SessionPhase::Running});
    writer.add(atSeconds(9.0), fact::PatientBuildSet{infant});
    const SessionState state = stateOf(writer);
    PatientRun often{timelineOf(state), atSeconds(0.0)};
    for (double seconds = 0.5; seconds <= 12.0; seconds += 0.5)
        often.advanceTo(timelineOf(state), atSeconds(seconds));
    QVERIFY(often.body().state() == ranTo(state, 12.0).body().state());
    LogWriter later = writer;
    for (const FactBody& part : ranTo(state, 9.0).checkpoint())
        later.add(atSeconds(10.0), part);
    const SessionState kept = stateOf(later);
    PatientRun late{timelineOf(kept), atSeconds(12.0)};
    QVERIFY(late.at() == atSeconds(9.0));
    late.advanceTo(timelineOf(kept), atSeconds(12.0));
    QVERIFY(late.body().state() == often.body().state());
}

void TestPatientBody::takesGasTubeAndBladeAtTheirTimes()
{
    const SessionState state = stateOf(intubation());
    const auto settingsAt = [&](double seconds) { return ranTo(state, seconds).body().settings(); };
    QVERIFY(settingsAt(2.9).gas == GasSupply{});
    QVERIFY(settingsAt(3.1).gas == (GasSupply{1.0, true, true}));
    QVERIFY(!settingsAt(27.9).bladeInMouth);
    QVERIFY(settingsAt(28.1).bladeInMouth);
    QVERIFY(!settingsAt(44.1).bladeInMouth);
    QVERIFY(settingsAt(31.0).tube == TubePlace{}); // above the cords
    QCOMPARE(settingsAt(42.1).tube.seat, TubeSeat::Trachea);
    QCOMPARE(settingsAt(43.1).tube.seat, TubeSeat::RightMain);
    QVERIFY(settingsAt(44.9).tube.leak > 0.0);
    QCOMPARE(settingsAt(45.1).tube.leak, 0.0);
    const auto deep = ranTo(state, 43.1).fold().settings().conditions;
    QVERIFY(deep
            == (LungConditions{{ConditionKind::MainstemIntubation, 1.0, ConditionSide::Right}}));
}

void TestPatientBody::breathesAloneWhileTheTubeIsInTheOesophagus()
{
    LogWriter writer = runningAdult();
    writer.add(atSeconds(2.0), fact::BagSqueezed{{perMinute(15.0), millilitres(450.0)}});
    note(writer, 4.0, IntubationStep::InOesophagus, TubeSeat::Oesophagus);
    const SessionState state = stateOf(writer);
    QVERIFY(ranTo(state, 3.9).fold().isVentilated()); // nobody watched a tube
    const PatientRun wrong = ranTo(state, 20.0);
    QVERIFY(!wrong.fold().isVentilated());
    QVERIFY(!wrong.fold().isStill());
    QVERIFY(wrong.fold().lastBreath().tidalVolume > millilitres(100.0));
    QCOMPARE(wrong.body().settings().stomachBreaths, perMinute(15.0));
    QCOMPARE(wrong.fold().settings().tube, Length{});
}

void TestPatientBody::letsTheConsoleOverrideTheMonitor()
{
    LogWriter writer = runningAdult();
    writer.add(atSeconds(2.0), fact::BagSqueezed{{perMinute(15.0), millilitres(450.0)}});
    note(writer, 4.0, IntubationStep::InOesophagus, TubeSeat::Oesophagus);
    writer.add(atSeconds(6.0), fact::TubePlaced{{TubeSeat::Trachea, millimetres(8.0)}});
    writer.add(atSeconds(8.0), fact::TubePlaced{});
    const SessionState state = stateOf(writer);
    QVERIFY(!ranTo(state, 5.9).fold().isVentilated());
    QVERIFY(ranTo(state, 6.1).fold().isVentilated());
    QCOMPARE(ranTo(state, 6.1).fold().settings().tube, millimetres(8.0));
    QVERIFY(timelineOf(state).tube().isOverriddenAt(atSeconds(6.1)));
    QVERIFY(!ranTo(state, 8.1).fold().isVentilated());
    QVERIFY(!timelineOf(state).tube().isOverriddenAt(atSeconds(8.1)));
}

void TestPatientBody::losesItsOwnBreathingByDrugs()
{
    LogWriter writer = runningAdult();
    writer.add(atSeconds(5.0), fact::DrugGiven{{DrugKind::Propofol, 200.0}});
    writer.add(atSeconds(5.0), fact::DrugGiven{{DrugKind::Rocuronium, 80.0}});
    const SessionState state = stateOf(writer);
    QCOMPARE(ranTo(state, 5.0).fold().settings().ownBreathing, 1.0);
    PatientRun run = ranTo(state, 5.0);
    for (double seconds = 5.0; seconds < 120.0; seconds += 0.5) {
        run.advanceTo(timelineOf(state), atSeconds(seconds));
        const double shares = run.fold().settings().ownBreathing / kBodyShare;
        QCOMPARE(shares, std::round(shares));
        QVERIFY(std::abs(shares * kBodyShare - run.body().breathingLeft()) <= 0.5 * kBodyShare);
    }
    QCOMPARE(run.fold().settings().ownBreathing, 0.0);
    QVERIFY(run.fold().isStill());
}

/// By the tone that is left, until a relaxant takes it.
void TestPatientBody::coughsAgainstATubeInTooLightASleep()
{
    LogWriter writer = runningAdult();
    writer.add(atSeconds(3.0), fact::BagSqueezed{{perMinute(15.0), millilitres(450.0)}});
    note(writer, 5.0, IntubationStep::ThroughCords, TubeSeat::Trachea);
    writer.add(atSeconds(20.0), fact::DrugGiven{{DrugKind::Propofol, 80.0}});
    writer.add(atSeconds(60.0), fact::DrugGiven{{DrugKind::Suxamethonium, 100.0}});
    const SessionState state = stateOf(writer);
    const PatientRun before = ranTo(state, 19.0);
    QVERIFY(before.body().coughs());
    QCOMPARE(before.fold().settings().cough, 0.0); // no drug acts
    const PatientRun light = ranTo(state, 58.0);
    QVERIFY(light.body().coughs());
    QVERIFY(std::abs(light.fold().settings().cough - light.body().tone()) <= 0.5 * kBodyShare);
    QVERIFY(light.fold().settings().cough > 0.2 && light.fold().settings().cough < 1.0);
    QVERIFY(light.fold().lastBreath().peak > before.fold().lastBreath().peak + cmH2O(3.0));
    QCOMPARE(ranTo(state, 150.0).fold().settings().cough, 0.0);
}

void TestPatientBody::doesNotCoughByDrugsThatAreNoAnaesthetics()
{
    LogWriter writer = runningAdult();
    note(writer, 5.0, IntubationStep::ThroughCords, TubeSeat::Trachea);
    writer.add(atSeconds(6.0), fact::DrugGiven{{DrugKind::Ephedrine, 10.0}});
    writer.add(atSeconds(6.0), fact::DrugGiven{{DrugKind::Fentanyl, 0.05}});
    const PatientRun run = ranTo(stateOf(writer), 40.0);
    QVERIFY(run.body().coughs()); // an awake one would
    QCOMPARE(run.fold().settings().cough, 0.0);
}

void TestPatientBody::doesNotDependOnHowOftenItIsAsked()
{
    const SessionState state = stateOf(intubation());
    PatientRun often{timelineOf(state), atSeconds(0.0)};
    for (double seconds = 0.0; seconds < 50.0; seconds += 0.0166)
        often.advanceTo(timelineOf(state), atSeconds(seconds));
    often.advanceTo(timelineOf(state), atSeconds(50.0));
    const PatientRun once = ranTo(state, 50.0);
    QVERIFY(once.body().state() == often.body().state());
    QVERIFY(once.fold().state() == often.fold().state());
}

void TestPatientBody::isTheSameForALateJoiner_data()
{
    QTest::addColumn<double>("seconds");
    QTest::newRow("before it runs") << 0.6;
    QTest::newRow("just before a dose") << 8.0;
    QTest::newRow("just after a dose") << 8.002;
    QTest::newRow("as two are given") << 9.0;
    QTest::newRow("between two steps of the body") << 13.506;
    QTest::newRow("in the pause") << 21.0;
    QTest::newRow("after a dose in the pause") << 24.0;
    QTest::newRow("in the oesophagus") << 36.0;
    QTest::newRow("in a main bronchus") << 46.0;
}

/// Who joins late and finds a checkpoint sees the same vitals to the last bit as who was there.
void TestPatientBody::isTheSameForALateJoiner()
{
    QFETCH(const double, seconds);
    LogWriter writer = intubation();
    const PatientRun there = ranTo(stateOf(writer), seconds);
    for (const FactBody& part : there.checkpoint())
        writer.add(atSeconds(48.0), part);
    const SessionState state = stateOf(writer);
    QVERIFY(timelineOf(state).checkpointBefore(atSeconds(50.0)) != nullptr);
    PatientRun late{timelineOf(state), atSeconds(50.0)};
    QVERIFY(late.at() == there.at());
    for (const double later : {50.0, 51.3, 60.0}) {
        late.advanceTo(timelineOf(state), atSeconds(later));
        const PatientRun whole = ranTo(stateOf(intubation()), later);
        QVERIFY(late.vitals() == whole.vitals());
        QVERIFY(late.body().state() == whole.body().state());
        QVERIFY(late.fold().state() == whole.fold().state());
        QVERIFY(late.fold().settings() == whole.fold().settings());
    }
}

void TestPatientBody::waitsForAllPartsOfACheckpoint()
{
    const LogWriter log = intubation();
    const auto parts = ranTo(stateOf(log), 46.0).checkpoint();
    const auto isComplete = [&](std::initializer_list<std::size_t> those) {
        LogWriter writer = log;
        for (const std::size_t part : those)
            writer.add(atSeconds(48.0), parts[part]);
        const SessionState state = stateOf(writer);
        return timelineOf(state).checkpointBefore(atSeconds(50.0)) != nullptr;
    };
    QVERIFY(isComplete({0, 1, 2}));
    QVERIFY(!isComplete({0, 1}));
    QVERIFY(!isComplete({0, 2}));
    QVERIFY(!isComplete({1, 2}));
    QVERIFY(!isComplete({1, 0, 2}));
}

void TestPatientBody::isMadeGoodAfterADoseThatComesLate()
{
    LogWriter writer = runningAdult();
    SessionState state = stateOf(writer);
    RespirationFollower follower;
    for (double seconds = 0.0; seconds <= 11.0; seconds += 1.0 / 64)
        follower.at(timelineOf(state), atSeconds(seconds));
    state.apply(writer.add(atSeconds(10.9), fact::DrugGiven{{DrugKind::Propofol, 150.0}}));
    const PatientRun& run = follower.at(timelineOf(state), atSeconds(12.0));
    QVERIFY(amountOf(run, DrugKind::Propofol) > 140.0);
    QVERIFY(run.body().state() == ranTo(state, 12.0).body().state());
}

CARINA_TEST(TestPatientBody)

} // namespace carina::test::patient_body_test

#include "tst_patient_body.moc"
