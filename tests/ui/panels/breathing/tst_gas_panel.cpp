#include "models/physiology/drug_words.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"
#include "ui/panels/breathing/gas_panel.h"
#include "widgets/checked_spin_box.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>

#include <cmath>

namespace carina::gas_panel_test
{

using test::FakeSessionNode;

/// The console's controls of gas, tube and drugs.
class TestGasPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void setsTheGasByKeyboardAlone();
    void givesADrugByKeyboardAlone();
    void offersTheUsualDoseOfEachDrug();
    void changesCuffAndStylet();
    void obstructsTheTube();
    void tellsWhereTheTubeIs();
    void setsWhereTheTubeIsByKeyboardAlone();
    void refusesATypedNumberWithItsRange();
    void changesNothingForAnObserver();
    void undoesFromItsButton();
    void namesEveryControlForAScreenReader();
};

namespace
{

constexpr std::chrono::milliseconds kLead{100};

struct Desk {
    FakeSessionNode node;
    SessionModel session{node};
    GasModel model{session, FakeSessionNode::kStation};
    GasPanel panel;

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
    void settle()
    {
        node.advance(kLead);
        node.announce();
        QCoreApplication::sendPostedEvents();
    }
    void enter(const char* name, const QString& text)
    {
        auto& box = find<CheckedDoubleSpinBox>(name);
        box.setFocus();
        box.selectAll();
        QTest::keyClicks(&box, text);
        QTest::keyClick(&box, Qt::Key_Return);
        settle();
    }
    void press(const char* name)
    {
        auto& button = find<QAbstractButton>(name);
        button.setFocus();
        QTest::keyClick(&button, Qt::Key_Space);
        settle();
    }
    [[nodiscard]] RespirationTimeline timeline() const
    {
        return node.state()->stations().at(FakeSessionNode::kStation).respiration;
    }
    void note(IntubationStep step, TubeSeat seat)
    {
        node.decide(fact::IntubationNoted{{.step = step, .at = *node.now(), .seat = seat}, {}});
        settle();
    }
};

} // namespace

void TestGasPanel::setsTheGasByKeyboardAlone()
{
    Desk desk;
    QCOMPARE(desk.find<CheckedDoubleSpinBox>("oxygen").value(), 21.0);
    desk.enter("oxygen", QStringLiteral("80"));
    desk.press("mask");
    desk.press("probe");
    const GasSupply gas = desk.timeline().gasAt(SessionTime::max());
    QCOMPARE(gas.inspiredOxygen, 0.8);
    QVERIFY(gas.maskHeld);
    QVERIFY(!gas.probeOn);
    desk.node.decide(fact::GasSupplySet{{1.0, false, true}});
    desk.settle();
    QVERIFY(!desk.find<QCheckBox>("mask").isChecked());
    QVERIFY(desk.find<QCheckBox>("probe").isChecked());
}

void TestGasPanel::givesADrugByKeyboardAlone()
{
    Desk desk;
    auto& drugs = desk.find<QComboBox>("drug");
    drugs.setFocus();
    for (int i = 0; i < int(DrugKind::Rocuronium); ++i)
        QTest::keyClick(&drugs, Qt::Key_Down);
    desk.enter("dose", QStringLiteral("1.2"));
    QCOMPARE(desk.find<QLabel>("wholeDose").text(),
             QStringLiteral("Rocuronium 48\u00a0mg for 40\u00a0kg"));
    desk.press("give");
    const RespirationTimeline timeline = desk.timeline();
    const auto doses = timeline.dosesWithin(SessionTime::min(), SessionTime::max());
    QCOMPARE(doses.size(), std::size_t{1});
    QVERIFY(doses.front().dose.kind == DrugKind::Rocuronium);
    QCOMPARE(doses.front().dose.milligrams, 48.0);
    QCOMPARE(desk.find<QLabel>("given").text(), QStringLiteral("● Given: Rocuronium 48\u00a0mg"));
}

void TestGasPanel::offersTheUsualDoseOfEachDrug()
{
    const Desk desk;
    auto& drugs = desk.find<QComboBox>("drug");
    const auto& dose = desk.find<CheckedDoubleSpinBox>("dose");
    QCOMPARE(drugs.count(), int(kDrugKinds.size()));
    drugs.setCurrentIndex(int(DrugKind::Propofol));
    QCOMPARE(dose.value(), 2.0);
    QCOMPARE(dose.suffix(), QStringLiteral("\u00a0mg/kg"));
    drugs.setCurrentIndex(int(DrugKind::Fentanyl));
    QCOMPARE(dose.value(), 2.0);
    QCOMPARE(dose.suffix(), QStringLiteral("\u00a0\u00b5g/kg"));
    drugs.setCurrentIndex(int(DrugKind::Ephedrine));
    QCOMPARE(dose.value(), 0.1);
    for (int i = 0; i < drugs.count(); ++i) {
        drugs.setCurrentIndex(i);
        QVERIFY(dose.minimum() > 0.0 && dose.maximum() > dose.value());
        QVERIFY(dose.accessibleName().contains(drugs.currentText()));
    }
}

void TestGasPanel::changesCuffAndStylet()
{
    Desk desk;
    QVERIFY(!desk.find<QPushButton>("stylet").isEnabled()); // there is no tube
    desk.note(IntubationStep::ThroughCords, TubeSeat::Trachea);
    desk.press("cuff");
    QVERIFY(desk.timeline().tube().cuffInflatedAt(SessionTime::max()));
    QVERIFY(desk.find<QPushButton>("stylet").isEnabled());
    desk.press("stylet");
    QVERIFY(!desk.timeline().tube().styletInAt(SessionTime::max()));
    QVERIFY(!desk.find<QPushButton>("stylet").isEnabled());
}

void TestGasPanel::obstructsTheTube()
{
    Desk desk;
    QVERIFY(!desk.find<QWidget>("obstruction").isEnabled()); // there is no tube
    desk.note(IntubationStep::ThroughCords, TubeSeat::Trachea);
    QVERIFY(desk.find<QWidget>("obstruction").isEnabled());
    desk.enter("obstruction", QStringLiteral("70"));
    QVERIFY(std::abs(desk.timeline().tube().obstructionAt(SessionTime::max()) - 0.7) < 1e-9);
}

void TestGasPanel::tellsWhereTheTubeIs()
{
    Desk desk;
    const auto& tube = desk.find<QLabel>("tubePlace");
    QVERIFY(!tube.isVisible());
    desk.note(IntubationStep::PastCarina, TubeSeat::RightMain);
    QVERIFY(tube.isVisible());
    QVERIFY(tube.text().contains(QStringLiteral("right main bronchus")));
}

void TestGasPanel::setsWhereTheTubeIsByKeyboardAlone()
{
    Desk desk;
    const auto set = [&] { return desk.timeline().tube().overrideAt(SessionTime::max()); };
    auto& seat = desk.find<QComboBox>("tubeSeat");
    const auto& size = desk.find<CheckedDoubleSpinBox>("tubeSize");
    QCOMPARE(seat.currentText(), QStringLiteral("as tracked"));
    QVERIFY(!size.isEnabled());
    desk.note(IntubationStep::ThroughCords, TubeSeat::Trachea);
    seat.setFocus();
    QTest::keyClick(&seat, Qt::Key_End);
    QTest::keyClick(&seat, Qt::Key_Up);
    desk.settle();
    desk.settle(); // each key set a place
    QCOMPARE(set().seat, TubeSeat::Oesophagus);
    QCOMPARE(inMillimetres(set().innerDiameter), size.value());
    QVERIFY(desk.find<QLabel>("tubePlace").text().contains(QStringLiteral("in the oesophagus")));
    desk.enter("tubeSize", QStringLiteral("5.5"));
    QVERIFY(std::abs(inMillimetres(set().innerDiameter) - 5.5) < 1e-9);
    QCOMPARE(set().seat, TubeSeat::Oesophagus);
    seat.setFocus();
    QTest::keyClick(&seat, Qt::Key_Home);
    desk.settle();
    QVERIFY(!set().isSet());
    QCOMPARE(seat.currentText(), QStringLiteral("as tracked"));
    for (const TubeSeat each : kTubeSeats) { // as others set it
        desk.node.decide(fact::TubePlaced{{each, millimetres(7.0)}});
        desk.settle();
        QCOMPARE(seat.currentText(), seatText(each));
    }
}

void TestGasPanel::refusesATypedNumberWithItsRange()
{
    Desk desk;
    const auto& refused = desk.find<QLabel>("refused");
    QVERIFY(!refused.isVisible());
    desk.enter("oxygen", QStringLiteral("15"));
    QVERIFY(refused.isVisible());
    QVERIFY2(refused.text().contains(QStringLiteral("21")), qPrintable(refused.text()));
    QVERIFY(desk.timeline().gasAt(SessionTime::max()) == GasSupply{});
    desk.enter("oxygen", QStringLiteral("50"));
    QVERIFY(!refused.isVisible());
}

void TestGasPanel::changesNothingForAnObserver()
{
    Desk desk{FakeSessionNode::kObserver};
    QCOMPARE(desk.find<QLabel>("obstacle").text(),
             QStringLiteral("Only an instructor changes the patient."));
    for (const char* name : {"oxygen", "mask", "probe", "cuff", "stylet", "obstruction", "drug",
                             "dose", "give", "undoGas"})
        QVERIFY2(!desk.find<QWidget>(name).isEnabled(), name);
    desk.node.decide(fact::GasSupplySet{{0.6, true, true}});
    desk.settle();
    QCOMPARE(desk.find<CheckedDoubleSpinBox>("oxygen").value(), 60.0);
}

void TestGasPanel::undoesFromItsButton()
{
    Desk desk;
    desk.press("mask");
    QVERIFY(desk.timeline().gasAt(SessionTime::max()).maskHeld);
    desk.press("undoGas");
    QVERIFY(!desk.timeline().gasAt(SessionTime::max()).maskHeld);
    QVERIFY(!desk.find<QPushButton>("undoGas").isEnabled());
}

void TestGasPanel::namesEveryControlForAScreenReader()
{
    const Desk desk;
    for (const char* name :
         {"oxygen", "stylet", "obstruction", "drug", "dose", "give", "given", "wholeDose"})
        QVERIFY2(!desk.find<QWidget>(name).accessibleName().isEmpty(), name);
    for (const char* name : {"mask", "probe", "cuff"})
        QVERIFY2(!desk.find<QCheckBox>(name).text().isEmpty(), name);
}

CARINA_SCREEN_TEST(TestGasPanel)

} // namespace carina::gas_panel_test

#include "tst_gas_panel.moc"
