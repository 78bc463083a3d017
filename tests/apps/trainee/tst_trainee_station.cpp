#include "apps/trainee/trainee_station.h"

#include "engine/anatomy/patient/builtin_patient.h"
#include "tests/engine/net/devices/igtl_offers.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

namespace carina::trainee_station_test
{
namespace
{

/// A tube that was seen once, a hundred millimetres from the tracker.
TrackerChoice recording()
{
    return {
        PlayedRecording{"tube.csv",
                        {{{.name = "tube",
                           .role = ToolRole::Tube,
                           .samples = {{.X_FO = RigidTransform::translation({0.1, 0.0, 0.0})}}}}},
                        Playing::Once}};
}

const SharedPatientModel& patient(BuiltinPatient which)
{
    static std::map<BuiltinPatient, SharedPatientModel> patients;
    SharedPatientModel& made = patients[which];
    if (!made)
        made = patientOf(builtinPatient(which).value()).value();
    return made;
}

/// Where the patients lie: one beside the other.
TraineeStation::Place placeOf(const PatientModel& of)
{
    const bool isAdult = &of == patient(BuiltinPatient::Adult).get();
    SitePlace place;
    place.setup = SiteSetup{};
    place.setup->registration.X_AT = RigidTransform::translation({0.0, isAdult ? 0.5 : -0.5, 0.0});
    return place;
}

/// A server that sends one tool, and how it stands to the first of several.
struct Sender {
    std::unique_ptr<IgtlServer> server = IgtlServer::listen({"127.0.0.1", 0}).value();
    std::string name;
    RigidTransform X_DO;
    int given = 0;

    /// Once more. It stamps 16 times a second.
    void give()
    {
        auto offer = std::make_shared<IgtlOffer>();
        offer->stamp = std::uint64_t(++given) << 28U;
        offer->tools = {{name, X_DO, true}};
        offer->landmarks = std::make_shared<const IgtlPoints>();
        server->give(std::move(offer));
    }

    [[nodiscard]] PlacedDescription described(ToolRole role, const DevicePlace& place) const
    {
        TrackerDescription described;
        described.kind = TrackerKind::OpenIgtLink;
        described.address = "127.0.0.1:" + std::to_string(server->port());
        described.tools.push_back({name, role, {}, name});
        return {std::move(described), place};
    }
};

class Station : public TraineeStation
{
public:
    explicit Station(std::optional<TrackerChoice> tracker)
        : TraineeStation{std::make_unique<test::FakeSessionNode>(test::FakeSessionNode::kTrainee),
                         {.tracker = std::move(tracker)},
                         [](const PatientModel& of) { return Result<Place>{placeOf(of)}; }}
    {
    }
};

} // namespace

class TraineeStationTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The sample stays that was delivered before the second patient was laid.
    void itsTrackerGoesOnForAnotherPatient()
    {
        Station station{recording()};
        QVERIFY(station.lay(patient(BuiltinPatient::Adult)));
        const Tracker* tracker = &station.tracking()->tracker();
        QTRY_VERIFY(station.tracking()->newest(ToolRole::Tube).has_value());
        const auto before = station.tracking()->newest(ToolRole::Tube);
        QVERIFY(station.lay(patient(BuiltinPatient::TwelveYears)));
        QCOMPARE(&station.tracking()->tracker(), tracker);
        const auto after = station.tracking()->newest(ToolRole::Tube);
        QVERIFY(after.has_value());
        QCOMPARE(after->time, before->time);
        const Vec3 moved = after->X_FO.translation() - before->X_FO.translation();
        QVERIFY((moved - Vec3{0.0, -1.0, 0.0}).norm() < 1e-12);
    }

    /// The second stands two metres along z from the first, and half a turn about x from it.
    void twoDevicesPlayTogether()
    {
        Sender chin{.name = "Chin", .X_DO = RigidTransform::translation({0.1, 0.2, 0.3})};
        Sender head{.name = "Head", .X_DO = RigidTransform::translation({0.4, 0.5, 0.6})};
        const DevicePlace place{{Quat{0.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 2.0}}, {}};
        Station station{TrackerChoice{
            DeviceSet{{chin.described(ToolRole::Jaw, {}), head.described(ToolRole::Head, place)}}}};
        QVERIFY(station.lay(patient(BuiltinPatient::Adult)));
        const auto haveCome = [&] {
            chin.give();
            head.give();
            const auto tools = station.tracking()->tracker().tools();
            return tools.size() == 2 && tools[0].history->newest() && tools[1].history->newest();
        };
        constexpr int kPatience_ms = 10'000;
        QTRY_VERIFY_WITH_TIMEOUT(haveCome(), kPatience_ms);
        constexpr double kFloat = 1e-6; // metres; of a message
        const auto tools = station.tracking()->tracker().tools();
        QVERIFY((tools[0].history->newest()->X_FO.translation() - Vec3{0.1, 0.2, 0.3}).norm()
                < kFloat);
        const auto seen = station.tracking()->newest(ToolRole::Head);
        QVERIFY(seen.has_value());
        // X_AT, and (x, -y, 2 - z).
        QVERIFY((seen->X_FO.translation() - Vec3{0.4, 0.0, 1.4}).norm() < kFloat);
    }

    void anotherTrackerIsAnother()
    {
        Station station{recording()};
        QVERIFY(station.lay(patient(BuiltinPatient::Adult)));
        const auto before = station.tracking(); // kept, so that its place is not used again
        QVERIFY(station.setTracker(recording(), {}));
        QVERIFY(&station.tracking()->tracker() != &before->tracker());
        QVERIFY(station.setTracker(std::nullopt, {}));
        QVERIFY(station.tracking() == nullptr);
    }

    /// A device that is tried may be its own, and has room for one.
    void letsGoOfItsDeviceForAWhile()
    {
        Sender tube{.name = "Tube", .X_DO = RigidTransform::translation({0.1, 0.2, 0.3})};
        Station station{TrackerChoice{tube.described(ToolRole::Tube, {}).described}};
        QVERIFY(station.lay(patient(BuiltinPatient::Adult)));
        QTRY_COMPARE(tube.server->clients(), 1);
        station.holdTracker(true);
        QTRY_COMPARE(tube.server->clients(), 0);
        station.holdTracker(false);
        QTRY_COMPARE(tube.server->clients(), 1);
        const auto hasCome = [&] {
            tube.give();
            return station.tracking()->newest(ToolRole::Tube).has_value();
        };
        constexpr int kPatience_ms = 10'000;
        QTRY_VERIFY_WITH_TIMEOUT(hasCome(), kPatience_ms);
    }

    /// Its manikin is the patient's own.
    void aSimulatedTrackerIsMadeForEachPatient()
    {
        Station station{TrackerChoice{SimulatedDevice{}}};
        QVERIFY(station.lay(patient(BuiltinPatient::Adult)));
        const auto before = station.tracking();
        QVERIFY(station.lay(patient(BuiltinPatient::TwelveYears)));
        QVERIFY(&station.tracking()->tracker() != &before->tracker());
    }
};

CARINA_TEST(TraineeStationTest)

} // namespace carina::trainee_station_test

#include "tst_trainee_station.moc"
