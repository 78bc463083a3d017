#include "engine/anatomy/patient/patient_name.h"
#include "engine/session/participant_limits.h"
#include "models/patient/shared_patient.h"
#include "models/station/own_station.h"
#include "models/station/stations_model.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

#include <array>

namespace carina::stations_model_test
{

using test::FakeSessionNode;

constexpr StationId kFirst = FakeSessionNode::kStation;
constexpr StationId kRoom{1};
constexpr StationId kThird{2};

class TestStationsModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void listsWhatIsOpenAndHowManyAreThere();
    void opensAStationWithItsPatient();
    void staysWhereItIsIfAskedTo();
    void saysWhatIsWrongWithAName_data();
    void saysWhatIsWrongWithAName();
    void saysWhatIsWrongWithAPatient();
    void saysWhyNoStationIsAdded();
    void saysWhyAStationIsNotClosed();
    void leavesAStationBeforeItIsClosed();
    void showsAnotherStationWhenTheShownOneIsClosed();
    void changesAllOnlyWhereThereAreSeveral();
    void movesParticipants();
    void followsItsOwnParticipant();
    void namesAndMovesAreTakenBack();
    void takesBackWhatIsStillUnderWay();
    void saysWhyItIsNotTakenBack_data();
    void saysWhyItIsNotTakenBack();
    void remembersNoMoveThatNobodyChose();
};

namespace
{

struct Console {
    FakeSessionNode node;
    SessionModel session{node};
    StationsModel stations{session};

    static void deliver() { QCoreApplication::sendPostedEvents(); }
    void addRoom()
    {
        node.addStation("Room 5");
        deliver();
    }
    void moveTom(StationId station) { stations.move(FakeSessionNode::kTrainee, station); }
};

/// What is done, and what happens since.
struct Step {
    const char* name;
    void (*make)(Console&);
    void (*since)(Console&);
    const char* told;
};
constexpr std::array kSteps{
    Step{"somebody gave it another name",
         [](Console& console) { console.stations.rename(kFirst, QStringLiteral("Hall")); },
         [](Console& console) { console.node.decide(fact::StationRenamed{"Yard"}); },
         "Not undone: somebody has called the station Yard since."},
    Step{"it has its name again",
         [](Console& console) { console.stations.rename(kFirst, QStringLiteral("Hall")); },
         [](Console& console) { console.node.decide(fact::StationRenamed{"Station 1"}); },
         "Nothing to undo: the station is called Station 1 again."},
    Step{"another has its name",
         [](Console& console) { console.stations.rename(kFirst, QStringLiteral("Hall")); },
         [](Console& console) { console.node.decideAt(kRoom, fact::StationRenamed{"Station 1"}); },
         "Not undone: another station is called Station 1 now."},
    Step{"who was moved has left", [](Console& console) { console.moveTom(kRoom); },
         [](Console& console) {
             console.node.decide(fact::ParticipantLeft{FakeSessionNode::kTrainee});
         },
         "Not undone: Tom has left the session."},
    Step{"who was moved is back", [](Console& console) { console.moveTom(kRoom); },
         [](Console& console) {
             console.node.decide(fact::ParticipantMoved{FakeSessionNode::kTrainee});
         },
         "Nothing to undo: Tom is at Station 1 again."},
    Step{"who was moved is elsewhere", [](Console& console) { console.moveTom(kRoom); },
         [](Console& console) {
             console.node.addStation("Hall");
             console.node.decideAt(kThird, fact::ParticipantMoved{FakeSessionNode::kTrainee});
         },
         "Not undone: Tom is at Hall now."},
    Step{"there is no way back", [](Console& console) { console.moveTom(kRoom); },
         [](Console& console) {
             for (const ParticipantId who :
                  {FakeSessionNode::kInstructor, FakeSessionNode::kObserver})
                 console.node.decideAt(kRoom, fact::ParticipantMoved{who});
             console.node.decide(fact::StationClosed{});
         },
         "Not undone: the station Station 1 has been closed."}};

} // namespace

void TestStationsModel::listsWhatIsOpenAndHowManyAreThere()
{
    Console console;
    QSignalSpy changed{&console.stations, &StationsModel::changed};
    using Rows = std::vector<StationsModel::Row>;
    QVERIFY((console.stations.open() == Rows{{kFirst, QStringLiteral("Station 1"), 3}}));
    console.addRoom();
    QCOMPARE(changed.count(), 1);
    console.node.decide(fact::ParticipantLeft{FakeSessionNode::kObserver});
    console.node.decideAt(kRoom, fact::ParticipantMoved{FakeSessionNode::kTrainee});
    console.node.decideAt(kRoom, fact::StationRenamed{"Hall"});
    Console::deliver();
    QVERIFY(
        (console.stations.open()
         == Rows{{kFirst, QStringLiteral("Station 1"), 1}, {kRoom, QStringLiteral("Hall"), 1}}));
    QCOMPARE(console.stations.shown(), kFirst);
    QCOMPARE(changed.count(), 2); // what came at once is told once
}

void TestStationsModel::opensAStationWithItsPatient()
{
    Console console;
    QSignalSpy shown{&console.stations, &StationsModel::shownChanged};
    console.stations.add(QStringLiteral(" Room 5 "), QStringLiteral("45 years, 182 cm, man"));
    Console::deliver();
    Console::deliver(); // what it proposed then
    const auto state = console.node.state();
    const Station& room = state->stations().at(kRoom);
    QCOMPARE(room.name, std::string{"Room 5"});
    const PatientParameters patient = patientFromWords("45 years, 182 cm, man").value();
    QCOMPARE(room.anatomyHash, madeHash(patient));
    QCOMPARE(room.respiration.settingsAt(SessionTime::max()).build.ageInYears, 45.0);
    QVERIFY(sharedPatient(*state, kRoom));
    QCOMPARE(sharedPatient(*state, kRoom)->owner, console.node.self());
    QVERIFY(state->stations().at(kFirst).anatomyHash.empty());
    QCOMPARE(console.stations.shown(), kRoom);
    QCOMPARE(shown.count(), 1);
}

void TestStationsModel::staysWhereItIsIfAskedTo()
{
    Console console;
    console.stations.add(QStringLiteral("Room 5"), QStringLiteral("adult"),
                         StationsModel::After::StayHere);
    Console::deliver();
    QCOMPARE(console.stations.open().size(), std::size_t{2});
    QCOMPARE(console.stations.shown(), kFirst);
}

void TestStationsModel::saysWhatIsWrongWithAName_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("isNewFine");
    QTest::addColumn<bool>("isRenamingFine"); // of the second station
    QTest::newRow("another") << QStringLiteral("Hall") << true << true;
    QTest::newRow("none") << QStringLiteral("  ") << false << false;
    QTest::newRow("that of the first") << QStringLiteral("STATION 1") << false << false;
    QTest::newRow("its own") << QStringLiteral("room 5") << false << true;
    QTest::newRow("too long") << QString{65, QLatin1Char('x')} << false << false;
    QTest::newRow("not seen") << QStringLiteral("Ha\u200bll") << false << false;
}

void TestStationsModel::saysWhatIsWrongWithAName()
{
    QFETCH(const QString, name);
    QFETCH(const bool, isNewFine);
    QFETCH(const bool, isRenamingFine);
    Console console;
    console.addRoom();
    QCOMPARE(console.stations.faultOfName(name, kNoStation).isEmpty(), isNewFine);
    QCOMPARE(console.stations.faultOfName(name, kRoom).isEmpty(), isRenamingFine);
    // The host is of the same opinion.
    console.stations.rename(kRoom, name);
    QCOMPARE(!console.node.refusal(), isRenamingFine);
}

void TestStationsModel::saysWhatIsWrongWithAPatient()
{
    for (const char* fine : {"adult", "Child, girl", "8y, 128cm, boy, slim"})
        QVERIFY(StationsModel::faultOfPatient(QLatin1String{fine}).isEmpty());
    for (const char* wrong : {"", "somebody", "8 years", "300 years, 180 cm, man"})
        QVERIFY(!StationsModel::faultOfPatient(QLatin1String{wrong}).isEmpty());
    const auto fault = [](const char* words) {
        return StationsModel::faultOfPatient(QLatin1String{words});
    };
    QCOMPARE(fault("30 years, 300 cm, man"),
             QStringLiteral("300 cm are out of range: a height is 100 to 210 cm."));
    QCOMPARE(fault("91 years, 170 cm, woman"),
             QStringLiteral("91 years are out of range: an age is 0 to 90 years."));
    QCOMPARE(fault("newborn, 50 cm, girl"), QString{});
    QCOMPARE(fault("newborn, 75 cm, girl"),
             QStringLiteral("75 cm are out of range: a height is 45 to 60 cm."));
    QCOMPARE(fault("2 months, 48 cm, boy"),
             QStringLiteral("48 cm are out of range: a height is 49 to 65 cm."));
    QCOMPARE(fault("2 months, 49 cm, boy"), QString{});
    const QString both = fault("91 years, 300 cm, man");
    QVERIFY2(both.contains(QStringLiteral("0 to 90 years"))
                 && both.contains(QStringLiteral("100 to 210 cm")),
             qPrintable(both));
    QVERIFY2(fault("adult, airway 300 mm").contains(QStringLiteral("204 to 276 mm")),
             qPrintable(fault("adult, airway 300 mm")));
}

void TestStationsModel::saysWhyNoStationIsAdded()
{
    Console console;
    for (std::size_t i = 1; i < kMostStations; ++i) {
        QVERIFY(console.stations.obstacleToAdding().isEmpty());
        console.node.addStation(("Room " + std::to_string(i)).c_str());
        Console::deliver();
    }
    QVERIFY(!console.stations.obstacleToAdding().isEmpty());
    console.node.decideAt(kRoom, fact::StationClosed{});
    Console::deliver();
    QVERIFY(console.stations.obstacleToAdding().isEmpty());
}

void TestStationsModel::saysWhyAStationIsNotClosed()
{
    Console console;
    QVERIFY(!console.stations.obstacleToClosing(kFirst).isEmpty()); // the only one
    console.addRoom();
    QVERIFY(console.stations.obstacleToClosing(kRoom).isEmpty());
    const QString occupied = console.stations.obstacleToClosing(kFirst);
    QVERIFY2(occupied.contains(QStringLiteral("Tom, Olga")), qPrintable(occupied));
    QVERIFY(!occupied.contains(QStringLiteral("Ina"))); // who closes it
    console.stations.move(FakeSessionNode::kTrainee, kRoom);
    console.stations.move(FakeSessionNode::kObserver, kRoom);
    QVERIFY(console.stations.obstacleToClosing(kFirst).isEmpty());
    QVERIFY(!console.stations.obstacleToClosing(kRoom).isEmpty());
}

void TestStationsModel::leavesAStationBeforeItIsClosed()
{
    Console console;
    console.addRoom();
    console.stations.move(FakeSessionNode::kTrainee, kRoom);
    console.stations.move(FakeSessionNode::kObserver, kRoom);
    console.stations.close(kFirst);
    QVERIFY(!console.node.refusal());
    QVERIFY(!console.node.state()->isOpen(kFirst));
    QCOMPARE(console.stations.stationOf(FakeSessionNode::kInstructor), kRoom);
}

void TestStationsModel::showsAnotherStationWhenTheShownOneIsClosed()
{
    Console console;
    console.addRoom();
    console.stations.show(kRoom);
    QCOMPARE(console.stations.shown(), kRoom);
    console.stations.show(StationId{9}); // none
    QCOMPARE(console.stations.shown(), kRoom);
    console.stations.close(kRoom);
    Console::deliver();
    QCOMPARE(console.stations.shown(), kFirst);
}

void TestStationsModel::changesAllOnlyWhereThereAreSeveral()
{
    Console console;
    QSignalSpy forAll{&console.stations, &StationsModel::forAllChanged};
    console.stations.setForAll(true);
    QVERIFY(!console.stations.isForAll());
    QCOMPARE(forAll.count(), 0);
    console.addRoom();
    QVERIFY(console.stations.isForAll());
    QCOMPARE(forAll.count(), 1);
    console.stations.close(kRoom);
    Console::deliver();
    QVERIFY(!console.stations.isForAll());
    QCOMPARE(forAll.count(), 2);
}

void TestStationsModel::movesParticipants()
{
    Console console;
    console.addRoom();
    console.stations.move(FakeSessionNode::kTrainee, kRoom);
    QCOMPARE(console.stations.stationOf(FakeSessionNode::kTrainee), kRoom);
    QCOMPARE(console.node.state()->objects().at(FakeSessionNode::kTube).station, kRoom);
}

void TestStationsModel::followsItsOwnParticipant()
{
    Console console;
    const OwnStation own{console.session};
    QSignalSpy changed{&own, &OwnStation::changed};
    QCOMPARE(own.id(), kFirst);
    QCOMPARE(stationText(console.node), QString{}); // there is but one
    console.addRoom();
    QCOMPARE(changed.count(), 0);
    QCOMPARE(stationText(console.node), QStringLiteral("Station: Station 1"));
    console.stations.move(FakeSessionNode::kInstructor, kRoom);
    Console::deliver();
    QCOMPARE(changed.count(), 1);
    QCOMPARE(own.id(), kRoom);
    QCOMPARE(stationText(console.node), QStringLiteral("Station: Room 5"));
    console.node.becomes(kNobody);
    console.node.announce();
    Console::deliver();
    QCOMPARE(own.id(), kNoStation);
}

void TestStationsModel::namesAndMovesAreTakenBack()
{
    Console console;
    console.addRoom();
    ChangeHistory history;
    console.stations.setHistory(history);
    console.stations.rename(kRoom, QStringLiteral(" Hall "));
    console.moveTom(kRoom);
    Console::deliver();
    QCOMPARE(history.texts(), (QStringList{QStringLiteral("Tom → moved to Hall"),
                                           QStringLiteral("Hall: Name of the station → Hall")}));
    console.stations.show(kRoom);
    QCOMPARE(history.texts().last(), QStringLiteral("Name of the station → Hall"));
    history.undo();
    QCOMPARE(console.stations.stationOf(FakeSessionNode::kTrainee), kFirst);
    QCOMPARE(console.node.state()->objects().at(FakeSessionNode::kTube).station, kFirst);
    history.undo();
    QCOMPARE(console.stations.nameOf(kRoom), QStringLiteral("Room 5"));
    QVERIFY(history.isEmpty());
    console.stations.rename(kRoom, QStringLiteral("Room 5")); // as it is
    console.moveTom(kFirst);
    QVERIFY(history.isEmpty());
}

void TestStationsModel::takesBackWhatIsStillUnderWay()
{
    Console console;
    console.addRoom();
    ChangeHistory history;
    console.stations.setHistory(history);
    const QSignalSpy refused{&history, &ChangeHistory::refused};
    console.node.hostGoesAway();
    console.stations.rename(kRoom, QStringLiteral("Hall"));
    console.moveTom(kRoom);
    history.undo(2);
    QVERIFY(refused.isEmpty());
    console.node.hostComesBack();
    QCOMPARE(console.stations.nameOf(kRoom), QStringLiteral("Room 5"));
    QCOMPARE(console.stations.stationOf(FakeSessionNode::kTrainee), kFirst);
    QVERIFY(!console.node.refusal());
}

void TestStationsModel::saysWhyItIsNotTakenBack_data()
{
    QTest::addColumn<int>("place");
    for (int place = 0; place < int(kSteps.size()); ++place)
        QTest::newRow(kSteps[std::size_t(place)].name) << place;
}

void TestStationsModel::saysWhyItIsNotTakenBack()
{
    QFETCH(const int, place);
    const Step& step = kSteps[std::size_t(place)];
    Console console;
    console.addRoom();
    ChangeHistory history;
    console.stations.setHistory(history);
    const QSignalSpy refused{&history, &ChangeHistory::refused};
    step.make(console);
    step.since(console);
    QVERIFY(!console.node.refusal());
    Console::deliver();
    const int proposed = console.node.proposed;
    history.undo();
    QCOMPARE(refused.size(), 1);
    QCOMPARE(refused.last().front().toString(), QString::fromUtf8(step.told));
    QCOMPARE(console.node.proposed, proposed);
    QVERIFY(history.isEmpty());
}

void TestStationsModel::remembersNoMoveThatNobodyChose()
{
    Console console;
    console.addRoom();
    ChangeHistory history;
    console.stations.setHistory(history);
    for (const ParticipantId who : {FakeSessionNode::kTrainee, FakeSessionNode::kObserver})
        console.node.decideAt(kRoom, fact::ParticipantMoved{who});
    console.stations.close(kFirst);
    QCOMPARE(console.stations.stationOf(FakeSessionNode::kInstructor), kRoom);
    QVERIFY(history.isEmpty());
}

CARINA_TEST(TestStationsModel)

} // namespace carina::stations_model_test

#include "tst_stations_model.moc"
