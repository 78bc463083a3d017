#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"
#include "ui/panels/session/network_panel.h"
#include "ui/panels/session/strategy_dialog.h"
#include "widgets/history_plot.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>

namespace carina::network_panel_test
{
namespace
{

using namespace std::chrono_literals;
using test::FakeSessionNode;

constexpr auto kTrainee = FakeSessionNode::kTrainee;
constexpr auto kObserver = FakeSessionNode::kObserver;

PathReport pathOf(ParticipantId peer, Duration delay)
{
    PathReport path;
    path.peer = peer;
    path.roundTrip = 2 * delay;
    path.delays = {delay, delay};
    path.meanDelay = delay;
    path.sigma = 0ms;
    return path;
}

struct Shown {
    FakeSessionNode node;
    SessionModel session{node};
    NetworkModel model{session};
    NetworkPanel panel;
    QComboBox* participant = panel.findChild<QComboBox*>();
    HistoryPlot* plot = panel.findChild<HistoryPlot*>();
    QTableView* table = panel.findChild<QTableView*>();
    QPushButton* curve = panel.findChild<QPushButton*>(QStringLiteral("delayCurve"));

    Shown() { panel.setModel(model); }
    void deliver(std::vector<PathReport> paths)
    {
        node.pathReports = std::move(paths);
        node.announce();
        QCoreApplication::sendPostedEvents();
    }
    [[nodiscard]] QString roundTrip() const
    {
        return table->model()->index(0, NetworkFiguresModel::HowMuch).data().toString();
    }
};

} // namespace

class TestNetworkPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysThatNobodyElseIsHere()
    {
        const Shown shown;
        QVERIFY(!shown.participant->isEnabled());
        QCOMPARE(shown.participant->placeholderText(), QStringLiteral("Nobody else is here yet"));
        QCOMPARE(shown.table->model()->rowCount(), 0);
        QCOMPARE(shown.plot->accessibleDescription(), QStringLiteral("Delays are not known yet"));
    }

    void showsWhoeverComesIn()
    {
        Shown shown;
        shown.deliver({pathOf(kTrainee, 10ms)});
        QVERIFY(shown.participant->isEnabled());
        QCOMPARE(shown.participant->currentText(), QStringLiteral("Tom"));
        QCOMPARE(shown.roundTrip(), QStringLiteral("20.00 ms"));
        QCOMPARE(shown.plot->drawing().curve.size(), 2);
        QVERIFY(shown.plot->accessibleDescription().contains(QStringLiteral("mean 10.00 ms")));
        shown.deliver({});
        QVERIFY(!shown.participant->isEnabled());
        QCOMPARE(shown.table->model()->rowCount(), 0);
        QVERIFY(shown.plot->drawing().curve.isEmpty());
    }

    void staysWithTheParticipantWhoWasChosen()
    {
        Shown shown;
        shown.deliver({pathOf(kObserver, 30ms)});
        shown.deliver({pathOf(kTrainee, 10ms), pathOf(kObserver, 31ms)});
        QCOMPARE(shown.participant->currentText(), QStringLiteral("Olga"));
        QCOMPARE(shown.roundTrip(), QStringLiteral("62.00 ms"));
        shown.panel.show();
        QTest::keyClick(shown.participant, Qt::Key_Up);
        QCOMPARE(shown.roundTrip(), QStringLiteral("20.00 ms"));
        shown.deliver({pathOf(kTrainee, 11ms), pathOf(kObserver, 31ms)});
        QCOMPARE(shown.roundTrip(), QStringLiteral("22.00 ms"));
    }

    /// The one who instructs: their actions, and no plot of a path that is not there.
    void showsOwnActionsBelowAllOthers()
    {
        Shown shown;
        shown.node.frequencies = {{FakeSessionNode::kInstructor, 4.0}};
        shown.deliver({pathOf(kTrainee, 10ms)});
        QCOMPARE(shown.participant->count(), 2);
        QCOMPARE(shown.participant->currentText(), QStringLiteral("Tom"));
        shown.curve->click();
        QVERIFY(!shown.plot->isHidden());
        shown.panel.choose(FakeSessionNode::kInstructor);
        QCOMPARE(shown.participant->currentText(), QStringLiteral("Ina (you)"));
        QVERIFY(shown.plot->isHidden());
        QVERIFY(!shown.curve->isEnabled());
        QCOMPARE(shown.table->model()->rowCount(), 1);
        QCOMPARE(shown.table->model()->index(0, NetworkFiguresModel::HowMuch).data().toString(),
                 QStringLiteral("4.0 (100) per s, ✓ below upshot"));
        shown.panel.choose(kTrainee);
        QVERIFY(!shown.plot->isHidden());
    }

    /// In a console of 800 pixels it would leave the figures no room.
    void showsTheCurveOnDemand()
    {
        Shown shown;
        shown.deliver({pathOf(kTrainee, 10ms)});
        shown.panel.show();
        QVERIFY(shown.plot->isHidden());
        QTest::keyClick(shown.curve, Qt::Key_Space);
        QVERIFY(shown.plot->isVisible());
        shown.deliver({pathOf(kTrainee, 11ms)});
        QVERIFY(shown.plot->isVisible());
        QTest::keyClick(shown.curve, Qt::Key_Space);
        QVERIFY(shown.plot->isHidden());
    }

    void aResearcherChoosesTheStrategy()
    {
        Shown shown;
        shown.panel.show();
        const auto* name = shown.panel.findChild<QLabel*>(QStringLiteral("strategyShown"));
        QCOMPARE(name->text(), QStringLiteral("Objects: Session clock"));
        QTest::keyClick(shown.panel.findChild<QPushButton*>(QStringLiteral("research")),
                        Qt::Key_Space);
        auto* dialog = shown.panel.findChild<StrategyDialog*>();
        QVERIFY(dialog != nullptr);
        auto* strategy = dialog->findChild<QComboBox*>(QStringLiteral("strategy"));
        auto* lag = dialog->findChild<QSpinBox*>(QStringLiteral("lag"));
        QVERIFY(!lag->isEnabled());
        strategy->setCurrentIndex(strategy->findText(QStringLiteral("Local lag")));
        QVERIFY(lag->isEnabled());
        QVERIFY(strategy->accessibleDescription().contains(QStringLiteral("longest lag")));
        lag->setValue(30);
        QTest::keyClick(dialog->findChild<QPushButton*>(QStringLiteral("use")), Qt::Key_Space);
        QCoreApplication::sendPostedEvents();
        const StrategyChoice chosen = shown.node.state()->strategy();
        QCOMPARE(chosen.kind, StrategyKind::LocalLag);
        QCOMPARE(chosen.longestLag, Duration{30ms});
        QCOMPARE(name->text(), QStringLiteral("Objects: Local lag"));
    }

    void isWorkedByKeyboardAndSpoken()
    {
        const Shown shown;
        for (const QWidget* widget :
             {static_cast<QWidget*>(shown.participant), static_cast<QWidget*>(shown.curve),
              static_cast<QWidget*>(shown.plot), static_cast<QWidget*>(shown.table)}) {
            QVERIFY(!widget->accessibleName().isEmpty());
            QVERIFY(widget->focusPolicy() & Qt::TabFocus);
        }
    }
};

CARINA_SCREEN_TEST(TestNetworkPanel)

} // namespace carina::network_panel_test

#include "tst_network_panel.moc"
