#include "models/session/session_plan.h"
#include "models/session/session_summary.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <set>

namespace carina::session_plan_test
{
namespace
{

using test::FakeSessionNode;

const QString kFile = QStringLiteral("session.sqlite");

SessionPlan complete()
{
    return {.name = QStringLiteral("Ward 3"), .patient = QStringLiteral("adult")};
}

QString leaving(const FakeSessionNode& node)
{
    return leavingText(*node.state(), *node.now() + std::chrono::seconds{1},
                       FakeSessionNode::kInstructor);
}

} // namespace

/// A session before it begins, and what is told of it at its end.
class TestSessionPlan : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void namesWhatIsMissing()
    {
        QVERIFY(faultOf(complete()).isEmpty());
        SessionPlan plan = complete();
        plan.name = QStringLiteral("  ");
        QVERIFY(faultOf(plan).contains(QStringLiteral("name")));
        plan = complete();
        plan.name = QString{65, QLatin1Char{'x'}};
        QVERIFY(faultOf(plan).contains(QStringLiteral("shorter")));
        plan = complete();
        plan.patient = QStringLiteral("a horse");
        QVERIFY(!faultOf(plan).isEmpty());
    }

    void saysWhatEachReachMeans()
    {
        std::set<QString> all;
        for (const SessionReach reach :
             {SessionReach::ThisComputer, SessionReach::Network, SessionReach::ByLink})
            all.insert(reachMeaning(reach));
        QCOMPARE(all.size(), std::size_t{3});
        QVERIFY(!all.contains(QString{}));
    }

    /// Who is there loses the instructor, and comes back when the session is resumed.
    void namesWhoIsLeftBehind()
    {
        FakeSessionNode node;
        node.decide(fact::PhaseChanged{SessionPhase::Running});
        QVERIFY(leaving(node).contains(QStringLiteral("Tom")));
        QVERIFY(leaving(node).contains(QStringLiteral("Olga (observer)")));
        QVERIFY(!leaving(node).contains(QStringLiteral("Ina")));
        node.decide(fact::ParticipantLeft{FakeSessionNode::kTrainee});
        QVERIFY(!leaving(node).contains(QStringLiteral("Tom")));
        node.decide(fact::ParticipantLeft{FakeSessionNode::kObserver});
        QVERIFY(leaving(node).contains(QStringLiteral("Nobody else")));
        node.decide(fact::PhaseChanged{SessionPhase::Ended});
        QVERIFY(leaving(node).isEmpty());
    }

    void asksNobodyBeforeAnythingHappened()
    {
        FakeSessionNode node;
        QVERIFY(!leaving(node).isEmpty());
        node.decide(fact::ParticipantLeft{FakeSessionNode::kTrainee});
        node.decide(fact::ParticipantLeft{FakeSessionNode::kObserver});
        QVERIFY(leaving(node).isEmpty());
    }

    void tellsWhatHappened()
    {
        FakeSessionNode node;
        node.decide(fact::AnatomyChosen{"builtin-adult-12", "Adult"});
        node.decide(fact::PhaseChanged{SessionPhase::Running});
        node.advance(std::chrono::milliseconds{75'500}); // its begin takes effect a little later
        QStringList told;
        for (const SummaryLine& line :
             summaryOf(*node.state(), *node.now(), FakeSessionNode::kInstructor, kFile))
            told += line.value;
        const QString all = told.join(QLatin1Char('\n'));
        for (const char* word : {"Routine intubation", "Station 1: Adult", "1 min 15 s", "Tom",
                                 "Olga (observer)", "session.sqlite"})
            QVERIFY2(all.contains(QLatin1String{word}), word);
        QVERIFY(!all.contains(QStringLiteral("Ina")));
    }
};

CARINA_TEST(TestSessionPlan)

} // namespace carina::session_plan_test

#include "tst_session_plan.moc"
