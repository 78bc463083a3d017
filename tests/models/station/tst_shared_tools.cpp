#include "models/station/shared_tools.h"

#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/tracking/simulated/scripted_hands.h"
#include "tests/models/fake_session_node.h"
#include "tests/models/tracker/sending_device.h"
#include "tests/support/soon.h"
#include "tests/support/test_class.h"

#include <map>

namespace carina::shared_tools_test
{
namespace
{

using test::FakeSessionNode;
using test::SendingDevice;
using test::soon;

constexpr std::chrono::seconds kPatience{10};
constexpr double kFloat = 1e-6;  ///< metres; of a message
constexpr double kExact = 1e-12; ///< metres

RigidTransform at(double x, double y, double z) { return RigidTransform::translation({x, y, z}); }

bool isAt(const std::optional<PoseSample>& sample, const Vec3& p, double tolerance = kExact)
{
    return sample && (sample->X_FO.translation() - p).norm() < tolerance;
}

/// Whether what was seen until then is still known. Samples that were on their way may come before
/// it or after: a device's stamps are read the better the more of them have come.
bool hasKept(const PoseHistory& history, SessionTime until)
{
    return history.samples().front().time <= until;
}

/// A tube, a hand and a stylus that were seen once, each at a place of its own.
TrackerChoice recording()
{
    const auto seen = [](const char* name, ToolRole role, double x) {
        return RecordedTool{.name = name, .role = role, .samples = {{.X_FO = at(x, 0.0, 0.0)}}};
    };
    return {PlayedRecording{"tools.csv",
                            {{seen("tube", ToolRole::Tube, 0.1), seen("hand", ToolRole::Hand, 0.2),
                              seen("stylus", ToolRole::Stylus, 0.3)}},
                            Playing::Once}};
}

/// A laryngoscope that was seen once.
TrackerChoice laryngoscopeCalled(const char* name)
{
    return {PlayedRecording{
        "tools.csv",
        {{RecordedTool{.name = name, .role = ToolRole::Laryngoscope, .samples = {PoseSample{}}}}},
        Playing::Once}};
}

const SharedPatientModel& patient(BuiltinPatient which = BuiltinPatient::Adult)
{
    static std::map<BuiltinPatient, SharedPatientModel> patients;
    SharedPatientModel& made = patients[which];
    if (!made)
        made = patientOf(builtinPatient(which).value()).value();
    return made;
}

/// What a site says: patients lie beside each other, and the tip of the stylus is known.
struct SaidBySite {
    bool isReadable = true;
    bool isRegistered = true;
    bool isThere = true;

    [[nodiscard]] Result<SharedTools::Place> placeOf(const PatientModel& of) const
    {
        if (!isReadable)
            return fail(Errc::FileMalformed, "site.json");
        if (!isThere)
            return std::optional<SitePlace>{};
        SitePlace place{
            .standing = {isRegistered ? RegistrationState::Good : RegistrationState::Stale,
                         StaleReason::None,
                         {}}};
        if (!isRegistered)
            return std::optional{place};
        const bool isAdult = &of == patient().get();
        place.setup = SiteSetup{
            .registration = {.X_AT = at(0.0, isAdult ? 0.5 : -0.5, 0.0)},
            .guard = GuardedRegistration{.styluses = {{.p_SQ = {0.0, 0.0, -0.1}, .tool = "stylus"}},
                                         .landmarks = {{"chin", {0.0, -0.1, 0.2}}},
                                         .covariance_A = 1e-8 * Mat6::Identity(),
                                         .fle = millimetres(0.5)}};
        return std::optional{place};
    }
};

struct Station {
    explicit Station(std::optional<TrackerChoice> tracker,
                     ParticipantId self = FakeSessionNode::kTrainee)
        : node{self}, tools{node, {.tracker = std::move(tracker)}, [this](const PatientModel& of) {
                                return site.placeOf(of);
                            }}
    {
    }

    FakeSessionNode node;
    SaidBySite site;
    SharedTools tools;

    [[nodiscard]] const Tracker* tracker() const { return &tools.tracking()->tracker(); }
    [[nodiscard]] std::vector<TrackedTool> tracked() const
    {
        return tools.tracking()->tracker().tools();
    }
    [[nodiscard]] std::optional<PoseSample> newest(ToolRole tool) const
    {
        return tools.tracking() ? tools.tracking()->newest(tool) : std::nullopt;
    }
};

/// A chin probe of the first device and a head of the second.
struct Two {
    SendingDevice chin{.name = "Chin", .X_DO = at(0.1, 0.2, 0.3)};
    SendingDevice head{.name = "Head", .X_DO = at(0.4, 0.5, 0.6)};

    [[nodiscard]] TrackerChoice choice(const DevicePlace& ofHead) const
    {
        return {DeviceSet{{chin.described(ToolRole::Jaw), head.described(ToolRole::Head, ofHead)}}};
    }
    /// Lets both send until their tools are seen.
    [[nodiscard]] bool haveCome(const Station& station)
    {
        return soon(
            [&] {
                chin.give();
                head.give();
                const auto tools = station.tracked();
                return tools.size() == 2 && tools[0].history->newest()
                       && tools[1].history->newest();
            },
            kPatience);
    }
};

} // namespace

class TestSharedTools : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The sample stays that was delivered before the second patient was laid.
    void itsTrackerGoesOnForAnotherPatient()
    {
        Station station{recording()};
        QVERIFY(station.tools.lay(patient()));
        const Tracker* tracker = station.tracker();
        QVERIFY(soon([&] { return station.newest(ToolRole::Tube).has_value(); }));
        const auto before = station.newest(ToolRole::Tube);
        QVERIFY(station.tools.lay(patient(BuiltinPatient::TwelveYears)));
        QCOMPARE(station.tracker(), tracker);
        const auto after = station.newest(ToolRole::Tube);
        QVERIFY(after.has_value());
        QCOMPARE(after->time, before->time);
        const Vec3 moved = after->X_FO.translation() - before->X_FO.translation();
        QVERIFY((moved - Vec3{0.0, -1.0, 0.0}).norm() < kExact);
    }

    /// The second stands two metres along z from the first, and half a turn about x from it.
    void twoDevicesPlayTogether()
    {
        Two two;
        Station station{two.choice({{Quat{0.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 2.0}}, {}})};
        QVERIFY(station.tools.lay(patient()));
        QVERIFY(two.haveCome(station));
        QVERIFY(isAt(station.tracked()[0].history->newest(), {0.1, 0.2, 0.3}, kFloat));
        // X_AT, and (x, -y, 2 - z).
        QVERIFY(isAt(station.newest(ToolRole::Head), {0.4, 0.0, 1.4}, kFloat));
    }

    void anotherTrackerIsAnother()
    {
        Station station{recording()};
        QVERIFY(station.tools.lay(patient()));
        const auto before = station.tools.tracking(); // kept, so that its place is not used again
        QVERIFY(station.tools.setTracker(recording()));
        QVERIFY(station.tracker() != &before->tracker());
        QVERIFY(station.tools.setTracker(std::nullopt));
        QVERIFY(station.tools.tracking() == nullptr);
        QVERIFY(!station.tools.trackerSight());
    }

    /// A device that is tried may be its own, and has room for one.
    void letsGoOfItsDeviceForAWhile()
    {
        SendingDevice tube{.name = "Tube", .X_DO = at(0.1, 0.2, 0.3)};
        Station station{TrackerChoice{tube.described(ToolRole::Tube).described}};
        QVERIFY(station.tools.lay(patient()));
        const auto hasClients = [&](int count) {
            return soon([&] { return tube.server->clients() == count; }, kPatience);
        };
        QVERIFY(hasClients(1));
        station.tools.holdTracker(true);
        QVERIFY(hasClients(0));
        station.tools.holdTracker(false);
        QVERIFY(hasClients(1));
        QVERIFY(soon(
            [&] {
                tube.give();
                return station.newest(ToolRole::Tube).has_value();
            },
            kPatience));
    }

    /// Its manikin is the patient's own.
    void aSimulatedTrackerIsMadeForEachPatient()
    {
        Station station{TrackerChoice{SimulatedDevice{}}};
        QVERIFY(station.tools.lay(patient()));
        const auto before = station.tools.tracking();
        QVERIFY(station.tools.lay(patient(BuiltinPatient::TwelveYears)));
        QVERIFY(station.tracker() != &before->tracker());
    }

    void showsTheTipOfAPlayedStylus_data()
    {
        QTest::addColumn<bool>("hasSite");
        QTest::newRow("by the tip that is calibrated") << true;
        QTest::newRow("without a site") << false;
    }

    /// At a place of the patient, as others see it. The site has its patient half a metre off the
    /// tracker, and the markers of the stylus 100 mm up its shaft.
    void showsTheTipOfAPlayedStylus()
    {
        QFETCH(const bool, hasSite);
        constexpr double kNoise_m = 0.003; // of the tracker, at the end of the shaft
        const Vec3 p_A{0.05, -0.1, -0.2};
        SimulatedDevice device;
        device.play = [&p_A](const PatientModel&) -> Result<PlayedMotion> {
            return PlayedMotion{.at = [&p_A](Duration) {
                return HandledTools{.X_AS = RigidTransform::translation(p_A)};
            }};
        };
        Station station{std::nullopt};
        station.site.isThere = hasSite;
        QVERIFY(station.tools.lay(patient()));
        QVERIFY(station.tools.setTracker(TrackerChoice{device}));
        const RigidTransform X_TA = patientBeforeTracker(patient()->landmarks().p_A_incisors);
        const Vec3 p_A_shown = hasSite ? at(0.0, 0.5, 0.0) * X_TA * p_A : p_A;
        const auto stylus = std::ranges::find(station.node.published, ObjectKind::Stylus,
                                              &FakeSessionNode::Published::kind);
        QVERIFY(stylus != station.node.published.end());
        QVERIFY(soon(
            [&] {
                station.node.advance(std::chrono::milliseconds{20});
                return stylus->newest().has_value();
            },
            kPatience));
        QVERIFY(isAt(stylus->newest(), p_A_shown, kNoise_m));
        QVERIFY(isAt(station.tools.posesOnScreen().at(ObjectKind::Stylus, *station.node.now()),
                     p_A_shown, kNoise_m));
    }

    /// Hands that play nothing leave it beside the patient, and it is not shown.
    void showsNoStylusThatNobodyCalibrated()
    {
        Station station{TrackerChoice{SimulatedDevice{}}};
        station.site.isThere = false;
        QVERIFY(station.tools.lay(patient()));
        QVERIFY(soon(
            [&] {
                station.node.advance(std::chrono::milliseconds{20});
                return station.newest(ToolRole::Stylus).has_value();
            },
            kPatience));
        QVERIFY(!station.tools.posesOnScreen().at(ObjectKind::Stylus, *station.node.now()));
    }

    void tellsOfAReplacementWhileTheFormerIsThere()
    {
        Station station{recording()};
        QVERIFY(station.tools.lay(patient()));
        const std::weak_ptr<const StationTracking> before = station.tools.tracking();
        int told = 0;
        station.tools.onReplaced([&] {
            ++told;
            QVERIFY(!before.expired());
            QVERIFY(station.tools.tracking() == nullptr);
        });
        QVERIFY(station.tools.setTracker(std::nullopt));
        QCOMPARE(told, 1);
        QVERIFY(before.expired());
    }

    void sharesItsToolsWhileItsParticipantIsThere()
    {
        Station station{recording(), FakeSessionNode::kInstructor};
        QVERIFY(station.node.published.empty());
        QVERIFY(station.tools.lay(patient()));
        const auto& published = station.node.published;
        const auto tube =
            std::ranges::find(published, ObjectKind::Tube, &FakeSessionNode::Published::kind);
        QVERIFY(tube != published.end());
        QVERIFY(soon([&] { return tube->newest().has_value(); }));
        QVERIFY(isAt(tube->newest(), {0.1, 0.5, 0.0}));
        const auto stylus =
            std::ranges::find(published, ObjectKind::Stylus, &FakeSessionNode::Published::kind);
        QVERIFY(soon([&] { return stylus->newest().has_value(); }));
        QVERIFY(isAt(stylus->newest(), {0.3, 0.5, -0.1})); // of the tip
        // The patient of another station is drawn before the participant has come there.
        station.node.addStation("Room 5");
        const StationId there = station.node.state()->stations().rbegin()->first;
        station.tools.setStation(there);
        QVERIFY(!tube->newest());
        station.node.decideAt(there, fact::ParticipantMoved{FakeSessionNode::kInstructor});
        QVERIFY(tube->newest().has_value());
        const std::size_t shared = published.size();
        QVERIFY(station.tools.setTracker(recording()));
        QCOMPARE(published.size(), shared); // once, whatever is tracked with
        QVERIFY(station.tools.setTracker(std::nullopt));
        QVERIFY(!station.node.published.front().newest());
    }

    /// Who shares a tube could be given the work with it.
    void sharesNothingUntilItIsRegistered()
    {
        Station station{recording()};
        station.site.isRegistered = false;
        QVERIFY(station.tools.lay(patient()));
        QVERIFY(station.node.published.empty());
        station.site.isRegistered = true;
        station.tools.takePlace();
        QVERIFY(!station.node.published.empty());
    }

    /// As others see by it which blade it has.
    void sharesALaryngoscopeByTheNameOfItsBlade()
    {
        const auto sharedAs = [](const TrackerChoice& tracker) {
            Station station{tracker};
            if (!station.tools.lay(patient()))
                return std::string{"nothing is laid"};
            const auto& published = station.node.published;
            const auto found = std::ranges::find(published, ObjectKind::Laryngoscope,
                                                 &FakeSessionNode::Published::kind);
            return found == published.end() ? std::string{} : found->name;
        };
        const auto recorded = laryngoscopeCalled;
        QCOMPARE(sharedAs(recorded("Macintosh 4")), std::string{"Laryngoscope macintosh-4"});
        QCOMPARE(sharedAs(recorded("blade")), std::string{"Laryngoscope"});
        QCOMPARE(sharedAs(recording()), std::string{});
        SimulatedDevice simulated;
        QCOMPARE(sharedAs({simulated}), std::string{});
        simulated.settings.laryngoscope = true;
        QCOMPARE(sharedAs({simulated}), std::string{"Laryngoscope"});
    }

    /// Others see its blade by its name, and only that which is tracked.
    void sharesALaryngoscopeAnewWithAnotherBlade()
    {
        Station station{laryngoscopeCalled("Macintosh 4")};
        QVERIFY(station.tools.lay(patient()));
        const auto laryngoscopes = [&station] {
            std::vector<FakeSessionNode::Published> found;
            for (const auto& object : station.node.published)
                if (object.kind == ObjectKind::Laryngoscope)
                    found.push_back(object);
            return found;
        };
        const auto isCalled = [&station](const std::string& name) {
            return station.tools.posesOnScreen().isCalled(ObjectKind::Laryngoscope, name);
        };
        QCOMPARE(laryngoscopes().size(), std::size_t{1});
        QVERIFY(soon([&] { return laryngoscopes()[0].newest().has_value(); }, kPatience));
        QVERIFY(station.tools.setTracker(laryngoscopeCalled("Miller 2")));
        QCOMPARE(laryngoscopes().size(), std::size_t{2});
        QCOMPARE(laryngoscopes()[1].name, std::string{"Laryngoscope miller-2"});
        QVERIFY(soon([&] { return laryngoscopes()[1].newest().has_value(); }, kPatience));
        QVERIFY(!laryngoscopes()[0].newest());
        QVERIFY(isCalled("Laryngoscope miller-2"));
        QVERIFY(!isCalled("Laryngoscope macintosh-4"));
        QVERIFY(station.tools.setTracker(laryngoscopeCalled("the other macintosh-4")));
        QCOMPARE(laryngoscopes().size(), std::size_t{2});
        QVERIFY(soon([&] { return laryngoscopes()[0].newest().has_value(); }, kPatience));
        QVERIFY(!laryngoscopes()[1].newest());
        QVERIFY(isCalled("Laryngoscope macintosh-4"));
    }

    void sharesNothingOnceItIsGone()
    {
        FakeSessionNode node;
        {
            const SaidBySite site;
            SharedTools tools{node, {.tracker = recording()}, [&](const PatientModel& of) {
                                  return site.placeOf(of);
                              }};
            QVERIFY(tools.lay(patient()));
            QVERIFY(soon([&] { return node.published.front().newest().has_value(); }));
        }
        QVERIFY(!node.published.front().newest());
    }

    /// Whoever demonstrates beside a trainee is not at work for that.
    void anInstructorsTubeTakesNobodysWork()
    {
        FakeSessionNode node;
        const auto shares =
            fact::ObjectShared{{}, FakeSessionNode::kInstructor, ObjectKind::Tube, "Tube"};
        node.decide(shares, FakeSessionNode::kInstructor);
        QCOMPARE(node.state()->objects().size(), std::size_t{2});
        QVERIFY(node.state()->atWork(FakeSessionNode::kStation) == FakeSessionNode::kTrainee);
        node.decide(fact::ParticipantLeft{FakeSessionNode::kTrainee});
        QVERIFY(node.state()->atWork(FakeSessionNode::kStation) == kNobody);
        node.decide(fact::WorkTaken{FakeSessionNode::kInstructor}, FakeSessionNode::kInstructor);
        QVERIFY(node.state()->atWork(FakeSessionNode::kStation) == FakeSessionNode::kInstructor);
    }

    void drawsHandsAndStylusForWhoLooksAtAScreen()
    {
        Station station{recording()};
        QVERIFY(station.tools.lay(patient()));
        QVERIFY(soon([&] { return station.newest(ToolRole::Stylus).has_value(); }));
        const SessionTime now = *station.node.now();
        const ObjectPoses onScreen = station.tools.posesOnScreen();
        QVERIFY(onScreen.handsAreDrawn);
        QVERIFY(isAt(onScreen.at(ObjectKind::Tube, now), {0.1, 0.5, 0.0}));
        QVERIFY(isAt(onScreen.at(ObjectKind::Hand, now), {0.2, 0.5, 0.0}));
        QVERIFY(isAt(onScreen.at(ObjectKind::Stylus, now), {0.3, 0.5, -0.1}));
        QVERIFY(!onScreen.at(ObjectKind::Head, now)); // the recording has none
        QVERIFY(!onScreen.hasTool(ObjectKind::Head));
        QVERIFY(onScreen.hasTool(ObjectKind::Tube));
        QVERIFY(onScreen.newest(ObjectKind::Tube).has_value());
        // What was asked for goes on with another tracker, and without one.
        QVERIFY(station.tools.setTracker(std::nullopt));
        QVERIFY(!onScreen.at(ObjectKind::Tube, now) && !onScreen.newest(ObjectKind::Tube));
        QVERIFY(!onScreen.hasTool(ObjectKind::Tube));
    }

    void laysThePatientAlsoWhereItsTrackerCannotBeUsed()
    {
        Station station{recording()};
        station.site.isReadable = false;
        QVERIFY(!station.tools.lay(patient()));
        station.tools.layAnyhow(patient());
        QVERIFY(station.tools.patient() == patient());
        QVERIFY(!station.tools.tracker() && station.tools.tracking() == nullptr);
        const auto sight = station.tools.trackerSight();
        QVERIFY(sight && sight->trouble.contains(QStringLiteral("site.json")));
        station.site.isReadable = true;
        QVERIFY(station.tools.setTracker(recording()));
        QVERIFY(station.tools.trackerSight()->trouble.isEmpty());
        QVERIFY(station.tools.tracking() != nullptr);
    }

    /// The frame of the second was calibrated anew. What was seen from elsewhere is forgotten.
    void putsADeviceInItsNewPlaceWhileAllRunOn()
    {
        Two two;
        Station station{two.choice({at(0.0, 0.0, 2.0), {}})};
        QVERIFY(station.tools.lay(patient()));
        QVERIFY(two.haveCome(station));
        const auto before = station.tracked();
        const SessionTime seen = before[0].history->newest()->time;
        QVERIFY(station.tools.setTracker(two.choice({at(0.0, 0.0, 3.0), {}}),
                                         SharedTools::Devices::RunOn));
        const auto after = station.tracked();
        QCOMPARE(after[0].history, before[0].history);
        QCOMPARE(after[1].history, before[1].history);
        QVERIFY(hasKept(*after[0].history, seen));
        QVERIFY(two.haveCome(station));
        for (const PoseSample& sample : after[1].history->samples())
            QVERIFY(isAt(sample, {0.4, 0.5, 3.6}, kFloat));
        QVERIFY(isAt(station.newest(ToolRole::Head), {0.4, 1.0, 3.6}, kFloat));
        QCOMPARE(two.chin.server->clients(), 1);
        QCOMPARE(two.head.server->clients(), 1);
    }

    void replacesTheDeviceAloneThatWasReplaced()
    {
        Two two;
        const DevicePlace place{at(0.0, 0.0, 2.0), {}};
        Station station{two.choice(place)};
        QVERIFY(station.tools.lay(patient()));
        QVERIFY(two.haveCome(station));
        const auto before = station.tools.tracking();
        const PoseHistory* chin = station.tracked()[0].history;
        const SessionTime seen = chin->newest()->time;
        SendingDevice another{.name = "Head", .X_DO = at(0.7, 0.8, 0.9)};
        QVERIFY(station.tools.setTracker(
            TrackerChoice{DeviceSet{
                {two.chin.described(ToolRole::Jaw), another.described(ToolRole::Head, place)}}},
            SharedTools::Devices::RunOn));
        QVERIFY(static_cast<const PoseHistory*>(station.tracked()[0].history) == chin);
        QVERIFY(hasKept(*chin, seen));
        QVERIFY(soon(
            [&] {
                another.give();
                return isAt(station.newest(ToolRole::Head), {0.7, 1.3, 2.9}, kFloat);
            },
            kPatience));
        QVERIFY(soon([&] { return two.head.server->clients() == 0; }, kPatience));
        QCOMPARE(two.chin.server->clients(), 1);
        // And takes it away.
        QVERIFY(station.tools.setTracker(TrackerChoice{two.chin.described(ToolRole::Jaw).described},
                                         SharedTools::Devices::RunOn));
        QCOMPARE(station.tracked().size(), std::size_t{1});
        QVERIFY(static_cast<const PoseHistory*>(station.tracked()[0].history) == chin);
        QVERIFY(soon([&] { return another.server->clients() == 0; }, kPatience));
        QCOMPARE(two.chin.server->clients(), 1);
    }

    /// Taken off by a person, or by a site that names no devices any more.
    void tellsTheSessionThatItsTrackerIsGone()
    {
        Station station{recording()};
        const auto known = [&] {
            const auto state = station.node.state();
            return state->participants().at(FakeSessionNode::kTrainee).registration;
        };
        const auto isKnown = [&](RegistrationState wanted) {
            return known().has_value() && known()->state == wanted;
        };
        QVERIFY(station.tools.lay(patient()));
        QTRY_VERIFY(isKnown(RegistrationState::Good));
        QVERIFY(station.tools.setTracker(std::nullopt));
        QTRY_VERIFY(isKnown(RegistrationState::NoTracker));
        QVERIFY(!station.tools.standing());
        QVERIFY(station.tools.setTracker(recording()));
        QTRY_VERIFY(isKnown(RegistrationState::Good));
    }

    /// As where the site alone says so. In the frame of another device it would be of no use.
    void usesARegistrationOnWhileTheFrameIsTheSame()
    {
        Two two;
        Station station{two.choice({at(0.0, 0.0, 2.0), {}})};
        QVERIFY(station.tools.lay(patient()));
        station.site.isRegistered = false;
        QVERIFY(station.tools.setTracker(two.choice({at(0.0, 0.0, 3.0), {}}),
                                         SharedTools::Devices::RunOn));
        QVERIFY(station.tools.tracking() != nullptr);
        QCOMPARE(station.tools.standing()->state, RegistrationState::Stale);
        QVERIFY(two.haveCome(station));
        QVERIFY(isAt(station.newest(ToolRole::Head), {0.4, 1.0, 3.6}, kFloat));
        QVERIFY(
            station.tools.setTracker(TrackerChoice{two.head.described(ToolRole::Head).described},
                                     SharedTools::Devices::RunOn));
        QVERIFY(station.tools.tracking() == nullptr);
    }
};

CARINA_TEST(TestSharedTools)

} // namespace carina::shared_tools_test

#include "tst_shared_tools.moc"
