#include "models/station/people_poses.h"
#include "models/station/people_words.h"
#include "models/station/station_notice.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <chrono>

namespace carina::people_poses_test
{
namespace
{

using test::FakeSessionNode;
using namespace std::chrono_literals;

constexpr SessionTime kNow{1000s};
constexpr ParticipantId kTom = FakeSessionNode::kTrainee;
constexpr ParticipantId kTess{4};
constexpr ObjectId kTomsTube = FakeSessionNode::kTube;
constexpr ObjectId kTomsHead{2};
constexpr ObjectId kTomsHand{3};
constexpr ObjectId kTessTube{4};
constexpr ObjectId kTessHead{5};
constexpr ObjectId kTessHand{6};
constexpr double kSmall = 1e-6; ///< metres

RigidTransform at(double x) { return RigidTransform::translation({x, 0.0, 0.5}); }

/// Two trainees with head, hand and tube each at one station; the first is at work. Each object
/// rests at a place that tells which it is.
FakeSessionNode session(ParticipantId self = FakeSessionNode::kInstructor)
{
    FakeSessionNode node{self};
    node.decide(fact::ParticipantJoined{{}, Role::Trainee, "Tess"});
    for (const auto& [owner, kind] :
         {std::pair{kTom, ObjectKind::Head}, std::pair{kTom, ObjectKind::Hand},
          std::pair{kTess, ObjectKind::Tube}, std::pair{kTess, ObjectKind::Head},
          std::pair{kTess, ObjectKind::Hand}})
        node.decide(fact::ObjectShared{{}, owner, kind, "object"});
    for (const ObjectId object : {kTomsTube, kTomsHead, kTomsHand, kTessTube, kTessHead, kTessHand})
        node.sees(object, at(object.value), kNow);
    return node;
}

const PersonPose& find(const std::vector<PersonPose>& people, ObjectId object)
{
    return *std::ranges::find(people, object, &PersonPose::object);
}

} // namespace

class TestPeoplePoses : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void listsWhatAllShareWithTheirOwners()
    {
        const FakeSessionNode node = session();
        const auto people = peoplePoses(node, FakeSessionNode::kStation, {}, kNow);
        QCOMPARE(people.size(), std::size_t{6});
        for (const PersonPose& person : people) {
            const bool isToms = person.object == kTomsTube || person.object == kTomsHead
                                || person.object == kTomsHand;
            QCOMPARE(person.owner, isToms ? kTom : kTess);
            QCOMPARE(person.ownerName, std::string{isToms ? "Tom" : "Tess"});
            QCOMPARE(person.X_AO.translation().x(), double(person.object.value));
            QCOMPARE(person.isAtWork, person.object == kTomsTube);
            QVERIFY(!person.isOwn);
        }
        QVERIFY(peoplePoses(node, StationId{1}, {}, kNow).empty());
    }

    void takesOwnPosesFromTheOwnTracker()
    {
        const FakeSessionNode node = session(kTess);
        const ObjectPoses own{
            .at = [](ObjectKind kind, SessionTime t) -> std::optional<PoseSample> {
                if (kind == ObjectKind::Hand)
                    return std::nullopt; // never seen
                PoseSample sample;
                sample.time = t;
                sample.X_FO = at(100.0);
                return sample;
            }};
        const auto people = peoplePoses(node, FakeSessionNode::kStation, own, kNow);
        QCOMPARE(people.size(), std::size_t{5});
        for (const PersonPose& person : people) {
            QCOMPARE(person.isOwn, person.owner == kTess);
            QCOMPARE(person.X_AO.translation().x(),
                     person.isOwn ? 100.0 : double(person.object.value));
        }
    }

    void leavesOutWhoHasGone()
    {
        FakeSessionNode node = session();
        node.decide(fact::ParticipantLeft{kTess});
        const auto people = peoplePoses(node, FakeSessionNode::kStation, {}, kNow);
        QCOMPARE(people.size(), std::size_t{3});
        for (const PersonPose& person : people)
            QCOMPARE(person.owner, kTom);
    }

    /// Whose samples are newer decides nothing.
    void worksWithTheTubeOfWhoIsAtWorkAndNotWithTheNewest()
    {
        FakeSessionNode node = session();
        node.sees(kTessTube, at(7.0), kNow + 1s);
        const auto tube = [&] {
            const auto people = peoplePoses(node, FakeSessionNode::kStation, {}, kNow);
            const PersonPose* found = atWork(people, ObjectKind::Tube);
            return found ? found->object : ObjectId{};
        };
        QCOMPARE(tube(), kTomsTube);
        node.decide(fact::WorkTaken{kTess, kTom});
        QCOMPARE(tube(), kTessTube);
        node.decide(fact::ParticipantLeft{kTess});
        QCOMPARE(tube(), kTomsTube); // the work passes on
        node.decide(fact::ParticipantLeft{kTom});
        QCOMPARE(tube(), ObjectId{});
    }

    /// A tube that was shared before, and is then handed to who is at work, took theirs away.
    void worksWithTheirOwnTubeAndNotWithOneHandedToThem()
    {
        FakeSessionNode node = session();
        const auto tube = [&] {
            const auto people = peoplePoses(node, FakeSessionNode::kStation, {}, kNow);
            return atWork(people, ObjectKind::Tube)->object;
        };
        node.decide(fact::WorkTaken{kTess, kTom});
        node.decide(fact::ObjectWanted{kTomsTube}, kTess);
        node.decide(fact::ObjectHandedOver{kTomsTube, kTess, 1}, kTom);
        QVERIFY(node.state()->objects().at(kTomsTube).owner == kTess);
        QCOMPARE(tube(), kTessTube);
        // Who has no tube of their own works with what they were given.
        node.decide(fact::ObjectHandedOver{kTessTube, FakeSessionNode::kInstructor, 1}, kTess);
        QCOMPARE(tube(), kTomsTube);
    }

    /// 90 degrees about +y take the patient's head end, +z, to the patient's left, +x.
    void drawsPeopleAtTheirPlaces()
    {
        FakeSessionNode node = session();
        node.decide(fact::PlaceChosen{kTess, degrees(90.0)});
        node.decide(fact::PlaceChosen{kTom, degrees(90.0)});
        const auto people = peoplePoses(node, FakeSessionNode::kStation, {}, kNow);
        const auto isTurned = [&](ObjectId object) {
            const PersonPose& person = find(people, object);
            const Vec3 turned{0.5, 0.0, -double(object.value)};
            const bool is = (person.X_AO.translation() - turned).norm() < kSmall;
            const bool isNot =
                (person.X_AO.translation() - person.pose.X_FO.translation()).norm() < kSmall;
            return is && !isNot;
        };
        for (const ObjectId object : {kTessHead, kTessHand, kTessTube, kTomsHead})
            QVERIFY(isTurned(object));
        // Tom is at work: his tube is in the patient, and his hand holds it.
        for (const ObjectId object : {kTomsTube, kTomsHand})
            QVERIFY(!isTurned(object));
        QVERIFY(headOf(people, kTess)->object == kTessHead);
        QVERIFY(headOf(people, FakeSessionNode::kInstructor) == nullptr);
    }

    /// Others see them there; PersonPose::pose is where the own tracker has them.
    void placesOwnObjectsAsThoseOfOthers()
    {
        FakeSessionNode node = session(kTess);
        node.decide(fact::ObjectShared{{}, kTess, ObjectKind::Laryngoscope, "blade"});
        node.decide(fact::PlaceChosen{kTess, degrees(90.0)});
        const ObjectPoses own{.at = [](ObjectKind, SessionTime t) -> std::optional<PoseSample> {
            PoseSample sample;
            sample.time = t;
            sample.X_FO = at(100.0);
            return sample;
        }};
        const auto people = peoplePoses(node, FakeSessionNode::kStation, own, kNow);
        QCOMPARE(std::ranges::count(people, true, &PersonPose::isOwn), 4);
        for (const PersonPose& person : people) {
            if (!person.isOwn)
                continue;
            QVERIFY((person.X_AO.translation() - Vec3{0.5, 0.0, -100.0}).norm() < kSmall);
            QCOMPARE(person.pose.X_FO.translation().x(), 100.0);
        }
    }

    void namesHeadsAndTubes()
    {
        const FakeSessionNode node = session(kTess);
        const ObjectPoses own{.at = [](ObjectKind, SessionTime) { return PoseSample{}; }};
        const auto people = peoplePoses(node, FakeSessionNode::kStation, own, kNow);
        const auto name = [&](ObjectId object) { return nameBeside(find(people, object), kTom); };
        QCOMPARE(name(kTomsHead), QStringLiteral("● Tom, at work"));
        QCOMPARE(name(kTomsTube), QStringLiteral("Tube of Tom"));
        QCOMPARE(name(kTessTube), QStringLiteral("Your tube"));
        QCOMPARE(name(kTomsHand), QString{});
        QCOMPARE(nameBeside(find(people, kTomsHead), kTess), QStringLiteral("Tom"));
    }

    void saysThroughWhoseEyesAViewIs()
    {
        const FakeSessionNode node = session();
        StationMoment moment;
        moment.people = peoplePoses(node, FakeSessionNode::kStation, {}, kNow);
        const auto text = [&] { return throughEyesText(*node.state(), moment, kTom); };
        QCOMPARE(text(), QStringLiteral("● Through the eyes of Tom"));
        moment.people = peoplePoses(node, FakeSessionNode::kStation, {}, kNow + 10s);
        const QString lost =
            QStringLiteral("▲ Through the eyes of Tom, whose head is not tracked now");
        QCOMPARE(text(), lost);
        moment.people.clear();
        QCOMPARE(text(), lost);
    }

    /// Of another's tube the own tracker sees nothing.
    void saysWhoseTubeIsOutOfView()
    {
        FakeSessionNode node = session(kTess);
        node.linkReports.emplace_back().state = LinkState::Connected;
        node.decide(fact::PhaseChanged{SessionPhase::Running});
        StationMoment moment;
        moment.time = kNow + 1s;
        moment.worker = kTom;
        const RegistrationStanding standing{RegistrationState::Simulated, StaleReason::None, {}};
        const auto notice = [&] {
            return stationNotice(node, moment, ViewOutput::Screen, standing);
        };
        QCOMPARE(notice(), QStringLiteral("The tube of Tom is out of view"));
        moment.tube.emplace().validity = Validity::Tracked;
        QCOMPARE(notice(), QString{});
        moment.tube->validity = Validity::Lost;
        moment.worker = kTess;
        QCOMPARE(notice(), QStringLiteral("Tube out of the tracker's view"));
    }
};

CARINA_TEST(TestPeoplePoses)

} // namespace carina::people_poses_test

#include "tst_people_poses.moc"
