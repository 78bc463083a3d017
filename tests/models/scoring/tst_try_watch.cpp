#include "models/scoring/try_watch.h"

#include "tests/models/scoring/tried_session.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

namespace carina::try_watch_test
{
namespace
{

using test::FakeSessionNode;
using test::TriedSession;

} // namespace

class TestTryWatch : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void reportsATryOnceThePatientIsVentilated();
    void takesTheFirstBreathThatIsNoted();
    void takesTheCuffFromItsControl();
    void takesNoCuffFromATubeThatIsOut();
    void takesNoCuffFromBeforeTheTry();
    void judgesTheDepthByTheRuleOfThePatient();
    void takesEachNoteOnceAlsoOfATubeThatRestsAgain();
    void watchesTheOxygen();
    void countsMaskVentilationBefore();
    void countsMaskVentilationBeforeAPause();
    void takesTheForcesThatAreEstimated();
    void tellsATubeInTheOesophagusWhenAsked();
    void judgesNoTubeByWhatWasSetBefore();
    void judgesAnEndedTryAnewByWhatTheInstructorSays();
    void takesAConfirmationOfAnEndedTry();
    void judgesNoEndedTryByWhatIsSaidOfALaterPlace();
    void takesWhatIsConcludedLaterOfAnEndedTry();
    void judgesTheSameWheneverItLooks();
    void knowsATubeThatWasThereBeforeTheBlade();
    void believesTheInstructorAboutThePlace();
    void endsByAPersonAtEveryProgram();
    void endsOnceWhereTwoEndIt();
    void endsByItselfBeforeAPersonEndsIt();
    void endsWithTheSession();
    void isEndedByAnInstructorOrWhoIsAtWork();
    void reportsATryThatWasGivenUp();
    void forgetsTheReportWhenAnotherTryBegins();
    void findsATryThatBeganBeforeItLooked();
    void findsTheLastTryThatEndedBeforeItLooked();
    void findsTheTryOfAnotherStation();
    void countsNoPause();
    void knowsTheTubeOfATryOfLongAgo();
};

void TestTryWatch::reportsATryOnceThePatientIsVentilated()
{
    TriedSession session;
    const QSignalSpy ended{&session.tries, &TryWatch::ended};
    QVERIFY(!session.tries.isUnderWay());
    session.intubate();
    QVERIFY(session.tries.isUnderWay());
    QVERIFY(!session.tries.report());
    session.note(IntubationStep::FirstBreath, TubeSeat::Trachea, millimetres(200.0));
    session.run(std::chrono::seconds{30});
    QCOMPARE(ended.count(), 1);
    QVERIFY(!session.tries.isUnderWay());
    const TryReport& report = session.tries.report().value();
    QCOMPARE(report.metrics.outcome, TryOutcome::Trachea);
    QCOMPARE(report.metrics.attempts.size(), std::size_t{1});
    QCOMPARE(report.metrics.glotticOpening, 0.6);
    QCOMPARE(report.advice.size(), kAdviceGiven);
}

/// The monitor finds it; a bag alone proves nothing.
void TestTryWatch::takesTheFirstBreathThatIsNoted()
{
    TriedSession session;
    session.intubate();
    session.squeezeBag();
    session.run(std::chrono::seconds{30});
    QVERIFY(session.tries.isUnderWay());
    const SessionTime breath = *session.node.now();
    session.note(IntubationStep::FirstBreath, TubeSeat::Trachea, millimetres(200.0));
    session.endTry();
    QVERIFY(session.tries.report()->metrics.firstBreath == breath);
}

void TestTryWatch::takesTheCuffFromItsControl()
{
    TriedSession session;
    session.intubate();
    session.node.decide(fact::CuffSet{true});
    session.run(std::chrono::seconds{1});
    session.endTry();
    QVERIFY(session.tries.report()->metrics.cuffInflated);
}

/// Its cuff is empty then, and nobody has emptied it: the next cuff is inflated as it is told, a
/// moment before the first one is.
void TestTryWatch::takesNoCuffFromATubeThatIsOut()
{
    TriedSession session;
    session.intubate();
    session.node.decide(fact::CuffSet{true});
    session.run(std::chrono::seconds{1});
    session.node.decide(
        fact::IntubationNoted{{.step = IntubationStep::TubeOut, .at = *session.node.now()}, {}});
    session.tries.watch(); // it takes effect later
    session.note(IntubationStep::CuffInflated);
    session.endTry();
    QVERIFY(session.tries.report()->metrics.cuffInflated);
}

/// It was inflated by who worked before.
void TestTryWatch::takesNoCuffFromBeforeTheTry()
{
    TriedSession session;
    session.node.decide(fact::CuffSet{true});
    session.run(std::chrono::seconds{1});
    session.note(IntubationStep::BladeIn);
    session.run(std::chrono::seconds{1});
    session.endTry();
    QVERIFY(!session.tries.report().value().metrics.cuffInflated);
}

/// The patient of a session is at first a child of 150 cm: 0.10 height + 5 cm is 200 mm.
void TestTryWatch::judgesTheDepthByTheRuleOfThePatient()
{
    TriedSession session;
    session.intubate();
    session.endTry();
    const TryReport usual = session.tries.report().value();
    QCOMPARE(usual.rule, DepthRule::TenthOfHeight);
    QVERIFY(std::abs(inMillimetres(usual.metrics.depthWanted.value()) - 200.0) < 1e-6);
    session.tries.setRule(DepthRule::HalfOfAge);
    session.intubate();
    session.endTry();
    const TryReport stated = session.tries.report().value();
    QCOMPARE(stated.rule, DepthRule::HalfOfAge);
    QVERIFY(std::abs(inMillimetres(stated.metrics.depthWanted.value()) - 180.0) < 1e-6);
}

void TestTryWatch::takesEachNoteOnceAlsoOfATubeThatRestsAgain()
{
    TriedSession session;
    session.intubate();
    session.note(IntubationStep::AtRest, TubeSeat::Trachea, millimetres(205.0));
    session.note(IntubationStep::AtRest, TubeSeat::Trachea, millimetres(210.0));
    session.endTry();
    const TryMetrics& metrics = session.tries.report()->metrics;
    QCOMPARE(metrics.attempts.size(), std::size_t{1});
    QVERIFY(std::abs(inMillimetres(metrics.depth->atTeeth) - 210.0) < 1e-6);
}

void TestTryWatch::watchesTheOxygen()
{
    TriedSession session;
    session.intubate();
    session.endTry();
    const OxygenFigures oxygen = session.tries.report()->metrics.oxygen.value();
    QVERIFY(oxygen.lowest > 0.0 && oxygen.lowest <= oxygen.first);
}

void TestTryWatch::countsMaskVentilationBefore()
{
    const auto checkAfter = [](bool isMaskHeld, std::chrono::milliseconds pause) {
        TriedSession session;
        session.node.decide(fact::GasSupplySet{{1.0, isMaskHeld, true}});
        session.squeezeBag();
        session.run(std::chrono::seconds{5});
        session.node.decide(fact::BagSqueezed{});
        session.run(pause);
        session.intubate();
        session.endTry();
        return session.tries.report()->metrics.check(TryCheck::MaskVentilated);
    };
    QCOMPARE(checkAfter(true, std::chrono::seconds{20}), std::optional{true});
    QVERIFY(!checkAfter(false, std::chrono::seconds{20})); // what was done is not known
    QVERIFY(!checkAfter(true, std::chrono::minutes{4}));
}

/// An explanation in between takes it away from nobody.
void TestTryWatch::countsMaskVentilationBeforeAPause()
{
    TriedSession session;
    session.node.decide(fact::GasSupplySet{{1.0, true, true}});
    session.squeezeBag();
    session.run(std::chrono::seconds{5});
    session.node.decide(fact::BagSqueezed{});
    session.run(std::chrono::seconds{5});
    session.node.decide(fact::PhaseChanged{SessionPhase::Paused});
    session.run(std::chrono::minutes{4});
    session.node.decide(fact::PhaseChanged{SessionPhase::Running});
    session.run(std::chrono::seconds{1});
    session.intubate();
    session.endTry();
    QCOMPARE(session.tries.report()->metrics.check(TryCheck::MaskVentilated), std::optional{true});
}

void TestTryWatch::takesTheForcesThatAreEstimated()
{
    TriedSession session;
    session.note(IntubationStep::BladeIn);
    BladeEffort effort;
    effort.teeth = newtons(25.0);
    effort.contact.tongue = newtons(35.0);
    session.tries.setEffort([effort] { return std::optional{effort}; });
    session.run(std::chrono::seconds{2});
    session.tries.setEffort([] { return std::nullopt; });
    session.note(IntubationStep::BladeOut);
    session.endTry();
    const TryMetrics& metrics = session.tries.report()->metrics;
    QCOMPARE(inNewtons(metrics.incisors->peak), 25.0);
    QCOMPARE(inNewtons(metrics.tongue->peak), 35.0);
    const double above = toSeconds(metrics.incisors->aboveWarning);
    QVERIFY(above > 1.5 && above < 2.6); // two seconds, and the gap that is held
}

void TestTryWatch::tellsATubeInTheOesophagusWhenAsked()
{
    TriedSession session;
    session.note(IntubationStep::BladeIn);
    session.note(IntubationStep::TubePastTeeth);
    session.note(IntubationStep::InOesophagus, TubeSeat::Oesophagus);
    session.note(IntubationStep::FirstBreath, TubeSeat::Oesophagus);
    session.run(std::chrono::seconds{40});
    QVERIFY(session.tries.isUnderWay());
    session.endTry();
    const TryMetrics& metrics = session.tries.report()->metrics;
    QCOMPARE(metrics.outcome, TryOutcome::OesophagusUnrecognised);
    QVERIFY(!metrics.firstBreath);
}

/// Of a tube in the mouth; what was set before it came says nothing of it.
void TestTryWatch::judgesNoTubeByWhatWasSetBefore()
{
    TriedSession session;
    session.node.decide(fact::TubePlaced{{TubeSeat::Oesophagus, millimetres(6.5)}});
    session.run(std::chrono::seconds{1});
    session.intubate();
    session.endTry();
    QCOMPARE(session.tries.report()->metrics.outcome, TryOutcome::Trachea);
}

/// As long as its tube is in the mouth, a try that has ended is judged anew.
void TestTryWatch::judgesAnEndedTryAnewByWhatTheInstructorSays()
{
    TriedSession session;
    session.intubate();
    session.note(IntubationStep::FirstBreath, TubeSeat::Trachea, millimetres(200.0));
    session.run(std::chrono::seconds{30});
    const TryMetrics before = session.tries.report().value().metrics;
    QVERIFY(!before.isTold);
    const auto say = [&](const SetTube& tube) {
        session.node.decide(fact::TubePlaced{tube});
        session.run(std::chrono::seconds{1});
        return session.tries.report().value().metrics;
    };
    const TryMetrics told = say({TubeSeat::Oesophagus, millimetres(6.5)});
    QCOMPARE(told.outcome, TryOutcome::OesophagusUnrecognised);
    QVERIFY(told.isTold);
    QCOMPARE(told.oesophagus.at(0).in, before.throughCords.value());
    QCOMPARE(told.ended, before.ended);
    QVERIFY(say({}) == before);
    session.note(IntubationStep::BackAboveCords);
    session.note(IntubationStep::TubeOut);
    QVERIFY(say({TubeSeat::Oesophagus, millimetres(6.5)}) == before);
}

/// Who sees the tube where the monitor has it has answered the question where it is.
void TestTryWatch::takesAConfirmationOfAnEndedTry()
{
    TriedSession session;
    session.note(IntubationStep::TubePastTeeth);
    session.node.decide(fact::IntubationNoted{{.step = IntubationStep::ThroughCords,
                                               .at = *session.node.now(),
                                               .seat = TubeSeat::Trachea,
                                               .confidence = 0.4},
                                              {}});
    session.run(std::chrono::seconds{1});
    session.endTry();
    QCOMPARE(session.tries.report()->metrics.confidence, 0.4);
    session.node.decide(fact::TubePlaced{{TubeSeat::Trachea, millimetres(6.5)}});
    session.run(std::chrono::seconds{1});
    const TryMetrics& metrics = session.tries.report()->metrics;
    QVERIFY(metrics.isTold);
    QCOMPARE(metrics.confidence, 1.0);
    QCOMPARE(metrics.outcome, TryOutcome::Trachea);
}

void TestTryWatch::judgesNoEndedTryByWhatIsSaidOfALaterPlace()
{
    TriedSession session;
    session.intubate();
    session.endTry();
    const TryReport before = session.tries.report().value();
    session.run(std::chrono::seconds{1});
    session.note(IntubationStep::BackAboveCords);
    session.node.decide(fact::TubePlaced{{TubeSeat::Oesophagus, millimetres(6.5)}});
    session.run(std::chrono::seconds{1});
    QVERIFY(session.tries.report().value() == before);
}

/// Of what happened before its end.
void TestTryWatch::takesWhatIsConcludedLaterOfAnEndedTry()
{
    TriedSession session;
    session.note(IntubationStep::TubePastTeeth);
    const SessionTime passed = *session.node.now();
    session.run(std::chrono::seconds{1});
    session.endTry();
    QCOMPARE(session.tries.report()->metrics.outcome, TryOutcome::Abandoned);
    const auto conclude = [&](IntubationStep step, TubeSeat seat) {
        session.node.decide(fact::IntubationNoted{{.step = step, .at = passed, .seat = seat}, {}});
        session.run(std::chrono::seconds{1});
        return session.tries.report()->metrics.outcome;
    };
    QCOMPARE(conclude(IntubationStep::InOesophagus, TubeSeat::Oesophagus),
             TryOutcome::OesophagusUnrecognised);
    conclude(IntubationStep::OutOfOesophagus, TubeSeat::None);
    QCOMPARE(conclude(IntubationStep::ThroughCords, TubeSeat::Trachea), TryOutcome::Trachea);
    session.node.decide(fact::TubePlaced{{TubeSeat::LeftMain, millimetres(6.5)}});
    session.run(std::chrono::seconds{1});
    QCOMPARE(session.tries.report()->metrics.outcome, TryOutcome::LeftMain);
}

/// A program that stood still sees all at once.
void TestTryWatch::judgesTheSameWheneverItLooks()
{
    const auto reportOf = [](bool isStalled) {
        TriedSession session;
        session.intubate();
        const auto pass = [&] {
            session.node.advance(std::chrono::milliseconds{300});
            if (!isStalled)
                session.tries.watch();
        };
        const auto noteNow = [&](IntubationStep step) {
            session.node.decide(
                fact::IntubationNoted{{.step = step, .at = *session.node.now()}, {}});
            pass();
        };
        session.node.decide(fact::TubePlaced{{TubeSeat::Oesophagus, millimetres(6.5)}});
        pass();
        noteNow(IntubationStep::BackAboveCords);
        noteNow(IntubationStep::TubeOut);
        session.tries.watch();
        session.endTry();
        return session.tries.report()->metrics;
    };
    const TryMetrics metrics = reportOf(false);
    QCOMPARE(metrics.outcome, TryOutcome::OesophagusRecognised);
    QVERIFY(reportOf(true) == metrics);
}

/// With its cuff inflated: that is no step of the try that begins, and moves no tube.
void TestTryWatch::knowsATubeThatWasThereBeforeTheBlade()
{
    TriedSession session;
    session.intubate();
    session.node.decide(fact::CuffSet{true});
    session.run(std::chrono::seconds{1});
    session.endTry();
    session.node.decide(fact::IntubationNoted{{.step = IntubationStep::BladeIn,
                                               .at = *session.node.now(),
                                               .seat = TubeSeat::Trachea,
                                               .depthAtTeeth = millimetres(200.0)},
                                              {}});
    session.run(std::chrono::seconds{1});
    session.endTry();
    const TryMetrics& metrics = session.tries.report()->metrics;
    QCOMPARE(metrics.outcome, TryOutcome::Trachea);
    QCOMPARE(metrics.depth->atTeeth, millimetres(200.0));
}

/// Who takes it out then has recognised it.
void TestTryWatch::believesTheInstructorAboutThePlace()
{
    TriedSession session;
    session.intubate();
    session.node.decide(fact::TubePlaced{{TubeSeat::Oesophagus, millimetres(6.5)}});
    session.run(std::chrono::seconds{1});
    session.note(IntubationStep::FirstBreath, TubeSeat::Trachea, millimetres(200.0));
    session.run(std::chrono::seconds{30});
    QVERIFY(session.tries.isUnderWay()); // no lung was ventilated
    session.note(IntubationStep::BackAboveCords);
    session.note(IntubationStep::TubeOut);
    session.endTry();
    const TryMetrics& metrics = session.tries.report()->metrics;
    QCOMPARE(metrics.outcome, TryOutcome::OesophagusRecognised);
    QVERIFY(metrics.oesophagus.at(0).out.has_value());
    session.intubate();
    session.node.decide(fact::TubePlaced{{TubeSeat::RightMain, millimetres(6.5)}});
    session.run(std::chrono::seconds{1});
    session.endTry();
    QCOMPARE(session.tries.report()->metrics.outcome, TryOutcome::RightMain);
}

/// At the same session time, though one looks later, when the next one has begun.
void TestTryWatch::endsByAPersonAtEveryProgram()
{
    TriedSession session;
    TryWatch other{session.session, FakeSessionNode::kStation};
    other.watch();
    session.note(IntubationStep::BladeIn);
    other.watch();
    session.endTry();
    const SessionTime ended = session.tries.report().value().metrics.ended;
    std::optional<SessionTime> endedThere;
    connect(&other, &TryWatch::ended, this,
            [&] { endedThere = other.report().value().metrics.ended; });
    session.note(IntubationStep::TubePastTeeth);
    QVERIFY(session.tries.isUnderWay());
    other.watch();
    QCOMPARE(endedThere.value(), ended);
    QVERIFY(other.isUnderWay());
    QCOMPARE(other.time(), session.tries.time());
}

/// By an instructor and who is at work, one after the other: the first end is that of the try.
void TestTryWatch::endsOnceWhereTwoEndIt()
{
    TriedSession session;
    TryWatch other{session.session, FakeSessionNode::kStation};
    other.watch();
    session.note(IntubationStep::BladeIn);
    other.watch();
    session.tries.finish();
    QVERIFY(!session.tries.mayFinish()); // it is to come
    session.node.decide(fact::TryEnded{}, FakeSessionNode::kTrainee);
    session.run(std::chrono::seconds{1});
    session.node.decide(fact::TryEnded{}, FakeSessionNode::kTrainee);
    session.run(std::chrono::seconds{1});
    other.watch();
    QVERIFY(other.report().value().metrics.ended == session.tries.report().value().metrics.ended);
}

/// Both were out for 10 s, a moment before a person ended it.
void TestTryWatch::endsByItselfBeforeAPersonEndsIt()
{
    TriedSession session;
    TryWatch other{session.session, FakeSessionNode::kStation};
    other.watch();
    session.note(IntubationStep::BladeIn);
    session.note(IntubationStep::BladeOut);
    other.watch();
    session.node.advance(std::chrono::milliseconds{8950});
    session.endTry(); // in effect 50 ms after the ten seconds
    other.watch();
    const SessionTime ended = session.tries.report().value().metrics.ended;
    QVERIFY(other.report().value().metrics.ended == ended);
    QVERIFY(*session.node.now() - ended > std::chrono::seconds{10});
}

void TestTryWatch::endsWithTheSession()
{
    TriedSession session;
    session.note(IntubationStep::BladeIn);
    session.node.decide(fact::PhaseChanged{SessionPhase::Ended});
    QVERIFY(!session.tries.mayFinish());
    session.run(std::chrono::seconds{1});
    QCOMPARE(session.tries.report().value().metrics.ended, session.node.state()->ended().value());
}

/// The trainee is at work here.
void TestTryWatch::isEndedByAnInstructorOrWhoIsAtWork()
{
    TriedSession session;
    QVERIFY(!session.tries.mayFinish()); // none
    session.note(IntubationStep::BladeIn);
    QVERIFY(session.tries.mayFinish());
    session.node.becomes(FakeSessionNode::kTrainee);
    QVERIFY(session.tries.mayFinish());
    session.node.decide(fact::ParticipantMuted{FakeSessionNode::kTrainee, true});
    QVERIFY(!session.tries.mayFinish());
    session.node.becomes(FakeSessionNode::kObserver);
    QVERIFY(!session.tries.mayFinish());
    session.endTry();
    QVERIFY(session.tries.isUnderWay());
}

void TestTryWatch::reportsATryThatWasGivenUp()
{
    TriedSession session;
    session.note(IntubationStep::BladeIn);
    session.note(IntubationStep::BladeOut);
    session.run(std::chrono::seconds{12});
    QCOMPARE(session.tries.report()->metrics.outcome, TryOutcome::Abandoned);
}

void TestTryWatch::forgetsTheReportWhenAnotherTryBegins()
{
    TriedSession session;
    session.intubate();
    session.endTry();
    QVERIFY(session.tries.report());
    session.note(IntubationStep::TubeOut); // begins none
    QVERIFY(session.tries.report());
    session.note(IntubationStep::BladeIn);
    QVERIFY(!session.tries.report());
    QVERIFY(session.tries.isUnderWay());
    QVERIFY(session.tries.time() >= std::chrono::seconds{1});
}

/// What facts tell of it is told; what was to be measured on the way is not.
void TestTryWatch::findsATryThatBeganBeforeItLooked()
{
    TriedSession session;
    session.note(IntubationStep::BladeIn);
    session.node.decide(fact::CuffSet{true}); // tried
    session.note(IntubationStep::BladeOut);
    session.note(IntubationStep::BladeIn); // the same try
    session.note(IntubationStep::TubePastTeeth);
    TryWatch late{session.session, FakeSessionNode::kStation};
    const QSignalSpy ended{&late, &TryWatch::ended};
    late.watch();
    QVERIFY(late.isUnderWay());
    QCOMPARE(late.time(), session.tries.time());
    session.note(IntubationStep::ThroughCords, TubeSeat::Trachea, millimetres(200.0));
    late.watch();
    session.endTry();
    late.watch();
    QCOMPARE(ended.count(), 1);
    TryMetrics whole = session.tries.report().value().metrics;
    const TryMetrics found = late.report().value().metrics;
    QCOMPARE(found.attempts.size(), std::size_t{2});
    QVERIFY(whole.oxygen && !found.oxygen);
    whole.oxygen.reset();
    whole.headExtension.reset();
    whole.cuffInflated.reset(); // no monitor noted it here
    QVERIFY(found == whole);
}

void TestTryWatch::findsTheLastTryThatEndedBeforeItLooked()
{
    TriedSession session;
    session.note(IntubationStep::BladeIn);
    session.note(IntubationStep::BladeOut);
    session.run(std::chrono::seconds{12});
    session.note(IntubationStep::BladeIn);
    session.node.decide(fact::PhaseChanged{SessionPhase::Paused});
    session.run(std::chrono::minutes{3});
    session.node.decide(fact::PhaseChanged{SessionPhase::Running});
    session.run(std::chrono::seconds{1});
    session.intubate();
    session.note(IntubationStep::FirstBreath, TubeSeat::Trachea, millimetres(200.0));
    session.run(std::chrono::seconds{5});
    session.node.decide(fact::PhaseChanged{SessionPhase::Paused});
    session.run(std::chrono::minutes{1});
    session.node.decide(fact::PhaseChanged{SessionPhase::Running});
    session.run(std::chrono::seconds{25});
    TryWatch late{session.session, FakeSessionNode::kStation};
    const QSignalSpy ended{&late, &TryWatch::ended};
    late.watch();
    QVERIFY(!late.isUnderWay());
    QCOMPARE(ended.count(), 0); // of long ago
    const TryMetrics found = late.report().value().metrics;
    const TryMetrics whole = session.tries.report().value().metrics;
    QCOMPARE(found.outcome, TryOutcome::Trachea);
    QCOMPARE(found.begun, whole.begun);
    QCOMPARE(found.ended, whole.ended);
    QCOMPARE(found.attempts, whole.attempts);
    QCOMPARE(valueOf(found, Metric::TimeToBreath), valueOf(whole, Metric::TimeToBreath));
    QCOMPARE(valueOf(found, Metric::BladeTime), valueOf(whole, Metric::BladeTime));
}

void TestTryWatch::findsTheTryOfAnotherStation()
{
    TriedSession session;
    session.node.addStation("Room 2");
    session.intubate();
    const Duration time = session.tries.time();
    const QSignalSpy changed{&session.tries, &TryWatch::changed};
    session.tries.setStation(StationId{1});
    QCOMPARE(changed.count(), 1);
    QVERIFY(!session.tries.isUnderWay());
    session.run(std::chrono::seconds{1});
    session.tries.setStation(FakeSessionNode::kStation);
    session.run(std::chrono::seconds{1});
    QVERIFY(session.tries.isUnderWay());
    QCOMPARE(session.tries.time(), time + std::chrono::seconds{2});
}

/// The instructor explains for three minutes, and goes on.
void TestTryWatch::countsNoPause()
{
    const auto metricsOf = [](bool isPaused) {
        TriedSession session;
        BladeEffort effort;
        effort.teeth = newtons(25.0);
        session.tries.setEffort([effort] { return std::optional{effort}; });
        session.note(IntubationStep::BladeIn);
        session.note(IntubationStep::GlottisSeen);
        if (isPaused) {
            session.node.decide(fact::PhaseChanged{SessionPhase::Paused});
            session.run(std::chrono::minutes{3});
            session.node.decide(fact::PhaseChanged{SessionPhase::Running});
        }
        session.note(IntubationStep::TubePastTeeth);
        session.note(IntubationStep::ThroughCords, TubeSeat::Trachea, millimetres(200.0));
        session.note(IntubationStep::BladeOut);
        session.tries.setEffort([] { return std::nullopt; });
        session.note(IntubationStep::FirstBreath, TubeSeat::Trachea, millimetres(200.0));
        const Duration before = session.tries.time();
        session.run(std::chrono::seconds{25});
        return std::pair{session.tries.report().value().metrics, before};
    };
    constexpr double kFactOnItsWay_s = 0.5;
    const auto [plain, plainTime] = metricsOf(false);
    const auto [paused, pausedTime] = metricsOf(true);
    const auto isAlike = [](double a, double b) { return std::abs(a - b) < kFactOnItsWay_s; };
    QVERIFY(isAlike(toSeconds(plainTime), toSeconds(pausedTime)));
    for (const Metric metric : {Metric::TimeToBreath, Metric::TimeToCords, Metric::BladeTime})
        QVERIFY(isAlike(*valueOf(plain, metric), *valueOf(paused, metric)));
    const double touched_s =
        toSeconds(paused.incisors->touched) - toSeconds(plain.incisors->touched);
    QVERIFY2(std::abs(touched_s) < 0.35, qPrintable(QString::number(touched_s)));
    QCOMPARE(valueOf(paused, Metric::Failed), std::optional{0.0});
    QVERIFY(isAlike(toSeconds(plain.sinceBegun(plain.ended)),
                    toSeconds(paused.sinceBegun(paused.ended))));
    QVERIFY(paused.ended - paused.begun > std::chrono::minutes{3}); // of the session
}

/// Whose checkpoints are gone.
void TestTryWatch::knowsTheTubeOfATryOfLongAgo()
{
    TriedSession session;
    session.node.decide(fact::TubePlaced{{TubeSeat::Trachea, millimetres(6.0)}});
    session.intubate();
    session.endTry();
    QVERIFY(session.tries.report());
    RespirationFollower patient;
    for (std::size_t i = 0; i < 2 * RespirationTimeline::kMostCheckpoints; ++i) {
        session.run(std::chrono::seconds{11});
        const auto state = session.node.state();
        const Station& station = state->stations().at(FakeSessionNode::kStation);
        for (const FactBody& part :
             patient.at(station.respiration, *session.node.now()).checkpoint())
            session.node.decide(part);
    }
    TryWatch late{session.session, FakeSessionNode::kStation};
    late.setRule(DepthRule::ThreeDiameters);
    late.watch();
    const auto wanted = late.report().value().metrics.depthWanted;
    QVERIFY(wanted.has_value());
    QVERIFY(std::abs(inMillimetres(*wanted) - 180.0) < 1e-6);
}

CARINA_TEST(TestTryWatch)

} // namespace carina::try_watch_test

#include "tst_try_watch.moc"
