#include "apps/trainee/trainee_station.h"

#include "engine/anatomy/patient/builtin_patient.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <map>

namespace carina::trainee_station_test
{
namespace
{

const SharedPatientModel& patient(BuiltinPatient which)
{
    static std::map<BuiltinPatient, SharedPatientModel> patients;
    SharedPatientModel& made = patients[which];
    if (!made)
        made = patientOf(builtinPatient(which).value()).value();
    return made;
}

/// A head that was seen once.
TrackerChoice recording()
{
    return {PlayedRecording{
        "head.csv", {{{.name = "head", .role = ToolRole::Head, .samples = {{}}}}}, Playing::Once}};
}

/// Without a tracker, where the patient lies in the tracker's frame.
class Station : public TraineeStation
{
public:
    Station()
        : TraineeStation{std::make_unique<test::FakeSessionNode>(test::FakeSessionNode::kTrainee),
                         {},
                         [](const PatientModel&) -> Result<SharedTools::Place> {
                             SitePlace place;
                             place.setup = SiteSetup{};
                             return std::optional{std::move(place)};
                         }}
    {
    }
};

} // namespace

class TraineeStationTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void showsAnotherPatientWhileTheFormerIsThere()
    {
        Station station;
        const StationView* shown = nullptr;
        int told = 0;
        station.onShown([&] {
            ++told;
            QVERIFY(&station.view() != shown); // whose place is not free yet
            shown = &station.view();
        });
        QVERIFY(station.tools().lay(patient(BuiltinPatient::Adult)));
        QCOMPARE(&station.patient(), patient(BuiltinPatient::Adult).get());
        QVERIFY(station.tools().lay(patient(BuiltinPatient::TwelveYears)));
        QCOMPARE(&station.patient(), patient(BuiltinPatient::TwelveYears).get());
        QCOMPARE(told, 2);
        QVERIFY(shown == &station.view());
    }

    /// With what a tracker that is given later sees.
    void viewsWhatIsTrackedNow()
    {
        Station station;
        QVERIFY(station.tools().lay(patient(BuiltinPatient::Adult)));
        const SessionTime now = *station.node().now();
        QVERIFY(!station.view().at(now, 0).head);
        QVERIFY(station.tools().setTracker(recording()));
        QTRY_VERIFY(station.view().at(now, 0).head.has_value());
        QVERIFY(station.view().at(now, 0).ownHandsAreDrawn); // where the output is a screen
        QVERIFY(station.tools().setTracker(std::nullopt));
        QVERIFY(!station.view().at(now, 0).head);
    }

    void opensAtTheStationOfItsParticipant()
    {
        Station station;
        QVERIFY(station.tools().lay(patient(BuiltinPatient::Adult)));
        const SessionTime now = *station.node().now();
        QVERIFY(station.view().at(now, 0).worker == test::FakeSessionNode::kTrainee);
        station.setStation(kNoStation);
        QVERIFY(station.view().at(now, 0).worker == kNobody);
    }
};

CARINA_TEST(TraineeStationTest)

} // namespace carina::trainee_station_test

#include "tst_trainee_station.moc"
