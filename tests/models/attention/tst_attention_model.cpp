#include "models/attention/attention_model.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

namespace carina::attention_model_test
{
namespace
{

using std::chrono::seconds;
using test::FakeSessionNode;

constexpr ParticipantId kTom = FakeSessionNode::kTrainee;
constexpr ParticipantId kOlga = FakeSessionNode::kObserver;
constexpr ObjectId kPatient = FakeSessionNode::kPatient;

struct Console {
    FakeSessionNode node;
    SessionModel session{node};
    AttentionModel model{session};

    /// Everybody is here, and the patient is this instructor's.
    Console()
    {
        everybodyIsHere();
        node.sharePatient(FakeSessionNode::kInstructor);
        look();
    }
    void everybodyIsHere()
    {
        node.linkReports = {{kTom, LinkState::Connected, {}, {}, {}},
                            {kOlga, LinkState::Connected, {}, {}, {}}};
    }
    void look()
    {
        QCoreApplication::sendPostedEvents();
        model.look();
    }
    void asks(ParticipantId who, bool wants = true)
    {
        node.decide(fact::ObjectWanted{kPatient, wants}, who);
        look();
    }
    void sets(const LungConditions& conditions)
    {
        node.decide(fact::LungConditionsSet{conditions});
        look();
    }
    void notes(IntubationStep step, TubeSeat seat, double confidence)
    {
        node.decide(fact::IntubationNoted{
            {.step = step, .at = *node.now(), .seat = seat, .confidence = confidence}, {}});
        node.advance(seconds{1});
        look();
    }
    void tubeIsSeen(bool seen)
    {
        node.advance(std::chrono::milliseconds{50});
        StreamCpo cpo;
        cpo.object = FakeSessionNode::kTube;
        cpo.time = *node.now();
        cpo.validity = seen ? StreamValidity::Tracked : StreamValidity::Lost;
        node.takes(cpo);
    }
    [[nodiscard]] QStringList texts() const
    {
        QStringList all;
        for (const Attention& each : model.all())
            all += each.text;
        return all;
    }
    [[nodiscard]] QStringList actions() const
    {
        QStringList all;
        for (const Attention& each : model.all())
            all += each.action;
        return all;
    }
};

} // namespace

class TestAttentionModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysNothingWhereNothingNeedsIt()
    {
        Console console;
        QCOMPARE(console.texts(), QStringList{});
    }

    void givesThePatientToWhoAsksForIt()
    {
        Console console;
        console.asks(kTom);
        QCOMPARE(console.texts(), QStringList{QStringLiteral("Tom asks for Adult")});
        QCOMPARE(console.actions(), QStringList{QStringLiteral("Give")});
        const Attention asked = console.model.all().front();
        console.model.act(asked);
        QVERIFY(console.node.state()->objects().at(kPatient).owner == kTom);
        QCOMPARE(console.texts(), QStringList{});
        const int before = console.node.proposed;
        console.model.act(asked); // pressed twice
        QCOMPARE(console.node.proposed, before);
    }

    void givingIsAChangeThatIsTakenBack()
    {
        Console console;
        ChangeHistory history;
        console.model.setHistory(history);
        console.asks(kTom);
        console.model.act(console.model.all().front());
        QCOMPARE(history.texts(), QStringList{QStringLiteral("Adult → given to Tom")});
        history.undo();
        QVERIFY(console.node.state()->objects().at(kPatient).owner == FakeSessionNode::kInstructor);
        QVERIFY(history.isEmpty());
    }

    void doesNotOfferWhatIsBeingGiven()
    {
        Console console;
        console.asks(kTom);
        console.node.hostGoesAway();
        console.model.act(console.model.all().front());
        QCOMPARE(console.texts(), QStringList{});
    }

    void forgetsARequestThatIsWithdrawn()
    {
        Console console;
        console.asks(kTom);
        console.asks(kTom, false);
        QCOMPARE(console.texts(), QStringList{});
    }

    void asksWhereATubeIsWhoseWayNothingTells()
    {
        Console console;
        const QSignalSpy shown{&console.model, &AttentionModel::showWanted};
        console.notes(IntubationStep::ThroughCords, TubeSeat::Trachea, 0.5);
        QCOMPARE(console.texts(), QStringList{});
        console.notes(IntubationStep::CuffInflated, TubeSeat::Trachea, 0.25);
        QCOMPARE(console.texts(),
                 QStringList{QStringLiteral("Tube in the trachea? (25\u00a0% sure): if you see "
                                            "where it is, set it")});
        console.notes(IntubationStep::BladeOut, TubeSeat::Trachea, 1.0);
        QCOMPARE(console.texts().size(), 1); // it is as sure of the blade
        console.notes(IntubationStep::ShapesApart, TubeSeat::Trachea, 1.0);
        QCOMPARE(console.texts().size(), 1); // and of the shapes
        console.model.act(console.model.all().front());
        QCOMPARE(shown.count(), 1);
        console.node.decide(fact::TubePlaced{{TubeSeat::Oesophagus, millimetres(6.5)}});
        console.node.advance(seconds{1});
        console.look();
        QCOMPARE(console.texts(), QStringList{});
        console.node.decide(fact::TubePlaced{});
        console.node.advance(seconds{1});
        console.look();
        QCOMPARE(console.texts().size(), 1);
        console.notes(IntubationStep::TubeOut, TubeSeat::None, 0.25);
        QCOMPARE(console.texts(), QStringList{});
    }

    void tellsATubeThatIsNotInTheTrachea()
    {
        Console console;
        console.notes(IntubationStep::InOesophagus, TubeSeat::Oesophagus, 0.99);
        QCOMPARE(console.texts(), QStringList{QStringLiteral("Tube in the oesophagus")});
        console.notes(IntubationStep::CuffInflated, TubeSeat::Oesophagus, 0.6);
        QCOMPARE(console.texts(),
                 QStringList{QStringLiteral("Tube in the oesophagus (60\u00a0% sure)")});
        console.notes(IntubationStep::OutOfOesophagus, TubeSeat::None, 1.0);
        QCOMPARE(console.texts(), QStringList{});
        console.notes(IntubationStep::PastCarina, TubeSeat::RightMain, 0.9);
        QCOMPARE(console.texts(), QStringList{QStringLiteral("Tube in the right main bronchus")});
        console.notes(IntubationStep::BackAboveCarina, TubeSeat::Trachea, 0.9);
        QCOMPARE(console.texts(), QStringList{});
    }

    void saysWhoIsAwayAndWhereThatIsSeen()
    {
        Console console;
        console.node.linkReports[0].state = LinkState::Away;
        console.look();
        QCOMPARE(console.texts(),
                 QStringList{QStringLiteral("Tom is away: their program is not heard of")});
        const QSignalSpy shown{&console.model, &AttentionModel::showWanted};
        console.model.act(console.model.all().front());
        QCOMPARE(shown.size(), 1);
        QVERIFY(qvariant_cast<Attention>(shown[0][0]).participant == kTom);
        console.node.decide(fact::ParticipantLeft{kTom});
        console.look();
        QCOMPARE(console.texts(), QStringList{}); // gone is not away
    }

    /// Whoever comes in under many names and falls silent does not bury everything else.
    void tellsOfManyWhoFellSilentByTheirNumber()
    {
        Console console;
        const auto comesAndFallsSilent = [&console](const std::string& name) {
            console.node.decide(fact::ParticipantJoined{{}, Role::Trainee, name});
            const auto state = console.node.state();
            for (const auto& [id, who] : state->participants())
                if (who.name == name)
                    return console.node.decide(fact::ParticipantFellSilent{id});
        };
        for (const char* name : {"Ada", "Bea", "Cleo"})
            comesAndFallsSilent(name);
        console.look();
        QCOMPARE(console.texts().size(), 3);
        comesAndFallsSilent("Dora");
        console.look();
        QCOMPARE(console.texts(), QStringList{QStringLiteral(
                                      "4 participants are away: their programs are not heard of")});
        console.model.act(console.model.all().front());
        QCOMPARE(console.texts(), QStringList{});
        comesAndFallsSilent("Eva");
        console.look();
        QCOMPARE(console.texts(),
                 QStringList{QStringLiteral("Eva is away: their program is not heard of")});
    }

    /// The host ends the path of a program that was killed or stopped, and says so by a fact.
    void saysWhoFellSilentUntilTheyAreBackOrDismissed()
    {
        Console console;
        const QStringList away{QStringLiteral("Tom is away: their program is not heard of")};
        const auto fallsSilent = [&] {
            console.node.linkReports = {{kOlga, LinkState::Connected, {}, {}, {}}};
            console.node.decide(fact::ParticipantFellSilent{kTom});
            console.look();
        };
        const auto comesBack = [&] {
            console.everybodyIsHere();
            console.node.decide(fact::ParticipantJoined{{}, Role::Trainee, "Tom"});
            console.look();
        };
        fallsSilent();
        QCOMPARE(console.texts(), away);
        QCOMPARE(console.actions(), QStringList{QStringLiteral("Dismiss")});
        console.node.advance(std::chrono::hours{1});
        console.look();
        QCOMPARE(console.texts(), away);
        comesBack();
        QCOMPARE(console.texts(), QStringList{});
        fallsSilent();
        QCOMPARE(console.texts(), away);
        console.model.act(console.model.all().front());
        QCOMPARE(console.texts(), QStringList{}); // dismissed
        console.node.advance(seconds{5});
        comesBack();
        fallsSilent();
        QCOMPARE(console.texts(), away); // another time
        console.node.decide(fact::ParticipantRemoved{kTom, false, {}},
                            FakeSessionNode::kInstructor);
        console.look();
        QCOMPARE(console.texts(), QStringList{}); // nobody waits for them
        comesBack();
        console.node.decide(fact::ParticipantRemoved{kTom, true, {}}, FakeSessionNode::kInstructor);
        console.look();
        QCOMPARE(console.texts(), QStringList{}); // banned
    }

    /// Those who were there before a session was resumed have left: the host says no more of them.
    void nobodyIsAwayWhoWasThereBeforeTheSessionWasResumed()
    {
        Console console;
        console.node.linkReports = {};
        for (const ParticipantId who : {kTom, kOlga})
            console.node.decide(fact::ParticipantLeft{who});
        console.look();
        QCOMPARE(console.texts(), QStringList{});
    }

    /// Because the console stopped and is here again.
    void saysWhatIsNoLongerShown()
    {
        Console console;
        const auto comesInAnew = [&] {
            console.node.decide(fact::ParticipantJoined{{}, Role::Instructor, "Ina"});
            console.look();
        };
        const auto show = [&](ParticipantId to) {
            console.node.decide(
                fact::LessonShown{to, {{true, LessonCut::All, {0.0, 1.0, 0.0}, 0.1}, true, {}}},
                FakeSessionNode::kInstructor);
            console.look();
        };
        comesInAnew();
        QCOMPARE(console.texts(), QStringList{}); // nothing was
        show(kNobody);
        QCOMPARE(console.texts(), QStringList{});
        comesInAnew();
        QCOMPARE(console.texts(),
                 QStringList{QStringLiteral(
                     "Shown to everybody until this program stopped: section, view")});
        QCOMPARE(console.actions(), QStringList{QStringLiteral("Show again")});
        const QSignalSpy shown{&console.model, &AttentionModel::showWanted};
        console.model.act(console.model.all().front());
        QCOMPARE(shown.size(), 1);
        show(kTom);
        QCOMPARE(console.texts(), QStringList{});
        comesInAnew();
        QCOMPARE(console.texts().size(), 1);
        QVERIFY(console.texts().front().startsWith(QStringLiteral("Shown to Tom until ")));
        console.node.advance(AttentionModel::kBrokenOffTold);
        console.look();
        QCOMPARE(console.texts(), QStringList{});
    }

    /// Until it breaks off once more.
    void saysNoMoreOfWhatIsNotToBeShownAgain()
    {
        Console console;
        const auto comesInAnew = [&] {
            console.node.advance(seconds{1});
            console.node.decide(fact::ParticipantJoined{{}, Role::Instructor, "Ina"});
            console.look();
        };
        const auto show = [&] {
            console.node.decide(
                fact::LessonShown{kNobody,
                                  {{true, LessonCut::All, {0.0, 1.0, 0.0}, 0.1}, true, {}}},
                FakeSessionNode::kInstructor);
            console.look();
        };
        show();
        comesInAnew();
        QCOMPARE(console.texts().size(), 1);
        const Attention brokenOff = console.model.all().front();
        QVERIFY(brokenOff.canBeDismissed);
        const int before = console.node.proposed;
        console.model.dismiss(brokenOff);
        QCOMPARE(console.texts(), QStringList{});
        console.node.advance(seconds{1});
        console.look();
        QCOMPARE(console.texts(), QStringList{});
        QCOMPARE(console.node.proposed, before); // for others nothing is changed
        show();
        comesInAnew();
        QCOMPARE(console.texts().size(), 1);
        console.asks(kTom);
        QVERIFY(!console.model.all().front().canBeDismissed);
        console.model.dismiss(console.model.all().front());
        QCOMPARE(console.texts().size(), 2);
    }

    void saysWhichToolIsOutOfViewOnceItStaysSo()
    {
        Console console;
        console.tubeIsSeen(true);
        console.look();
        console.tubeIsSeen(false);
        console.look();
        QCOMPARE(console.texts(), QStringList{}); // a hand passes
        console.node.advance(AttentionModel::kUnseenTold);
        console.tubeIsSeen(false);
        console.look();
        QCOMPARE(console.texts(),
                 QStringList{QStringLiteral("Out of the view of Tom's tracker: tube")});
        console.tubeIsSeen(true);
        console.look();
        QCOMPARE(console.texts(), QStringList{});
    }

    /// And nothing of tools meanwhile: none is seen.
    void saysWhatKeepsTheOwnTrackerFromTracking()
    {
        Console console;
        std::optional<TrackerSight> sight;
        console.model.setTracker([&] { return sight; });
        QCOMPARE(console.texts(), QStringList{});
        sight = TrackerSight{.trouble = QStringLiteral("/dev/ttyUSB0:\nthere is no such port"),
                             .tools = {{.name = QStringLiteral("Tube"), .age_s = 60.0}}};
        console.look();
        QCOMPARE(console.texts(),
                 QStringList{QStringLiteral("/dev/ttyUSB0: there is no such port")});
        QCOMPARE(console.actions(), QStringList{QStringLiteral("Connect")});
        const QSignalSpy shown{&console.model, &AttentionModel::showWanted};
        console.model.act(console.model.all().front());
        QCOMPARE(shown.size(), 1);
        sight.reset();
        console.look();
        QCOMPARE(console.texts(), QStringList{});
    }

    void saysWhichOwnToolIsOutOfViewOnceItStaysSo()
    {
        Console console;
        const double told = toSeconds(AttentionModel::kUnseenTold);
        TrackerSight sight{
            .tools = {{.name = QStringLiteral("Tube"), .age_s = 0.5 * told},
                      {.name = QStringLiteral("Headset"), .age_s = told},
                      {.name = QStringLiteral("Stylus")}, // never seen
                      {.name = QStringLiteral("Hand probe"), .isVisible = true, .age_s = told}}};
        console.model.setTracker([&] { return std::optional{sight}; });
        QCOMPARE(console.texts(),
                 QStringList{QStringLiteral("Out of the view of your tracker: headset")});
        QVERIFY(console.model.all().front().participant == FakeSessionNode::kInstructor);
    }

    /// Without a tracker it says nothing of what was stated with one.
    void saysWhetherTheOwnRegistrationCanBeReliedOn()
    {
        Console console;
        console.node.decide(fact::RegistrationStated{{RegistrationState::Missing, {}, {}}},
                            FakeSessionNode::kInstructor);
        console.look();
        QCOMPARE(console.texts(), QStringList{});
        console.model.setTracker([] { return std::optional{TrackerSight{}}; });
        QCOMPARE(console.texts().size(), 1);
        QVERIFY(console.texts().front().startsWith(QStringLiteral("Ina: ")));
    }

    void saysWhatDevelops()
    {
        Console console;
        console.node.decide(fact::PhaseChanged{SessionPhase::Running});
        console.sets({{ConditionKind::TensionPneumothorax, 0.9, ConditionSide::Right}});
        console.node.advance(seconds{5});
        console.look();
        QCOMPARE(console.texts().size(), 1);
        const QString begun =
            QStringLiteral("Pneumothorax, tension, right lung: developing, lung ");
        QString text = console.texts().front();
        QVERIFY2(text.startsWith(begun) && text.contains(QStringLiteral("\u00a0% closed")),
                 qPrintable(text));
        QVERIFY2(!text.contains(QStringLiteral(" 0\u00a0mm")), qPrintable(text));
        console.node.advance(seconds{55});
        console.look();
        QCOMPARE(console.texts().size(), 1);
        text = console.texts().front();
        // A twentieth stays open, and breathes: the figures of a breath have some ml of that side.
        QVERIFY2(text.startsWith(QStringLiteral("Pneumothorax, tension, right lung: lung closed "
                                                "but for the last 5\u00a0%, gas still comes in, "
                                                "mediastinum ")),
                 qPrintable(text));
        QVERIFY2(text.endsWith(QStringLiteral("\u00a0mm aside")), qPrintable(text));
        console.sets({});
        console.node.advance(seconds{2});
        console.look();
        QCOMPARE(console.texts(), QStringList{});
    }

    void saysHowFarALungIsEmptied()
    {
        Console console;
        console.node.decide(fact::PhaseChanged{SessionPhase::Running});
        console.sets({{ConditionKind::MainstemIntubation, 1.0, ConditionSide::Right}});
        console.node.advance(seconds{5});
        console.look();
        QCOMPARE(console.texts().size(), 1);
        QVERIFY2(console.texts().front().endsWith(QStringLiteral("\u00a0%")),
                 qPrintable(console.texts().front()));
    }

    void saysThatBreathingIsStopping()
    {
        Console console;
        console.node.decide(fact::PhaseChanged{SessionPhase::Running});
        console.node.decide(fact::BreathingStopped{true, seconds{10}});
        console.node.advance(seconds{5});
        console.look();
        QCOMPARE(console.texts().size(), 1);
        QVERIFY(console.texts().front().startsWith(QStringLiteral("Breathing is stopping: ")));
        console.node.advance(seconds{10});
        console.look();
        QCOMPARE(console.texts(), QStringList{});
    }

    void saysWhoseRegistrationCannotBeReliedOn_data();
    void saysWhoseRegistrationCannotBeReliedOn()
    {
        QFETCH(const RegistrationStanding, standing);
        QFETCH(const QString, doubt);
        Console console;
        console.node.decide(fact::RegistrationStated{standing}, kTom);
        console.look();
        QCOMPARE(console.texts().size(), doubt.isEmpty() ? 0 : 1);
        if (doubt.isEmpty())
            return;
        const QString text = console.texts().front();
        QVERIFY2(text.startsWith(QStringLiteral("Tom: ")) && text.contains(doubt),
                 qPrintable(text));
    }

    void forgetsTheDoubtWithTheTracker()
    {
        Console console;
        console.node.decide(fact::RegistrationStated{{RegistrationState::NotGood, {}, {}}}, kTom);
        console.look();
        QCOMPARE(console.texts().size(), 1);
        console.node.decide(fact::RegistrationStated{{RegistrationState::NoTracker, {}, {}}}, kTom);
        console.look();
        QCOMPARE(console.texts(), QStringList{});
    }

    void namesWhoseClockContradictsThePath()
    {
        Console console;
        console.node.pathReports = {
            {.peer = kTom, .external = ExternalVerdict{seconds{2}, std::chrono::milliseconds{1}}},
            {.peer = kOlga}};
        console.look();
        QCOMPARE(console.texts(), QStringList{});
        console.node.pathReports[0].external->isRefused = true;
        console.look();
        QCOMPARE(console.texts().size(), 1);
        QVERIFY(console.texts().front().contains(QStringLiteral("clock of Tom's computer")));
        QVERIFY(console.model.all().front().participant == kTom);
    }

    void tellsOfAReplacedTokenForAMinute()
    {
        Console console;
        console.node.decide(fact::TokenReplaced{kTom});
        console.look();
        QCOMPARE(console.texts().size(), 1);
        QVERIFY(console.texts().front().contains(QStringLiteral("token of Tom")));
        console.node.advance(AttentionModel::kReplacedTold);
        console.look();
        QCOMPARE(console.texts(), QStringList{});
    }

    void showsARefusalUntilItIsRead()
    {
        Console console;
        console.node.isRefused({Errc::OutOfRange, "9999 ml"});
        console.look();
        QCOMPARE(console.actions(), QStringList{QStringLiteral("Dismiss")});
        console.model.act(console.model.all().front());
        QCOMPARE(console.texts(), QStringList{});
        console.node.isRefused({Errc::OutOfRange, "8888 ml"}); // another one
        console.look();
        QCOMPARE(console.texts().size(), 1);
    }

    void putsTheMostUrgentFirst()
    {
        Console console;
        console.node.decide(fact::PhaseChanged{SessionPhase::Running});
        console.node.decide(fact::RegistrationStated{{RegistrationState::NotGood, {}, {}}}, kTom);
        console.sets({{ConditionKind::TensionPneumothorax, 0.9, ConditionSide::Left}});
        console.tubeIsSeen(false);
        console.look();
        console.node.advance(seconds{3});
        console.tubeIsSeen(false);
        console.node.linkReports[1].state = LinkState::Away;
        console.asks(kTom);
        std::vector<Concern> concerns;
        for (const Attention& each : console.model.all())
            concerns.push_back(each.concern);
        QCOMPARE(concerns, (std::vector{Concern::Asked, Concern::Away, Concern::Unseen,
                                        Concern::Registration, Concern::Developing}));
    }

    void namesTheStationWhereThereAreSeveral()
    {
        Console console;
        console.node.addStation("Room 5");
        console.asks(kTom);
        QCOMPARE(console.texts(), QStringList{QStringLiteral("Station 1: Tom asks for Adult")});
    }

    void saysNothingOnceTheSessionHasEnded()
    {
        Console console;
        console.asks(kTom);
        console.node.decide(fact::PhaseChanged{SessionPhase::Running});
        console.node.decide(fact::PhaseChanged{SessionPhase::Ended});
        console.node.advance(seconds{1});
        console.look();
        QCOMPARE(console.texts(), QStringList{});
    }
};

void TestAttentionModel::saysWhoseRegistrationCannotBeReliedOn_data()
{
    QTest::addColumn<RegistrationStanding>("standing");
    QTest::addColumn<QString>("doubt"); // empty: none
    const auto row = [](const char* name, const RegistrationStanding& standing, const char* doubt) {
        QTest::newRow(name) << standing << QString::fromUtf8(doubt);
    };
    using State = RegistrationState;
    using Why = StaleReason;
    row("good", {State::Good, Why::None, millimetres(1.4)}, "");
    row("simulated", {State::Simulated, Why::None, {}}, "");
    row("no tracker", {State::NoTracker, Why::None, {}}, "");
    row("missing", {State::Missing, Why::None, {}}, "not registered");
    row("unverified", {State::Unverified, Why::Fit, millimetres(2.0)}, "not verified");
    row("not good", {State::NotGood, Why::None, millimetres(4.2)}, "judged not good, 4.2\u00a0mm");
    row("stylus", {State::Stale, Why::Stylus, {}}, "stylus");
    row("landmarks", {State::Stale, Why::Landmarks, {}}, "landmarks were changed");
    row("touches", {State::Stale, Why::Touches, {}}, "touched again");
    row("tracker", {State::Stale, Why::Tracker, {}}, "one of its devices");
    row("patient", {State::Stale, Why::Patient, {}}, "another patient");
    row("manikin", {State::Stale, Why::Manikin, {}}, "was moved");
    row("registering", {State::Stale, Why::Registering, {}}, "being registered");
    row("age", {State::Stale, Why::Age, {}}, "30 days");
    row("drift", {State::Stale, Why::Drift, millimetres(8.0)}, "moved by about 8\u00a0mm");
}

CARINA_TEST(TestAttentionModel)

} // namespace carina::attention_model_test

#include "tst_attention_model.moc"
