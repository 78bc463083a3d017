#include "engine/anatomy/patient/builtin_patient.h"
#include "models/patient/patient_source.h"
#include "tests/support/test_class.h"
#include "ui/scene/people_figures.h"
#include "ui/scene/scene_parts.h"
#include "ui/scene/station_scene.h"

#include <set>

namespace carina::people_figures_test
{
namespace
{

constexpr ParticipantId kSelf{1};
constexpr ParticipantId kTom{2};
constexpr ParticipantId kTess{3};

PersonPose seen(std::uint16_t object, ParticipantId owner, ObjectKind kind)
{
    PersonPose person{.object = ObjectId{object}, .owner = owner, .ownerName = "Tom", .kind = kind};
    person.isOwn = owner == kSelf;
    person.pose.validity = Validity::Tracked;
    person.X_AO = RigidTransform::translation({double(object), 0.0, 0.0});
    person.pose.X_FO = person.X_AO;
    return person;
}

/// Everybody with everything, the second at work.
StationMoment crowd()
{
    StationMoment moment;
    moment.worker = kTom;
    std::uint16_t object = 0;
    for (const ParticipantId owner : {kSelf, kTom, kTess})
        for (const ObjectKind kind : {ObjectKind::Head, ObjectKind::Hand, ObjectKind::Stylus,
                                      ObjectKind::Jaw, ObjectKind::Tube}) {
            moment.people.push_back(seen(++object, owner, kind));
            const bool isOfWork = kind == ObjectKind::Jaw || kind == ObjectKind::Tube;
            moment.people.back().isAtWork = owner == kTom && isOfWork;
        }
    return moment;
}

std::vector<DrawnPerson> drawn(const StationMoment& moment)
{
    static const SharedPatientModel patient =
        patientOf(builtinPatient(BuiltinPatient::TwelveYears).value()).value();
    return drawnPeople(moment, StationLaryngoscope{*patient});
}

/// An object of somebody who stands elsewhere, as many metres to the patient's left by its tracker,
/// as its number says; others see it as many to the right.
StationMoment crowdAtPlaces()
{
    StationMoment moment = crowd();
    for (const ParticipantId owner : {kSelf, kTom})
        moment.people.push_back(
            seen(std::uint16_t(20 + owner.value), owner, ObjectKind::Laryngoscope));
    for (PersonPose& person : moment.people) {
        if (person.owner != kTom) // who is at work has them in the patient
            person.X_AO = placedBy(degrees(180.0)) * person.X_AO;
    }
    return moment;
}

/// Which objects are drawn where others see them, at a place.
std::set<std::uint16_t> turned(const SceneFrame& frame)
{
    std::set<std::uint16_t> objects;
    for (const auto& [name, body] : frame.bodies)
        if (const double x = body.X_AF.translation().x(); x < 0.0)
            objects.insert(std::uint16_t(std::lround(-x)));
    return objects;
}

std::set<std::uint16_t> bodies(const StationMoment& moment,
                               const std::optional<ParticipantId>& throughEyesOf = {})
{
    SceneFrame frame;
    addPeople(frame, moment, throughEyesOf);
    std::set<std::uint16_t> objects;
    for (const auto& [name, body] : frame.bodies)
        objects.insert(std::uint16_t(std::lround(body.X_AF.translation().x())));
    return objects;
}

} // namespace

class TestPeopleFigures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Objects 1 to 5 are the own head, hand, stylus, jaw and tube, 6 to 10 Tom's, 11 to 15 Tess's.
    void drawsOthersAndAllTubesAndNeverTheOwnHead()
    {
        QCOMPARE(bodies(crowd()), (std::set<std::uint16_t>{5, 6, 7, 8, 11, 12, 13, 15}));
    }

    /// Who looks at a screen does not see their own hands before the patient.
    void drawsOwnHandsAndStylusOnAScreen()
    {
        StationMoment moment = crowd();
        moment.ownHandsAreDrawn = true;
        QCOMPARE(bodies(moment), (std::set<std::uint16_t>{2, 3, 5, 6, 7, 8, 11, 12, 13, 15}));
    }

    /// The output can be changed while the program runs.
    void drawsNoOwnHandsInAHeadset()
    {
        StationMoment moment = crowd();
        moment.ownHandsAreDrawn = true;
        QVERIFY(StationScene::drawsOwnHands(moment, ViewOutput::Screen));
        QVERIFY(!StationScene::drawsOwnHands(moment, ViewOutput::Mono));
        QVERIFY(!StationScene::drawsOwnHands(moment, ViewOutput::SideBySide));
        moment.time = SessionTime{std::chrono::seconds{1}};
        QVERIFY(StationScene::drawsOwnHands(moment, ViewOutput::Mono)); // turned by mouse
        moment.head = PoseSample{};
        QVERIFY(!StationScene::drawsOwnHands(moment, ViewOutput::Mono));
        moment.ownHandsAreDrawn = false; // a view that has none
        QVERIFY(!StationScene::drawsOwnHands(moment, ViewOutput::Screen));
    }

    void doesNotDrawWhatIsLost()
    {
        StationMoment moment = crowd();
        moment.people[5].pose.validity = Validity::Lost;
        QCOMPARE(bodies(moment), (std::set<std::uint16_t>{5, 7, 8, 11, 12, 13, 15}));
    }

    void doesNotDrawTheHeadThroughWhoseEyesItLooks()
    {
        QCOMPARE(bodies(crowd(), kTess), (std::set<std::uint16_t>{5, 6, 7, 8, 12, 13, 15}));
    }

    /// A tube and a laryngoscope of one's own are where the hands are that hold them.
    void doesNotTurnWhatIsOwn()
    {
        StationMoment moment = crowdAtPlaces();
        moment.ownHandsAreDrawn = true;
        SceneFrame frame;
        addPeople(frame, moment);
        QCOMPARE(turned(frame), (std::set<std::uint16_t>{11, 12, 13, 15}));
        QVERIFY(frame.bodies.contains("person 21")); // the own laryngoscope
        // What the own program draws elsewhere is told as others see it.
        for (const ObjectInFrame& object : objectsIn(frame, moment))
            QCOMPARE(object.X_AO.translation().x() < 0.0, object.owner != kTom);
    }

    /// Their eyes are at the head as it is tracked, and so are their hands; the own tools are where
    /// they see them.
    void doesNotTurnWhatIsOfWhomItLooksThroughTheEyes()
    {
        const StationMoment moment = crowdAtPlaces();
        SceneFrame frame;
        addPeople(frame, moment, kTess);
        QVERIFY(frame.bodies.contains("person 12"));
        QCOMPARE(turned(frame), (std::set<std::uint16_t>{5, 21}));
        SceneFrame ofOwn;
        addPeople(ofOwn, moment, kSelf);
        QCOMPARE(turned(ofOwn), (std::set<std::uint16_t>{11, 12, 13, 15}));
    }

    void drawsEverybodysTubeBesideThePatientWhileNobodyIsAtWork()
    {
        StationMoment moment = crowd();
        moment.worker = kNobody;
        for (PersonPose& person : moment.people)
            person.isAtWork = false;
        QCOMPARE(bodies(moment), (std::set<std::uint16_t>{5, 6, 7, 8, 10, 11, 12, 13, 15}));
    }

    /// As tubes are, and with the patient while their owner is at work.
    void drawsTheLaryngoscopeOfEverybody()
    {
        StationMoment moment = crowd();
        for (const ParticipantId owner : {kSelf, kTom})
            moment.people.push_back(
                seen(std::uint16_t(20 + owner.value), owner, ObjectKind::Laryngoscope));
        QCOMPARE(bodies(moment), (std::set<std::uint16_t>{5, 6, 7, 8, 11, 12, 13, 15, 21, 22}));
        const auto people = drawn(moment);
        QCOMPARE(std::ranges::count(people, ObjectKind::Laryngoscope, &DrawnPerson::kind), 2);
    }

    void namesTheTubeAtWorkWithoutDrawingItTwice()
    {
        const auto people = drawn(crowd());
        const auto tube = std::ranges::find(people, ObjectId{10}, &DrawnPerson::object);
        QVERIFY(tube != people.end() && tube->isAtWork);
        QCOMPARE(tube->name, QStringLiteral("Tube of Tom"));
    }

    /// Who moves needs no other figure; who comes, goes or takes the work does.
    void needsNewFiguresOnlyWhereOthersAreThere()
    {
        StationMoment moment = crowd();
        const auto before = drawn(moment);
        for (PersonPose& person : moment.people) {
            person.X_AO = {};
            person.pose.validity = Validity::Lost;
        }
        QCOMPARE(drawn(moment), before);
        moment.worker = kTess;
        QVERIFY(drawn(moment) != before);
    }
};

CARINA_TEST(TestPeopleFigures)

} // namespace carina::people_figures_test

#include "tst_people_figures.moc"
