#include "engine/session/body/tube_timeline.h"

#include "engine/anatomy/patient/patient_dimensions.h"
#include "tests/engine/session/facts/sample_session.h"
#include "tests/support/test_class.h"

namespace carina::test::tube_timeline_test
{

namespace
{

const PatientBuild kAdult{metres(1.75), 77.0, 40.0, Sex::Male};

IntubationEvent noted(IntubationStep step, TubeSeat seat) { return {.step = step, .seat = seat}; }

TubePlace placeAt(const TubeTimeline& tube, double seconds)
{
    return tube.placeAt(atSeconds(seconds), kAdult);
}

} // namespace

class TestTubeTimeline : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasNoTubeAtFirst()
    {
        const TubeTimeline tube;
        QVERIFY(placeAt(tube, 0.0) == TubePlace{});
        QVERIFY(!tube.isWatchedAt(SessionTime::max()));
        QVERIFY(!tube.isOverriddenAt(SessionTime::max()));
        QVERIFY(!tube.cuffInflatedAt(atSeconds(0.0)));
        QVERIFY(tube.styletInAt(atSeconds(0.0)));
        QVERIFY(tube.changeAfter(SessionTime::min()) == SessionTime::max());
    }

    void placesTheTubeThatTheConsoleSets()
    {
        TubeTimeline tube;
        tube.setOverride(atSeconds(1.0), {TubeSeat::Trachea, millimetres(6.5)});
        QVERIFY(placeAt(tube, 0.9) == TubePlace{});
        QVERIFY(placeAt(tube, 1.0) == (TubePlace{TubeSeat::Trachea, millimetres(6.5)}));
        QVERIFY(!tube.isOverriddenAt(atSeconds(1.0))); // of nothing
    }

    void placesItWhereTheConsoleSaysThatItIs()
    {
        const Length size = millimetres(7.5);
        for (const TubeSeat seat : kTubeSeats) {
            TubeTimeline tube;
            tube.note(atSeconds(1.0), noted(IntubationStep::ThroughCords, TubeSeat::Trachea), size);
            tube.setOverride(atSeconds(2.0), {seat, size});
            QVERIFY(placeAt(tube, 2.0) == (TubePlace{seat, size, kEmptyCuffLeak}));
            QVERIFY(tube.isOverriddenAt(atSeconds(2.0)));
        }
    }

    /// What was set while no tube was in the mouth stays.
    void saysNothingOfATubeAnyMoreThatIsOut()
    {
        TubeTimeline tube;
        const Length size = millimetres(7.5);
        tube.note(atSeconds(1.0), noted(IntubationStep::TubePastTeeth, TubeSeat::None), size);
        tube.note(atSeconds(2.0), noted(IntubationStep::ThroughCords, TubeSeat::Trachea), size);
        tube.setOverride(atSeconds(3.0), {TubeSeat::Oesophagus, size});
        tube.note(atSeconds(4.0), noted(IntubationStep::BackAboveCords, TubeSeat::None), size);
        QCOMPARE(placeAt(tube, 4.0).seat, TubeSeat::Oesophagus);
        tube.setObstruction(atSeconds(4.0), 0.3);
        tube.note(atSeconds(5.0), noted(IntubationStep::TubeOut, TubeSeat::None), size);
        QVERIFY(!tube.isOverriddenAt(atSeconds(5.0)));
        QCOMPARE(placeAt(tube, 5.0).seat, TubeSeat::None);
        QCOMPARE(placeAt(tube, 5.0).obstruction, 0.0);
        tube.setOverride(atSeconds(6.0), {TubeSeat::Trachea, size});
        tube.note(atSeconds(7.0), noted(IntubationStep::TubePastTeeth, TubeSeat::None), size);
        tube.note(atSeconds(8.0), noted(IntubationStep::TubeOut, TubeSeat::None), size);
        QCOMPARE(placeAt(tube, 8.0).seat, TubeSeat::Trachea);
    }

    /// A tube that comes out ends what is said of it; where nothing is, nothing changes.
    void tellsNoEndOfWhatWasTakenBack()
    {
        TubeTimeline tube;
        tube.note(atSeconds(1.0), noted(IntubationStep::ThroughCords, TubeSeat::Trachea), {});
        tube.setOverride(atSeconds(2.0), {TubeSeat::Oesophagus, millimetres(7.5)});
        tube.setOverride(atSeconds(3.0), {});
        tube.note(atSeconds(4.0), noted(IntubationStep::TubeOut, TubeSeat::None), {});
        QCOMPARE(tube.overrides().size(), std::size_t{2});
    }

    /// By the monitor it is above the cords all the while.
    void takesATubePastTheTeethForOneInTheMouth()
    {
        for (const auto next : {IntubationStep::TubePastTeeth, IntubationStep::ShapesApart}) {
            TubeTimeline tube;
            tube.note(atSeconds(1.0), noted(IntubationStep::TubePastTeeth, TubeSeat::None), {});
            tube.note(atSeconds(2.0), noted(next, TubeSeat::None), {});
            tube.setOverride(atSeconds(3.0), {TubeSeat::Trachea, millimetres(7.5)});
            tube.note(atSeconds(4.0), noted(IntubationStep::TubeOut, TubeSeat::None), {});
            QVERIFY(tube.isOverriddenAt(atSeconds(3.0)));
            QVERIFY(!tube.isOverriddenAt(atSeconds(4.0)));
        }
    }

    void knowsTheLastEntryAboutATubeInTheMouth()
    {
        TubeTimeline tube;
        const auto lastAt = [&](double seconds) { return tube.lastOfSeatAt(atSeconds(seconds)); };
        tube.note(atSeconds(1.0), noted(IntubationStep::BladeIn, TubeSeat::None), {});
        QVERIFY(!lastAt(1.0));
        tube.note(atSeconds(2.0), noted(IntubationStep::ThroughCords, TubeSeat::Trachea), {});
        tube.note(atSeconds(3.0), noted(IntubationStep::BladeOut, TubeSeat::Trachea), {});
        QVERIFY(!lastAt(1.9));
        QCOMPARE(lastAt(3.0)->step, IntubationStep::ThroughCords);
        tube.note(atSeconds(4.0), noted(IntubationStep::TubeOut, TubeSeat::None), {});
        QVERIFY(lastAt(3.9) && !lastAt(4.0));
    }

    /// Steps that tell something else say nothing of the seat, however sure they are.
    void isAsSureAsTheSeatWas()
    {
        TubeTimeline tube;
        IntubationEvent through = noted(IntubationStep::ThroughCords, TubeSeat::Trachea);
        through.confidence = 0.4;
        tube.note(atSeconds(1.0), through, {});
        for (const auto other : {IntubationStep::ShapesApart, IntubationStep::ShapesTogether,
                                 IntubationStep::PassedShut, IntubationStep::BladeOut}) {
            tube.note(atSeconds(2.0), noted(other, TubeSeat::Trachea), {});
            QCOMPARE(tube.lastOfSeatAt(atSeconds(2.0))->confidence, 0.4);
        }
        tube.note(atSeconds(3.0), noted(IntubationStep::CuffInflated, TubeSeat::Trachea), {});
        QCOMPARE(tube.lastOfSeatAt(atSeconds(3.0))->confidence, 1.0);
    }

    /// A cuff is tried before anybody has seen a tube: what blows reaches the lungs as before.
    void watchesNoTubeThatOnlyControlsTellOf()
    {
        TubeTimeline tube;
        for (const auto step : {IntubationStep::CuffInflated, IntubationStep::CuffDeflated,
                                IntubationStep::StyletOut}) {
            tube.note(atSeconds(1.0), noted(step, TubeSeat::None), {});
            QVERIFY(!tube.isWatchedAt(atSeconds(1.0)));
        }
        QVERIFY(placeAt(tube, 1.0) == TubePlace{});
        QCOMPARE(tube.notes().size(), std::size_t{3});
    }

    void remembersItsLastSettings()
    {
        TubeTimeline tube;
        for (int i = 1; i <= int(TubeTimeline::kMostNotes) + 20; ++i)
            tube.setOverride(atSeconds(i), {TubeSeat::Trachea, millimetres(5.0 + 0.01 * i)});
        tube.forgetBefore(atSeconds(10.0));
        QCOMPARE(tube.overrides().front().from, atSeconds(10.0)); // none later than that is lost
        tube.forgetBefore(atSeconds(1000.0));
        QCOMPARE(tube.overrides().size(), TubeTimeline::kMostNotes);
        tube.forgetBefore(atSeconds(2000.0));
        QCOMPARE(tube.overrides().size(), TubeTimeline::kMostNotes);
    }

    void followsTheMonitorFromTheTeethOn()
    {
        TubeTimeline tube;
        const Length size = millimetres(7.5);
        tube.note(atSeconds(1.0), noted(IntubationStep::BladeIn, TubeSeat::None), size);
        QVERIFY(!tube.isWatchedAt(atSeconds(1.5)));
        tube.note(atSeconds(2.0), noted(IntubationStep::TubePastTeeth, TubeSeat::None), size);
        QVERIFY(tube.isWatchedAt(atSeconds(2.0)));
        QCOMPARE(placeAt(tube, 2.0).seat, TubeSeat::None);
        QCOMPARE(placeAt(tube, 2.0).innerDiameter, size);
        tube.note(atSeconds(3.0), noted(IntubationStep::ThroughCords, TubeSeat::Trachea), size);
        QCOMPARE(placeAt(tube, 2.9).seat, TubeSeat::None);
        QCOMPARE(placeAt(tube, 3.0).seat, TubeSeat::Trachea);
        tube.note(atSeconds(4.0), noted(IntubationStep::PastCarina, TubeSeat::RightMain), size);
        QCOMPARE(placeAt(tube, 4.0).seat, TubeSeat::RightMain);
        tube.note(atSeconds(5.0), noted(IntubationStep::TubeOut, TubeSeat::None), size);
        QCOMPARE(placeAt(tube, 5.0).seat, TubeSeat::None);
        QCOMPARE(tube.notes().size(), std::size_t{5});
    }

    void takesAUsualTubeWhereItsDiameterIsNotKnown()
    {
        TubeTimeline tube;
        tube.note(atSeconds(1.0), noted(IntubationStep::ThroughCords, TubeSeat::Trachea), {});
        QCOMPARE(placeAt(tube, 1.0).innerDiameter, usualTube(40.0, Sex::Male));
        QVERIFY(placeAt(tube, 1.0).innerDiameter.si > 0.0);
    }

    void letsTheConsoleOverrideTheMonitorAndSaysSo()
    {
        TubeTimeline tube;
        const Length size = millimetres(7.5);
        tube.note(atSeconds(1.0), noted(IntubationStep::InOesophagus, TubeSeat::Oesophagus), size);
        tube.setOverride(atSeconds(2.0), {TubeSeat::Trachea, millimetres(6.0)});
        tube.setOverride(atSeconds(3.0), {});
        QCOMPARE(placeAt(tube, 1.9).seat, TubeSeat::Oesophagus);
        QVERIFY(!tube.isOverriddenAt(atSeconds(1.9)));
        QVERIFY(placeAt(tube, 2.0)
                == (TubePlace{TubeSeat::Trachea, millimetres(6.0), kEmptyCuffLeak}));
        QVERIFY(tube.isOverriddenAt(atSeconds(2.0)));
        QCOMPARE(placeAt(tube, 3.0).seat, TubeSeat::Oesophagus);
        QVERIFY(!tube.isOverriddenAt(atSeconds(3.0)));
    }

    void leaksUntilTheCuffIsInflated()
    {
        TubeTimeline tube;
        tube.note(atSeconds(1.0), noted(IntubationStep::ThroughCords, TubeSeat::Trachea), {});
        tube.setCuff(atSeconds(2.0), true);
        tube.setCuff(atSeconds(3.0), false);
        QCOMPARE(placeAt(tube, 1.9).leak, kEmptyCuffLeak);
        QCOMPARE(placeAt(tube, 2.0).leak, 0.0);
        QCOMPARE(placeAt(tube, 3.0).leak, kEmptyCuffLeak);
        tube.setOverride(atSeconds(4.0), {TubeSeat::RightMain, millimetres(6.0)});
        QCOMPARE(placeAt(tube, 4.0).leak, kEmptyCuffLeak); // only its place is said
        tube.setCuff(atSeconds(5.0), true);
        QCOMPARE(placeAt(tube, 5.0).leak, 0.0);
    }

    /// Nobody follows it, so nobody sees to its cuff.
    void doesNotLeakWhereTheConsoleAloneHasATube()
    {
        TubeTimeline tube;
        tube.note(atSeconds(1.0), noted(IntubationStep::CuffInflated, TubeSeat::None), {}); // tried
        tube.note(atSeconds(1.5), noted(IntubationStep::StyletOut, TubeSeat::None), {});
        tube.setOverride(atSeconds(2.0), {TubeSeat::Trachea, millimetres(6.0)});
        QCOMPARE(placeAt(tube, 2.0).leak, 0.0);
        QVERIFY(!tube.lastOfSeatAt(atSeconds(2.0)));
    }

    void emptiesTheCuffOfATubeThatIsTakenOut()
    {
        TubeTimeline tube;
        tube.note(atSeconds(1.0), noted(IntubationStep::InOesophagus, TubeSeat::Oesophagus), {});
        tube.setCuff(atSeconds(2.0), true);
        tube.note(atSeconds(3.0), noted(IntubationStep::TubeOut, TubeSeat::None), {});
        QVERIFY(tube.cuffInflatedAt(atSeconds(2.9)));
        QVERIFY(!tube.cuffInflatedAt(atSeconds(3.0)));
        tube.note(atSeconds(4.0), noted(IntubationStep::ThroughCords, TubeSeat::Trachea), {});
        QCOMPARE(placeAt(tube, 4.0).leak, kEmptyCuffLeak);
    }

    void isObstructedUntilTheTubeIsTakenOut()
    {
        TubeTimeline tube;
        tube.note(atSeconds(1.0), noted(IntubationStep::ThroughCords, TubeSeat::Trachea), {});
        tube.setObstruction(atSeconds(2.0), 0.6);
        QCOMPARE(placeAt(tube, 1.9).obstruction, 0.0);
        QCOMPARE(placeAt(tube, 2.0).obstruction, 0.6);
        QVERIFY(tube.changeAfter(atSeconds(1.0)) == atSeconds(2.0));
        tube.setOverride(atSeconds(3.0), {TubeSeat::Trachea, millimetres(6.0)});
        QCOMPARE(placeAt(tube, 3.0).obstruction, 0.6);
        tube.setOverride(atSeconds(4.0), {});
        QCOMPARE(placeAt(tube, 4.0).obstruction, 0.6); // it is still in
        tube.note(atSeconds(5.0), noted(IntubationStep::TubeOut, TubeSeat::None), {});
        QCOMPARE(placeAt(tube, 5.0).obstruction, 0.0);
    }

    void isObstructedNoLongerOnceTheConsoleHasNoTube()
    {
        TubeTimeline tube;
        tube.setObstruction(atSeconds(0.5), 0.6); // of the tube that is to come
        tube.setOverride(atSeconds(1.0), {TubeSeat::Trachea, millimetres(6.0)});
        QCOMPARE(placeAt(tube, 1.0).obstruction, 0.6);
        tube.setOverride(atSeconds(2.0), {});
        tube.setOverride(atSeconds(3.0), {TubeSeat::Trachea, millimetres(6.0)});
        QCOMPARE(placeAt(tube, 3.0).obstruction, 0.0);
    }

    void isObstructedAtTheConsoleWhereverTheTrackedTubeGoes()
    {
        TubeTimeline tube;
        tube.setOverride(atSeconds(1.0), {TubeSeat::Trachea, millimetres(6.0)});
        tube.setObstruction(atSeconds(2.0), 0.6);
        tube.note(atSeconds(3.0), noted(IntubationStep::TubeOut, TubeSeat::None), {});
        QCOMPARE(placeAt(tube, 3.0).obstruction, 0.6);
    }

    void knowsBladeAndStylet()
    {
        TubeTimeline tube;
        tube.note(atSeconds(1.0), noted(IntubationStep::BladeIn, TubeSeat::None), {});
        tube.note(atSeconds(4.0), noted(IntubationStep::BladeOut, TubeSeat::None), {});
        QVERIFY(!tube.bladeInMouthAt(atSeconds(0.9)));
        QVERIFY(tube.bladeInMouthAt(atSeconds(1.0)));
        QVERIFY(!tube.bladeInMouthAt(atSeconds(4.0)));
        tube.drawStylet(atSeconds(2.0));
        QVERIFY(!tube.styletInAt(atSeconds(2.0)));
        tube.note(atSeconds(5.0), noted(IntubationStep::TubeOut, TubeSeat::None), {});
        QVERIFY(tube.styletInAt(atSeconds(5.0)));
    }

    /// Until they are together again, or the tube is out; other steps tell nothing of it.
    void tellsWhetherBothShapesAreApart()
    {
        TubeTimeline tube;
        QVERIFY(!tube.areShapesApartAt(atSeconds(0.0)));
        tube.note(atSeconds(1.0), noted(IntubationStep::ShapesApart, TubeSeat::None), {});
        tube.note(atSeconds(2.0), noted(IntubationStep::ThroughCords, TubeSeat::Trachea), {});
        tube.note(atSeconds(3.0), noted(IntubationStep::ShapesTogether, TubeSeat::Trachea), {});
        tube.note(atSeconds(4.0), noted(IntubationStep::ShapesApart, TubeSeat::Trachea), {});
        tube.note(atSeconds(5.0), noted(IntubationStep::TubeOut, TubeSeat::None), {});
        const auto areApart = [&](double seconds) {
            return tube.areShapesApartAt(atSeconds(seconds));
        };
        QVERIFY(!areApart(0.9) && areApart(1.0) && areApart(2.5));
        QVERIFY(!areApart(3.0) && areApart(4.0) && !areApart(5.0));
    }

    void namesTheNextChange()
    {
        TubeTimeline tube;
        tube.note(atSeconds(1.0), noted(IntubationStep::BladeIn, TubeSeat::None), {});
        tube.note(atSeconds(2.0), noted(IntubationStep::GlottisSeen, TubeSeat::None), {});
        tube.note(atSeconds(3.0), noted(IntubationStep::ThroughCords, TubeSeat::Trachea), {});
        tube.setCuff(atSeconds(4.0), true);
        tube.setOverride(atSeconds(5.0), {TubeSeat::Trachea, millimetres(6.0)});
        const auto after = [&](double seconds) { return tube.changeAfter(atSeconds(seconds)); };
        QVERIFY(after(0.0) == atSeconds(1.0));
        QVERIFY(after(1.0) == atSeconds(3.0)); // the view changes nothing of the patient
        QVERIFY(after(3.0) == atSeconds(4.0));
        QVERIFY(after(4.0) == atSeconds(5.0));
        QVERIFY(after(5.0) == SessionTime::max());
    }

    void keepsTheLatestEntries()
    {
        TubeTimeline tube;
        constexpr int kMore = 10;
        for (int i = 0; i < int(TubeTimeline::kMostNotes) + kMore; ++i)
            tube.note(atSeconds(i), noted(IntubationStep::ThroughCords, TubeSeat::Trachea), {});
        QCOMPARE(tube.notes().size(), TubeTimeline::kMostNotes);
        QVERIFY(tube.notes().front().effect == atSeconds(kMore));
    }

    /// A hand that trembles for long.
    void keepsTheLastOfManyRests()
    {
        TubeTimeline tube;
        const auto note = [&tube](int second, IntubationStep step) {
            tube.note(atSeconds(second), noted(step, TubeSeat::Trachea), {});
        };
        note(0, IntubationStep::ThroughCords);
        constexpr int kRests = 2 * int(TubeTimeline::kMostNotes);
        for (int i = 1; i <= kRests; ++i)
            note(i, IntubationStep::AtRest);
        note(kRests + 1, IntubationStep::CuffInflated);
        note(kRests + 2, IntubationStep::AtRest);
        QCOMPARE(tube.notes().size(), std::size_t{4});
        QCOMPARE(tube.notes()[0].event.step, IntubationStep::ThroughCords);
        QVERIFY(tube.notes()[1].effect == atSeconds(kRests));
        QVERIFY(tube.notes()[3].effect == atSeconds(kRests + 2));
        QCOMPARE(placeAt(tube, 1.0).seat, TubeSeat::Trachea);
        QVERIFY(tube.changeAfter(atSeconds(5.0)) == atSeconds(6.0)); // each is of the patient's
    }

    void tellsWhatWasNotedSince()
    {
        TubeTimeline tube;
        const auto note = [&tube](IntubationStep step) {
            tube.note(atSeconds(1.0), noted(step, TubeSeat::Trachea), {});
        };
        QCOMPARE(tube.lastNote(), 0U);
        QVERIFY(tube.notesAfter(0).empty());
        note(IntubationStep::ThroughCords);
        note(IntubationStep::AtRest);
        const std::uint64_t seen = tube.lastNote();
        QCOMPARE(tube.notesAfter(0).size(), std::size_t{2});
        QVERIFY(tube.notesAfter(seen).empty());
        note(IntubationStep::AtRest); // in place of the one that was seen
        QCOMPARE(tube.notesAfter(seen).size(), std::size_t{1});
        QCOMPARE(tube.notesAfter(seen).front().number, tube.lastNote());
    }
};

CARINA_TEST(TestTubeTimeline)

} // namespace carina::test::tube_timeline_test

#include "tst_tube_timeline.moc"
