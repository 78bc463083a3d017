#include "engine/session/body/noted_so_far.h"

#include "tests/engine/session/facts/sample_session.h"
#include "tests/support/test_class.h"

namespace carina::test::noted_so_far_test
{

class TestNotedSoFar : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void knowsNothingAtFirst()
    {
        const NotedSoFar noted = notedSoFar(TubeTimeline{});
        QVERIFY(!noted.isBladeIn && !noted.isTubeIn && !noted.breath);
        QCOMPARE(noted.seat, TubeSeat::None);
    }

    void knowsWhereTheTubeIsAndHowSureThatIs()
    {
        TubeTimeline tube;
        note(tube, {.step = IntubationStep::TubePastTeeth});
        note(tube, {.step = IntubationStep::ThroughCords,
                    .seat = TubeSeat::Trachea,
                    .confidence = 0.8,
                    .depthAtTeeth = millimetres(150.0)});
        note(tube, {.step = IntubationStep::AtRest,
                    .seat = TubeSeat::Trachea,
                    .confidence = 0.9,
                    .depthAtTeeth = millimetres(210.0),
                    .tipAboveCarina = millimetres(30.0)});
        note(tube, {.step = IntubationStep::BladeOut, .seat = TubeSeat::Trachea});
        const NotedSoFar noted = notedSoFar(tube);
        QVERIFY(noted.isTubeIn && !noted.isBladeIn && !noted.areShapesApart);
        QCOMPARE(noted.seat, TubeSeat::Trachea);
        QCOMPARE(noted.confidence, 0.9);
        QCOMPARE(noted.tip.depthAtTeeth, millimetres(210.0));
        QCOMPARE(noted.tip.aboveCarina, millimetres(30.0));
    }

    /// The view is that of the attempt under way.
    void knowsTheAttempt()
    {
        TubeTimeline tube;
        note(tube, {.step = IntubationStep::BladeIn});
        note(tube, {.step = IntubationStep::GlottisSeen, .glotticOpening = 0.7});
        note(tube, {.step = IntubationStep::BladeOut, .glotticOpening = 0.9});
        note(tube, {.step = IntubationStep::BladeIn});
        QVERIFY(notedSoFar(tube).isBladeIn && !notedSoFar(tube).wasGlottisSeen);
        QCOMPARE(notedSoFar(tube).glottis, 0.0);
        note(tube, {.step = IntubationStep::GlottisSeen, .glotticOpening = 0.2});
        note(tube, {.step = IntubationStep::TubePastTeeth, .glotticOpening = 0.4});
        QVERIFY(notedSoFar(tube).wasGlottisSeen);
        QCOMPARE(notedSoFar(tube).glottis, 0.4);
    }

    /// Of the tube that is there, and not of one that was.
    void knowsWhatHappenedToTheTube()
    {
        TubeTimeline tube;
        note(tube, {.step = IntubationStep::ShapesApart});
        note(tube, {.step = IntubationStep::PassedShut});
        note(tube, {.step = IntubationStep::FirstBreath, .seat = TubeSeat::Oesophagus});
        QVERIFY(notedSoFar(tube).areShapesApart && notedSoFar(tube).hasPassedShut);
        QVERIFY(notedSoFar(tube).breath == TubeSeat::Oesophagus);
        note(tube, {.step = IntubationStep::TubeOut});
        QVERIFY(!notedSoFar(tube).areShapesApart && !notedSoFar(tube).hasPassedShut);
        QVERIFY(!notedSoFar(tube).breath && !notedSoFar(tube).isTubeIn);
    }

private:
    static void note(TubeTimeline& tube, const IntubationEvent& event)
    {
        tube.note(atSeconds(double(tube.lastNote() + 1)), event, {});
    }
};

CARINA_TEST(TestNotedSoFar)

} // namespace carina::test::noted_so_far_test

#include "tst_noted_so_far.moc"
