#include "models/intubation/intubation_timeline.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>

#include <set>

namespace carina::intubation_timeline_test
{
namespace
{

using test::FakeSessionNode;
using namespace std::chrono_literals;

constexpr Duration kLead = 100ms; ///< until a change takes effect

struct Story {
    FakeSessionNode node;
    SessionModel session{node};
    IntubationTimeline timeline{session, FakeSessionNode::kStation};
    QAbstractItemModelTester tester{&timeline};
    SessionTime begun = *node.now() + kLead;

    Story() { node.decide(fact::PhaseChanged{SessionPhase::Running}); }
    void notes(IntubationEvent event, Duration after)
    {
        node.advance(begun + after - *node.now());
        event.at = *node.now();
        node.decide(fact::IntubationNoted{.event = event});
        QCoreApplication::sendPostedEvents();
    }
    [[nodiscard]] QString line(int row) const { return timeline.index(row, 0).data().toString(); }
};

} // namespace

class TestIntubationTimeline : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tellsEachStepWithItsTime()
    {
        Story story;
        QCOMPARE(story.timeline.rowCount(), 0);
        story.notes({.step = IntubationStep::BladeIn}, 12s);
        story.notes({.step = IntubationStep::AtRest,
                     .seat = TubeSeat::Trachea,
                     .depthAtTeeth = millimetres(201.0)},
                    102s);
        QCOMPARE(story.timeline.rowCount(), 2);
        QCOMPARE(story.line(0), QStringLiteral("00:12  Blade in the mouth: an attempt begins"));
        QCOMPARE(story.line(1), QStringLiteral("01:42  Tube at rest, 20.1 cm at the teeth"));
    }

    /// It is frozen: the manikin's airway is not the virtual one.
    void tellsNoDepthWhileBothShapesAreApart()
    {
        Story story;
        const auto note = [&](IntubationStep step, Duration after) {
            story.notes({.step = step,
                         .seat = TubeSeat::Trachea,
                         .depthAtTeeth = millimetres(120.0),
                         .besides = millimetres(9.0)},
                        after);
        };
        note(IntubationStep::ShapesApart, 10s);
        note(IntubationStep::CuffInflated, 12s);
        note(IntubationStep::ShapesTogether, 14s);
        note(IntubationStep::AtRest, 16s);
        QCOMPARE(story.line(1), QStringLiteral("00:12  Cuff inflated"));
        QCOMPARE(story.line(3), QStringLiteral("00:16  Tube at rest, 12.0 cm at the teeth"));
    }

    void findsTheStepOfAMoment()
    {
        Story story;
        QCOMPARE(story.timeline.rowAt(story.begun), -1);
        story.notes({.step = IntubationStep::BladeIn}, 12s);
        story.notes({.step = IntubationStep::GlottisSeen}, 14s);
        story.notes({.step = IntubationStep::TubePastTeeth}, 20s);
        for (const auto& [after, row] : {std::pair{0s, 0}, std::pair{12s, 0}, std::pair{13s, 0},
                                         std::pair{14s, 1}, std::pair{19s, 1}, std::pair{99s, 2}})
            QCOMPARE(story.timeline.rowAt(story.begun + after), row);
    }

    /// A rigid tube goes there straight, and one that was not seen to pass lies deeper.
    void tellsNoDepthAtTheCords()
    {
        for (const IntubationStep step :
             {IntubationStep::ThroughCords, IntubationStep::BackAboveCords,
              IntubationStep::InOesophagus, IntubationStep::OutOfOesophagus})
            QVERIFY(!intubationText({.step = step, .depthAtTeeth = millimetres(210.0)})
                         .contains(QStringLiteral("cm")));
    }

    void tellsTheSide()
    {
        IntubationEvent event{.step = IntubationStep::PastCarina,
                              .seat = TubeSeat::RightMain,
                              .depthAtTeeth = millimetres(263.0)};
        QCOMPARE(intubationText(event),
                 QStringLiteral("▲ In the right main bronchus, 26.3 cm at the teeth"));
        event.seat = TubeSeat::LeftMain;
        QVERIFY(intubationText(event).contains(QLatin1String{"left"}));
    }

    void saysWhereTheFirstBreathGoes()
    {
        IntubationEvent event{.step = IntubationStep::FirstBreath, .seat = TubeSeat::Trachea};
        QCOMPARE(intubationText(event), QStringLiteral("First breath through the tube"));
        event.seat = TubeSeat::Oesophagus;
        QCOMPARE(intubationText(event), QStringLiteral("▲ First breath goes into the oesophagus"));
        event.seat = TubeSeat::RightMain;
        QVERIFY(intubationText(event).contains(QLatin1String{"right lung alone"}));
        event.seat = TubeSeat::LeftMain;
        QVERIFY(intubationText(event).contains(QLatin1String{"left lung alone"}));
    }

    void saysWhatIsUncertain()
    {
        IntubationEvent event{.step = IntubationStep::InOesophagus, .confidence = 0.64};
        QCOMPARE(intubationText(event), QStringLiteral("▲ In the oesophagus (64\u00a0% sure)"));
        event.confidence = 0.9;
        QCOMPARE(intubationText(event), QStringLiteral("▲ In the oesophagus"));
    }

    /// It happened; only where the tube is may be something else.
    void doubtsNothingThatPeopleSet()
    {
        for (const IntubationStep step :
             {IntubationStep::CuffInflated, IntubationStep::CuffDeflated, IntubationStep::StyletOut,
              IntubationStep::FirstBreath, IntubationStep::AtRest}) {
            const IntubationEvent event{.step = step, .seat = TubeSeat::Trachea, .confidence = 0.4};
            QVERIFY(!intubationText(event).contains(QStringLiteral("sure")));
        }
        const IntubationEvent event{
            .step = IntubationStep::FirstBreath, .seat = TubeSeat::Oesophagus, .confidence = 0.4};
        QCOMPARE(intubationText(event),
                 QStringLiteral("▲ First breath goes into the oesophagus? (40\u00a0% sure)"));
    }

    /// How much was seen at most is known at the end of an attempt.
    void tellsTheBestViewOfAnAttempt()
    {
        QCOMPARE(intubationText({.step = IntubationStep::BladeOut, .glotticOpening = 0.61}),
                 QStringLiteral("Blade out: up to 61\u00a0% of the glottis was seen"));
        QCOMPARE(intubationText({.step = IntubationStep::BladeOut}), QStringLiteral("Blade out"));
    }

    /// As where a tube bends, and nothing tells which way it went.
    void asksWhatIsLessLikelyThanNot()
    {
        IntubationEvent event{.step = IntubationStep::ThroughCords, .confidence = 0.25};
        QCOMPARE(intubationText(event), QStringLiteral("Through the cords? (25\u00a0% sure)"));
        event.confidence = 0.5;
        QCOMPARE(intubationText(event), QStringLiteral("Through the cords (50\u00a0% sure)"));
    }

    /// A kind of event that is added needs words.
    void hasWordsForEveryStep()
    {
        std::set<QString> texts;
        for (int step = 0; step <= int(kLastIntubationStep); ++step)
            texts.insert(intubationText({.step = IntubationStep(step)}));
        QVERIFY(!texts.contains(QString{}));
        QCOMPARE(int(texts.size()), int(kLastIntubationStep) + 1);
    }

    void tellsTheStepsOfItsStationOnly()
    {
        Story story;
        story.node.addStation("Station 2");
        story.notes({.step = IntubationStep::BladeIn}, 3s);
        story.timeline.setStation(StationId{1});
        QCOMPARE(story.timeline.rowCount(), 0);
        story.timeline.setStation(FakeSessionNode::kStation);
        QCOMPARE(story.timeline.rowCount(), 1);
    }

    /// The monitor's own seat is another one.
    void tellsWhereTheConsoleSetTheTube()
    {
        Story story;
        const SetTube set{TubeSeat::Oesophagus, millimetres(6.5)};
        story.notes({.step = IntubationStep::ThroughCords, .seat = TubeSeat::Trachea}, 10s);
        story.node.decide(fact::TubePlaced{set});
        story.notes({.step = IntubationStep::FirstBreath, .seat = TubeSeat::Trachea}, 15s);
        story.node.advance(1s);
        story.node.decide(fact::TubePlaced{});
        story.notes({.step = IntubationStep::BladeOut}, 20s);
        QCOMPARE(story.timeline.rowCount(), 5);
        QCOMPARE(story.line(1),
                 QStringLiteral("00:10  Console: tube in the oesophagus, 6.5\u00a0mm"));
        QCOMPARE(story.line(2), QStringLiteral("00:15  ▲ First breath goes into the oesophagus"));
        QCOMPARE(story.line(3), QStringLiteral("00:16  Console: tube as tracked"));
    }

    /// What is noted later can have happened earlier.
    void ordersTheStepsByTheirTime()
    {
        Story story;
        story.notes({.step = IntubationStep::TubePastTeeth}, 10s);
        IntubationEvent late{.step = IntubationStep::GlottisSeen,
                             .at = *story.node.now() - 2s,
                             .glotticOpening = 0.43};
        story.node.advance(1s);
        story.node.decide(fact::IntubationNoted{.event = late});
        QCoreApplication::sendPostedEvents();
        QCOMPARE(story.line(0), QStringLiteral("00:08  Glottis seen"));
        QCOMPARE(story.line(1), QStringLiteral("00:10  Tube past the teeth"));
    }

    void changesOnlyWithItsLines()
    {
        Story story;
        story.notes({.step = IntubationStep::BladeIn}, 3s);
        const QSignalSpy reset{&story.timeline, &QAbstractItemModel::modelReset};
        story.node.advance(1s);
        story.node.announce();
        QCoreApplication::sendPostedEvents();
        QCOMPARE(reset.count(), 0);
    }
};

CARINA_TEST(TestIntubationTimeline)

} // namespace carina::intubation_timeline_test

#include "tst_intubation_timeline.moc"
