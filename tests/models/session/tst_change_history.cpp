#include "models/respiration/breathing_model.h"
#include "models/respiration/respiration_model.h"
#include "models/session/change_history.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

namespace carina::change_history_test
{

using test::FakeSessionNode;

namespace
{

constexpr std::chrono::milliseconds kLead{100};

struct Desk {
    FakeSessionNode node;
    SessionModel session{node};
    BreathingModel breathing{session, FakeSessionNode::kStation};
    RespirationModel respiration{session, FakeSessionNode::kStation};
    ChangeHistory history;

    Desk()
    {
        breathing.setHistory(history);
        respiration.setHistory(history);
    }
    void settle()
    {
        node.advance(kLead);
        node.announce();
        QCoreApplication::sendPostedEvents();
    }
    [[nodiscard]] RespiratorySettings settings() const
    {
        const auto state = node.state();
        return state->stations()
            .at(FakeSessionNode::kStation)
            .respiration.settingsAt(SessionTime::max());
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
    void forgetsWhatIsOfAnotherStation();
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

void TestChangeHistory::forgetsWhatIsOfAnotherStation()
{
    Desk desk;
    desk.node.addStation("Room 5");
    desk.breathing.set(BreathingParameter::Rate, 30.0);
    desk.settle();
    desk.breathing.setStation(StationId{1});
    QVERIFY(desk.history.isEmpty());
}

CARINA_TEST(TestChangeHistory)

} // namespace carina::change_history_test

#include "tst_change_history.moc"
