#include "apps/lab/intubation/intubation_trial.h"
#include "tests/evaluation/intubation/tube_patient.h"
#include "tests/support/test_class.h"

#include <algorithm>

namespace carina::lab::bent_intubation_test
{
namespace
{

constexpr std::uint32_t kSeed = 11;
constexpr double kUnsure = 0.8; ///< a confidence: from there on a step stands without it

/// Whose tube bends between the walls, and whose monitor is shown a rod.
const IntubationSubject& subject()
{
    static const IntubationSubject boy = [] {
        const PatientDimensions dimensions = dimensionsOf(BuiltinPatient::TwelveYears);
        return intubationSubject(test::tubePatient(dimensions), buildOf(dimensions), {},
                                 TubeBending::Elastic)
            .value();
    }();
    return boy;
}

bool areApart(const IntubationTrial& trial)
{
    return std::ranges::any_of(trial.noted, [](const NotedStep& step) {
        return step.event.step == IntubationStep::ShapesApart;
    });
}

} // namespace

/// Motions with a tube that bends, through to the monitor, in a patient of tubes.
class TestBentIntubation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tubeInTheTracheaIsNotToldInTheOesophagus_data()
    {
        QTest::addColumn<MotionKind>("kind");
        QTest::newRow("good") << MotionKind::Good;
        QTest::newRow("dental_lever") << MotionKind::DentalLever;
        QTest::newRow("neck_flexed") << MotionKind::NeckFlexed;
    }
    void tubeInTheTracheaIsNotToldInTheOesophagus()
    {
        QFETCH(const MotionKind, kind);
        const IntubationTrial trial = runTrial(subject(), kind, kSeed).value();
        QVERIFY(areApart(trial));
        QVERIFY(std::ranges::none_of(trial.noted, [](const NotedStep& step) {
            return step.event.step == IntubationStep::InOesophagus;
        }));
        QCOMPARE(trial.course.seat, TubeSeat::Trachea);
        QVERIFY(trial.course.confidence < kUnsure);
    }

    /// Whatever is said of one in the oesophagus, it is said to be unsure.
    void tubeInTheOesophagusIsNeverSurelyInTheTrachea()
    {
        const IntubationTrial trial = runTrial(subject(), MotionKind::Oesophageal, kSeed).value();
        QVERIFY(areApart(trial));
        QVERIFY(trial.course.confidence < kUnsure);
        for (const NotedStep& step : trial.noted)
            if (step.event.step == IntubationStep::ThroughCords)
                QVERIFY(step.event.confidence < kUnsure);
    }
};

CARINA_TEST(TestBentIntubation)

} // namespace carina::lab::bent_intubation_test

#include "tst_bent_intubation.moc"
