#include "engine/io/anatomy_set/anatomy_cache.h"
#include "models/airway/airway_presets.h"
#include "models/airway/airway_words.h"
#include "models/patient/session_patient.h"
#include "tests/models/fake_session_node.h"
#include "tests/models/lacking_patient.h"
#include "tests/support/test_class.h"
#include "ui/panels/airway_panel.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>

#include <optional>

namespace carina::airway_panel_test
{

using test::FakeSessionNode;
using enum AirwayEventKind;

/// The console's controls of what makes an airway difficult.
class TestAirwayPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void setsASeverityByKeyboardAlone();
    void leadsFromEachEventToTheNextByTab();
    void setsSeverityBySliderAndBox();
    void tellsTheSeverityOfNowWhileItChanges();
    void clearsTheAirwayByItsButton();
    void setsAPresetAsOneChange();
    void saysCustomWhereItIsNoPreset();
    void laysTheHeadByKeyboardOverTheTimeOfAChange();
    void tellsHowTheHeadLies();
    void saysOtherWhereTheHeadLiesInNoUsualWay();
    void leadsFromTheTimeOverTheHeadToTheEventsByTab();
    void tellsWhatTravels();
    void keepsWhatIsBeingTyped();
    void refusesATypedSeverityWithItsRange();
    void changesNothingForAnObserver();
    void saysWhatThePatientDoesNotShow();
    void staysToBeSetForAllStations();
    void saysWhyAPatientShowsNoEvent();
    void namesAndExplainsEveryControl();
    void fitsIntoItsColumn();
};

namespace
{

constexpr std::chrono::milliseconds kLead{100};
constexpr int kColumn = 430; ///< pixels of a console's panels, with their scroll bar
constexpr int kHeight = 659; ///< that a console of 800 pixels has for a panel

struct Desk {
    FakeSessionNode node;
    SessionModel session{node};
    AirwayEventModel model{session, FakeSessionNode::kStation};
    HeadPositionModel head{session, FakeSessionNode::kStation};
    AirwayPanel panel;
    std::optional<SessionPatient> patient;

    explicit Desk(ParticipantId self = FakeSessionNode::kInstructor) : node{self}
    {
        panel.setModels(model, head);
        panel.show();
        QApplication::setActiveWindow(&panel); // the display has no window manager
    }
    void lay(const SharedPatientModel& lying)
    {
        patient.emplace(node, FakeSessionNode::kStation, lying, AnatomyCache::defaultFolder());
        model.setPatient(*patient);
    }
    /// The control that gets the keyboard with the panel.
    [[nodiscard]] QString first()
    {
        panel.setFocus();
        return QApplication::focusWidget()->objectName();
    }
    template <class Widget> [[nodiscard]] Widget& find(const char* name) const
    {
        return *panel.findChild<Widget*>(QLatin1String{name});
    }
    [[nodiscard]] QSpinBox& box(const char* name) const { return find<QSpinBox>(name); }
    [[nodiscard]] QString text(const char* name) const { return find<QLabel>(name).text(); }
    void settle(Duration time = kLead)
    {
        node.advance(time);
        node.announce();
        QCoreApplication::sendPostedEvents();
    }
    void type(const char* name, const QString& text) const
    {
        QSpinBox& field = box(name);
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, text);
    }
    void enter(const char* name, const QString& text) const
    {
        type(name, text);
        QTest::keyClick(&box(name), Qt::Key_Return);
    }
    [[nodiscard]] AirwayEvents decided() const
    {
        return node.state()
            ->stations()
            .at(FakeSessionNode::kStation)
            .airwayEvents.decidedAt(SessionTime::max());
    }
};

const SharedPatientModel& tongueless()
{
    static const SharedPatientModel made = test::childWithout(PartRole::Tongue);
    return made;
}

} // namespace

void TestAirwayPanel::setsASeverityByKeyboardAlone()
{
    Desk desk;
    desk.panel.setFocus();
    QCOMPARE(QApplication::focusWidget()->objectName(), QStringLiteral("tongue_oedema"));
    desk.enter("tongue_oedema", QStringLiteral("60"));
    desk.settle();
    QVERIFY(desk.decided() == (AirwayEvents{{TongueOedema, 0.6}}));
    desk.enter("laryngospasm", QStringLiteral("10"));
    desk.settle();
    QVERIFY(desk.decided() == (AirwayEvents{{TongueOedema, 0.6}, {Laryngospasm, 0.1}}));
}

/// Also those whose label has no key.
void TestAirwayPanel::leadsFromEachEventToTheNextByTab()
{
    Desk desk;
    desk.panel.setFocus();
    for (int kind = 0; kind < kAirwayEventKinds; ++kind) {
        const QString name = QLatin1String{eventName(static_cast<AirwayEventKind>(kind))};
        QCOMPARE(QApplication::focusWidget()->objectName(), name);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QCOMPARE(QApplication::focusWidget()->objectName(), name + QStringLiteral("Slider"));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
}

void TestAirwayPanel::setsSeverityBySliderAndBox()
{
    Desk desk;
    desk.find<QSlider>("epiglottitisSlider").setValue(80);
    desk.settle();
    QVERIFY(desk.decided() == (AirwayEvents{{Epiglottitis, 0.8}}));
    QCOMPARE(desk.box("epiglottitis").value(), 80);
    desk.box("epiglottitis").setValue(25);
    desk.settle();
    QVERIFY(desk.decided() == (AirwayEvents{{Epiglottitis, 0.25}}));
    QCOMPARE(desk.find<QSlider>("epiglottitisSlider").value(), 25);
}

/// 80 % over 20 s: a quarter of it after five.
void TestAirwayPanel::tellsTheSeverityOfNowWhileItChanges()
{
    Desk desk;
    QCOMPARE(desk.box("airwayOver").text(), QStringLiteral("at once"));
    desk.enter("airwayOver", QStringLiteral("20"));
    desk.enter("laryngeal_oedema", QStringLiteral("80"));
    desk.settle();
    desk.settle(std::chrono::seconds{5});
    QCOMPARE(desk.box("laryngeal_oedema").value(), 80);
    QCOMPARE(desk.text("laryngeal_oedemaNow"), QStringLiteral("now 20\u00a0%"));
    QVERIFY(desk.text("tongue_oedemaNow").isEmpty());
    desk.settle(std::chrono::seconds{15});
    QVERIFY(desk.text("laryngeal_oedemaNow").isEmpty());
}

void TestAirwayPanel::clearsTheAirwayByItsButton()
{
    Desk desk;
    auto& clear = desk.find<QPushButton>("clearAirway");
    QVERIFY(!clear.isEnabled());
    desk.node.decide(fact::AirwayEventsSet{{{TongueOedema, 1.0}, {Epiglottitis, 0.5}}, {}});
    desk.settle();
    QVERIFY(clear.isEnabled());
    QTest::keyClick(&clear, Qt::Key_Space);
    desk.settle();
    QVERIFY(desk.decided().empty());
    QCOMPARE(desk.box("tongue_oedema").value(), 0);
    QVERIFY(!clear.isEnabled());
}

// By keyboard: the letter chooses it.
void TestAirwayPanel::setsAPresetAsOneChange()
{
    Desk desk;
    auto& presets = desk.find<QComboBox>("airwayPreset");
    QCOMPARE(presets.currentText(), QStringLiteral("Clear"));
    desk.enter("laryngospasm", QStringLiteral("50"));
    desk.settle();
    presets.setFocus();
    QTest::keyClicks(&presets, QStringLiteral("ana"));
    desk.settle();
    desk.settle();
    QCOMPARE(presets.currentText(), QStringLiteral("Anaphylaxis"));
    const AirwayEvents swollen = presetNamed("anaphylaxis")->events;
    QVERIFY(desk.decided() == swollen);
    QCOMPARE(desk.box("laryngospasm").value(), 0);
    for (const AirwayEvent& event : swollen)
        QCOMPARE(desk.box(eventName(event.kind)).value(), qRound(100.0 * event.severity));
    desk.model.undo();
    desk.settle();
    QVERIFY(desk.decided() == (AirwayEvents{{Laryngospasm, 0.5}}));
}

void TestAirwayPanel::saysCustomWhereItIsNoPreset()
{
    Desk desk;
    const auto& presets = desk.find<QComboBox>("airwayPreset");
    desk.model.setEvents(presetNamed("web")->events);
    QCOMPARE(presets.currentText(), QStringLiteral("Congenital web"));
    desk.settle();
    QCOMPARE(presets.currentText(), QStringLiteral("Congenital web"));
    desk.box("laryngeal_web").setValue(71);
    desk.settle();
    QCOMPARE(presets.currentIndex(), -1);
    QCOMPARE(presets.placeholderText(), QStringLiteral("Custom"));
    desk.model.clear();
    desk.settle();
    QCOMPARE(presets.currentText(), QStringLiteral("Clear"));
}

// The letter chooses it. 35 degrees over 10 s: 7 after two of them.
void TestAirwayPanel::laysTheHeadByKeyboardOverTheTimeOfAChange()
{
    Desk desk;
    auto& positions = desk.find<QComboBox>("headPosition");
    QCOMPARE(positions.currentText(), QStringLiteral("Neutral"));
    QCOMPARE(desk.text("headPositionNow"), QStringLiteral("neck 0°\nhead 0°"));
    desk.enter("airwayOver", QStringLiteral("10"));
    positions.setFocus();
    QTest::keyClicks(&positions, QStringLiteral("f"));
    QCOMPARE(positions.currentText(), QStringLiteral("Flexed"));
    QCOMPARE(desk.text("airwayTravelling"),
             QStringLiteral("Head position → Flexed: neck 35° flexed, head 0°"));
    desk.settle();
    desk.settle(std::chrono::seconds{2});
    QCOMPARE(positions.currentText(), QStringLiteral("Flexed"));
    QCOMPARE(desk.text("headPositionNow"), QStringLiteral("neck 7° flexed\nhead 0°"));
    QVERIFY(desk.decided().empty());
    desk.head.undo();
    desk.settle();
    QCOMPARE(positions.currentText(), QStringLiteral("Neutral"));
    QCOMPARE(desk.text("headPositionNow"), QStringLiteral("neck 0°\nhead 0°"));
}

/// Of 35 and 30 degrees a stiff neck of 40 % leaves 21 and 18; clearing the airway leaves the head
/// as it was laid.
void TestAirwayPanel::tellsHowTheHeadLies()
{
    Desk desk;
    desk.node.decide(fact::HeadPositionSet{kSniffing, {}});
    desk.settle();
    const auto& positions = desk.find<QComboBox>("headPosition");
    QCOMPARE(positions.currentText(), QStringLiteral("Sniffing"));
    QCOMPARE(positions.accessibleDescription(),
             QStringLiteral("Sniffing: neck 35° flexed, head 24° extended"));
    QCOMPARE(desk.text("headPositionNow"), QStringLiteral("neck 35° flexed\nhead 24° extended"));
    desk.enter("stiff_neck", QStringLiteral("40"));
    desk.settle();
    QCOMPARE(positions.currentText(), QStringLiteral("Sniffing"));
    QCOMPARE(desk.text("headPositionNow"), QStringLiteral("neck 21° flexed\nhead 18° extended"));
    desk.find<QPushButton>("clearAirway").click();
    desk.settle();
    QCOMPARE(desk.text("headPositionNow"), QStringLiteral("neck 35° flexed\nhead 24° extended"));
}

void TestAirwayPanel::saysOtherWhereTheHeadLiesInNoUsualWay()
{
    Desk desk;
    desk.node.decide(fact::HeadPositionSet{{degrees(-20.0), degrees(5.0)}, {}});
    desk.settle();
    const auto& positions = desk.find<QComboBox>("headPosition");
    QCOMPARE(positions.currentIndex(), -1);
    QCOMPARE(positions.placeholderText(), QStringLiteral("Other"));
    QCOMPARE(desk.text("headPositionNow"), QStringLiteral("neck 20° extended\nhead 5° extended"));
}

void TestAirwayPanel::leadsFromTheTimeOverTheHeadToTheEventsByTab()
{
    Desk desk;
    desk.node.decide(fact::AirwayEventsSet{{{Laryngospasm, 1.0}}, {}}); // there is one to clear
    desk.settle();
    desk.box("airwayOver").setFocus();
    for (const char* name : {"airwayOver", "clearAirway", "headPosition", "tongue_oedema"}) {
        QCOMPARE(QApplication::focusWidget()->objectName(), QLatin1String{name});
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
}

void TestAirwayPanel::tellsWhatTravels()
{
    Desk desk;
    desk.box("pharyngeal_swelling").setValue(40);
    QCOMPARE(desk.text("airwayTravelling"),
             QStringLiteral("Airway → Pharyngeal swelling 40\u00a0%"));
    desk.settle();
    QVERIFY(desk.text("airwayTravelling").isEmpty());
}

void TestAirwayPanel::keepsWhatIsBeingTyped()
{
    Desk desk;
    desk.type("tongue_oedema", QStringLiteral("7"));
    desk.node.decide(fact::AirwayEventsSet{{{Laryngospasm, 1.0}}, {}}); // somebody else
    desk.settle();
    QCOMPARE(desk.box("tongue_oedema").cleanText(), QStringLiteral("7"));
    QCOMPARE(desk.box("laryngospasm").value(), 100);
    QTest::keyClick(&desk.box("tongue_oedema"), Qt::Key_Return);
    desk.settle();
    QVERIFY(desk.decided() == (AirwayEvents{{TongueOedema, 0.07}, {Laryngospasm, 1.0}}));
}

void TestAirwayPanel::refusesATypedSeverityWithItsRange()
{
    Desk desk;
    desk.enter("laryngospasm", QStringLiteral("120"));
    desk.settle();
    QVERIFY(desk.decided().empty());
    const auto& refused = desk.find<QLabel>("refused");
    QVERIFY(refused.isVisible());
    QVERIFY2(refused.text().contains(QStringLiteral("120")), qPrintable(refused.text()));
}

void TestAirwayPanel::changesNothingForAnObserver()
{
    Desk desk{FakeSessionNode::kObserver};
    QCOMPARE(desk.text("airwayObstacle"),
             QStringLiteral("Only an instructor changes the patient."));
    for (const char* name : {"airwayPreset", "airwayOver", "headPosition", "tongue_oedema",
                             "tongue_oedemaSlider", "clearAirway"})
        QVERIFY2(!desk.find<QWidget>(name).isEnabled(), name);
    desk.node.decide(fact::AirwayEventsSet{{{Laryngospasm, 1.0}}, {}});
    desk.settle();
    QCOMPARE(desk.box("laryngospasm").value(), 100);
}

/// What somebody else set can be ended.
void TestAirwayPanel::saysWhatThePatientDoesNotShow()
{
    Desk desk;
    const auto& why = desk.find<QLabel>("tongue_oedemaNotShown");
    QVERIFY(!why.isVisible());
    desk.lay(tongueless());
    QVERIFY(why.isVisible());
    QCOMPARE(why.text(), QStringLiteral("Not shown: this patient has no tongue of its own."));
    QCOMPARE(desk.box("tongue_oedema").accessibleDescription(), why.text());
    QVERIFY(!desk.box("tongue_oedema").isEnabled());
    QVERIFY(!desk.find<QSlider>("tongue_oedemaSlider").isEnabled());
    QVERIFY(!desk.find<QLabel>("epiglottitisNotShown").isVisible());
    QVERIFY(!desk.find<QLabel>("airwayNotShown").isVisible());
    QCOMPARE(desk.first(), QStringLiteral("pharyngeal_swelling"));
    desk.node.decide(fact::AirwayEventsSet{{{TongueOedema, 0.5}}, {}});
    desk.settle();
    QVERIFY(why.isVisible());
    desk.enter("tongue_oedema", QStringLiteral("0"));
    desk.settle();
    QVERIFY(desk.decided().empty());
    QVERIFY(!desk.box("tongue_oedema").isEnabled());
}

void TestAirwayPanel::staysToBeSetForAllStations()
{
    Desk desk;
    desk.lay(tongueless());
    desk.model.setForAll(true);
    QVERIFY(desk.box("tongue_oedema").isEnabled());
    QVERIFY(desk.find<QLabel>("tongue_oedemaNotShown").isVisible());
    QCOMPARE(desk.first(), QStringLiteral("tongue_oedema"));
}

void TestAirwayPanel::saysWhyAPatientShowsNoEvent()
{
    Desk desk;
    desk.lay(test::childWithout(PartRole::Epiglottis));
    const auto& why = desk.find<QLabel>("airwayNotShown");
    QVERIFY(why.isVisible());
    QVERIFY2(why.text().contains(QStringLiteral("no epiglottis")), qPrintable(why.text()));
    for (int kind = 0; kind < kAirwayEventKinds; ++kind) {
        const QByteArray name = eventName(static_cast<AirwayEventKind>(kind));
        QVERIFY2(!desk.box(name.constData()).isEnabled(), name.constData());
        QVERIFY(!desk.find<QLabel>((name + "NotShown").constData()).isVisible());
    }
    QVERIFY(!desk.find<QComboBox>("airwayPreset").isEnabled());
    QCOMPARE(desk.first(), QStringLiteral("airwayOver"));
}

/// Also each label has the words of the field, with its key and over two lines where it is long.
void TestAirwayPanel::namesAndExplainsEveryControl()
{
    const Desk desk;
    for (int kind = 0; kind < kAirwayEventKinds; ++kind) {
        const auto event = static_cast<AirwayEventKind>(kind);
        const QSpinBox& box = desk.box(eventName(event));
        QVERIFY(box.accessibleName().startsWith(eventText(event)));
        QCOMPARE(box.toolTip(), eventEffect(event));
        const auto& slider =
            desk.find<QSlider>(QByteArray{eventName(event)}.append("Slider").constData());
        QVERIFY(slider.accessibleName().startsWith(eventText(event)));
        QVERIFY(!slider.toolTip().isEmpty());
        int labels = 0;
        for (const QLabel* label : desk.panel.findChildren<QLabel*>())
            if (label->buddy() == &box) {
                const QString words = QString{label->text()}.remove(QLatin1Char{'&'});
                QCOMPARE(words.simplified(), eventText(event));
                ++labels;
            }
        QCOMPARE(labels, 1);
    }
    QVERIFY(!desk.box("airwayOver").accessibleName().isEmpty());
    const auto& presets = desk.find<QComboBox>("airwayPreset");
    QVERIFY(!presets.accessibleName().isEmpty() && !presets.toolTip().isEmpty());
    QVERIFY(!desk.find<QPushButton>("clearAirway").toolTip().isEmpty());
    const auto& positions = desk.find<QComboBox>("headPosition");
    QVERIFY(!positions.accessibleName().isEmpty());
    QVERIFY(positions.toolTip().contains(QStringLiteral("by hand")));
    for (int place = 0; place < positions.count(); ++place)
        QVERIFY(positions.itemData(place, Qt::ToolTipRole)
                    .toString()
                    .startsWith(positions.itemText(place) + QStringLiteral(": ")));
}

void TestAirwayPanel::fitsIntoItsColumn()
{
    Desk desk;
    desk.enter("airwayOver", QStringLiteral("600"));
    desk.enter("pharyngeal_swelling", QStringLiteral("100"));
    desk.enter("external_pressure", QStringLiteral("100"));
    desk.settle();
    desk.head.setPosition(kSniffing);
    desk.settle();
    desk.settle(std::chrono::minutes{1});
    QVERIFY(!desk.text("pharyngeal_swellingNow").isEmpty());
    const QSize least = desk.panel.minimumSizeHint();
    QVERIFY2(least.width() <= kColumn - 20, qPrintable(QString::number(least.width())));
    QVERIFY2(least.height() <= kHeight, qPrintable(QString::number(least.height())));
}

CARINA_SCREEN_TEST(TestAirwayPanel)

} // namespace carina::airway_panel_test

#include "tst_airway_panel.moc"
