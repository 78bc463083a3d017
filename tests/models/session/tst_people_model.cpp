#include "models/session/people_model.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

#include <array>

namespace carina::people_model_test
{
namespace
{

using test::FakeSessionNode;
constexpr ParticipantId kTom = FakeSessionNode::kTrainee;
constexpr ParticipantId kTess{4};
constexpr StationId kStation = FakeSessionNode::kStation;

/// The session as one of its participants has it before them.
struct Seat {
    FakeSessionNode node;
    SessionModel session{node};
    PeopleModel people{session, kStation};

    explicit Seat(ParticipantId self) : node{self}
    {
        node.decide(fact::ParticipantJoined{{}, Role::Trainee, "Tess"});
        node.decide(fact::ObjectShared{{}, kTess, ObjectKind::Head, "Head"});
    }
    [[nodiscard]] ParticipantId worker() const { return node.state()->atWork(kStation); }
    [[nodiscard]] Angle turnOf(ParticipantId id) const
    {
        return node.state()->participants().at(id).turn;
    }
    [[nodiscard]] bool canBeGiven(ParticipantId id) const { return people.person(id)->canBeGiven; }
};

RigidTransform headAt(double x, double z) { return RigidTransform::translation({x, -0.3, z}); }

/// An instructor's seat with a history.
struct Console : Seat {
    ChangeHistory history;
    QSignalSpy refused{&history, &ChangeHistory::refused};

    Console() : Seat{FakeSessionNode::kInstructor} { people.setHistory(history); }
    void giveToTess() { people.giveWork(kTess); }
    void placeTess() { people.place(kTess, PatientSide::Left); }
    /// By another.
    void decideWork(ParticipantId to)
    {
        node.decide(fact::WorkTaken{to, worker()}, FakeSessionNode::kInstructor);
    }
    void decidePlace(double turn_deg)
    {
        node.decide(fact::PlaceChosen{kTess, degrees(turn_deg)}, FakeSessionNode::kInstructor);
    }
};

/// What is done, and what happens since.
struct Deed {
    const char* name;
    void (*make)(Console&);
    void (*since)(Console&);
    const char* told;
};
constexpr std::array kDeeds{
    Deed{"work, given back", [](Console& console) { console.giveToTess(); },
         [](Console& console) { console.decideWork(kTom); },
         "Nothing to undo: Tom is at work again."},
    Deed{"work, passed on", [](Console& console) { console.giveToTess(); },
         [](Console& console) { console.decideWork(FakeSessionNode::kInstructor); },
         "Not undone: Ina is at work now."},
    Deed{"work, who had it left", [](Console& console) { console.giveToTess(); },
         [](Console& console) { console.node.decide(fact::ParticipantLeft{kTom}); },
         "Not undone: Tom, who was at work, is not at the station any more."},
    Deed{"place, as before", [](Console& console) { console.placeTess(); },
         [](Console& console) { console.decidePlace(0.0); },
         "Nothing to undo: Tess is seen where they were again."},
    Deed{"place, another", [](Console& console) { console.placeTess(); },
         [](Console& console) { console.decidePlace(-90.0); },
         "Not undone: somebody has placed Tess elsewhere since."}};

} // namespace

class TestPeopleModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysWhoIsAtWork()
    {
        Seat console{FakeSessionNode::kInstructor};
        QCOMPARE(console.people.workText(), QStringLiteral("● At work: Tom"));
        const Seat own{kTom};
        QCOMPARE(own.people.workText(), QStringLiteral("● You are at work"));
        console.node.decide(fact::ParticipantLeft{kTom});
        QCOMPARE(console.people.workText(), QStringLiteral("○ Nobody is at work"));
        QVERIFY(!console.people.person(kTom));
    }

    /// Offered is what the host permits.
    void offersWhatTheHostPermits_data()
    {
        QTest::addColumn<int>("self");
        QTest::addColumn<bool>("isTomThere");
        QTest::newRow("instructor") << 1 << true;
        QTest::newRow("at work") << 2 << true;
        QTest::newRow("observer") << 3 << true;
        QTest::newRow("another trainee") << 4 << true;
        QTest::newRow("instructor, nobody at work") << 1 << false;
        QTest::newRow("observer, nobody at work") << 3 << false;
        QTest::newRow("another trainee, nobody at work") << 4 << false;
    }
    void offersWhatTheHostPermits()
    {
        QFETCH(int, self);
        QFETCH(bool, isTomThere);
        for (const int to : {1, 2, 3, 4}) {
            Seat seat{ParticipantId(std::uint16_t(self))};
            if (!isTomThere)
                seat.node.decide(fact::ParticipantLeft{kTom});
            const ParticipantId who{std::uint16_t(to)};
            const auto person = seat.people.person(who);
            const bool isOffered = person && person->canBeGiven;
            const ParticipantId before = seat.worker();
            seat.people.giveWork(who);
            QCOMPARE(seat.worker() == who && before != who, isOffered);
        }
    }

    void saysWhatIsInTheWay()
    {
        const auto work = [](const Seat& seat, ParticipantId id) {
            return seat.people.obstacleToWork(id);
        };
        Seat console{FakeSessionNode::kInstructor};
        QCOMPARE(work(console, kTess), QString{});
        QCOMPARE(work(console, kTom), QStringLiteral("Tom is at work already."));
        QCOMPARE(work(console, FakeSessionNode::kObserver),
                 QStringLiteral("Olga is an observer, who is not given work."));
        QCOMPARE(console.people.obstacleToPlace(kTess), QString{});
        QCOMPARE(console.people.obstacleToPlace(kTom),
                 QStringLiteral("Tom shares no head that could be placed."));
        QCOMPARE(work(Seat{FakeSessionNode::kObserver}, kTess),
                 QStringLiteral("Only an instructor, or who is at work, can give work to Tess."));
        QCOMPARE(Seat{kTom}.people.obstacleToPlace(kTess),
                 QStringLiteral("Only an instructor, or they themselves, can place Tess."));
        console.node.addStation("Room 5");
        console.node.decideAt(StationId{1}, fact::ParticipantMoved{kTess});
        QCOMPARE(work(console, kTess), QStringLiteral("Tess is at another station."));
        console.node.decide(fact::ParticipantLeft{kTess});
        QCOMPARE(work(console, kTess), QStringLiteral("Tess is not here any more."));
        QCOMPARE(console.people.obstacleToPlace(kTess), work(console, kTess));
    }

    void offersAPlaceToWhoMayChooseIt()
    {
        const auto canBePlaced = [](ParticipantId self, ParticipantId whom) {
            return Seat{self}.people.person(whom)->canBePlaced;
        };
        QVERIFY(canBePlaced(FakeSessionNode::kInstructor, kTess));
        QVERIFY(!canBePlaced(FakeSessionNode::kInstructor, kTom)); // shares no head
        QVERIFY(canBePlaced(kTess, kTess));
        QVERIFY(!canBePlaced(kTom, kTess));
        QVERIFY(!canBePlaced(FakeSessionNode::kObserver, kTess));
    }

    /// By quarter turns from where the head is: +x is the patient's left, +z the head end.
    void turnsAHeadToASide_data()
    {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("z");
        QTest::addColumn<int>("side");
        QTest::addColumn<double>("turn_deg");
        const auto row = [](const char* name, double x, double z, PatientSide side, double turn) {
            QTest::newRow(name) << x << z << int(side) << turn;
        };
        row("head to left", 0.1, 0.5, PatientSide::Left, 90.0);
        row("head to right", -0.1, 0.5, PatientSide::Right, -90.0);
        row("head to feet", 0.0, 0.5, PatientSide::Feet, 180.0);
        row("stays at the head", 0.1, 0.5, PatientSide::Head, 0.0);
        row("left to right", 0.6, 0.1, PatientSide::Right, 180.0);
        row("right to head", -0.6, 0.1, PatientSide::Head, 90.0);
        row("feet to left", 0.0, -0.9, PatientSide::Left, -90.0);
    }
    void turnsAHeadToASide()
    {
        QFETCH(double, x);
        QFETCH(double, z);
        QFETCH(int, side);
        QFETCH(double, turn_deg);
        constexpr double kNear_deg = 1e-9;
        const Angle turn = turnTo(PatientSide(side), headAt(x, z));
        QVERIFY(std::abs(inDegrees(turn) - turn_deg) < kNear_deg);
    }

    void placesAsTrackedAndByWhereTheHeadIs()
    {
        Seat console{FakeSessionNode::kInstructor};
        console.people.place(kTess, PatientSide::Left); // never seen: at the head end
        QCOMPARE(qRound(inDegrees(console.turnOf(kTess))), 90);
        QVERIFY(console.people.person(kTess)->isPlaced);
        console.people.place(kTess, std::nullopt);
        QCOMPARE(qRound(inDegrees(console.turnOf(kTess))), 0);
        QVERIFY(!console.people.person(kTess)->isPlaced);
        console.node.sees(ObjectId{2}, headAt(0.6, 0.0), *console.node.now());
        console.people.place(kTess, PatientSide::Head);
        QCOMPARE(qRound(inDegrees(console.turnOf(kTess))), -90);

        Seat own{kTess};
        PoseSample head;
        head.X_FO = headAt(-0.6, 0.0);
        own.people.place(kTess, PatientSide::Head, head);
        QCOMPARE(qRound(inDegrees(own.turnOf(kTess))), 90);
    }

    void givesWorkAndPlacesBack()
    {
        Console console;
        console.giveToTess();
        console.placeTess();
        console.people.place(kTess, std::nullopt);
        console.people.place(kTess, std::nullopt); // as it is
        QCOMPARE(console.history.texts(),
                 (QStringList{QStringLiteral("Tess → seen as tracked"),
                              QStringLiteral("Tess → seen at the patient's left"),
                              QStringLiteral("Work → Tess")}));
        console.history.undo();
        QCOMPARE(qRound(inDegrees(console.turnOf(kTess))), 90);
        console.history.undo();
        QCOMPARE(qRound(inDegrees(console.turnOf(kTess))), 0);
        QVERIFY(console.worker() == kTess);
        console.history.undo();
        QVERIFY(console.worker() == kTom);
        QVERIFY(console.refused.isEmpty() && !console.node.refusal());
    }

    /// Who got it may have gone, and the console may look at another station.
    void givesWorkBackWhereItWasGiven()
    {
        Console console;
        console.node.addStation("Room 5");
        console.decideWork(kTess); // who has no tube, so that it does not pass to her
        console.people.giveWork(kTom);
        console.people.setStation(StationId{1});
        console.node.decide(fact::ParticipantLeft{kTom});
        QVERIFY(console.worker() == kNobody);
        console.history.undo();
        QVERIFY(console.worker() == kTess);
        QVERIFY(console.refused.isEmpty());
    }

    /// No fact gives it back to nobody.
    void remembersNoWorkThatNobodyDid()
    {
        Console console;
        console.node.decide(fact::ParticipantLeft{kTom});
        console.giveToTess();
        QVERIFY(console.worker() == kTess);
        QVERIFY(console.history.isEmpty());
    }

    void takesBackWhatIsStillUnderWay()
    {
        Console console;
        console.node.hostGoesAway();
        console.giveToTess();
        console.placeTess();
        console.history.undo(2);
        QVERIFY(console.refused.isEmpty());
        console.node.hostComesBack();
        QVERIFY(console.worker() == kTom);
        QCOMPARE(qRound(inDegrees(console.turnOf(kTess))), 0);
        QVERIFY(!console.node.refusal());
    }

    void saysWhyItStays_data()
    {
        QTest::addColumn<int>("place");
        for (int place = 0; place < int(kDeeds.size()); ++place)
            QTest::newRow(kDeeds[std::size_t(place)].name) << place;
    }
    void saysWhyItStays()
    {
        QFETCH(const int, place);
        const Deed& deed = kDeeds[std::size_t(place)];
        Console console;
        deed.make(console);
        deed.since(console);
        QVERIFY(!console.node.refusal());
        const int proposed = console.node.proposed;
        console.history.undo();
        QCOMPARE(console.refused.size(), 1);
        QCOMPARE(console.refused.last().front().toString(), QString::fromUtf8(deed.told));
        QCOMPARE(console.node.proposed, proposed);
        QVERIFY(console.history.isEmpty());
    }
};

CARINA_TEST(TestPeopleModel)

} // namespace carina::people_model_test

#include "tst_people_model.moc"
