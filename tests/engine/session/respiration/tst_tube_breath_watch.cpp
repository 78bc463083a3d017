#include "engine/session/respiration/tube_breath_watch.h"

#include "tests/engine/session/facts/sample_session.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <vector>

namespace carina::test::tube_breath_watch_test
{

namespace
{

constexpr double kLook_s = 0.02;
constexpr double kRate_perMin = 12.0; // of the bag: a breath every 5 s

void note(LogWriter& writer, double seconds, IntubationStep step, TubeSeat seat)
{
    writer.add(atSeconds(seconds),
               fact::IntubationNoted{{.step = step, .at = atSeconds(seconds), .seat = seat},
                                     millimetres(7.5)});
}

void squeezeBag(LogWriter& writer, double seconds)
{
    writer.add(atSeconds(seconds),
               fact::BagSqueezed{{perMinute(kRate_perMin), millilitres(500.0)}});
}

/// An adult who makes no breath; the tube is at the teeth.
LogWriter stillAdult()
{
    LogWriter writer = sampleSession();
    writer.add(atSeconds(0.5), fact::PatientBuildSet{{metres(1.75), 77.0, 40.0, Sex::Male}});
    writer.add(atSeconds(0.5), fact::BreathingStopped{true, {}});
    writer.add(atSeconds(1.0), fact::PhaseChanged{SessionPhase::Running});
    note(writer, 2.0, IntubationStep::TubePastTeeth, TubeSeat::None);
    return writer;
}

struct Found {
    double began_s;
    double known_s;
};

/// What is found until a time, the tube being taken to lie where it is noted to.
std::vector<Found> foundIn(const LogWriter& writer, double until_s)
{
    const SessionState state = stateOf(writer);
    const RespirationTimeline& timeline = timelineOf(state);
    PatientRun run{timeline, atSeconds(0.0)};
    TubeBreathWatch watch;
    std::vector<Found> found;
    for (double seconds = 0.0; seconds < until_s; seconds += kLook_s) {
        const SessionTime t = atSeconds(seconds);
        run.advanceTo(timeline, t);
        TubeSeat seat = TubeSeat::None;
        for (const NotedStep& step : timeline.tube().notes())
            if (step.effect <= t)
                seat = step.event.seat;
        if (const auto began = watch.take(run, seat))
            found.push_back({toSeconds(*began - atSeconds(0.0)), seconds});
    }
    return found;
}

} // namespace

/// A bag of 12 breaths a minute inspires for a third of 5 s.
class TestTubeBreathWatch : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsABreathThatTheLungsHaveTaken()
    {
        LogWriter writer = stillAdult();
        note(writer, 4.0, IntubationStep::ThroughCords, TubeSeat::Trachea);
        squeezeBag(writer, 10.0);
        const std::vector<Found> found = foundIn(writer, 40.0);
        QCOMPARE(found.size(), std::size_t{1});
        QVERIFY2(found[0].began_s >= 10.0 - kLook_s && found[0].began_s < 15.1,
                 qPrintable(QString::number(found[0].began_s)));
        const double after = found[0].known_s - found[0].began_s;
        QVERIFY2(after > 0.3 && after < 5.0 / 3.0, qPrintable(QString::number(after)));
    }

    /// The breath under way when the tube comes there is of before.
    void takesNoBreathThatBeganBeforeTheTubeWasThere()
    {
        LogWriter writer = stillAdult();
        writer.add(atSeconds(2.5), fact::GasSupplySet{{1.0, true, true}}); // by a mask until then
        squeezeBag(writer, 3.0);
        note(writer, 9.2, IntubationStep::ThroughCords, TubeSeat::Trachea);
        const std::vector<Found> found = foundIn(writer, 40.0);
        QCOMPARE(found.size(), std::size_t{1});
        QVERIFY2(found[0].began_s >= 9.2 - kLook_s && found[0].began_s <= 9.2 + 5.1,
                 qPrintable(QString::number(found[0].began_s)));
    }

    void findsNoneWhileNothingBlows()
    {
        LogWriter writer = stillAdult();
        writer.add(atSeconds(3.0), fact::BreathingStopped{false, {}}); // breathes through the tube
        note(writer, 4.0, IntubationStep::ThroughCords, TubeSeat::Trachea);
        QVERIFY(foundIn(writer, 40.0).empty());
    }

    void findsWhatIsBlownIntoTheStomachAndThenTheFirstOfTheLungs()
    {
        LogWriter writer = stillAdult();
        squeezeBag(writer, 3.0);
        note(writer, 5.0, IntubationStep::InOesophagus, TubeSeat::Oesophagus);
        note(writer, 20.0, IntubationStep::OutOfOesophagus, TubeSeat::None);
        note(writer, 22.0, IntubationStep::ThroughCords, TubeSeat::Trachea);
        note(writer, 30.0, IntubationStep::PastCarina, TubeSeat::RightMain); // the same breaths
        const std::vector<Found> found = foundIn(writer, 50.0);
        QCOMPARE(found.size(), std::size_t{2});
        QVERIFY(found[0].began_s >= 5.0 - kLook_s && found[0].known_s < 20.0);
        QVERIFY(std::abs(found[0].known_s - found[0].began_s - 5.0 / 3.0) < 2.0 * kLook_s);
        QVERIFY(found[1].began_s >= 22.0 - kLook_s && found[1].began_s < 28.0);
    }

    /// The console's own tube is in the trachea, whatever was noted.
    void findsNoneWhereTheConsoleOverridesTheTube()
    {
        LogWriter writer = stillAdult();
        writer.add(atSeconds(3.0), fact::TubePlaced{{TubeSeat::Trachea, millimetres(7.0)}});
        note(writer, 4.0, IntubationStep::InOesophagus, TubeSeat::Oesophagus);
        squeezeBag(writer, 5.0);
        QVERIFY(foundIn(writer, 30.0).empty());
    }
};

CARINA_TEST(TestTubeBreathWatch)

} // namespace carina::test::tube_breath_watch_test

#include "tst_tube_breath_watch.moc"
