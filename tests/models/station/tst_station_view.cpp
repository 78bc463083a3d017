#include "engine/anatomy/events/swallow.h"
#include "engine/lungs/drawing/chest_drawing.h"
#include "models/errors/error_text.h"
#include "models/station/station_notice.h"
#include "models/station/station_view.h"
#include "tests/engine/lungs/drawing/lung_like_mesh.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <map>

namespace carina::station_view_test
{
namespace
{

using std::chrono::milliseconds;
using test::FakeSessionNode;

constexpr SessionTime kNow{std::chrono::seconds{1000}}; ///< where the fake session begins
constexpr LocalTime kLit{std::chrono::seconds{2000}};   ///< which it takes for its own time

/// Of a program with a tracker.
const RegistrationStanding kStanding{RegistrationState::Simulated, StaleReason::None, {}};

LungPair lungs()
{
    Anatomy anatomy;
    anatomy.parts = {{"Right lung",
                      PartRole::RightLung,
                      {},
                      {test::lungLikeMesh({-0.06, 0.0, -0.02}, {0.045, 0.065, 0.09}, 12, 24)}},
                     {"Left lung",
                      PartRole::LeftLung,
                      {},
                      {test::lungLikeMesh({0.06, 0.0, -0.02}, {0.045, 0.065, 0.09}, 12, 24)}}};
    return LungPair::of(anatomy).value();
}

/// Poses whose place tells for what and when they were asked: x is the kind, y the seconds.
PoseSample tellingPose(ObjectKind kind, SessionTime t)
{
    PoseSample sample;
    sample.time = t;
    sample.X_FO = RigidTransform::translation(
        {static_cast<double>(kind), toSeconds(t.time_since_epoch()), 0.0});
    return sample;
}

ObjectPoses tellingPoses(SessionTime newest)
{
    return {.at = [](ObjectKind kind, SessionTime t) { return tellingPose(kind, t); },
            .newest = [newest](ObjectKind) { return newest; }};
}

bool tells(const std::optional<PoseSample>& sample, ObjectKind kind, SessionTime t)
{
    return sample && sample->X_FO.translation() == tellingPose(kind, t).X_FO.translation();
}

} // namespace

class TestStationView : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void asksEverythingForTheTimeOfLight();
    void nobodysTubeIsThePatientsWhileNobodyIsAtWork();
    void breathesAtTheTimeOfLight();
    void hasTheAirwayOfTheTimeOfLight();
    void swallowsAgainAndAgainAtEverySiteAlike();
    void shutsTheCordsOfWhoSleepsTooLightly();
    void hasTheHeadAsItLiesAtTheTimeOfLight();
    void exaggeratesOnlyWhereAsked();
    void showsRestBeforeTheClockIsSet();
    void showsThePatientAsActionsHaveItAtTheTimeOfLight();
    void tellsHowTheTubeIsDrawn();
    void bendsTheTubeOfAnotherAsItWasSent();
    void tellsForAWhileThatOneWasMoved();
    void tellsForAWhileWhatWasTakenFromOne();
    void saysThatThePatientIsAway();
    void saysWhatWasDecidedAboutItsParticipant();
    void saysWhenTheHeadsetIsLost_data();
    void saysWhenTheHeadsetIsLost();
    void saysThatAHeadsetWasNotSeenYet();
    void saysHowToLookAroundWithoutATracker();
    void knowsTheOwnPlaceAndWhetherAHeadIsAwaited();
    void saysThatThereIsNoTracker_data();
    void saysThatThereIsNoTracker();
    void saysThatTheSessionHasEnded();
    void saysThatItIsPausedAlsoWhileItConnects();
    void offersAnotherSessionWhileTheHostIsSilent();
    void showsWhatAnInstructorShowsToThisParticipant();
    void looksFromWhereTheInstructorDoes();
};

void TestStationView::asksEverythingForTheTimeOfLight()
{
    const FakeSessionNode node{FakeSessionNode::kTrainee}; // who is at work
    const LungPair pair = lungs();
    const SessionTime lit{kLit.time_since_epoch()};
    const StationView view{node, FakeSessionNode::kStation, pair,
                           tellingPoses(lit - milliseconds{30})};
    const StationMoment moment = view.litAt(kLit, 0);
    QVERIFY(moment.time == lit);
    QVERIFY(tells(moment.tube, ObjectKind::Tube, lit));
    QVERIFY(tells(moment.jaw, ObjectKind::Jaw, lit));
    QVERIFY(tells(moment.head, ObjectKind::Head, lit));
    QVERIFY(moment.sampleAge == milliseconds{30});
}

void TestStationView::nobodysTubeIsThePatientsWhileNobodyIsAtWork()
{
    FakeSessionNode node; // of an instructor
    const LungPair pair = lungs();
    const StationView view{node, FakeSessionNode::kStation, pair, tellingPoses(kNow)};
    node.decide(fact::ParticipantLeft{FakeSessionNode::kTrainee});
    const StationMoment alone = view.at(kNow, 0);
    QVERIFY(alone.worker == kNobody);
    QVERIFY(!alone.tube && !alone.jaw && !alone.sampleAge);
    QVERIFY(tells(alone.head, ObjectKind::Head, kNow));
    node.decide(fact::WorkTaken{FakeSessionNode::kInstructor}, FakeSessionNode::kInstructor);
    QVERIFY(tells(view.at(kNow, 0).tube, ObjectKind::Tube, kNow));
    node.decide(fact::ParticipantLeft{FakeSessionNode::kInstructor});
    node.becomes(kNobody); // as before it is admitted
    QVERIFY(tells(view.at(kNow, 0).tube, ObjectKind::Tube, kNow));
}

void TestStationView::breathesAtTheTimeOfLight()
{
    FakeSessionNode node;
    node.decide(fact::PhaseChanged{SessionPhase::Running});
    const LungPair pair = lungs();
    const StationView view{node, FakeSessionNode::kStation, pair, tellingPoses(kNow)};
    const RespirationTimeline timeline =
        node.state()->stations().at(FakeSessionNode::kStation).respiration;
    for (const int ms : {1000, 1040, 4000, 2500}) {
        const SessionTime t = kNow + milliseconds{ms};
        PatientRun run{timeline, t};
        run.advanceTo(timeline, t);
        const StationMoment moment = view.at(t, 0);
        QVERIFY(moment.breathing == run.shape());
        QCOMPARE(moment.pose, drawnPose(pair, run.shape(), 0));
    }
    const auto diaphragm = [&](int ms) {
        return view.at(kNow + milliseconds{ms}, 0).pose.lungs[0].diaphragm;
    };
    QVERIFY(std::abs(diaphragm(1040) - diaphragm(1000)) > 1e-3);
}

/// A tongue that swells over 10 s is at its half after five of them.
void TestStationView::hasTheAirwayOfTheTimeOfLight()
{
    FakeSessionNode node;
    const LungPair pair = lungs();
    const StationView view{node, FakeSessionNode::kStation, pair};
    node.decide(
        fact::AirwayEventsSet{{{AirwayEventKind::TongueOedema, 0.5}}, std::chrono::seconds{10}});
    const SessionTime effect = kNow + kShortestLead;
    QVERIFY(view.at(effect, 0).airwayEvents.empty());
    const AirwayEvents half{{AirwayEventKind::TongueOedema, 0.25}};
    QVERIFY(view.at(effect + std::chrono::seconds{5}, 0).airwayEvents == half);
    const AirwayEvents all{{AirwayEventKind::TongueOedema, 0.5}};
    QVERIFY(view.at(effect + std::chrono::seconds{20}, 0).airwayEvents == all);
}

/// By as much of the severity as the swallow has come to, also for who looks later; a relaxed
/// patient does not.
void TestStationView::swallowsAgainAndAgainAtEverySiteAlike()
{
    constexpr double kSeverity = 0.8;
    FakeSessionNode node;
    const LungPair pair = lungs();
    const StationView first{node, FakeSessionNode::kStation, pair};
    node.decide(fact::PhaseChanged{SessionPhase::Running});
    node.decide(fact::AirwayEventsSet{{{AirwayEventKind::Swallowing, kSeverity}}, {}});
    node.advance(std::chrono::seconds{1});
    const auto next = [&] { // at the height of the next swallow
        const Duration since = node.now()->time_since_epoch();
        node.advance(kSwallowEvery - since % kSwallowEvery + milliseconds{1000});
        return *node.now();
    };
    const auto amount = [&](const StationView& view, SessionTime t) {
        return severityOf(view.at(t, 0).airwayEvents, AirwayEventKind::Swallowing);
    };
    for (int swallow = 0; swallow < 3; ++swallow) {
        const SessionTime height = next();
        const StationView late{node, FakeSessionNode::kStation, pair};
        for (const int ms : {-1200, -900, -700, -300, 0, 200, 500, 900, 1300, 3000}) {
            const SessionTime t = height + milliseconds{ms};
            QCOMPARE(amount(first, t), kSeverity * swallowAt(t));
            QCOMPARE(amount(late, t), amount(first, t));
        }
        QCOMPARE(amount(first, height), kSeverity);
    }
    node.decide(fact::DrugGiven{{DrugKind::Suxamethonium, 60.0}});
    for (int second = 0; second < 60; ++second) {
        node.advance(std::chrono::seconds{1});
        amount(first, *node.now());
    }
    QVERIFY(amount(first, next()) < 0.1);
}

/// Half of the way to the sniffing position after half of 10 s; a neck that is half as stiff as can
/// be is flexed by half of 35 degrees at most.
/// By the patient's own spasm, as in the mechanics, until a relaxant acts.
void TestStationView::shutsTheCordsOfWhoSleepsTooLightly()
{
    FakeSessionNode node;
    const LungPair pair = lungs();
    const StationView view{node, FakeSessionNode::kStation, pair};
    const auto spasmNow = [&] {
        return severityOf(view.at(*node.now(), 0).airwayEvents, AirwayEventKind::Laryngospasm);
    };
    RespirationFollower follower;
    const auto mechanicsNow = [&] {
        const auto state = node.state();
        const Station& station = state->stations().at(FakeSessionNode::kStation);
        return follower.at(station.respiration, *node.now()).spasm();
    };
    const auto goOn = [&](int seconds) {
        for (int i = 0; i < seconds; ++i) {
            node.advance(std::chrono::seconds{1});
            QVERIFY(spasmNow() >= mechanicsNow());
        }
    };
    node.decide(fact::PhaseChanged{SessionPhase::Running});
    node.decide(fact::DrugGiven{{DrugKind::Propofol, 40.0}}); // 1 mg/kg: too little
    goOn(75);
    QCOMPARE(spasmNow(), 0.0);
    node.decide(fact::IntubationNoted{{.step = IntubationStep::BladeIn, .at = *node.now()}, {}});
    goOn(15);
    QVERIFY2(spasmNow() > 0.5, qPrintable(QString::number(spasmNow())));
    QCOMPARE(spasmNow(), mechanicsNow());
    node.decide(fact::AirwayEventsSet{{{AirwayEventKind::Laryngospasm, 1.0}}, {}});
    goOn(1);
    QCOMPARE(spasmNow(), 1.0); // the worse of both
    node.decide(fact::AirwayEventsSet{});
    node.decide(fact::DrugGiven{{DrugKind::Suxamethonium, 60.0}});
    goOn(60);
    QVERIFY2(spasmNow() < 0.1, qPrintable(QString::number(spasmNow())));
}

void TestStationView::hasTheHeadAsItLiesAtTheTimeOfLight()
{
    constexpr double kRounding = 1e-12; // radians
    FakeSessionNode node;
    const LungPair pair = lungs();
    const StationView view{node, FakeSessionNode::kStation, pair};
    QVERIFY(view.at(kNow, 0).headPosition == HeadPosition{});
    node.decide(fact::HeadPositionSet{kSniffing, std::chrono::seconds{10}});
    const SessionTime effect = kNow + kShortestLead;
    QVERIFY(view.at(effect, 0).headPosition == HeadPosition{});
    const HeadPosition half = view.at(effect + std::chrono::seconds{5}, 0).headPosition;
    QVERIFY(std::abs(half.flexion.si - 0.5 * kSniffing.flexion.si) < kRounding);
    QVERIFY(std::abs(half.extension.si - 0.5 * kSniffing.extension.si) < kRounding);
    QVERIFY(view.at(effect + std::chrono::seconds{10}, 0).headPosition == kSniffing);
    node.decide(fact::AirwayEventsSet{{{AirwayEventKind::StiffNeck, 0.5}}, {}});
    const HeadPosition stiff = view.at(effect + std::chrono::seconds{10}, 0).headPosition;
    QVERIFY(std::abs(stiff.flexion.si - 0.5 * kMostFlexion.si) < kRounding);
    QVERIFY(std::abs(stiff.extension.si - 0.5 * kMostExtension.si) < kRounding);
}

void TestStationView::showsWhatAnInstructorShowsToThisParticipant()
{
    const LungPair pair = lungs();
    FakeSessionNode node{FakeSessionNode::kTrainee};
    const StationView view{node, FakeSessionNode::kStation, pair};
    QVERIFY(!view.at(kNow, 0).lesson);
    const auto show = [&](ParticipantId to) {
        node.decide(fact::LessonShown{to, {{}, true, {}}}, FakeSessionNode::kInstructor);
    };
    show(FakeSessionNode::kObserver);
    QVERIFY(!view.at(kNow, 0).lesson);
    show(kNobody);
    QVERIFY(view.at(kNow, 0).lesson && view.at(kNow, 0).lesson->lesson.showsView);
    node.decide(fact::LessonEnded{});
    QVERIFY(!view.at(kNow, 0).lesson);
    show(kNobody);
    QVERIFY(view.at(kNow, 0).lesson);
    node.decide(fact::ParticipantJoined{{}, Role::Instructor, "Ina"}); // a program started again
    QVERIFY(!view.at(kNow, 0).lesson);
}

/// The view is nothing that is drawn, and the pointer is seen by whom something is shown to.
void TestStationView::looksFromWhereTheInstructorDoes()
{
    const LungPair pair = lungs();
    FakeSessionNode node{FakeSessionNode::kTrainee};
    const ParticipantId ina = FakeSessionNode::kInstructor;
    node.decide(fact::ObjectShared{{}, ina, ObjectKind::View, "View"});
    node.decide(fact::ObjectShared{{}, ina, ObjectKind::Pointer, "Pointer"});
    const RigidTransform X_AD = RigidTransform::translation({0.0, -2.0, 0.0});
    node.sees(ObjectId{2}, X_AD, kNow);
    node.sees(ObjectId{3}, X_AD, kNow);
    const StationView view{node, FakeSessionNode::kStation, pair};
    QVERIFY(view.at(kNow, 0).people.empty());
    QVERIFY(!view.at(kNow, 0).lessonView);
    node.decide(fact::LessonShown{kNobody, {{}, true, {}}}, ina);
    const StationMoment moment = view.at(kNow, 0);
    QVERIFY(moment.lessonView
            && (moment.lessonView->X_FO.translation() - X_AD.translation()).norm() < 1e-4);
    QCOMPARE(moment.people.size(), std::size_t{1});
    QCOMPARE(moment.people.front().kind, ObjectKind::Pointer);
    QVERIFY(!view.at(kNow + std::chrono::seconds{2}, 0).lessonView); // nothing is heard of it
}

void TestStationView::exaggeratesOnlyWhereAsked()
{
    FakeSessionNode node;
    node.decide(fact::PhaseChanged{SessionPhase::Running});
    const LungPair pair = lungs();
    StationView view{node, FakeSessionNode::kStation, pair, tellingPoses(kNow)};
    const StationMoment truly = view.at(kNow + milliseconds{1200}, 0);
    QCOMPARE(truly.exaggeration, 1.0);
    view.exaggerate(2.0);
    const StationMoment larger = view.at(kNow + milliseconds{1200}, 0);
    QCOMPARE(larger.exaggeration, 2.0);
    QVERIFY(larger.breathing == truly.breathing);
    QCOMPARE(larger.pose, exaggerated(truly.pose, 2.0));
    QVERIFY(larger.pose.lungs[0].diaphragm > 1.9 * truly.pose.lungs[0].diaphragm);
}

void TestStationView::showsRestBeforeTheClockIsSet()
{
    FakeSessionNode node;
    node.loseClock();
    const LungPair pair = lungs();
    const StationView view{node, FakeSessionNode::kStation, pair, tellingPoses(kNow)};
    const StationMoment moment = view.litAt(kLit, 0);
    QVERIFY(moment.time == SessionTime{});
    QVERIFY(!moment.tube && !moment.jaw && !moment.head && !moment.sampleAge);
    QCOMPARE(moment.pose, ChestPose{});
}

void TestStationView::showsThePatientAsActionsHaveItAtTheTimeOfLight()
{
    FakeSessionNode node;
    const LungPair pair = lungs();
    const StationView view{node, FakeSessionNode::kStation, pair, tellingPoses(kNow)};
    node.sharePatient(FakeSessionNode::kTrainee);
    QVERIFY(!view.at(kNow, 0).patient);
    node.ownerActs(FakeSessionNode::kPatient, {ActionKind::Translation, Vec3::UnitX(), 0.5});
    QCOMPARE(view.at(kNow + std::chrono::seconds{2}, 0).patient->acted.X_AO.translation(),
             Vec3(1.0, 0.0, 0.0));
    StationView elsewhere{node, StationId{1}, pair, tellingPoses(kNow)};
    QVERIFY(!elsewhere.at(kNow, 0).patient);
    elsewhere.setStation(FakeSessionNode::kStation);
    QVERIFY(elsewhere.at(kNow, 0).patient);
}

void TestStationView::tellsForAWhileThatOneWasMoved()
{
    FakeSessionNode node{FakeSessionNode::kTrainee};
    node.linkReports.emplace_back().state = LinkState::Connected;
    node.decide(fact::PhaseChanged{SessionPhase::Running});
    node.addStation("Room 5");
    node.decideAt(StationId{1}, fact::ParticipantMoved{FakeSessionNode::kTrainee});
    StationMoment moment;
    moment.tube = tellingPose(ObjectKind::Tube, kNow);
    const auto noticeAfter = [&](std::chrono::seconds time) {
        moment.time = *node.now() + time;
        return stationNotice(node, moment, ViewOutput::Screen);
    };
    QCOMPARE(noticeAfter(std::chrono::seconds{14}),
             QStringLiteral("The instructor has moved you to the station “Room 5”"));
    QCOMPARE(noticeAfter(std::chrono::seconds{15}), QString{});
}

void TestStationView::tellsHowTheTubeIsDrawn()
{
    FakeSessionNode node{FakeSessionNode::kTrainee};
    node.linkReports.emplace_back().state = LinkState::Connected;
    node.decide(fact::PhaseChanged{SessionPhase::Running});
    StationMoment moment;
    moment.time = *node.now() + std::chrono::seconds{1};
    moment.tube = tellingPose(ObjectKind::Tube, kNow);
    const auto notice = [&] { return stationNotice(node, moment, ViewOutput::Screen); };
    QCOMPARE(notice(), QString{});
    moment.tubeDrawing = TubeDrawing::InAirway;
    QCOMPARE(notice(), QString{});
    for (const auto& [drawing, word] :
         {std::pair{TubeDrawing::Apart, "5\u00a0mm beside the virtual one"},
          {TubeDrawing::Awaited, "being measured"},
          {TubeDrawing::NoLumen, "cannot be measured"}}) {
        moment.tubeDrawing = drawing;
        QVERIFY2(notice().contains(QString::fromUtf8(word)), qPrintable(notice()));
    }
}

/// Of another at work as it was sent, with what is noted of it; nothing of an own one.
void TestStationView::bendsTheTubeOfAnotherAsItWasSent()
{
    const LungPair pair = lungs();
    FakeSessionNode node{FakeSessionNode::kInstructor};
    StreamCpo cpo;
    cpo.object = FakeSessionNode::kTube;
    cpo.time = kNow;
    cpo.shape = StreamShape{kNow, 0.3, 0.01, {}, {4.0}};
    node.takes(cpo);
    const StationView view{node, FakeSessionNode::kStation, pair};
    const StationMoment moment = view.at(kNow, 0);
    QVERIFY(moment.tubeShape && moment.tubeShape->to.perMetre[0] == 4.0);
    QVERIFY(!moment.tubeIsApart);
    node.decide(fact::PhaseChanged{SessionPhase::Running});
    node.decide(fact::IntubationNoted{{.step = IntubationStep::ShapesApart, .at = kNow}, {}},
                FakeSessionNode::kTrainee);
    QVERIFY(view.at(kNow + std::chrono::milliseconds{200}, 0).tubeIsApart);
    QVERIFY(!view.at(kNow + std::chrono::milliseconds{200}, 0).isCuffInflated);
    node.decide(fact::CuffSet{true});
    QVERIFY(view.at(kNow + std::chrono::milliseconds{400}, 0).isCuffInflated);
    node.becomes(FakeSessionNode::kTrainee);
    QVERIFY(!view.at(kNow, 0).tubeShape);
}

/// And not what one gave away, or has got back.
void TestStationView::tellsForAWhileWhatWasTakenFromOne()
{
    static constexpr ParticipantId kTom = FakeSessionNode::kTrainee;
    static constexpr ParticipantId kIna = FakeSessionNode::kInstructor;
    FakeSessionNode node{kTom};
    node.linkReports.emplace_back().state = LinkState::Connected;
    node.decide(fact::PhaseChanged{SessionPhase::Running});
    const auto lines = [&node](std::chrono::seconds time = std::chrono::seconds{1}) {
        StationMoment moment;
        moment.tube = tellingPose(ObjectKind::Tube, kNow);
        moment.time = *node.now() + time;
        return stationNotice(node, moment, ViewOutput::Screen).split(QLatin1Char{'\n'});
    };
    const auto shareTomsOwn = [&node](const char* name) {
        node.decide(fact::ObjectShared{{}, kNobody, ObjectKind::OrganGroup, name});
        const ObjectId object = node.state()->objects().rbegin()->first;
        node.decide(fact::ObjectHandedOver{object, kTom, 1}, kTom);
        return object;
    };
    const auto pass = [&node](ObjectId object, ParticipantId to, ParticipantId by) {
        const std::uint16_t epoch = node.state()->objects().at(object).epoch;
        node.decide(fact::ObjectHandedOver{object, to, epoch}, by);
    };
    const ObjectId lungs = shareTomsOwn("lungs");
    const ObjectId airway = shareTomsOwn("airway");
    const ObjectId skeleton = shareTomsOwn("skeleton");
    pass(skeleton, kNobody, kTom);
    QCOMPARE(lines(), QStringList{QString{}});
    pass(lungs, kNobody, kIna);
    pass(airway, kNobody, kIna);
    const QString both = QStringLiteral("The instructor has put back: Lungs, Airway");
    QCOMPARE(lines(std::chrono::seconds{14}), QStringList{both});
    QCOMPARE(lines(std::chrono::seconds{15}), QStringList{QString{}});
    pass(lungs, kTom, kIna);
    QCOMPARE(lines(), QStringList{QStringLiteral("The instructor has put back: Airway")});
    pass(airway, kTom, kTom);
    QCOMPARE(lines(), QStringList{QString{}});
    pass(lungs, kIna, kIna);
    QCOMPARE(lines(), QStringList{QStringLiteral("The instructor has taken over: Lungs")});
}

void TestStationView::saysThatThePatientIsAway()
{
    FakeSessionNode node;
    node.linkReports.emplace_back().state = LinkState::Connected;
    node.decide(fact::PhaseChanged{SessionPhase::Running});
    StationMoment moment;
    moment.time = kNow + std::chrono::seconds{1};
    moment.tube = tellingPose(ObjectKind::Tube, moment.time);
    const auto notice = [&] { return stationNotice(node, moment, ViewOutput::Screen); };
    moment.patient.emplace();
    QCOMPARE(notice(), QString{});
    moment.patient->acted.scale = 1.01;
    const QString away = QStringLiteral("The virtual patient was moved away from its place");
    QCOMPARE(notice(), away);
    node.linkReports.front().sinceLastDatagram = std::chrono::milliseconds{799};
    QCOMPARE(notice(), away);
    node.linkReports.front().sinceLastDatagram = std::chrono::milliseconds{800};
    QCOMPARE(notice(), QStringLiteral("Connecting to the instructor …\n") + away);
}

/// What an instructor decided, and that a token was replaced.
void TestStationView::saysWhatWasDecidedAboutItsParticipant()
{
    FakeSessionNode node{FakeSessionNode::kTrainee};
    node.linkReports.emplace_back().state = LinkState::Connected;
    node.decide(fact::PhaseChanged{SessionPhase::Running});
    StationMoment moment;
    moment.time = kNow + std::chrono::seconds{1};
    moment.tube = tellingPose(ObjectKind::Tube, moment.time);
    const auto notice = [&] { return stationNotice(node, moment, ViewOutput::Screen); };
    const QString muted = errorText({Errc::Muted, {}});
    node.decide(fact::ParticipantMuted{FakeSessionNode::kTrainee, true});
    QCOMPARE(notice(), muted);
    node.isRefused({Errc::Muted, {}});
    QCOMPARE(notice(), muted); // once
    node.decide(fact::ParticipantMuted{FakeSessionNode::kTrainee, false});
    QCOMPARE(notice(), QString{});
    node.decide(fact::TokenReplaced{FakeSessionNode::kTrainee});
    QVERIFY(notice().contains(QStringLiteral("new token")));
    moment.time = *node.now() + std::chrono::minutes{1};
    moment.tube->time = moment.time;
    QCOMPARE(notice(), QString{});
    QVERIFY(!isRemoved(node));
    node.linkReports.front().state = LinkState::Ended;
    node.isRefused({Errc::Removed, "Ina: too loud"});
    moment.patient.emplace().acted.scale = 2.0;
    QVERIFY(isRemoved(node));
    QCOMPARE(notice(), errorText({Errc::Removed, "Ina: too loud"}));
}

void TestStationView::saysWhenTheHeadsetIsLost_data()
{
    QTest::addColumn<ViewOutput>("output");
    QTest::addColumn<std::optional<Validity>>("head");
    QTest::addColumn<QString>("notice");
    using Head = std::optional<Validity>;
    const QString lost = QStringLiteral("Headset out of the tracker's view");
    QTest::newRow("lost, one picture") << ViewOutput::Mono << Head{Validity::Lost} << lost;
    QTest::newRow("lost, two pictures") << ViewOutput::SideBySide << Head{Validity::Lost} << lost;
    QTest::newRow("seen in part") << ViewOutput::Mono << Head{Validity::PartlyOccluded}
                                  << QString{};
    QTest::newRow("seen") << ViewOutput::SideBySide << Head{Validity::Tracked} << QString{};
    QTest::newRow("lost before a screen")
        << ViewOutput::Screen << Head{Validity::Lost} << QString{};
}

void TestStationView::saysWhenTheHeadsetIsLost()
{
    QFETCH(ViewOutput, output);
    QFETCH(std::optional<Validity>, head);
    QFETCH(QString, notice);
    FakeSessionNode node;
    node.linkReports.emplace_back().state = LinkState::Connected;
    node.decide(fact::PhaseChanged{SessionPhase::Running});
    StationMoment moment;
    moment.time = kNow + std::chrono::seconds{1};
    moment.tube = tellingPose(ObjectKind::Tube, moment.time);
    if (head) {
        moment.head = tellingPose(ObjectKind::Head, moment.time);
        moment.head->validity = *head;
    }
    QCOMPARE(stationNotice(node, moment, output, kStanding), notice);
}

/// A headset's picture stays dark while the tracker has not seen the headset.
void TestStationView::saysThatAHeadsetWasNotSeenYet()
{
    FakeSessionNode node{FakeSessionNode::kTrainee};
    node.linkReports.emplace_back().state = LinkState::Connected;
    node.decide(fact::PhaseChanged{SessionPhase::Running});
    StationMoment moment;
    moment.time = kNow + std::chrono::seconds{1};
    moment.headIsAwaited = true;
    const QString unseen = stationNotice(node, moment, ViewOutput::Mono, kStanding);
    QVERIFY(unseen.contains(QStringLiteral("has not seen the headset")));
    QVERIFY(unseen.contains(QStringLiteral("Esc")));
    QVERIFY(!unseen.contains(QStringLiteral("by mouse")));
}

/// Beside what else is to be said, also where the tracker has no tool for the head.
void TestStationView::saysHowToLookAroundWithoutATracker()
{
    FakeSessionNode node{FakeSessionNode::kTrainee};
    node.linkReports.emplace_back().state = LinkState::Connected;
    node.decide(fact::PhaseChanged{SessionPhase::Running});
    StationMoment moment;
    moment.time = kNow + std::chrono::seconds{1};
    const QString byMouse = QStringLiteral("You look around by mouse: no headset is tracked.");
    const QString without = stationNotice(node, moment, ViewOutput::SideBySide);
    QVERIFY(without.startsWith(QStringLiteral("No tracker is connected here")));
    QVERIFY(without.contains(QLatin1Char{'\n'} + byMouse));
    QVERIFY(!stationNotice(node, moment, ViewOutput::Screen).contains(byMouse));
    moment.tube = tellingPose(ObjectKind::Tube, moment.time);
    QVERIFY(stationNotice(node, moment, ViewOutput::Mono, kStanding).startsWith(byMouse));
    moment.head = tellingPose(ObjectKind::Head, moment.time);
    QCOMPARE(stationNotice(node, moment, ViewOutput::Mono, kStanding), QString{});
}

void TestStationView::knowsTheOwnPlaceAndWhetherAHeadIsAwaited()
{
    FakeSessionNode node{FakeSessionNode::kTrainee};
    const LungPair pair = lungs();
    ObjectPoses own;
    const StationView without{node, FakeSessionNode::kStation, pair, own};
    own.hasTool = [](ObjectKind kind) { return kind == ObjectKind::Head; };
    const StationView with{node, FakeSessionNode::kStation, pair, own};
    QVERIFY(!without.at(kNow, 0).headIsAwaited);
    QVERIFY(with.at(kNow, 0).headIsAwaited);
    QCOMPARE(without.at(kNow, 0).turn.si, 0.0);
    node.decide(fact::PlaceChosen{FakeSessionNode::kTrainee, degrees(90.0)});
    QCOMPARE(without.at(kNow, 0).turn.si, degrees(90.0).si);
}

void TestStationView::saysThatThereIsNoTracker_data()
{
    QTest::addColumn<ParticipantId>("self");
    QTest::addColumn<ParticipantId>("worker");
    QTest::addColumn<bool>("hasTracker");
    QTest::addColumn<QString>("notice");
    const QString nobody = QStringLiteral("Nobody is at work here");
    const QString lost = QStringLiteral("Tube out of the tracker's view");
    QTest::newRow("trainee without one") << FakeSessionNode::kTrainee << kNobody << false
                                         << QStringLiteral("No tracker is connected here");
    QTest::newRow("trainee with one")
        << FakeSessionNode::kTrainee << FakeSessionNode::kTrainee << true << lost;
    QTest::newRow("trainee who is not at work")
        << FakeSessionNode::kTrainee << kNobody << true << nobody;
    QTest::newRow("observer") << FakeSessionNode::kObserver << kNobody << false << nobody;
}

void TestStationView::saysThatThereIsNoTracker()
{
    QFETCH(const ParticipantId, self);
    QFETCH(const ParticipantId, worker);
    QFETCH(const bool, hasTracker);
    QFETCH(const QString, notice);
    FakeSessionNode node{self};
    node.linkReports.emplace_back().state = LinkState::Connected;
    node.decide(fact::PhaseChanged{SessionPhase::Running});
    StationMoment moment;
    moment.time = kNow + std::chrono::seconds{1};
    moment.worker = worker;
    const QString told = stationNotice(node, moment, ViewOutput::Screen,
                                       hasTracker ? std::optional{kStanding} : std::nullopt);
    QVERIFY2(told.startsWith(notice), qPrintable(told));
    QCOMPARE(told.contains(QStringLiteral("tracker's view")), worker == self);
}

/// Whatever has become of its host.
void TestStationView::saysThatTheSessionHasEnded()
{
    FakeSessionNode node{FakeSessionNode::kTrainee};
    node.linkReports.emplace_back().state = LinkState::Connected;
    node.decide(fact::PhaseChanged{SessionPhase::Running});
    StationMoment moment;
    moment.time = kNow + std::chrono::seconds{1};
    QVERIFY(!isOver(node));
    node.decide(fact::PhaseChanged{SessionPhase::Ended});
    node.advance(std::chrono::seconds{1});
    QVERIFY(isOver(node));
    for (const LinkState link : {LinkState::Connected, LinkState::Away}) {
        node.linkReports.front().state = link;
        QVERIFY(stationNotice(node, moment, ViewOutput::Screen)
                    .startsWith(QStringLiteral("The session has ended")));
    }
}

/// The patient does not move, whether or not the host is heard of.
void TestStationView::saysThatItIsPausedAlsoWhileItConnects()
{
    FakeSessionNode node{FakeSessionNode::kTrainee};
    LinkReport& link = node.linkReports.emplace_back();
    link.state = LinkState::Connected;
    node.decide(fact::PhaseChanged{SessionPhase::Running});
    node.decide(fact::PhaseChanged{SessionPhase::Paused});
    node.advance(std::chrono::seconds{1});
    StationMoment moment;
    moment.time = *node.now();
    const auto notice = [&] { return stationNotice(node, moment, ViewOutput::Screen); };
    QCOMPARE(notice(), QStringLiteral("Paused"));
    link.state = LinkState::Away;
    link.sinceLastDatagram = std::chrono::seconds{2};
    QCOMPARE(notice(), QStringLiteral("Paused. Connecting to the instructor …"));
    link.sinceLastDatagram = std::chrono::seconds{6};
    QVERIFY2(notice().startsWith(QStringLiteral("Paused. The instructor's program does not")),
             qPrintable(notice()));
}

/// A host that was closed for good, or ended the session unheard, keeps nobody.
void TestStationView::offersAnotherSessionWhileTheHostIsSilent()
{
    FakeSessionNode node{FakeSessionNode::kTrainee};
    node.decide(fact::PhaseChanged{SessionPhase::Running});
    StationMoment moment;
    moment.time = kNow + std::chrono::seconds{1};
    LinkReport& link = node.linkReports.emplace_back();
    link.state = LinkState::Connected;
    QVERIFY(!offersAnother(node));
    for (const LinkState state : {LinkState::Away, LinkState::Connecting}) {
        link.state = state;
        link.sinceLastDatagram = std::chrono::seconds{2}; // as in a gap of the network
        QVERIFY(!offersAnother(node));
        QVERIFY(stationNotice(node, moment, ViewOutput::Screen)
                    .startsWith(QStringLiteral("Connecting to the instructor")));
        link.sinceLastDatagram = std::chrono::seconds{6};
        QVERIFY(offersAnother(node));
        QVERIFY(!isOver(node));
        const QString told = stationNotice(node, moment, ViewOutput::Screen);
        QVERIFY2(told.contains(QStringLiteral("another session")), qPrintable(told));
    }
    link.state = LinkState::Connected; // it is back
    link.sinceLastDatagram = std::chrono::milliseconds{100};
    QVERIFY(!offersAnother(node));
}

CARINA_TEST(TestStationView)

} // namespace carina::station_view_test

#include "tst_station_view.moc"
