#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"
#include "ui/panels/breathing/condition_panel.h"
#include "ui/panels/breathing/waveform_panel.h"
#include "widgets/waveform_plot.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QStandardItemModel>
#include <QToolButton>

#include <cmath>

namespace carina::condition_panel_test
{

using test::FakeSessionNode;

/// The console's controls of the mechanics, and its curves.
class TestConditionPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void laysThePatientByKeyboardAlone();
    void setsAConditionByKeyboardAlone();
    void setsSeverityBySliderAndBox();
    void addsAndRemovesConditionsByKeyboardAlone();
    void offersNoConditionTwiceOnALung();
    void offersWhatTheVentilatorHasInItsMode();
    void setsPauseOwnBreathsAndTrigger();
    void undoesFromItsButton();
    void keepsWhatIsBeingTyped();
    void refusesATypedPressureWithItsRange();
    void changesNothingForAnObserver();
    void namesEveryControlForAScreenReader();
    void tellsTheFiguresOfTheLastBreath();
    void saysThatTheCurvesAreFrozen();
    void tellsWhatLiesBetweenTwoMarks();
    void leavesAConsoleOf800PixelsItsHeight();
};

namespace
{

constexpr std::chrono::milliseconds kLead{100};

struct Desk {
    FakeSessionNode node;
    SessionModel session{node};
    RespirationModel model{session, FakeSessionNode::kStation};
    ConditionPanel panel;

    explicit Desk(ParticipantId self = FakeSessionNode::kInstructor) : node{self}
    {
        panel.setModel(model);
        panel.show();
        QApplication::setActiveWindow(&panel); // the display has no window manager
    }
    template <class Widget> [[nodiscard]] Widget& find(const char* name) const
    {
        return *panel.findChild<Widget*>(QLatin1String{name});
    }
    [[nodiscard]] QDoubleSpinBox& box(const char* name) const { return find<QDoubleSpinBox>(name); }
    void settle()
    {
        node.advance(kLead);
        node.announce();
        QCoreApplication::sendPostedEvents();
    }
    void choose(const char* name, int place)
    {
        auto& combo = find<QComboBox>(name);
        combo.setFocus();
        QTest::keyClick(&combo, Qt::Key_Home);
        for (int i = 0; i < place; ++i)
            QTest::keyClick(&combo, Qt::Key_Down);
        settle();
    }
    [[nodiscard]] RespiratorySettings decided() const
    {
        return node.state()
            ->stations()
            .at(FakeSessionNode::kStation)
            .respiration.settingsAt(SessionTime::max());
    }
};

} // namespace

void TestConditionPanel::laysThePatientByKeyboardAlone()
{
    Desk desk;
    QCOMPARE(desk.find<QComboBox>("position").currentText(), QStringLiteral("Supine"));
    desk.choose("position", 3);
    desk.settle();
    QCOMPARE(desk.decided().position, BodyPosition::RightLateral);
    desk.node.decide(fact::BodyPositionSet{BodyPosition::Sitting});
    desk.settle();
    QCOMPARE(desk.find<QComboBox>("position").currentText(), QStringLiteral("Sitting"));
}

void TestConditionPanel::setsAConditionByKeyboardAlone()
{
    Desk desk;
    QVERIFY(!desk.box("severity").isEnabled() && !desk.find<QComboBox>("side").isEnabled());
    desk.choose("condition", 4);
    desk.settle();
    QVERIFY(desk.decided().conditions.front()
            == (LungCondition{ConditionKind::SimplePneumothorax, 0.5, ConditionSide::Right}));
    QCOMPARE(desk.find<QComboBox>("side").currentText(), QStringLiteral("Right lung"));
    desk.choose("side", 2);
    QCOMPARE(desk.decided().conditions.front().side, ConditionSide::Left);
}

void TestConditionPanel::setsSeverityBySliderAndBox()
{
    Desk desk;
    desk.choose("condition", 2);
    desk.settle();
    desk.find<QSlider>("severitySlider").setValue(80);
    desk.settle();
    QCOMPARE(desk.decided().conditions.front().severity, 0.8);
    QCOMPARE(desk.box("severity").value(), 0.8);
    desk.box("severity").setValue(0.25);
    desk.settle();
    QCOMPARE(desk.decided().conditions.front().severity, 0.25);
    QCOMPARE(desk.find<QSlider>("severitySlider").value(), 25);
}

/// Severe asthma with a pneumothorax on the left.
void TestConditionPanel::addsAndRemovesConditionsByKeyboardAlone()
{
    Desk desk;
    auto& list = desk.find<QListWidget>("conditions");
    auto& add = desk.find<QPushButton>("addCondition");
    auto& remove = desk.find<QPushButton>("removeCondition");
    QVERIFY(add.isEnabled() && !remove.isEnabled());
    desk.choose("condition", 3);
    desk.settle();
    desk.box("severity").setValue(0.9);
    desk.settle();
    add.setFocus();
    QTest::keyClick(&add, Qt::Key_Space);
    desk.settle();
    QCOMPARE(list.currentRow(), 1);
    desk.choose("condition", 3); // asthma is passed over
    desk.settle();
    desk.choose("side", 2);
    const LungCondition asthma{ConditionKind::Asthma, 0.9, ConditionSide::Both};
    const LungCondition left{ConditionKind::SimplePneumothorax, 0.5, ConditionSide::Left};
    QVERIFY(desk.decided().conditions == (LungConditions{asthma, left}));
    QCOMPARE(list.count(), 2);
    QCOMPARE(list.item(1)->text(),
             QStringLiteral("Pneumothorax, simple, left lung, severity\u00a00.50"));
    QVERIFY(list.item(1)->toolTip().contains(QStringLiteral("left lung, severity\u00a00.50")));
    QVERIFY(list.item(1)->toolTip().contains(QStringLiteral("0 is healthy")));
    list.setFocus();
    QTest::keyClick(&list, Qt::Key_Up);
    QCOMPARE(desk.find<QComboBox>("condition").currentText(), QStringLiteral("Asthma"));
    QCOMPARE(desk.box("severity").value(), 0.9);
    QTest::keyClick(&list, Qt::Key_Delete);
    desk.settle();
    QVERIFY(desk.decided().conditions == LungConditions{left});
    desk.choose("condition", 0);
    QVERIFY(desk.decided().conditions.empty());
    QVERIFY(!remove.isEnabled() && !desk.box("severity").isEnabled());
}

void TestConditionPanel::offersNoConditionTwiceOnALung()
{
    Desk desk;
    desk.node.decide(
        fact::LungConditionsSet{{{ConditionKind::Copd, 0.6, ConditionSide::Both},
                                 {ConditionKind::Atelectasis, 0.5, ConditionSide::Right}}});
    desk.settle();
    desk.find<QListWidget>("conditions").setCurrentRow(1);
    const auto* kinds =
        qobject_cast<QStandardItemModel*>(desk.find<QComboBox>("condition").model());
    const auto isOffered = [&](ConditionKind kind) {
        return kinds->item(static_cast<int>(kind))->isEnabled();
    };
    QVERIFY(!isOffered(ConditionKind::Copd));
    QVERIFY(isOffered(ConditionKind::Ards) && isOffered(ConditionKind::Normal));
}

void TestConditionPanel::offersWhatTheVentilatorHasInItsMode()
{
    Desk desk;
    const auto enabled = [&](const char* name) { return desk.box(name).isEnabled(); };
    QVERIFY(!enabled("peep") && !enabled("driving") && !enabled("limit"));
    desk.choose("mode", 1);
    QVERIFY(enabled("peep") && !enabled("driving") && enabled("limit"));
    desk.box("peep").setValue(9.0);
    desk.settle();
    desk.choose("mode", 2);
    QVERIFY(enabled("peep") && enabled("driving") && !enabled("limit"));
    desk.box("driving").setValue(17.0);
    desk.settle();
    const VentilatorSettings ventilator = desk.decided().ventilator;
    QCOMPARE(ventilator.mode, VentilationMode::PressureControl);
    QCOMPARE(ventilator.peep, cmH2O(9.0));
    QCOMPARE(ventilator.drivingPressure, cmH2O(17.0));
    QCOMPARE(ventilator.pressureLimit, VentilatorSettings{}.pressureLimit);
}

void TestConditionPanel::setsPauseOwnBreathsAndTrigger()
{
    Desk desk;
    for (const char* name : {"pause", "ownRate", "ownEffort", "trigger"})
        QVERIFY(!desk.box(name).isEnabled());
    desk.choose("mode", 1);
    QVERIFY(desk.box("pause").isEnabled() && desk.box("trigger").isEnabled());
    QVERIFY(!desk.box("ownEffort").isEnabled());
    QCOMPARE(desk.box("ownRate").text(), QStringLiteral("none"));
    const auto set = [&](const char* name, double value) {
        desk.box(name).setValue(value);
        desk.settle();
    };
    set("ownRate", 22.0);
    QCOMPARE(desk.decided().ventilator.ownEffort, 0.5);
    set("ownEffort", 80.0);
    set("pause", 10.0);
    set("trigger", 3.0);
    const VentilatorSettings ventilator = desk.decided().ventilator;
    QCOMPARE(ventilator.ownRate, perMinute(22.0));
    QCOMPARE(ventilator.ownEffort, 0.8);
    QCOMPARE(ventilator.pauseShare, 0.1);
    QCOMPARE(ventilator.trigger, litresPerMinute(3.0));
    set("ownRate", desk.box("ownRate").minimum());
    QCOMPARE(desk.decided().ventilator.ownRate, Frequency{});
    QCOMPARE(desk.decided().ventilator.ownEffort, 0.0);
}

void TestConditionPanel::undoesFromItsButton()
{
    Desk desk;
    auto& undo = desk.find<QPushButton>("undoCondition");
    QVERIFY(!undo.isEnabled());
    desk.choose("mode", 1);
    QVERIFY(undo.isEnabled());
    undo.click();
    QCOMPARE(desk.find<QLabel>("travelling").text(), QStringLiteral("Ventilation → Spontaneous"));
    desk.settle();
    QCOMPARE(desk.decided().ventilator.mode, VentilationMode::Spontaneous);
    QVERIFY(!undo.isEnabled());
}

void TestConditionPanel::keepsWhatIsBeingTyped()
{
    Desk desk;
    desk.choose("condition", 2);
    desk.settle();
    QDoubleSpinBox& severity = desk.box("severity");
    severity.setFocus();
    severity.selectAll();
    QTest::keyClicks(&severity, QStringLiteral("0.7"));
    desk.node.decide(
        fact::TubePlaced{{TubeSeat::Trachea, millimetres(7.0)}}); // and something else changes
    desk.settle();
    QCOMPARE(severity.cleanText(), QStringLiteral("0.7"));
    QTest::keyClick(&severity, Qt::Key_Return);
    desk.settle();
    QCOMPARE(desk.decided().conditions.front().severity, 0.7);
}

void TestConditionPanel::refusesATypedPressureWithItsRange()
{
    Desk desk;
    desk.choose("mode", 1);
    desk.settle();
    QDoubleSpinBox& peep = desk.box("peep");
    const double before = peep.value();
    const auto enter = [&peep](const QString& text) {
        peep.setFocus();
        peep.selectAll();
        QTest::keyClicks(&peep, text);
        QTest::keyClick(&peep, Qt::Key_Return);
    };
    const auto& refused = desk.find<QLabel>("refused");
    QVERIFY(!refused.isVisible());
    enter(QStringLiteral("80"));
    desk.settle();
    QCOMPARE(inCmH2O(desk.decided().ventilator.peep), before);
    QVERIFY(refused.isVisible());
    QVERIFY2(refused.text().contains(QStringLiteral("80")), qPrintable(refused.text()));
    enter(QStringLiteral("7"));
    QVERIFY(!refused.isVisible());
}

void TestConditionPanel::changesNothingForAnObserver()
{
    Desk desk{FakeSessionNode::kObserver};
    QCOMPARE(desk.find<QLabel>("obstacle").text(),
             QStringLiteral("Only an instructor changes the patient."));
    for (const char* name : {"condition", "severity", "side", "mode", "peep"})
        QVERIFY2(!desk.find<QWidget>(name).isEnabled(), name);
    QVERIFY(!desk.find<QPushButton>("undoCondition").isEnabled());
    desk.node.decide(fact::LungConditionsSet{{{ConditionKind::Copd, 0.9, {}}}});
    desk.settle();
    QCOMPARE(desk.find<QComboBox>("condition").currentText(), QStringLiteral("COPD"));
    QVERIFY(!desk.box("severity").isEnabled());
}

void TestConditionPanel::namesEveryControlForAScreenReader()
{
    const Desk desk;
    for (const char* name : {"position", "conditions", "addCondition", "removeCondition",
                             "condition", "severity", "severitySlider", "side", "mode", "peep",
                             "driving", "limit", "pause", "ownRate", "ownEffort", "trigger"})
        QVERIFY2(!desk.find<QWidget>(name).accessibleName().isEmpty(), name);
    const WaveformPanel waveforms;
    int plots = 0;
    for (const QWidget* child : waveforms.findChildren<QWidget*>()) {
        QVERIFY(!child->accessibleName().isEmpty());
        ++plots;
    }
    QCOMPARE(plots, 7); // three curves, their figures, and three controls
}

void TestConditionPanel::tellsTheFiguresOfTheLastBreath()
{
    FakeSessionNode node;
    SessionModel session{node};
    BreathTrace trace{session, FakeSessionNode::kStation};
    WaveformPanel panel;
    panel.setTrace(trace);
    const auto figures = [&] {
        return panel.findChild<QLabel*>(QStringLiteral("figures"))->text();
    };
    QCOMPARE(figures(), QStringLiteral("No whole breath yet"));
    node.decide(fact::PhaseChanged{SessionPhase::Running});
    for (int i = 0; i < 600; ++i) {
        node.advance(std::chrono::milliseconds{20});
        trace.sample();
    }
    WaveformPanel later;
    later.setTrace(trace);
    const QString told = later.findChild<QLabel*>(QStringLiteral("figures"))->text();
    QVERIFY2(told.contains(QStringLiteral("19.0\u00a0/min")), qPrintable(told));
    QVERIFY2(!told.contains(QStringLiteral("peak")), qPrintable(told)); // nobody pushes
    QVERIFY2(!told.contains(QStringLiteral("-0.0")), qPrintable(told));
}

void TestConditionPanel::saysThatTheCurvesAreFrozen()
{
    const WaveformPanel panel;
    auto& freeze = *panel.findChild<QToolButton*>(QStringLiteral("freeze"));
    const int width = freeze.sizeHint().expandedTo(freeze.minimumSize()).width();
    QVERIFY(!freeze.text().remove(QLatin1Char{'&'}).contains(QStringLiteral("Frozen")));
    QTest::keyClick(&freeze, Qt::Key_Space);
    QVERIFY(freeze.text().remove(QLatin1Char{'&'}).contains(QStringLiteral("■ Frozen")));
    QCOMPARE(freeze.sizeHint().expandedTo(freeze.minimumSize()).width(), width);
    QTest::keyClick(&freeze, Qt::Key_Space);
    QCOMPARE(freeze.text(), QStringLiteral("Free&ze"));
}

/// Above each curve, and in words for who cannot see them.
void TestConditionPanel::tellsWhatLiesBetweenTwoMarks()
{
    FakeSessionNode node;
    SessionModel session{node};
    BreathTrace trace{session, FakeSessionNode::kStation};
    WaveformPanel panel;
    panel.setTrace(trace);
    panel.resize(400, 400);
    static_cast<QWidget&>(panel).show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    node.decide(fact::PhaseChanged{SessionPhase::Running});
    for (int i = 0; i < 300; ++i) {
        node.advance(std::chrono::milliseconds{20});
        trace.sample();
    }
    const auto& measured = *panel.findChild<QLabel*>(QStringLiteral("measured"));
    const QList<WaveformPlot*> plots = panel.findChildren<WaveformPlot*>();
    QCOMPARE(plots.size(), 3);
    QTest::keyClick(panel.findChild<QToolButton*>(QStringLiteral("freeze")), Qt::Key_Space);
    QVERIFY(measured.text().startsWith(QStringLiteral("Point at a place")));
    const auto pointAt = [&plots](double share) {
        const QRectF frame = plots[0]->drawing().frame;
        QTest::mouseClick(plots[0], Qt::LeftButton, {},
                          {int(frame.left() + share * frame.width()), 30});
        return plots[0]->atCursor().value_or(WaveformPlot::Value{});
    };
    const WaveformPlot::Value first = pointAt(0.36);
    QCOMPARE(plots[0]->note().toDouble(), qRound(10.0 * first.value) / 10.0);
    QVERIFY(!plots[0]->drawing().mark);
    const WaveformPlot::Value second = pointAt(0.46);
    QVERIFY(plots[0]->drawing().mark);
    const double between = qRound(10.0 * (second.value - first.value)) / 10.0;
    QVERIFY2(
        plots[0]->note().endsWith(QString::number(std::abs(between), 'f', 1) + QLatin1Char{')'}),
        qPrintable(plots[0]->note()));
    const QString seconds = QString::number(second.time_s - first.time_s, 'f', 2);
    QCOMPARE(measured.text(),
             QStringLiteral("In brackets: between the marks, %1\u00a0s").arg(seconds));
    QVERIFY(measured.accessibleDescription().contains(
        QStringLiteral("between the marks: %1\u00a0s, ").arg(seconds)));
    auto& freeze = *panel.findChild<QToolButton*>(QStringLiteral("freeze"));
    QTest::keyClick(&freeze, Qt::Key_Space);
    QVERIFY(plots[0]->note().isEmpty() && measured.text().isEmpty());
    // Of another patient nothing is held.
    QTest::keyClick(&freeze, Qt::Key_Space);
    static_cast<void>(pointAt(0.4));
    Q_EMIT trace.startedAfresh();
    QVERIFY(!freeze.isChecked());
    QVERIFY(plots[0]->note().isEmpty() && measured.text().isEmpty());
}

/// A dock is as tall as its contents ask for, and the console with it: beside bars, titles and tabs
/// 659 pixels are left.
void TestConditionPanel::leavesAConsoleOf800PixelsItsHeight()
{
    const ConditionPanel panel;
    QVERIFY2(panel.minimumSizeHint().height() <= 659,
             qPrintable(QString::number(panel.minimumSizeHint().height())));
}

CARINA_SCREEN_TEST(TestConditionPanel)

} // namespace carina::condition_panel_test

#include "tst_condition_panel.moc"
