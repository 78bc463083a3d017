#include "apps/lab/intubation/intubation_trial.h"

#include "tests/evaluation/intubation/tube_patient.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::lab::intubation_trial_test
{
namespace
{

constexpr double kDepthTolerance_mm = 3.0;
constexpr Duration kTimeTolerance = std::chrono::milliseconds{100};

/// With the tube as it is measured: what the hands move is rigid.
const IntubationSubject& subject()
{
    static const IntubationSubject boy = [] {
        const PatientDimensions dimensions = dimensionsOf(BuiltinPatient::TwelveYears);
        IntubationSubject it =
            intubationSubject(test::tubePatient(dimensions), buildOf(dimensions), {}).value();
        it.lumen = nullptr;
        return it;
    }();
    return boy;
}

ObservationSettings withoutErrors()
{
    return {.jitter = {},
            .noise = {},
            .rotationNoise = {},
            .dropouts = 0.0,
            .registration = {},
            .registrationTurn = {}};
}

IntubationTrial trialOf(MotionKind kind, std::uint32_t seed = 1,
                        const ObservationSettings& observation = withoutErrors())
{
    return runTrial(subject(), kind, seed, observation).value();
}

std::vector<SessionTime> timesOf(const IntubationTrial& trial, IntubationStep step)
{
    std::vector<SessionTime> times;
    for (const IntubationEvent& event : trial.byTime())
        if (event.step == step)
            times.push_back(event.at);
    return times;
}

} // namespace

/// Motions in a patient of tubes, which is made at once, through to the monitor.
class TestIntubationTrial : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesTheUsualTube()
    {
        QCOMPARE(inMillimetres(subject().innerDiameter), 6.5);
        const auto larger =
            intubationSubject(test::tubePatient(dimensionsOf(BuiltinPatient::TwelveYears)),
                              subject().build, millimetres(7.0));
        QVERIFY(larger.has_value());
        QCOMPARE(inMillimetres(larger->tube.outerDiameter), 9.6);
    }

    void tellsEachOutcomeOfExactPoses_data()
    {
        QTest::addColumn<MotionKind>("kind");
        for (const NamedMotion& motion : kNamedMotions)
            QTest::newRow(motion.name.data()) << motion.kind;
    }
    void tellsEachOutcomeOfExactPoses()
    {
        QFETCH(const MotionKind, kind);
        const IntubationTrial trial = trialOf(kind);
        QCOMPARE(trial.course.seat, seatOf(trial.truth.outcome));
        QVERIFY(!trial.isWrong());
        QCOMPARE(trial.course.attempts, trial.truth.attempts);
        const double deeper_mm =
            inMillimetres(trial.course.tip.depthAtTeeth - trial.truth.depthAtTeeth);
        QVERIFY2(std::abs(deeper_mm) < kDepthTolerance_mm, qPrintable(QString::number(deeper_mm)));
    }

    void timesThePassagesOfExactPoses()
    {
        const IntubationTrial trial = trialOf(MotionKind::RightMainstem);
        const StepErrors errors = stepErrors(trial);
        QVERIFY(errors.missed.empty());
        QCOMPARE(errors.times.size(), std::size_t{5});
        for (const Duration error : errors.times)
            QVERIFY2(std::chrono::abs(error) < kTimeTolerance,
                     qPrintable(QString::number(toSeconds(error))));
    }

    void notesWhatHandsTellInTheirOrder()
    {
        const IntubationTrial trial = trialOf(MotionKind::LateRecognition);
        for (const auto& [act, step] :
             {std::pair{MotionAct::CuffInflated, IntubationStep::CuffInflated},
              {MotionAct::CuffDeflated, IntubationStep::CuffDeflated},
              {MotionAct::BreathsBegin, IntubationStep::FirstBreath}}) {
            std::vector<SessionTime> told;
            for (const MotionCommand& command : trial.commands)
                if (command.act == act)
                    told.push_back(kTrialStart + command.at);
            QCOMPARE(timesOf(trial, step), told);
        }
        QVERIFY(std::ranges::is_sorted(trial.noted, {}, &NotedStep::effect));
        for (const NotedStep& step : trial.noted)
            QVERIFY(step.effect >= step.event.at);
    }

    void findsWhatWasMissedAndInvented()
    {
        IntubationTrial trial = trialOf(MotionKind::Good);
        const std::size_t all = stepErrors(trial).times.size();
        std::erase_if(trial.noted, [](const NotedStep& step) {
            return step.event.step == IntubationStep::ThroughCords;
        });
        NotedStep wrong = trial.noted.front();
        wrong.event.step = IntubationStep::PastCarina;
        trial.noted.push_back(wrong);
        const StepErrors errors = stepErrors(trial);
        QCOMPARE(errors.times.size(), all - 1);
        QCOMPARE(errors.missed, std::vector{TrueStep::ThroughCords});
        QCOMPARE(std::ranges::count(errors.invented, IntubationStep::PastCarina), 1);
        trial.course.seat = TubeSeat::Oesophagus;
        QVERIFY(trial.isWrong());
    }

    void isTheSameForOneSeed()
    {
        const IntubationTrial once = trialOf(MotionKind::StuckAtArytenoid, 9, {});
        const IntubationTrial again = trialOf(MotionKind::StuckAtArytenoid, 9, {});
        QCOMPARE(once.noted, again.noted);
        QCOMPARE(once.course, again.course);
        QVERIFY(once.noted != trialOf(MotionKind::StuckAtArytenoid, 10, {}).noted);
    }
};

CARINA_TEST(TestIntubationTrial)

} // namespace carina::lab::intubation_trial_test

#include "tst_intubation_trial.moc"
