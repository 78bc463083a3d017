#include "models/intubation/intubation_watch.h"

#include "engine/anatomy/airway/airway_measure.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "models/intubation/sent_shape.h"
#include "models/patient/patient_source.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <QEventLoop>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace carina::intubation_watch_test
{
namespace
{

using test::FakeSessionNode;
using namespace std::chrono_literals;

constexpr double kDepth = 6e-3;  // m: the tube's line is not the airway's middle
constexpr double kAtRest = 9e-3; // m: a rod lies where it bends least, and not in the middle
constexpr double kTime = 0.1;    // s
constexpr double kSent_m = 1e-3; // by which a shape that is sent may be off

const PatientModel& patient()
{
    static const SharedPatientModel made =
        patientOf(builtinPatient(BuiltinPatient::TwelveYears).value()).value();
    return *made;
}

/// The same with a tube of the same form that was touched.
const PatientModel& touched()
{
    static const PatientModel made =
        patient().withTube(patient().tube().p_E_centre, patient().tube().outerDiameter);
    return made;
}

/// The trainee is at work with tube and laryngoscope, where a test says they are.
struct Work {
    explicit Work(ParticipantId self = FakeSessionNode::kTrainee) : node{self}
    {
        node.decide(fact::ObjectShared{
            {}, FakeSessionNode::kTrainee, ObjectKind::Laryngoscope, "Laryngoscope"});
        watch.lieIn(patient());
    }
    FakeSessionNode node;
    std::function<std::optional<RigidTransform>(SessionTime)> tube = [](SessionTime) {
        return std::nullopt;
    };
    std::function<std::optional<RigidTransform>(SessionTime)> blade = tube;
    IntubationWatch watch{node,
                          FakeSessionNode::kStation,
                          {.at = [this](ObjectKind kind, SessionTime t) { return poseOf(kind, t); },
                           .newest = [this](ObjectKind) { return node.now(); }}};

    [[nodiscard]] std::optional<PoseSample> poseOf(ObjectKind kind, SessionTime t) const
    {
        std::optional<RigidTransform> pose;
        if (kind == ObjectKind::Tube)
            pose = tube(t);
        if (kind == ObjectKind::Laryngoscope)
            pose = blade(t);
        return pose ? std::optional{PoseSample{.time = t, .X_FO = *pose}} : std::nullopt;
    }
    void runs() { node.decide(fact::PhaseChanged{SessionPhase::Running}); }
    [[nodiscard]] std::optional<StreamShape> shape() const
    {
        return node.shapes.at(ObjectKind::Tube)();
    }
    /// Until the lumen is measured, and a moment on.
    void measureLumen();
    void goOn(Duration time)
    {
        const SessionTime until = *node.now() + time;
        while (*node.now() < until) {
            node.advance(20ms);
            watch.look();
        }
    }
    /// Of what does not move a look now and then is enough.
    void rests(std::chrono::seconds time)
    {
        for (int i = 0; i < time.count(); ++i) {
            node.advance(1s);
            watch.look();
        }
    }
    /// Where the mechanics take the tube to be.
    [[nodiscard]] TubePlace place() const
    {
        const auto state = node.state();
        return state->stations().at(FakeSessionNode::kStation).respiration.tubePlaceAt(*node.now());
    }
    [[nodiscard]] std::vector<IntubationEvent> noted(IntubationStep step) const
    {
        std::vector<IntubationEvent> found;
        const auto state = node.state();
        const auto& timeline = state->stations().at(FakeSessionNode::kStation).respiration;
        for (const NotedStep& note : timeline.tube().notes())
            if (note.event.step == step)
                found.push_back(note.event);
        return found;
    }
};

/// The tube of the patient at its final depth, pushed deeper along the trachea.
RigidTransform pushed(double deeper)
{
    const Vec3 down = -waysOf(patient()).up_A();
    return RigidTransform::translation(deeper * down) * patient().tube().X_AE;
}

/// How it is drawn now.
TubeInAirway drawnNow(const Work& work)
{
    StationMoment moment;
    moment.time = *work.node.now();
    moment.worker = FakeSessionNode::kTrainee;
    moment.tube = work.poseOf(ObjectKind::Tube, moment.time);
    return work.watch.tubeAt(moment, {[](const Vec3& p_A, AirwayTissue) { return p_A; }, {}});
}

void Work::measureLumen()
{
    goOn(20ms);
    QEventLoop until;
    QObject::connect(&watch, &IntubationWatch::lumenMeasured, &until, &QEventLoop::quit);
    until.exec();
    goOn(20ms);
}

double secondsFrom(SessionTime begin, SessionTime t) { return toSeconds(t - begin); }

/// In the trachea, in which a tube ends that is pushed in.
double confidenceBy(const RegistrationStanding& standing, const PatientModel& who)
{
    Work work;
    work.watch.readStanding([standing] { return std::optional{standing}; });
    work.watch.lieIn(who);
    work.tube = [](SessionTime) { return pushed(0.0); };
    work.measureLumen();
    work.tube = [](SessionTime) { return pushed(-0.2); };
    work.goOn(1s);
    work.runs();
    const SessionTime begin = *work.node.now();
    work.tube = [begin](SessionTime t) {
        return pushed(std::min(0.05 * secondsFrom(begin, t), 0.2) - 0.2);
    };
    work.goOn(7s);
    const IntubationCourse& course = work.watch.course();
    return course.seat == TubeSeat::Trachea ? course.confidence : -1.0;
}

} // namespace

class TestIntubationWatch : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void notesATubeThatIsInItsPlace()
    {
        Work work;
        work.runs();
        work.tube = [](SessionTime) { return pushed(0.0); };
        work.goOn(2s);
        const auto through = work.noted(IntubationStep::ThroughCords);
        QCOMPARE(through.size(), 1U);
        QCOMPARE(through.front().seat, TubeSeat::Trachea);
        const double above = patient().tube().tipAboveCarina.si;
        QVERIFY(std::abs(through.front().tipAboveCarina.si - above) < kDepth);
        QVERIFY(std::abs(through.front().depthAtTeeth.si
                         - (teethToCarina(patient().landmarks()).si - above))
                < kDepth);
        QVERIFY(through.front().confidence < 0.75); // nobody saw it pass
        QVERIFY(work.noted(IntubationStep::InOesophagus).empty());
    }

    /// A tube of the site's that is thicker than the patient's usual one.
    void notesTheSizeOfTheTubeThatLiesThere()
    {
        const PatientModel thicker =
            patient().withTube(patient().tube().p_E_centre, outerDiameterOf(millimetres(7.5)));
        Work work;
        work.runs();
        work.tube = [](SessionTime) { return pushed(0.0); };
        work.goOn(2s);
        QCOMPARE(work.place().seat, TubeSeat::Trachea);
        QCOMPARE(inMillimetres(work.place().innerDiameter), 6.5);
        work.watch.lieIn(thicker);
        work.goOn(3s);
        QCOMPARE(inMillimetres(work.place().innerDiameter), 7.5);
    }

    /// 10 mm further after it was noted, and nothing else happens.
    void notesHowDeepTheTubeLiesInTheEnd()
    {
        Work work;
        work.runs();
        const SessionTime begin = *work.node.now();
        work.tube = [begin](SessionTime t) {
            return pushed(std::clamp(0.01 * (secondsFrom(begin, t) - 3.0), 0.0, 0.01));
        };
        work.goOn(8s);
        const auto rests = work.noted(IntubationStep::AtRest);
        QCOMPARE(rests.size(), 1U); // before it lay where it was noted
        const IntubationCourse& course = work.watch.course();
        const Length off = rests.back().depthAtTeeth - course.tip.depthAtTeeth;
        QVERIFY(std::abs(off.si) < RestWatch::kStill.si);
        QCOMPARE(rests.back().seat, TubeSeat::Trachea);
    }

    void notesATubeThatIsPushedPastTheCarina()
    {
        Work work;
        work.runs();
        const SessionTime begin = *work.node.now();
        constexpr double kSpeed = 0.02; // m/s, from 2 s on, by 55 mm
        work.tube = [begin](SessionTime t) {
            return pushed(std::clamp(kSpeed * (secondsFrom(begin, t) - 2.0), 0.0, 0.055));
        };
        work.goOn(6s);
        const auto past = work.noted(IntubationStep::PastCarina);
        QCOMPARE(past.size(), 1U);
        const double at = 2.0 + patient().tube().tipAboveCarina.si / kSpeed;
        QVERIFY(std::abs(secondsFrom(begin, past.front().at) - at) < kTime + kDepth / kSpeed);
        QVERIFY(work.watch.course().tip.aboveCarina < Length{});
    }

    void notesTheBlade()
    {
        Work work;
        work.runs();
        const SessionTime begin = *work.node.now();
        const RigidTransform inMouth = Laryngoscopy::of(patient(), bladeOf(BladeKind::Macintosh3))
                                           ->pose(LaryngoscopyStep::Uvula, kUsualLift)
                                           .X_AL;
        work.blade = [begin, inMouth](SessionTime t) {
            const bool isIn = secondsFrom(begin, t) > 1.0 && secondsFrom(begin, t) < 4.0;
            return isIn ? inMouth : RigidTransform::translation({0.0, -0.4, 0.3});
        };
        work.watch.readView([] {
            GlotticView view;
            view.opening = 0.5;
            return std::optional{view};
        });
        work.goOn(8s);
        const auto in = work.noted(IntubationStep::BladeIn);
        const auto out = work.noted(IntubationStep::BladeOut);
        QVERIFY(in.size() == 1 && out.size() == 1);
        QVERIFY(std::abs(secondsFrom(begin, in.front().at) - 1.0) < kTime);
        QVERIFY(std::abs(secondsFrom(begin, out.front().at) - 4.0) < kTime);
        QCOMPARE(work.noted(IntubationStep::GlottisSeen).size(), 1U);
    }

    /// Of which no time passes for who is intubated: the blade is lost for 20 s, of which the
    /// session runs for one.
    void forgetsNoBladeThatIsLostInAPause()
    {
        Work work;
        work.runs();
        const RigidTransform inMouth = Laryngoscopy::of(patient(), bladeOf(BladeKind::Macintosh3))
                                           ->pose(LaryngoscopyStep::Uvula, kUsualLift)
                                           .X_AL;
        work.blade = [inMouth](SessionTime) { return inMouth; };
        work.goOn(2s);
        QCOMPARE(work.noted(IntubationStep::BladeIn).size(), 1U);
        work.node.decide(fact::PhaseChanged{SessionPhase::Paused});
        work.blade = [](SessionTime) { return std::nullopt; };
        work.goOn(20s);
        work.runs();
        work.goOn(1s);
        QVERIFY(work.noted(IntubationStep::BladeOut).empty());
        work.blade = [inMouth](SessionTime) { return inMouth; };
        work.goOn(1s);
        QCOMPARE(work.noted(IntubationStep::BladeIn).size(), 1U);
        work.blade = [](SessionTime) { return std::nullopt; };
        work.goOn(9s);
        QVERIFY(work.noted(IntubationStep::BladeOut).empty());
        work.goOn(2s);
        QCOMPARE(work.noted(IntubationStep::BladeOut).size(), 1U);
    }

    /// They work with another tube, which is not in the patient.
    void notesThatTheTubeOfWhoWorkedBeforeIsOut()
    {
        Work work;
        work.runs();
        work.tube = [](SessionTime) { return pushed(0.0); };
        work.goOn(2s);
        work.node.decide(fact::CuffSet{true});
        work.goOn(1s);
        QCOMPARE(work.place().seat, TubeSeat::Trachea);
        const auto isWorkOf = [&work](ParticipantId next) {
            const ParticipantId before = work.node.state()->atWork(FakeSessionNode::kStation);
            work.node.decide(fact::WorkTaken{next, before});
            work.goOn(1s);
            QCOMPARE(work.node.state()->atWork(FakeSessionNode::kStation), next);
        };
        isWorkOf(FakeSessionNode::kInstructor);
        QVERIFY(work.noted(IntubationStep::TubeOut).empty());
        isWorkOf(FakeSessionNode::kTrainee); // with the same tube
        work.goOn(2s);
        QVERIFY(work.noted(IntubationStep::AtRest).empty());
        QCOMPARE(work.noted(IntubationStep::TubePastTeeth).size(), 1U);
        QCOMPARE(work.noted(IntubationStep::ThroughCords).size(), 1U);
        isWorkOf(FakeSessionNode::kInstructor);
        work.tube = [](SessionTime) { return RigidTransform::translation({0.0, -0.4, 0.3}); };
        isWorkOf(FakeSessionNode::kTrainee);
        QCOMPARE(work.noted(IntubationStep::TubeOut).size(), 1U);
        QCOMPARE(work.place().seat, TubeSeat::None);
        const auto state = work.node.state();
        const Station& station = state->stations().at(FakeSessionNode::kStation);
        QVERIFY(!station.respiration.tube().cuffInflatedAt(*work.node.now()));
    }

    /// Its curve at rest was not touched; a simulated one has that which is assumed.
    void asksWhereARealTubeIsOfWhichTheBendIsNotKnown()
    {
        QVERIFY(confidenceBy({RegistrationState::Simulated, {}, {}}, patient()) > 0.7);
        QVERIFY(confidenceBy({RegistrationState::Good, {}, {}}, patient())
                <= IntubationMonitor::kTipNotKnown);
        QVERIFY(confidenceBy({RegistrationState::Good, {}, {}}, touched()) > 0.7);
        for (const auto state :
             {RegistrationState::NotGood, RegistrationState::Stale, RegistrationState::Missing})
            QVERIFY(confidenceBy({state, {}, {}}, touched()) <= IntubationMonitor::kTipNotKnown);
    }

    /// Trachea and oesophagus are less than that apart.
    void isLessSureByARegistrationThatIsFarOff()
    {
        const double close =
            confidenceBy({RegistrationState::Good, {}, millimetres(3.0)}, touched());
        const double far =
            confidenceBy({RegistrationState::Good, {}, millimetres(30.0)}, touched());
        QVERIFY2(far < 0.8 && close > far + 0.1,
                 qPrintable(QStringLiteral("%1 %2").arg(close).arg(far)));
    }

    /// What was decided of who worked before takes effect later than the change of who works.
    void knowsWhatIsStillToTakeEffect()
    {
        Work work;
        work.runs();
        work.goOn(1s);
        const ParticipantId instructor = FakeSessionNode::kInstructor;
        work.node.decide(fact::WorkTaken{instructor, FakeSessionNode::kTrainee});
        work.tube = [](SessionTime) { return RigidTransform::translation({0.0, -0.4, 0.3}); };
        work.goOn(1s);
        work.node.decide(fact::IntubationNoted{{.step = IntubationStep::ThroughCords,
                                                .at = *work.node.now(),
                                                .seat = TubeSeat::Trachea},
                                               {}});
        work.node.decide(fact::WorkTaken{FakeSessionNode::kTrainee, instructor});
        QCOMPARE(work.place().seat, TubeSeat::None);
        work.watch.look();
        work.goOn(3s);
        QCOMPARE(work.noted(IntubationStep::TubeOut).size(), 1U);
        QCOMPARE(work.place().seat, TubeSeat::None);
    }

    void notesWhatPeopleSet()
    {
        Work work;
        work.runs();
        work.tube = [](SessionTime) { return pushed(0.0); };
        work.goOn(2s);
        work.node.decide(fact::StyletDrawn{});
        work.node.decide(fact::CuffSet{true});
        work.goOn(2s);
        work.node.decide(fact::CuffSet{false});
        work.goOn(1s);
        const auto inflated = work.noted(IntubationStep::CuffInflated);
        QVERIFY(inflated.size() == 1 && inflated.front().seat == TubeSeat::Trachea);
        QVERIFY(inflated.front().depthAtTeeth > millimetres(100.0));
        QCOMPARE(work.noted(IntubationStep::CuffDeflated).size(), 1U);
        QCOMPARE(work.noted(IntubationStep::StyletOut).size(), 1U);
        QVERIFY(work.noted(IntubationStep::FirstBreath).empty());
    }

    /// A mask's breaths before are not through the tube, nor is the one that goes on as it comes
    /// there.
    void notesTheFirstBreathThroughTheTube()
    {
        Work work;
        work.runs();
        const SessionTime begin = *work.node.now();
        work.node.decide(fact::BagSqueezed{{.rate = perMinute(12.0)}});
        work.tube = [begin](SessionTime t) -> std::optional<RigidTransform> {
            if (secondsFrom(begin, t) < 2.0)
                return std::nullopt;
            return pushed(0.0);
        };
        work.goOn(4s); // the bag has been at work with the tube in place
        QVERIFY(work.noted(IntubationStep::FirstBreath).empty());
        work.goOn(6s);
        const auto first = work.noted(IntubationStep::FirstBreath);
        QCOMPARE(first.size(), 1U);
        const auto through = work.noted(IntubationStep::ThroughCords);
        QVERIFY(through.size() == 1 && first.front().at > through.front().at);
        QCOMPARE(first.front().seat, TubeSeat::Trachea);
    }

    /// The patient's own spasm shuts the cords: too little of a hypnotic, and a blade.
    void notesATubeThatPassesCordsInSpasm()
    {
        Work work;
        work.runs();
        work.goOn(20ms); // from when on this program watches: it sees no blade
        work.node.decide(fact::GasSupplySet{{1.0, true, true}});
        work.node.decide(fact::DrugGiven{{DrugKind::Propofol, 40.0}}); // 1 mg/kg
        work.node.decide(
            fact::IntubationNoted{{.step = IntubationStep::BladeIn, .at = *work.node.now()}, {}});
        RespirationFollower follower;
        const auto spasm = [&] {
            const auto state = work.node.state();
            const Station& station = state->stations().at(FakeSessionNode::kStation);
            return follower.at(station.respiration, *work.node.now()).spasm();
        };
        for (int i = 0; i < 120 && spasm() < 0.97; ++i) {
            work.node.advance(1s);
            work.watch.look();
        }
        QVERIFY2(spasm() >= 0.97, qPrintable(QString::number(spasm())));
        work.goOn(1s);
        QVERIFY(work.noted(IntubationStep::PassedShut).empty());
        work.tube = [](SessionTime) { return pushed(0.0); };
        work.goOn(2s);
        QCOMPARE(work.noted(IntubationStep::PassedShut).size(), 1U);
        QCOMPARE(spasm(), 0.0); // the tube holds them open
    }

    /// As soon as the lumen is measured; a tube that lies in its place does so in the airway, too.
    void bendsTheTubeInTheAirway()
    {
        Work work;
        work.watch.lieIn(touched());
        work.tube = [](SessionTime) { return pushed(0.0); };
        work.measureLumen();
        work.goOn(500ms); // until it rests
        QVERIFY(!drawnNow(work).p_E.empty());
        const TubeShape& shape = touched().tube();
        const TubeInAirway drawn = drawnNow(work);
        QVERIFY((drawn.p_E.front() - shape.p_E_centre.front()).norm() < 1e-9);
        QVERIFY((drawn.p_E.back() - shape.p_E_tip).norm() < kAtRest);
        QCOMPARE(drawn.drawing, TubeDrawing::InAirway);
        work.runs();
        work.goOn(2s);
        const auto through = work.noted(IntubationStep::ThroughCords);
        QCOMPARE(through.size(), 1U);
        QCOMPARE(through.front().seat, TubeSeat::Trachea);
    }

    /// Its curve at rest is the form of the airway: so it says, and that it is the patient's.
    void bendsATubeThatWasNotTouched()
    {
        Work work;
        work.tube = [](SessionTime) { return pushed(0.0); };
        work.measureLumen();
        work.goOn(500ms); // until it rests
        const TubeInAirway drawn = drawnNow(work);
        QCOMPARE(drawn.drawing, TubeDrawing::InAirway);
        QVERIFY((drawn.p_E.back() - patient().tube().p_E_tip).norm() < kAtRest);
        const auto sent = work.shape();
        QVERIFY(sent && sent->isOfPatientsTube());
        const TubeShape& own = patient().ownTube();
        const Vec3 p_E_told = lineOf(toStream(atRest(own), own, drawn.p_E, sent->time), own).back();
        QVERIFY((lineOf(*sent, own).back() - p_E_told).norm() < kSent_m);
    }

    void saysThatTheLumenIsBeingMeasured()
    {
        Work work;
        work.watch.lieIn(touched());
        work.tube = [](SessionTime) { return pushed(0.0); };
        work.goOn(20ms);
        QVERIFY(drawnNow(work).p_E.empty());
        QCOMPARE(drawnNow(work).drawing, TubeDrawing::Awaited);
    }

    /// As it is drawn, as long as it is seen and this program's participant is at work.
    void sendsHowTheTubeBends()
    {
        Work work;
        work.watch.lieIn(touched());
        work.tube = [](SessionTime) { return pushed(0.0); };
        QVERIFY(!work.shape());
        work.measureLumen();
        QVERIFY(!drawnNow(work).p_E.empty());
        const auto sent = work.shape();
        QVERIFY(sent);
        QVERIFY(*work.node.now() - sent->time < IntubationWatch::kShapeEach);
        QVERIFY(!sent->isOfPatientsTube());
        const TubeShape& own = touched().ownTube();
        const std::vector<Vec3> drawn =
            lineOf(toStream(atRest(touched().tube()), own, drawnNow(work).p_E, sent->time), own);
        const std::vector<Vec3> line = lineOf(*sent, own);
        QCOMPARE(line.size(), drawn.size());
        for (std::size_t i = 0; i < line.size(); ++i)
            QVERIFY((line[i] - drawn[i]).norm() < kSent_m);
        work.tube = [](SessionTime) { return std::nullopt; };
        work.goOn(IntubationWatch::kShapeEach);
        QVERIFY(!work.shape());
        work.tube = [](SessionTime) { return pushed(0.0); };
        work.goOn(IntubationWatch::kShapeEach);
        QVERIFY(work.shape());
        work.node.becomes(FakeSessionNode::kInstructor);
        work.goOn(IntubationWatch::kShapeEach);
        QVERIFY(!work.shape());
    }

    /// Its tip is held by the airway's wall where the real one is far to the side.
    void tellsThatTheShapesPart()
    {
        Work work;
        work.watch.lieIn(touched());
        work.runs();
        work.tube = [](SessionTime) { return pushed(0.0); };
        work.measureLumen();
        QVERIFY(!drawnNow(work).p_E.empty());
        const SessionTime begin = *work.node.now();
        work.tube = [begin](SessionTime t) {
            const double aside = std::min(0.02 * secondsFrom(begin, t), 0.015);
            return RigidTransform::translation({aside, 0.0, 0.0}) * pushed(0.0);
        };
        work.goOn(3s);
        QCOMPARE(drawnNow(work).drawing, TubeDrawing::Apart);
        QCOMPARE(work.noted(IntubationStep::ShapesApart).size(), 1U);
    }

    /// Its curve at rest is assumed: that says nothing of where the real one is.
    void tellsNothingOfShapesWhoseCurveIsNotKnown()
    {
        Work work;
        work.runs();
        work.tube = [](SessionTime) {
            return RigidTransform::translation({0.015, 0.0, 0.0}) * pushed(0.0);
        };
        work.measureLumen();
        work.goOn(3s);
        QCOMPARE(drawnNow(work).drawing, TubeDrawing::InAirway);
        QVERIFY(work.noted(IntubationStep::ShapesApart).empty());
    }

    void forgetsTheTubeOfAnotherPatient()
    {
        const PatientModel other =
            patient().withTube(patient().tube().p_E_centre, millimetres(7.0));
        Work work;
        work.watch.lieIn(touched());
        work.tube = [](SessionTime) { return pushed(0.0); };
        work.measureLumen();
        QVERIFY(!drawnNow(work).p_E.empty());
        work.watch.lieIn(other);
        QVERIFY(drawnNow(work).p_E.empty());
        work.goOn(20ms); // its lumen is another one
        QVERIFY(drawnNow(work).p_E.empty());
    }

    void notesNothingWhileTheSessionDoesNotRun()
    {
        Work work;
        work.tube = [](SessionTime) { return pushed(0.0); };
        work.goOn(2s);
        QCOMPARE(work.node.proposed, 0);
    }

    void notesNothingOfTheWorkOfOthers()
    {
        Work work{FakeSessionNode::kInstructor};
        work.runs();
        work.tube = [](SessionTime) { return pushed(0.0); };
        work.goOn(2s);
        QCOMPARE(work.node.proposed, 0);
    }

    void notesNothingWithoutAPatient()
    {
        FakeSessionNode node{FakeSessionNode::kTrainee};
        node.decide(fact::PhaseChanged{SessionPhase::Running});
        IntubationWatch watch{node, FakeSessionNode::kStation, {}};
        node.advance(1s);
        watch.look();
        QCOMPARE(node.proposed, 0);
    }

    /// The same step again is noted a while later, as the session takes it.
    void allThatIsProposedIsTaken()
    {
        Work work;
        work.runs();
        const SessionTime begin = *work.node.now();
        work.tube = [begin](SessionTime t) {
            return pushed(0.030 + 0.022 * std::sin(3.0 * secondsFrom(begin, t)));
        };
        work.goOn(10s);
        QVERIFY(work.noted(IntubationStep::PastCarina).size() > 2);
        std::size_t steps = 0;
        for (int step = 0; step <= int(kLastIntubationStep); ++step)
            steps += work.noted(IntubationStep(step)).size();
        QCOMPARE(int(steps), work.node.proposed);
    }

    /// What happened meanwhile would be too old for the session.
    void losesNoStepWhileTheHostIsAway()
    {
        Work work;
        work.runs();
        work.goOn(1s);
        work.node.hostGoesAway();
        work.tube = [](SessionTime) { return pushed(0.0); };
        work.goOn(2s);
        work.tube = [](SessionTime) { return pushed(0.055); };
        work.goOn(10s);
        QCOMPARE(work.node.proposed, 1); // the next waits for the answer
        work.node.hostComesBack();
        QVERIFY(work.noted(IntubationStep::TubePastTeeth).empty()); // it came too late
        work.goOn(1s);
        QCOMPARE(work.noted(IntubationStep::TubePastTeeth).size(), 1U);
        QCOMPARE(work.noted(IntubationStep::ThroughCords).size(), 1U);
        QCOMPARE(work.noted(IntubationStep::PastCarina).size(), 1U);
        QVERIFY(work.place().seat == work.watch.course().seat);
    }

    /// What arrives after 6 s is never news.
    void givesUpAStepThatIsAlwaysLate()
    {
        Work work;
        work.runs();
        work.goOn(1s);
        work.node.isFarAway(6s);
        work.tube = [](SessionTime) { return pushed(0.0); };
        work.goOn(1s); // past the teeth, through the cords
        work.rests(120s);
        QCOMPARE(work.node.proposed, 2 * IntubationWatch::kMostProposals);
        QVERIFY(work.noted(IntubationStep::ThroughCords).empty());
    }

    /// The third step waits for two answers of 3 s each, and arrives when it is too old.
    void allowsForTheTimeOnASlowPath()
    {
        Work work;
        work.runs();
        work.goOn(1s);
        work.node.isFarAway(1500ms);
        work.tube = [](SessionTime) { return pushed(0.055); };
        work.goOn(1s);
        work.rests(30s);
        QCOMPARE(work.noted(IntubationStep::TubePastTeeth).size(), 1U);
        QCOMPARE(work.noted(IntubationStep::ThroughCords).size(), 1U);
        QCOMPARE(work.noted(IntubationStep::PastCarina).size(), 1U);
        QVERIFY(work.node.proposed > 3);
    }

    /// A program that joins again hears the answers first, and shows the facts a little later.
    void notesAStepOnceWhoseAnswerWasLost()
    {
        Work work;
        work.runs();
        work.goOn(1s);
        work.node.hearsNothing();
        work.tube = [](SessionTime) { return pushed(0.0); };
        work.goOn(7s);
        work.node.hearsAnswers();
        work.goOn(100ms);
        work.node.hearsFacts();
        work.goOn(2s);
        QCOMPARE(work.noted(IntubationStep::TubePastTeeth).size(), 1U);
        QCOMPARE(work.noted(IntubationStep::ThroughCords).size(), 1U);
        QCOMPARE(work.node.proposed, 2);
    }

    /// Somebody plays with the cuff meanwhile.
    void keepsTheLatestStepsWhileTheHostIsAway()
    {
        Work work;
        work.runs();
        work.tube = [](SessionTime) { return pushed(0.0); };
        work.goOn(1s);
        const int before = work.node.proposed;
        work.node.hostGoesAway();
        for (std::size_t i = 0; i < 2 * IntubationWatch::kMostQueued; ++i) {
            work.node.decide(fact::CuffSet{i % 2 == 0});
            work.goOn(200ms);
        }
        work.node.hostComesBack();
        work.rests(90s);
        QCOMPARE(work.noted(IntubationStep::CuffInflated).size()
                     + work.noted(IntubationStep::CuffDeflated).size(),
                 IntubationWatch::kMostQueued);
        QCOMPARE(work.node.proposed - before, int(IntubationWatch::kMostQueued) + 1);
    }
};

CARINA_TEST(TestIntubationWatch)

} // namespace carina::intubation_watch_test

#include "tst_intubation_watch.moc"
