#include "models/session/conduct_model.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

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
    void knowsWhichReasonsFit();
};

namespace
{

struct Desk {
    FakeSessionNode node;
    SessionModel session{node};
    ConductModel model{session};

    [[nodiscard]] Participant tom() const
    {
        return node.state()->participants().at(FakeSessionNode::kTrainee);
    }
    [[nodiscard]] ConductModel::Standing standingOfTom() const
    {
        return model.standingOf(FakeSessionNode::kTrainee);
    }
};

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
    ChangeHistory history;
    desk.model.setHistory(history);
    desk.model.setMuted(FakeSessionNode::kTrainee, true);
    desk.model.setLocked(true);
    QCOMPARE(history.texts(),
             (QStringList{QStringLiteral("Session → locked"), QStringLiteral("Tom → muted")}));
    history.undo(2);
    QVERIFY(!desk.model.isLocked());
    QVERIFY(!desk.tom().muted);
    desk.model.setLocked(true);
    desk.node.decide(fact::SessionLocked{false}); // by another
    const int proposed = desk.node.proposed;
    history.undo();
    QCOMPARE(desk.node.proposed, proposed);
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
