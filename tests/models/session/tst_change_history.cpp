#include "models/respiration/breathing_model.h"
#include "models/respiration/respiration_model.h"
#include "models/session/change_history.h"
#include "models/station/stations_model.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

namespace carina::change_history_test
{

using test::FakeSessionNode;

namespace
{

constexpr std::chrono::milliseconds kLead{100};
constexpr StationId kFirst = FakeSessionNode::kStation;
constexpr StationId kRoom{1};

struct Desk {
    FakeSessionNode node;
    SessionModel session{node};
    StationsModel stations{session};
    BreathingModel breathing{session, FakeSessionNode::kStation};
    RespirationModel respiration{session, FakeSessionNode::kStation};
    ChangeHistory history;

    Desk()
    {
        breathing.setHistory(history);
        respiration.setHistory(history);
        stations.setHistory(history);
        QObject::connect(&stations, &StationsModel::shownChanged, &history, [this](StationId now) {
            breathing.setStation(now);
            respiration.setStation(now);
        });
    }
    void addRoom()
    {
        node.addStation("Room 5");
        settle();
    }
    void setRate(double rate)
    {
        breathing.set(BreathingParameter::Rate, rate);
        settle();
    }
    void settle()
    {
        node.advance(kLead);
        node.announce();
        QCoreApplication::sendPostedEvents();
    }
    [[nodiscard]] RespiratorySettings settings(StationId station = kFirst) const
    {
        const auto state = node.state();
        return state->stations().at(station).respiration.settingsAt(SessionTime::max());
    }
    [[nodiscard]] int rateAt(StationId station) const
    {
        return qRound(inPerMinute(settings(station).pattern.rate));
    }
};

} // namespace

/// One undo for all panels.
class TestChangeHistory : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesBackTheLastOfAllPanels();
    void namesADragByItsEnd();
    void takesBackDownToAChange();
    void undoesAtTheStationWhereItWasMade();
    void forgetsWhatIsOfAStationThatWasClosed();
    void namesNoStationOfWhatIsOfNone();
    void undoesWhatBelongsTogetherAtOnce();
    void leavesTheRestOfAJointChange();
    void forgetsTheOldestWhole();
};

void TestChangeHistory::takesBackTheLastOfAllPanels()
{
    Desk desk;
    QVERIFY(desk.history.isEmpty());
    desk.breathing.set(BreathingParameter::TidalVolume, 400.0);
    desk.settle();
    desk.respiration.setPosition(BodyPosition::Prone);
    desk.settle();
    desk.breathing.set(BreathingParameter::Rate, 30.0);
    desk.settle();
    QCOMPARE(desk.history.texts(), (QStringList{QStringLiteral("Breathing rate → 30\u00a0/min"),
                                                QStringLiteral("Position → Prone"),
                                                QStringLiteral("Tidal volume → 400\u00a0ml")}));
    desk.history.undo();
    desk.settle();
    QVERIFY(std::abs(inPerMinute(desk.settings().pattern.rate) - 19.0) < 1e-9);
    QCOMPARE(desk.settings().position, BodyPosition::Prone);
    desk.history.undo();
    desk.settle();
    QCOMPARE(desk.settings().position, BodyPosition::Supine);
    QVERIFY(std::abs(inMillilitres(desk.settings().pattern.tidalVolume) - 400.0) < 1e-9);
    desk.history.undo();
    desk.settle();
    QVERIFY(std::abs(inMillilitres(desk.settings().pattern.tidalVolume) - 280.0) < 1e-9);
    QVERIFY(desk.history.isEmpty());
    desk.history.undo(); // nothing
}

void TestChangeHistory::namesADragByItsEnd()
{
    Desk desk;
    for (const double rate : {20.0, 21.0, 24.0})
        desk.breathing.set(BreathingParameter::Rate, rate);
    QCOMPARE(desk.history.texts(), QStringList{QStringLiteral("Breathing rate → 24\u00a0/min")});
}

void TestChangeHistory::takesBackDownToAChange()
{
    Desk desk;
    for (const double volume : {300.0, 350.0, 400.0}) {
        desk.breathing.set(BreathingParameter::TidalVolume, volume);
        desk.settle();
    }
    desk.history.undo(2);
    desk.settle();
    QVERIFY(std::abs(inMillilitres(desk.settings().pattern.tidalVolume) - 300.0) < 1e-9);
    QCOMPARE(desk.history.texts().size(), 1);
}

/// Whichever is shown by then.
void TestChangeHistory::undoesAtTheStationWhereItWasMade()
{
    Desk desk;
    desk.addRoom();
    const int before = desk.rateAt(kFirst);
    desk.setRate(30.0);
    desk.respiration.setPosition(BodyPosition::Prone);
    desk.settle();
    desk.stations.show(kRoom);
    desk.setRate(25.0);
    QCOMPARE(desk.history.texts(),
             (QStringList{QStringLiteral("Breathing rate → 25\u00a0/min"),
                          QStringLiteral("Station 1: Position → Prone"),
                          QStringLiteral("Station 1: Breathing rate → 30\u00a0/min")}));
    desk.stations.show(kFirst); // a glance back
    QCOMPARE(desk.history.texts(),
             (QStringList{QStringLiteral("Room 5: Breathing rate → 25\u00a0/min"),
                          QStringLiteral("Position → Prone"),
                          QStringLiteral("Breathing rate → 30\u00a0/min")}));
    desk.history.undo();
    desk.settle();
    QCOMPARE(desk.rateAt(kRoom), before);
    QCOMPARE(desk.rateAt(kFirst), 30);
    desk.stations.show(kRoom);
    desk.history.undo(2);
    desk.settle();
    QCOMPARE(desk.settings().position, BodyPosition::Supine);
    QCOMPARE(desk.rateAt(kFirst), before);
    QCOMPARE(desk.rateAt(kRoom), before);
    QVERIFY(desk.history.isEmpty());
    QVERIFY(!desk.node.refusal());
}

void TestChangeHistory::forgetsWhatIsOfAStationThatWasClosed()
{
    Desk desk;
    desk.addRoom();
    const int before = desk.rateAt(kFirst);
    desk.setRate(30.0);
    desk.stations.show(kRoom);
    desk.setRate(25.0);
    desk.node.decideAt(kRoom, fact::StationClosed{});
    desk.settle();
    QCOMPARE(desk.history.texts(), QStringList{QStringLiteral("Breathing rate → 30\u00a0/min")});
    desk.history.undo();
    desk.settle();
    QCOMPARE(desk.rateAt(kFirst), before);
    QVERIFY(desk.history.isEmpty());
}

void TestChangeHistory::namesNoStationOfWhatIsOfNone()
{
    ChangeHistory history;
    const QObject owner;
    history.add(owner, QStringLiteral("a"), [] {});
    history.add(
        owner, QStringLiteral("b"), [] {}, 0, kRoom);
    history.setStations(kFirst, {{kFirst, QStringLiteral("Hall")}, {kRoom, QStringLiteral("%2")}});
    QCOMPARE(history.texts(), (QStringList{QStringLiteral("%2: b"), QStringLiteral("a")}));
    history.setStations(kFirst, {{kFirst, QStringLiteral("Hall")}});
    QCOMPARE(history.texts(), QStringList{QStringLiteral("a")});
}

/// The last part first, and also the part that came later.
void TestChangeHistory::undoesWhatBelongsTogetherAtOnce()
{
    ChangeHistory history;
    const QObject owner;
    QStringList undone;
    const auto add = [&](const QString& text) {
        history.add(owner, text, [&undone, text] { undone << text; });
    };
    add(QStringLiteral("before"));
    const ChangeHistory::Joint joint = history.newJoint(QStringLiteral("all"));
    {
        const ChangeHistory::Joining joining{&history, joint};
        add(QStringLiteral("a"));
        add(QStringLiteral("b"));
    }
    QVERIFY(!history.goOn(owner, QStringLiteral("b goes on"), 0));
    add(QStringLiteral("after"));
    {
        const ChangeHistory::Joining joining{&history, joint};
        add(QStringLiteral("c"));
    }
    QCOMPARE(history.texts(), (QStringList{QStringLiteral("after"), QStringLiteral("all"),
                                           QStringLiteral("before")}));
    history.undo();
    QCOMPARE(undone, QStringList{QStringLiteral("after")});
    history.undo();
    QCOMPARE(undone.mid(1),
             (QStringList{QStringLiteral("c"), QStringLiteral("b"), QStringLiteral("a")}));
    QCOMPARE(history.texts(), QStringList{QStringLiteral("before")});
}

void TestChangeHistory::leavesTheRestOfAJointChange()
{
    ChangeHistory history;
    const QObject owner;
    QList<int> undone;
    {
        const ChangeHistory::Joining joining{&history, history.newJoint(QStringLiteral("all"))};
        for (const int topic : {1, 2, 3})
            history.add(
                owner, QString::number(topic), [&undone, topic] { undone << topic; }, topic);
    }
    history.forget(owner, 2);
    QCOMPARE(history.texts(), QStringList{QStringLiteral("all")});
    history.undo();
    QCOMPARE(undone, (QList<int>{3, 1}));
    QVERIFY(history.isEmpty());
}

/// No part of it is left to be undone alone.
void TestChangeHistory::forgetsTheOldestWhole()
{
    ChangeHistory history;
    const QObject owner;
    {
        const ChangeHistory::Joining joining{&history, history.newJoint(QStringLiteral("all"))};
        history.add(owner, QStringLiteral("a"), [] {});
        history.add(owner, QStringLiteral("b"), [] {});
    }
    for (std::size_t more = 2; more < ChangeHistory::kMost; ++more)
        history.add(owner, QStringLiteral("more"), [] {});
    QCOMPARE(history.texts().last(), QStringLiteral("all"));
    history.add(owner, QStringLiteral("one more"), [] {});
    QCOMPARE(history.texts().size(), int(ChangeHistory::kMost) - 1);
    QCOMPARE(history.texts().last(), QStringLiteral("more"));
}

CARINA_TEST(TestChangeHistory)

} // namespace carina::change_history_test

#include "tst_change_history.moc"
