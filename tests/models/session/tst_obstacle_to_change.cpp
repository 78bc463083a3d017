#include "models/session/obstacle_to_change.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

namespace carina::obstacle_to_change_test
{

using test::FakeSessionNode;

class TestObstacleToChange : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void dependsOnTheRole_data();
    void dependsOnTheRole();
    void isTheEndOfTheSession_data();
    void isTheEndOfTheSession();
    void toTheTubeDependsOnRoleAndStation();
};

namespace
{

constexpr std::chrono::milliseconds kLead{100}; ///< until a change takes effect

void enter(FakeSessionNode& node, SessionPhase phase)
{
    node.decide(fact::PhaseChanged{phase});
    node.advance(kLead);
}

} // namespace

void TestObstacleToChange::dependsOnTheRole_data()
{
    QTest::addColumn<ParticipantId>("self");
    QTest::addColumn<QString>("obstacle");
    const QString others = QStringLiteral("Only an instructor changes the patient.");
    QTest::newRow("instructor") << FakeSessionNode::kInstructor << QString{};
    QTest::newRow("trainee") << FakeSessionNode::kTrainee << others;
    QTest::newRow("observer") << FakeSessionNode::kObserver << others;
    QTest::newRow("nobody yet") << kNobody
                                << QStringLiteral("Wait until the session has let you in.");
}

/// Before it starts, while it runs and in a pause.
void TestObstacleToChange::dependsOnTheRole()
{
    QFETCH(ParticipantId, self);
    QFETCH(QString, obstacle);
    FakeSessionNode node{self};
    const SessionModel session{node};
    QCOMPARE(obstacleToChange(session), obstacle);
    for (const SessionPhase phase : {SessionPhase::Running, SessionPhase::Paused}) {
        enter(node, phase);
        QCOMPARE(obstacleToChange(session), obstacle);
    }
}

void TestObstacleToChange::isTheEndOfTheSession_data()
{
    QTest::addColumn<ParticipantId>("self");
    QTest::newRow("instructor") << FakeSessionNode::kInstructor;
    QTest::newRow("trainee") << FakeSessionNode::kTrainee;
}

void TestObstacleToChange::isTheEndOfTheSession()
{
    QFETCH(ParticipantId, self);
    FakeSessionNode node{self};
    const SessionModel session{node};
    enter(node, SessionPhase::Running);
    enter(node, SessionPhase::Ended);
    QCOMPARE(obstacleToChange(session), QStringLiteral("The session has ended."));
}

void TestObstacleToChange::toTheTubeDependsOnRoleAndStation()
{
    constexpr StationId kElsewhere{1};
    const auto obstacleOf = [](ParticipantId self, StationId station, bool isMuted = false) {
        FakeSessionNode node{self};
        node.addStation("Station 2");
        if (isMuted)
            node.decide(fact::ParticipantMuted{self, true});
        const SessionModel session{node};
        return obstacleToTube(session, station);
    };
    const StationId here = FakeSessionNode::kStation;
    QVERIFY(obstacleOf(FakeSessionNode::kTrainee, here).isEmpty());
    QVERIFY(obstacleOf(FakeSessionNode::kTrainee, here, true)
                .contains(QStringLiteral("muted"), Qt::CaseInsensitive));
    QCOMPARE(obstacleOf(FakeSessionNode::kTrainee, kElsewhere),
             QStringLiteral("You are at another station."));
    QVERIFY(obstacleOf(FakeSessionNode::kInstructor, kElsewhere).isEmpty());
    QCOMPARE(obstacleOf(FakeSessionNode::kObserver, here),
             QStringLiteral("Observers watch; trainees handle the tube."));
    QCOMPARE(obstacleOf(kNobody, here), QStringLiteral("Wait until the session has let you in."));
}

CARINA_TEST(TestObstacleToChange)

} // namespace carina::obstacle_to_change_test

#include "tst_obstacle_to_change.moc"
