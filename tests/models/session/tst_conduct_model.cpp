#include "models/session/conduct_model.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

#include <array>

namespace carina::conduct_model_test
{

using test::FakeSessionNode;

class TestConductModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void decidesAboutOthersOnly();
    void mutesAndTakesItBack();
    void removesAndTakesABanBack();
    void locksAndUnlocks();
    void isTakenBackUnlessSomebodyDecidedSince();
    void saysWhyItStays_data();
    void saysWhyItStays();
    void mutesNotTheLastInstructorByUndo();
    void takesBackWhatIsStillUnderWay();
    void knowsWhichReasonsFit();
};

namespace
{

struct Desk {
    FakeSessionNode node;
    SessionModel session{node};
    ConductModel model{session};
    ChangeHistory history;
    QSignalSpy refused{&history, &ChangeHistory::refused};

    Desk() { model.setHistory(history); }
    /// Why the last change stayed.
    [[nodiscard]] QString reason() const
    {
        return refused.isEmpty() ? QString{} : refused.last().front().toString();
    }
    void mute(bool muted) { model.setMuted(FakeSessionNode::kTrainee, muted); }
    /// By another.
    void decideMute(bool muted)
    {
        node.decide(fact::ParticipantMuted{FakeSessionNode::kTrainee, muted});
    }
    [[nodiscard]] Participant tom() const
    {
        return node.state()->participants().at(FakeSessionNode::kTrainee);
    }
    [[nodiscard]] ConductModel::Standing standingOfTom() const
    {
        return model.standingOf(FakeSessionNode::kTrainee);
    }
};

/// What is done, and what somebody decides since.
struct Decided {
    const char* name;
    void (*make)(Desk&);
    void (*since)(Desk&);
    const char* told;
};
constexpr std::array kDecided{
    Decided{"muted", [](Desk& desk) { desk.mute(true); },
            [](Desk& desk) { desk.decideMute(false); },
            "Nothing to undo: Tom is not muted any more."},
    Decided{"not muted",
            [](Desk& desk) {
                desk.decideMute(true);
                desk.mute(false);
            },
            [](Desk& desk) { desk.decideMute(true); }, "Nothing to undo: Tom is muted again."},
    Decided{"locked", [](Desk& desk) { desk.model.setLocked(true); },
            [](Desk& desk) { desk.node.decide(fact::SessionLocked{false}); },
            "Nothing to undo: the session is not locked any more."},
    Decided{"unlocked",
            [](Desk& desk) {
                desk.node.decide(fact::SessionLocked{true});
                desk.model.setLocked(false);
            },
            [](Desk& desk) { desk.node.decide(fact::SessionLocked{true}); },
            "Nothing to undo: the session is locked again."}};

} // namespace

void TestConductModel::decidesAboutOthersOnly()
{
    Desk desk;
    desk.node.decide(fact::ParticipantJoined{FakeSessionNode::kHost, Role::Instructor, "Dr. Hall"});
    for (const ParticipantId needed :
         {FakeSessionNode::kHost, FakeSessionNode::kInstructor, ParticipantId{42}}) {
        const auto standing = desk.model.standingOf(needed);
        QVERIFY(!standing.canMute && !standing.canRemove && !standing.isBanned);
    }
    const auto tom = desk.standingOfTom();
    QVERIFY(tom.canMute && tom.canRemove);
    QCOMPARE(tom.name, QStringLiteral("Tom"));
}

void TestConductModel::mutesAndTakesItBack()
{
    Desk desk;
    QSignalSpy changes{&desk.model, &ConductModel::changed};
    desk.model.setMuted(FakeSessionNode::kTrainee, true);
    QCoreApplication::sendPostedEvents();
    QCOMPARE(changes.count(), 1);
    QVERIFY(desk.tom().muted && desk.standingOfTom().isMuted);
    desk.node.decide(fact::ParticipantLeft{FakeSessionNode::kTrainee});
    QVERIFY(desk.standingOfTom().canMute); // or nobody could take it back
    desk.model.setMuted(FakeSessionNode::kTrainee, false);
    QVERIFY(!desk.tom().muted);
    QVERIFY(!desk.standingOfTom().canMute);
}

void TestConductModel::removesAndTakesABanBack()
{
    Desk desk;
    desk.model.remove(FakeSessionNode::kTrainee, QStringLiteral("zu laut – später"), false);
    QVERIFY(!desk.tom().present && !desk.tom().removal->banned);
    QCOMPARE(QString::fromStdString(desk.tom().removal->reason),
             QStringLiteral("zu laut – später"));
    QVERIFY(desk.standingOfTom().canRemove); // for good, now
    desk.model.remove(FakeSessionNode::kTrainee, {}, true);
    QVERIFY(desk.standingOfTom().isBanned && !desk.standingOfTom().canRemove);
    desk.model.letBack(FakeSessionNode::kTrainee);
    QVERIFY(!desk.standingOfTom().isBanned);
}

void TestConductModel::locksAndUnlocks()
{
    Desk desk;
    QVERIFY(!desk.model.isLocked());
    desk.model.setLocked(true);
    QVERIFY(desk.model.isLocked());
    desk.model.setLocked(false);
    QVERIFY(!desk.model.isLocked());
    desk.model.changeCode(Role::Observer);
    QVERIFY(!desk.node.refusal());
}

void TestConductModel::isTakenBackUnlessSomebodyDecidedSince()
{
    Desk desk;
    desk.mute(true);
    desk.model.setLocked(true);
    QCOMPARE(desk.history.texts(),
             (QStringList{QStringLiteral("Session → locked"), QStringLiteral("Tom → muted")}));
    desk.history.undo(2);
    QVERIFY(!desk.model.isLocked());
    QVERIFY(!desk.tom().muted);
    QVERIFY(desk.refused.isEmpty());
}

void TestConductModel::saysWhyItStays_data()
{
    QTest::addColumn<int>("place");
    for (int place = 0; place < int(kDecided.size()); ++place)
        QTest::newRow(kDecided[std::size_t(place)].name) << place;
}

void TestConductModel::saysWhyItStays()
{
    QFETCH(const int, place);
    const Decided& decided = kDecided[std::size_t(place)];
    Desk desk;
    decided.make(desk);
    decided.since(desk);
    const int proposed = desk.node.proposed;
    desk.history.undo();
    QCOMPARE(desk.reason(), QString::fromUtf8(decided.told));
    QCOMPARE(desk.node.proposed, proposed);
    QVERIFY(desk.history.isEmpty()); // the next undo is about the change before
}

void TestConductModel::mutesNotTheLastInstructorByUndo()
{
    constexpr ParticipantId kIvo{4};
    Desk desk;
    desk.node.decide(fact::ParticipantJoined{{}, Role::Instructor, "Ivo"});
    desk.model.setMuted(kIvo, true);
    desk.model.setMuted(kIvo, false);
    desk.node.decide(fact::ParticipantMuted{FakeSessionNode::kInstructor, true});
    QVERIFY(!desk.node.refusal());
    const int proposed = desk.node.proposed;
    desk.history.undo();
    QCOMPARE(desk.reason(), QStringLiteral("Not undone: nobody but Ivo instructs now."));
    QCOMPARE(desk.node.proposed, proposed);
}

void TestConductModel::takesBackWhatIsStillUnderWay()
{
    Desk desk;
    desk.node.hostGoesAway();
    desk.mute(true);
    desk.model.setLocked(true);
    desk.history.undo(2);
    QVERIFY(desk.refused.isEmpty());
    desk.node.hostComesBack();
    QVERIFY(!desk.tom().muted);
    QVERIFY(!desk.model.isLocked());
    QVERIFY(!desk.node.refusal());
}

void TestConductModel::knowsWhichReasonsFit()
{
    QVERIFY(ConductModel::isShortEnough(QString(64, QLatin1Char('x'))));
    QVERIFY(!ConductModel::isShortEnough(QString(65, QLatin1Char('x'))));
    QVERIFY(!ConductModel::isShortEnough(QString(33, QChar{0xe4}))); // two bytes each
}

CARINA_TEST(TestConductModel)

} // namespace carina::conduct_model_test

#include "tst_conduct_model.moc"
