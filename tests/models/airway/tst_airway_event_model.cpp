#include "engine/io/anatomy_set/anatomy_cache.h"
#include "models/airway/airway_event_model.h"
#include "models/airway/airway_words.h"
#include "models/patient/session_patient.h"
#include "tests/models/fake_session_node.h"
#include "tests/models/lacking_patient.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

#include <set>

namespace carina::airway_event_model_test
{

using test::FakeSessionNode;
using enum AirwayEventKind;

class TestAirwayEventModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isClearAtFirst();
    void setsOneEventAndLeavesTheOthers();
    void setsAllEventsAsOneChange();
    void tellsTheSeverityToBeSeenWhileItChanges();
    void tellsWhatIsDrawnInAFullThroat();
    void clearsAllOverTheTime();
    void knowsWhatThereIsToEnd();
    void takesFluidsAwayBySuction();
    void takesAFluidAwayThatGoesSlowly();
    void takesFluidsAwayAtAllStationsAndLeavesTheRest();
    void bringsWhatIsSetAgainOverAnotherTime();
    void keepsOneProposalUnderWayWhileASeverityIsDragged();
    void doesNotProposeWhatIsAlreadySo();
    void undoesADragAtOnceAndThenWhatWasBefore();
    void undoesAChangeInItsMidstAtOnce();
    void undoesNotWhatSomebodyDecidedSince();
    void undoesThroughTheHistory();
    void changesAllStationsAndUndoesEach();
    void followsAnotherInstructor();
    void letsOnlyAnInstructorChange();
    void saysThatATongueIsMissing();
    void saysThatATracheaIsMissing();
    void saysThatIncisorsAreMissing();
    void saysThatAnEpiglottisIsTooSmall();
    void saysWhatIsShownInPart();
    void saysWhatALarynxLacks();
    void ofAllPatientsSetsWhatOneDoesNotShow();
    void knowsOnlyThePatientThatLiesAtItsStation();
    void hasAWordForEverything();
};

namespace
{

constexpr std::chrono::milliseconds kLead{100};
constexpr double kRounding = 1e-9; ///< of a severity

struct Console {
    FakeSessionNode node;
    SessionModel session{node};
    AirwayEventModel model{session, FakeSessionNode::kStation};

    std::optional<SessionPatient> patient;

    explicit Console(ParticipantId self = FakeSessionNode::kInstructor) : node{self} {}
    explicit Console(const SharedPatientModel& lying) : Console{}
    {
        patient.emplace(node, FakeSessionNode::kStation, lying, AnatomyCache::defaultFolder());
        model.setPatient(*patient);
    }
    void deliver()
    {
        node.announce();
        QCoreApplication::sendPostedEvents();
    }
    void settle(Duration time = kLead)
    {
        node.advance(time);
        deliver();
    }
    [[nodiscard]] AirwayEvents decided(StationId station = FakeSessionNode::kStation) const
    {
        return node.state()->stations().at(station).airwayEvents.decidedAt(SessionTime::max());
    }
    /// Those that the patient shows.
    [[nodiscard]] std::set<AirwayEventKind> shownKinds() const
    {
        std::set<AirwayEventKind> kinds;
        for (int kind = 0; kind < kAirwayEventKinds; ++kind)
            if (model.limits().canShow(static_cast<AirwayEventKind>(kind)))
                kinds.insert(static_cast<AirwayEventKind>(kind));
        return kinds;
    }
    [[nodiscard]] bool showsNow(AirwayEventKind kind, double severity) const
    {
        return std::abs(model.present(kind) - severity) < kRounding;
    }
};

const SharedPatientModel& tongueless()
{
    static const SharedPatientModel made = test::childWithout(PartRole::Tongue);
    return made;
}

/// About its middle.
void shrink(AnatomyPart& part, float scale)
{
    for (TriangleMesh& level : part.levels) {
        Vec3f middle = Vec3f::Zero();
        for (const Vec3f& p : level.positions)
            middle += p / float(level.positions.size());
        for (Vec3f& p : level.positions)
            p = middle + scale * (p - middle);
    }
}

} // namespace

void TestAirwayEventModel::isClearAtFirst()
{
    const Console console;
    QVERIFY(console.model.events().empty());
    QCOMPARE(console.model.severity(Epiglottitis), 0.0);
    QCOMPARE(console.model.inForceText(), QStringLiteral("Clear"));
    QVERIFY(console.model.travellingText().isEmpty());
    QVERIFY(!console.model.canUndo());
}

void TestAirwayEventModel::setsOneEventAndLeavesTheOthers()
{
    Console console;
    console.model.setSeverity(Laryngospasm, 1.0);
    QCOMPARE(console.model.severity(Laryngospasm), 1.0);
    QCOMPARE(console.model.present(Laryngospasm), 0.0); // not in force yet
    QCOMPARE(console.model.travellingText(), QStringLiteral("Airway → Laryngospasm 100\u00a0%"));
    console.settle();
    QVERIFY(console.model.travellingText().isEmpty());
    QCOMPARE(console.model.present(Laryngospasm), 1.0);
    console.model.setSeverity(TongueOedema, 0.6);
    console.settle();
    QVERIFY(console.decided() == (AirwayEvents{{TongueOedema, 0.6}, {Laryngospasm, 1.0}}));
    QCOMPARE(console.model.inForceText(),
             QStringLiteral("Tongue oedema 60\u00a0% + Laryngospasm 100\u00a0%"));
    console.model.setSeverity(Laryngospasm, 0.0);
    console.settle();
    QVERIFY(console.decided() == (AirwayEvents{{TongueOedema, 0.6}}));
}

void TestAirwayEventModel::setsAllEventsAsOneChange()
{
    const AirwayEvents burnt{{TongueOedema, 0.3}, {LaryngealOedema, 0.7}, {LaryngealWeb, 0.1}};
    Console console;
    console.model.setSeverity(Laryngospasm, 1.0);
    console.settle();
    console.model.setEvents(burnt);
    QVERIFY(console.model.events() == burnt);
    QCOMPARE(console.node.proposed, 2);
    console.settle();
    QVERIFY(console.decided() == burnt);
    console.model.undo();
    console.settle();
    QVERIFY(console.decided() == (AirwayEvents{{Laryngospasm, 1.0}}));
}

/// 0.8 over 20 s: a quarter of it after five.
void TestAirwayEventModel::tellsTheSeverityToBeSeenWhileItChanges()
{
    Console console;
    console.model.setChangeTime(std::chrono::seconds{20});
    console.model.setSeverity(TongueOedema, 0.8);
    console.settle();
    QCOMPARE(console.model.severity(TongueOedema), 0.8);
    QVERIFY(console.showsNow(TongueOedema, 0.0));
    const QSignalSpy changed{&console.model, &AirwayEventModel::changed};
    console.settle(std::chrono::seconds{5});
    QVERIFY(console.showsNow(TongueOedema, 0.2));
    QVERIFY(!changed.isEmpty());
    console.model.setSeverity(TongueOedema, 0.0); // and back over 20 s
    console.settle();
    console.settle(std::chrono::seconds{10});
    QVERIFY(console.showsNow(TongueOedema, 0.5 * (0.2 + 0.8 * 0.1 / 20.0)));
    console.settle(std::chrono::seconds{10});
    QVERIFY(console.showsNow(TongueOedema, 0.0));
    QVERIFY(console.model.events().empty());
}

/// Of three at their worst two thirds each; a patient without a tongue has room for the others.
void TestAirwayEventModel::tellsWhatIsDrawnInAFullThroat()
{
    const AirwayEvents three{{TongueOedema, 1.0}, {Epiglottitis, 1.0}, {FloppyEpiglottis, 1.0}};
    Console console;
    console.model.setEvents(three);
    QCOMPARE(console.model.drawn(Epiglottitis), 0.0); // not in force yet
    console.settle();
    QCOMPARE(console.model.present(Epiglottitis), 1.0);
    QVERIFY(std::abs(console.model.drawn(Epiglottitis) - 2.0 / 3.0) < kRounding);
    QCOMPARE(console.model.drawn(Laryngospasm), 0.0);
    console.model.setSeverity(Swallowing, 1.0); // which takes room for a second of eight
    console.settle();
    QVERIFY(std::abs(console.model.drawn(Epiglottitis) - 2.0 / 3.0) < kRounding);
    QCOMPARE(console.model.drawn(LaryngealOedema), 0.0);
    QCOMPARE(console.model.drawn(Swallowing), 1.0);
    Console mute{tongueless()};
    mute.model.setEvents(three);
    mute.settle();
    QCOMPARE(mute.model.drawn(Epiglottitis), 1.0);
    QCOMPARE(mute.model.drawn(TongueOedema), 0.0);
}

void TestAirwayEventModel::clearsAllOverTheTime()
{
    Console console;
    console.node.decide(fact::AirwayEventsSet{{{TongueOedema, 1.0}, {Epiglottitis, 0.5}}, {}});
    console.settle();
    console.model.setChangeTime(std::chrono::seconds{10});
    console.model.clear();
    console.settle();
    QVERIFY(console.model.events().empty());
    console.settle(std::chrono::seconds{5});
    QVERIFY(console.showsNow(TongueOedema, 0.5) && console.showsNow(Epiglottitis, 0.25));
    console.settle(std::chrono::seconds{5});
    QCOMPARE(console.model.inForceText(), QStringLiteral("Clear"));
}

/// Also at another station where a change is for all, and until what was ended is gone.
void TestAirwayEventModel::knowsWhatThereIsToEnd()
{
    constexpr StationId kRoom{1};
    Console console;
    console.node.addStation("Room 5");
    console.node.decideAt(kRoom, fact::AirwayEventsSet{{{Laryngospasm, 0.4}}, {}});
    console.settle();
    QVERIFY(!console.model.hasEvents());
    console.model.setForAll(true);
    QVERIFY(console.model.hasEvents() && !console.model.isSeen());
    console.model.clear();
    console.settle();
    QVERIFY(console.decided(kRoom).empty());
    QVERIFY(!console.model.hasEvents());
    console.model.setSeverity(Blood, 1.0);
    console.settle();
    console.model.setChangeTime(std::chrono::seconds{10});
    console.model.clear();
    console.settle();
    console.settle(std::chrono::seconds{5});
    QVERIFY(console.model.events().empty());
    QVERIFY(console.model.hasEvents() && console.model.isSeen());
    console.settle(std::chrono::seconds{5});
    QVERIFY(!console.model.hasEvents() && !console.model.isSeen());
}

void TestAirwayEventModel::takesFluidsAwayBySuction()
{
    Console console;
    console.node.decide(
        fact::AirwayEventsSet{{{TongueOedema, 0.5}, {Secretions, 0.3}, {Blood, 1.0}}, {}});
    console.settle();
    QVERIFY(console.model.hasFluid());
    console.model.setChangeTime(std::chrono::seconds{60});
    console.model.suction();
    console.settle();
    QVERIFY(console.model.hasFluid()); // while it goes
    console.settle(std::chrono::milliseconds{2500});
    QVERIFY(console.showsNow(Blood, 0.5) && console.showsNow(Secretions, 0.15));
    console.settle(std::chrono::milliseconds{2500});
    QVERIFY(console.showsNow(Blood, 0.0) && console.showsNow(TongueOedema, 0.5));
    QVERIFY(!console.model.hasFluid());
    QCOMPARE(console.decided(), (AirwayEvents{{TongueOedema, 0.5}}));
    console.model.undo();
    console.settle();
    QVERIFY(console.showsNow(Blood, 1.0) && console.showsNow(Secretions, 0.3));
}

/// Which it does already, over another time. Once more changes nothing.
void TestAirwayEventModel::takesAFluidAwayThatGoesSlowly()
{
    Console console;
    console.model.setSeverity(Blood, 1.0);
    console.settle();
    console.model.setChangeTime(std::chrono::seconds{600});
    console.model.clear();
    console.settle();
    QCOMPARE(console.model.severity(Blood), 0.0);
    QVERIFY(console.model.hasFluid());
    console.model.suction();
    QCOMPARE(console.node.proposed, 3);
    console.settle();
    console.model.suction();
    QCOMPARE(console.node.proposed, 3);
    console.settle(kSuction);
    QVERIFY(console.showsNow(Blood, 0.0));
    QVERIFY(!console.model.hasFluid());
    console.model.undo(); // that it was cleared: suction decided nothing else
    console.settle();
    QVERIFY(console.showsNow(Blood, 1.0));
}

/// As one change, though it is a fact for each; also where there is none at the station shown.
void TestAirwayEventModel::takesFluidsAwayAtAllStationsAndLeavesTheRest()
{
    constexpr StationId kRoom{1};
    const AirwayEvents here{{TongueOedema, 0.5}};
    const AirwayEvents bloody{{TongueOedema, 0.5}, {Blood, 1.0}};
    const AirwayEvents there{{Laryngospasm, 0.4}};
    const AirwayEvents vomiting{{Laryngospasm, 0.4}, {Vomit, 0.8}};
    Console console;
    ChangeHistory history;
    console.model.setHistory(history);
    console.node.addStation("Room 5");
    console.node.decide(fact::AirwayEventsSet{here, {}});
    console.node.decideAt(kRoom, fact::AirwayEventsSet{vomiting, {}});
    console.settle();
    QVERIFY(!console.model.hasFluid());
    console.model.setForAll(true);
    QVERIFY(console.model.hasFluid());
    console.model.suction();
    console.settle();
    console.settle(kSuction);
    QCOMPARE(console.decided(), here);
    QCOMPARE(console.decided(kRoom), there);
    QVERIFY(!console.model.hasFluid());
    console.node.decide(fact::AirwayEventsSet{bloody, {}});
    console.node.decideAt(kRoom, fact::AirwayEventsSet{vomiting, {}});
    console.settle(kSuction);
    QVERIFY(history.isEmpty()); // somebody decided otherwise
    console.model.suction();
    console.settle();
    QCOMPARE(console.decided(), here);
    QCOMPARE(console.decided(kRoom), there);
    QCOMPARE(history.texts(), QStringList{QStringLiteral("Airway → suction of all fluids")});
    history.undo();
    console.settle();
    QCOMPARE(console.decided(), bloody);
    QCOMPARE(console.decided(kRoom), vomiting);
}

void TestAirwayEventModel::bringsWhatIsSetAgainOverAnotherTime()
{
    const AirwayEvents spasm{{Laryngospasm, 0.5}};
    Console console;
    console.model.setChangeTime(std::chrono::seconds{600});
    console.model.setEvents(spasm);
    console.settle();
    console.model.setEvents(spasm);
    QCOMPARE(console.node.proposed, 1);
    console.model.setChangeTime({});
    console.model.setEvents(spasm);
    QCOMPARE(console.node.proposed, 2);
    console.settle();
    QVERIFY(console.showsNow(Laryngospasm, 0.5));
    console.model.setChangeTime(std::chrono::seconds{10});
    console.model.setEvents(spasm); // it is so already
    QCOMPARE(console.node.proposed, 2);
}

void TestAirwayEventModel::keepsOneProposalUnderWayWhileASeverityIsDragged()
{
    Console console;
    for (int percent = 1; percent <= 50; ++percent)
        console.model.setSeverity(Epiglottitis, 0.01 * percent);
    QCOMPARE(console.node.proposed, 1);
    console.settle();
    QCOMPARE(console.node.proposed, 2);
    console.settle();
    QVERIFY(console.decided() == (AirwayEvents{{Epiglottitis, 0.5}}));
    QCOMPARE(console.node.proposed, 2);
}

void TestAirwayEventModel::doesNotProposeWhatIsAlreadySo()
{
    Console console;
    console.model.clear();
    console.model.setSeverity(Epiglottitis, 0.0);
    QCOMPARE(console.node.proposed, 0);
    QVERIFY(!console.model.canUndo());
}

void TestAirwayEventModel::undoesADragAtOnceAndThenWhatWasBefore()
{
    Console console;
    console.model.setSeverity(TongueOedema, 0.3);
    console.settle();
    for (const double severity : {0.4, 0.5, 0.6})
        console.model.setSeverity(TongueOedema, severity);
    console.settle();
    console.settle();
    console.model.undo();
    console.settle();
    QVERIFY(console.decided() == (AirwayEvents{{TongueOedema, 0.3}}));
    console.model.undo();
    console.settle();
    QVERIFY(console.decided().empty());
    QVERIFY(!console.model.canUndo());
}

void TestAirwayEventModel::undoesAChangeInItsMidstAtOnce()
{
    Console console;
    console.model.setSeverity(TongueOedema, 0.4);
    console.settle();
    console.model.setChangeTime(std::chrono::minutes{10});
    console.model.setSeverity(TongueOedema, 1.0);
    console.settle(std::chrono::minutes{5});
    QVERIFY(console.model.present(TongueOedema) > 0.6);
    console.model.undo();
    console.settle();
    QCOMPARE(console.model.present(TongueOedema), 0.4);
}

void TestAirwayEventModel::undoesNotWhatSomebodyDecidedSince()
{
    Console console;
    console.model.setSeverity(TongueOedema, 0.4);
    console.settle();
    console.node.decide(fact::AirwayEventsSet{{{Laryngospasm, 0.9}}, {}});
    console.settle();
    QVERIFY(!console.model.canUndo());
    console.model.undo();
    console.settle();
    QVERIFY(console.decided() == (AirwayEvents{{Laryngospasm, 0.9}}));
}

void TestAirwayEventModel::undoesThroughTheHistory()
{
    Console console;
    ChangeHistory history;
    console.model.setHistory(history);
    console.model.setSeverity(Laryngospasm, 0.5);
    console.settle();
    QCOMPARE(history.texts(), QStringList{QStringLiteral("Airway → Laryngospasm 50\u00a0%")});
    history.undo();
    console.settle();
    QVERIFY(console.decided().empty());
    QVERIFY(history.isEmpty());
}

void TestAirwayEventModel::changesAllStationsAndUndoesEach()
{
    constexpr StationId kRoom{1};
    Console console;
    console.node.addStation("Room 5");
    console.model.setSeverity(Epiglottitis, 0.2);
    console.settle();
    console.model.setForAll(true);
    console.model.setSeverity(Epiglottitis, 0.7);
    console.settle();
    const AirwayEvents swollen{{Epiglottitis, 0.7}};
    QVERIFY(console.decided() == swollen);
    QVERIFY(console.decided(kRoom) == swollen);
    console.model.setForAll(false);
    console.model.setStation(kRoom);
    QCOMPARE(console.model.severity(Epiglottitis), 0.7);
    console.model.undo();
    console.settle();
    QVERIFY(console.decided() == (AirwayEvents{{Epiglottitis, 0.2}}));
    QVERIFY(console.decided(kRoom).empty());
}

void TestAirwayEventModel::followsAnotherInstructor()
{
    Console console;
    const QSignalSpy changed{&console.model, &AirwayEventModel::changed};
    console.node.decide(fact::AirwayEventsSet{{{LaryngealOedema, 0.25}}, {}});
    console.settle();
    QCOMPARE(console.model.severity(LaryngealOedema), 0.25);
    QVERIFY(!changed.isEmpty());
}

void TestAirwayEventModel::letsOnlyAnInstructorChange()
{
    Console console{FakeSessionNode::kObserver};
    QVERIFY(!console.model.obstacle().isEmpty());
    console.model.setSeverity(Laryngospasm, 1.0);
    QCOMPARE(console.node.proposed, 0);
    QVERIFY(console.model.events().empty());
}

/// What was set before can be ended.
void TestAirwayEventModel::saysThatATongueIsMissing()
{
    Console console{tongueless()};
    QCOMPARE(console.shownKinds().size(), std::size_t{kAirwayEventKinds - 1});
    QCOMPARE(console.model.limits().of(TongueOedema),
             QStringLiteral("Not shown: this patient has no tongue of its own."));
    QVERIFY(console.model.limits().of(Epiglottitis).isEmpty());
    QVERIFY(console.model.limits().all.isEmpty());
    QVERIFY(!console.model.canBeSet(TongueOedema));
    QVERIFY(console.model.canBeSet(Epiglottitis));
    console.node.decide(fact::AirwayEventsSet{{{TongueOedema, 0.5}}, {}});
    console.settle();
    QVERIFY(console.model.canBeSet(TongueOedema));
    console.model.setSeverity(TongueOedema, 0.0);
    console.settle();
    QVERIFY(console.decided().empty());
    QVERIFY(!console.model.canBeSet(TongueOedema));
}

void TestAirwayEventModel::saysThatATracheaIsMissing()
{
    const Console console{test::childWithout(PartRole::Trachea)};
    for (const AirwayEventKind kind : {TrachealStenosis, TrachealDeviation, Goitre})
        QCOMPARE(console.model.limits().of(kind),
                 QStringLiteral("Not shown: this patient has no trachea of its own."));
    QCOMPARE(console.shownKinds().size(), std::size_t{kAirwayEventKinds - 3});
}

void TestAirwayEventModel::saysThatIncisorsAreMissing()
{
    const Console console{test::childWithout(PartRole::Tooth)};
    for (const AirwayEventKind kind : {ProminentIncisors, FragileTeeth})
        QCOMPARE(
            console.model.limits().of(kind),
            QStringLiteral("Not shown: this patient has no teeth where the upper incisors are."));
    QCOMPARE(console.shownKinds().size(), std::size_t{kAirwayEventKinds - 2});
}

void TestAirwayEventModel::saysThatAnEpiglottisIsTooSmall()
{
    Anatomy anatomy = builtinPatient(BuiltinPatient::TwelveYears).value();
    for (AnatomyPart& part : anatomy.parts)
        if (part.role == PartRole::Epiglottis)
            shrink(part, 0.05F);
    const Console console{patientOf(std::move(anatomy)).value()};
    QVERIFY(!console.shownKinds().contains(Epiglottitis));
    QVERIFY(console.shownKinds().contains(TongueOedema));
    QCOMPARE(console.model.limits().of(Epiglottitis),
             QStringLiteral("Not shown: this patient has too little of what it changes."));
}

/// Which can be set all the same.
void TestAirwayEventModel::saysWhatIsShownInPart()
{
    const Console skinless{test::childWithout(PartRole::Skin)};
    QCOMPARE(skinless.shownKinds().size(), std::size_t{kAirwayEventKinds});
    for (const AirwayEventKind kind : {Goitre, NeckObesity}) {
        QCOMPARE(skinless.model.limits().said(kind),
                 QStringLiteral("Shown in part: this patient has no skin."));
        QVERIFY(skinless.model.canBeSet(kind));
    }
    QVERIFY(skinless.model.limits().said(Epiglottitis).isEmpty());
    QVERIFY(skinless.model.limits().said(AngioOedema).isEmpty());
    const Console mute{tongueless()};
    for (const AirwayEventKind kind : {AngioOedema, Burn})
        QCOMPARE(mute.model.limits().said(kind),
                 QStringLiteral("Shown in part: this patient has no tongue of its own."));
    QVERIFY(mute.model.limits().said(TongueOedema).startsWith(QStringLiteral("Not shown")));
    const Console jawless{test::childWithout(PartRole::Mandible)};
    QCOMPARE(jawless.model.limits().said(Trismus),
             QStringLiteral("Shown in part: this patient has no lower jaw of its own."));
    const auto isFirst = [](const AnatomyPart& part) {
        return part.name == "Right upper central secondary incisor tooth";
    };
    const Console gapped{test::childWithout(isFirst, "gapped")};
    QCOMPARE(gapped.model.limits().said(FragileTeeth),
             QStringLiteral("Shown in part: this patient has no right upper central incisor of its "
                            "own."));
    QVERIFY(skinless.model.limits().said(FragileTeeth).isEmpty());
}

void TestAirwayEventModel::saysWhatALarynxLacks()
{
    const Console console{test::childWithout(PartRole::Epiglottis)};
    QVERIFY(console.model.limits().all.contains(QStringLiteral("no epiglottis")));
    QVERIFY(console.shownKinds().empty());
    for (int kind = 0; kind < kAirwayEventKinds; ++kind) {
        QVERIFY(console.model.limits().of(static_cast<AirwayEventKind>(kind)).isEmpty());
        QVERIFY(!console.model.canBeSet(static_cast<AirwayEventKind>(kind)));
    }
}

void TestAirwayEventModel::ofAllPatientsSetsWhatOneDoesNotShow()
{
    Console console{tongueless()};
    const QSignalSpy changed{&console.model, &AirwayEventModel::changed};
    console.model.setForAll(true);
    QCOMPARE(changed.count(), 1);
    QVERIFY(console.model.canBeSet(TongueOedema));
    QVERIFY(!console.model.limits().canShow(TongueOedema));
    console.model.setForAll(false);
    QVERIFY(!console.model.canBeSet(TongueOedema));
}

/// While another one is chosen there and not here yet, nothing is known of it.
void TestAirwayEventModel::knowsOnlyThePatientThatLiesAtItsStation()
{
    constexpr StationId kRoom{1};
    Console console{tongueless()};
    const QSignalSpy changed{&console.model, &AirwayEventModel::changed};
    console.node.decide(fact::AnatomyChosen{"another", "Another"});
    console.settle();
    QVERIFY(console.model.limits().canShow(TongueOedema));
    QVERIFY(!changed.isEmpty());
    console.node.addStation("Room 5");
    console.node.decideAt(kRoom, fact::AnatomyChosen{tongueless()->contentHash(), "Child"});
    console.model.setStation(kRoom);
    QVERIFY(!console.model.limits().canShow(TongueOedema));
    console.model.setStation(FakeSessionNode::kStation);
    QVERIFY(console.model.limits().canShow(TongueOedema));
}

void TestAirwayEventModel::hasAWordForEverything()
{
    std::set<QString> words;
    for (int kind = 0; kind < kAirwayEventKinds; ++kind) {
        words.insert(eventText(static_cast<AirwayEventKind>(kind)));
        words.insert(eventEffect(static_cast<AirwayEventKind>(kind)));
    }
    QCOMPARE(words.size(), std::size_t{2 * kAirwayEventKinds});
    QVERIFY(!words.contains(QString{}));
}

CARINA_TEST(TestAirwayEventModel)

} // namespace carina::airway_event_model_test

#include "tst_airway_event_model.moc"
