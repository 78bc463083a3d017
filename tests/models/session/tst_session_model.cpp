#include "models/session/session_model.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>
#include <thread>

namespace carina::session_model_test
{

using test::FakeSessionNode;

class TestSessionModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void offersWhatThePhaseAllows_data();
    void offersWhatThePhaseAllows();
    void showsTheNameOfTheSession();
    void countsRunningMinutesAndSeconds_data();
    void countsRunningMinutesAndSeconds();
    void goesThroughASession();
    void isPreparedWhileTheClockIsUnknown();
    void bringsManyChangesAsOne();
    void mayBeGoneBeforeTheNode();
};

namespace
{

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr milliseconds kLead{100}; ///< until a change takes effect

void enter(FakeSessionNode& node, SessionPhase phase)
{
    if (phase != SessionPhase::Prepared)
        node.decide(fact::PhaseChanged{SessionPhase::Running});
    if (phase == SessionPhase::Paused || phase == SessionPhase::Ended)
        node.decide(fact::PhaseChanged{phase});
    node.advance(kLead);
}

/// Brings what waits for the model's thread.
void deliver() { QCoreApplication::sendPostedEvents(); }

} // namespace

void TestSessionModel::offersWhatThePhaseAllows_data()
{
    QTest::addColumn<int>("phase");
    QTest::addColumn<QString>("word");
    QTest::addColumn<bool>("start");
    QTest::addColumn<bool>("pause");
    QTest::addColumn<bool>("end");
    const auto row = [](const char* name, SessionPhase phase, const char* word, bool start,
                        bool pause, bool end) {
        QTest::newRow(name) << int(phase) << QString::fromUtf8(word) << start << pause << end;
    };
    row("prepared", SessionPhase::Prepared, "Ready to start", true, false, true);
    row("running", SessionPhase::Running, "Running", false, true, true);
    row("paused", SessionPhase::Paused, "Paused", true, false, true);
    row("ended", SessionPhase::Ended, "Ended", false, false, false);
}

void TestSessionModel::offersWhatThePhaseAllows()
{
    QFETCH(const int, phase);
    QFETCH(const QString, word);
    FakeSessionNode node;
    const SessionModel model{node};
    enter(node, SessionPhase(phase));
    QCOMPARE(int(model.phase()), phase);
    QCOMPARE(SessionModel::textOf(model.phase()), word);
    QTEST(model.canStart(), "start");
    QTEST(model.canPause(), "pause");
    QTEST(model.canEnd(), "end");
}

void TestSessionModel::showsTheNameOfTheSession()
{
    FakeSessionNode node;
    QCOMPARE(SessionModel{node}.name(), QStringLiteral("Routine intubation"));
}

void TestSessionModel::countsRunningMinutesAndSeconds_data()
{
    QTest::addColumn<int>("ran_ms");
    QTest::addColumn<QString>("shown");
    QTest::newRow("nothing yet") << 0 << QStringLiteral("00:00");
    QTest::newRow("not yet a second") << 999 << QStringLiteral("00:00");
    QTest::newRow("a second") << 1000 << QStringLiteral("00:01");
    QTest::newRow("not yet a minute") << 59'999 << QStringLiteral("00:59");
    QTest::newRow("four minutes") << 252'000 << QStringLiteral("04:12");
    QTest::newRow("more than an hour") << 6'005'000 << QStringLiteral("100:05");
}

void TestSessionModel::countsRunningMinutesAndSeconds()
{
    QFETCH(const int, ran_ms);
    QFETCH(const QString, shown);
    FakeSessionNode node;
    const SessionModel model{node};
    enter(node, SessionPhase::Running);
    node.advance(milliseconds{ran_ms});
    QCOMPARE(model.runningTimeText(), shown);
}

void TestSessionModel::goesThroughASession()
{
    FakeSessionNode node;
    SessionModel model{node};
    const auto after = [&](void (SessionModel::*verb)()) {
        (model.*verb)();
        node.advance(kLead);
        return model.phase();
    };
    QVERIFY(after(&SessionModel::start) == SessionPhase::Running);
    node.advance(seconds{30});
    QVERIFY(after(&SessionModel::pause) == SessionPhase::Paused);
    const QString held = model.runningTimeText();
    QCOMPARE(held, QStringLiteral("00:30"));
    node.advance(seconds{600});
    QCOMPARE(model.runningTimeText(), held);
    QVERIFY(after(&SessionModel::start) == SessionPhase::Running);
    QVERIFY(after(&SessionModel::end) == SessionPhase::Ended);
    QVERIFY(after(&SessionModel::start) == SessionPhase::Ended);
}

void TestSessionModel::isPreparedWhileTheClockIsUnknown()
{
    FakeSessionNode node;
    enter(node, SessionPhase::Running);
    node.loseClock();
    const SessionModel model{node};
    QVERIFY(model.phase() == SessionPhase::Prepared);
    QCOMPARE(model.runningTimeText(), QStringLiteral("00:00"));
}

void TestSessionModel::bringsManyChangesAsOne()
{
    FakeSessionNode node;
    SessionModel model{node};
    QSignalSpy changes{&model, &SessionModel::changed};
    std::thread nodeThread{[&] {
        for (int i = 0; i < 100; ++i)
            node.announce();
    }};
    nodeThread.join();
    QCOMPARE(changes.count(), 0); // not on the node's thread
    deliver();
    QCOMPARE(changes.count(), 1);
    node.announce();
    deliver();
    QCOMPARE(changes.count(), 2);
}

void TestSessionModel::mayBeGoneBeforeTheNode()
{
    FakeSessionNode node;
    {
        const SessionModel model{node};
        node.announce(); // under way when the model goes
    }
    deliver();
    node.announce();
    deliver();
}

CARINA_TEST(TestSessionModel)

} // namespace carina::session_model_test

#include "tst_session_model.moc"
