#include "engine/io/anatomy_set/anatomy_cache.h"
#include "models/airway/airway_groups.h"
#include "models/airway/airway_presets.h"
#include "models/airway/airway_words.h"
#include "models/patient/session_patient.h"
#include "tests/models/fake_session_node.h"
#include "tests/models/lacking_patient.h"
#include "tests/support/soon.h"
#include "tests/support/test_class.h"
#include "ui/panels/airway/airway_group_bar.h"
#include "ui/panels/airway/airway_panel.h"
#include "widgets/theme/dark_theme.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QSpinBox>

#include <algorithm>
#include <optional>
#include <vector>

namespace carina::airway_panel_test
{

using test::FakeSessionNode;
using test::soon;
using enum AirwayEventKind;

/// The console's controls of what makes an airway difficult.
class TestAirwayPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { applyDarkTheme(*qApp); } // with its letters, which are larger
    void beginsWithTheFirstGroup();
    void hasOneGroupInSightOrAll();
    void leadsByTheKeyOfAGroupToItsFirstEvent();
    void saysHowManyOfAGroupAreSet();
    void marksAGroupOfWhichThePatientDoesNotShowAll();
    void namesTheEventsOfEachGroup();
    void keepsItsHeadingsWhereTheyAre();
    void showsOnlyReasonsOfTheGroup();
    void staysAtTheHeadingWhereNothingCanBeSet();
    void setsASeverityByKeyboardAlone();
    void leadsFromEachEventToTheNextByTab();
    void setsSeverityBySliderAndBox();
    void tellsTheSeverityOfNowWhileItChanges();
    void tellsWhatIsDrawnOfEventsThatFillTheThroat();
    void clearsTheAirwayByItsButton();
    void endsAtOnceWhatGoesSlowly();
    void takesFluidsAwayByTheButtonOfTheirGroup();
    void setsAPresetAsOneChange();
    void saysCustomWhereItIsNoPreset();
    void tellsWhatAPresetSets();
    void saysWhatOfAPresetIsNotDrawn();
    void saysOfWhatAPresetsGradeIsPromised();
    void laysTheHeadByKeyboardOverTheTimeOfAChange();
    void tellsHowTheHeadLies();
    void saysThatAnInfantsNeckFlexesNoFarther();
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

std::vector<AirwayEventKind> kindsAsOffered()
{
    std::vector<AirwayEventKind> kinds;
    for (const AirwayGroup& group : airwayGroups())
        kinds.insert(kinds.end(), group.kinds.begin(), group.kinds.end());
    return kinds;
}

struct Desk {
    FakeSessionNode node;
    SessionModel session{node};
    AirwayEventModel model{session, FakeSessionNode::kStation};
    HeadPositionModel head{session, FakeSessionNode::kStation};
    AirwayPanel panel;
    std::optional<SessionPatient> patient;

    /// With all events in sight.
    explicit Desk(ParticipantId self = FakeSessionNode::kInstructor) : node{self}
    {
        panel.setModels(model, head);
        panel.showGroup(AirwayGroupBar::kAll);
        panel.show();
        QApplication::setActiveWindow(&panel); // the display has no window manager
    }
    void lay(const SharedPatientModel& lying)
    {
        patient.emplace(node, FakeSessionNode::kStation, lying, AnatomyCache::defaultFolder());
        model.setPatient(*patient);
        head.setPatient(*patient);
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
    [[nodiscard]] QPushButton& heading(const QByteArray& name) const
    {
        return find<QPushButton>(QByteArray{"airwayGroup_" + name}.constData());
    }
    [[nodiscard]] QPushButton& heading(const AirwayGroup& group) const
    {
        return heading(QByteArray{group.name.data(), qsizetype(group.name.size())});
    }
    /// Whose boxes, sliders and names are in sight.
    [[nodiscard]] std::vector<AirwayEventKind> inSight() const
    {
        std::vector<AirwayEventKind> kinds;
        for (const AirwayEventKind kind : kindsAsOffered()) {
            const QByteArray name = eventName(kind);
            const bool isSeen = box(name.constData()).isVisible();
            for (const char* part : {"Slider", "Now"})
                if (find<QWidget>((name + part).constData()).isVisible() != isSeen)
                    qFatal("half a row");
            if (isSeen)
                kinds.push_back(kind);
        }
        return kinds;
    }
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

void TestAirwayPanel::beginsWithTheFirstGroup()
{
    AirwayPanel panel;
    panel.show();
    QVERIFY(panel.findChild<QPushButton*>(QStringLiteral("airwayGroup_mouth"))->isChecked());
    QVERIFY(panel.findChild<QSpinBox*>(QStringLiteral("tongue_oedema"))->isVisible());
    QVERIFY(!panel.findChild<QSpinBox*>(QStringLiteral("laryngospasm"))->isVisible());
}

void TestAirwayPanel::hasOneGroupInSightOrAll()
{
    Desk desk;
    for (const AirwayGroup& group : airwayGroups()) {
        QTest::keyClick(&desk.heading(group), Qt::Key_Space);
        const std::vector<AirwayEventKind> seen = desk.inSight();
        QVERIFY(std::ranges::equal(seen, group.kinds));
        for (const AirwayGroup& other : airwayGroups())
            QCOMPARE(desk.heading(other).isChecked(), &other == &group);
        desk.heading(group).click(); // once more
        QVERIFY(desk.heading(group).isChecked());
        QVERIFY(desk.inSight() == seen);
    }
    desk.heading("all").click();
    QVERIFY(desk.inSight() == kindsAsOffered());
    desk.panel.showGroup("nose"); // there is none
    QVERIFY(desk.inSight() == kindsAsOffered());
}

/// From a number that is half typed, too, which is entered.
void TestAirwayPanel::leadsByTheKeyOfAGroupToItsFirstEvent()
{
    Desk desk;
    const QSignalSpy chosen{&desk.panel, &AirwayPanel::groupChosen};
    desk.heading("mouth").click();
    QCOMPARE(QApplication::focusWidget()->objectName(), QStringLiteral("tongue_oedema"));
    desk.type("tongue_oedema", QStringLiteral("30"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_L, Qt::AltModifier);
    const QString first = QStringLiteral("laryngeal_oedema");
    QVERIFY(soon([&first] { return QApplication::focusWidget()->objectName() == first; }));
    QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("60"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
    desk.settle();
    desk.settle();
    QVERIFY(desk.decided() == (AirwayEvents{{TongueOedema, 0.3}, {LaryngealOedema, 0.6}}));
    QCOMPARE(chosen.size(), 2);
    QCOMPARE(chosen.back().front().toByteArray(), QByteArray{"larynx"});
}

/// Whichever group is in sight.
void TestAirwayPanel::saysHowManyOfAGroupAreSet()
{
    Desk desk;
    desk.heading("mouth").click();
    const auto words = [&desk](const char* group) {
        return desk.heading(group).text().remove(QLatin1Char{'&'});
    };
    QCOMPARE(words("larynx"), QStringLiteral("Larynx"));
    desk.node.decide(fact::AirwayEventsSet{
        {{TongueOedema, 1.0}, {LaryngealOedema, 0.4}, {Laryngospasm, 0.01}}, {}});
    desk.settle();
    QCOMPARE(words("mouth"), QStringLiteral("Mouth · 1"));
    QCOMPARE(words("throat"), QStringLiteral("Throat"));
    QCOMPARE(words("larynx"), QStringLiteral("Larynx · 2"));
    const QString set = QStringLiteral("Laryngeal oedema 40\u00a0% + Laryngospasm 1\u00a0%");
    QVERIFY(desk.heading("larynx").toolTip().contains(set));
    QVERIFY(desk.heading("larynx").accessibleDescription().contains(set));
    desk.find<QPushButton>("clearAirway").click();
    QCOMPARE(words("larynx"), QStringLiteral("Larynx")); // as it is requested
    desk.settle();
    QCOMPARE(words("mouth"), QStringLiteral("Mouth"));
}

void TestAirwayPanel::marksAGroupOfWhichThePatientDoesNotShowAll()
{
    Desk desk;
    desk.lay(tongueless());
    desk.node.decide(
        fact::AirwayEventsSet{{{TongueOedema, 0.5}, {Laryngospasm, 1.0}, {AngioOedema, 0.2}}, {}});
    desk.settle();
    const auto words = [&desk](const char* group) {
        return desk.heading(group).text().remove(QLatin1Char{'&'});
    };
    QCOMPARE(words("mouth"), QStringLiteral("Mouth ▲ 2"));
    QCOMPARE(words("larynx"), QStringLiteral("Larynx · 1"));
    const QString told = QStringLiteral("Not shown by this patient: Tongue oedema 50\u00a0%");
    QVERIFY(desk.heading("mouth").toolTip().endsWith(told));
    QVERIFY(desk.heading("mouth").accessibleDescription().endsWith(told));
    QVERIFY(!desk.heading("larynx").toolTip().contains(QStringLiteral("Not shown")));
    desk.lay(test::childWithout(PartRole::Epiglottis)); // shows no event
    QCOMPARE(words("larynx"), QStringLiteral("Larynx ▲ 1"));
}

/// A heading has the words of its group, with its key.
void TestAirwayPanel::namesTheEventsOfEachGroup()
{
    const Desk desk;
    for (const AirwayGroup& group : airwayGroups()) {
        const QPushButton& heading = desk.heading(group);
        QCOMPARE(heading.text(), groupText(group));
        QVERIFY(!heading.shortcut().isEmpty());
        for (const AirwayEventKind kind : group.kinds) {
            QVERIFY2(heading.toolTip().contains(eventText(kind)), eventName(kind));
            QVERIFY2(heading.accessibleDescription().contains(eventText(kind)), eventName(kind));
        }
    }
    QVERIFY(!desk.heading("all").toolTip().isEmpty());
}

void TestAirwayPanel::keepsItsHeadingsWhereTheyAre()
{
    Desk desk;
    desk.panel.resize(kColumn - 20, 700);
    QCoreApplication::sendPostedEvents();
    const auto places = [&desk] {
        QCoreApplication::sendPostedEvents();
        QList<QRect> all;
        for (const AirwayGroup& group : airwayGroups())
            all +=
                QRect{desk.heading(group).mapTo(&desk.panel, QPoint{}), desk.heading(group).size()};
        return all;
    };
    desk.heading(airwayGroups().back()).click(); // all events are higher than the panel
    desk.settle();
    const QList<QRect> before = places();
    for (const AirwayGroup& group : airwayGroups()) {
        desk.heading(group).click();
        QCOMPARE(places(), before);
    }
    desk.model.setEvents(presetNamed("anaphylaxis")->events);
    desk.settle();
    QCOMPARE(places(), before);
}

void TestAirwayPanel::showsOnlyReasonsOfTheGroup()
{
    Desk desk;
    desk.heading("larynx").click();
    desk.lay(tongueless());
    QVERIFY(!desk.find<QLabel>("tongue_oedemaNotShown").isVisible());
    desk.heading("mouth").click();
    QVERIFY(desk.find<QLabel>("tongue_oedemaNotShown").isVisible());
    QCOMPARE(QApplication::focusWidget()->objectName(), QStringLiteral("angio_oedema"));
}

/// Which an observer can look through.
void TestAirwayPanel::staysAtTheHeadingWhereNothingCanBeSet()
{
    Desk desk{FakeSessionNode::kObserver};
    desk.lay(test::childWithout(PartRole::Epiglottis)); // shows no event
    for (const AirwayGroup& group : airwayGroups()) {
        QPushButton& heading = desk.heading(group);
        heading.setFocus();
        QTest::keyClick(&heading, Qt::Key_Space);
        QCOMPARE(QApplication::focusWidget(), static_cast<QWidget*>(&heading));
        QVERIFY(std::ranges::equal(desk.inSight(), group.kinds));
    }
}

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

void TestAirwayPanel::leadsFromEachEventToTheNextByTab()
{
    Desk desk;
    desk.panel.setFocus();
    for (const AirwayEventKind kind : kindsAsOffered()) {
        const QString name = QLatin1String{eventName(kind)};
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

/// Of three at 100 % each is drawn at two thirds.
void TestAirwayPanel::tellsWhatIsDrawnOfEventsThatFillTheThroat()
{
    Desk desk;
    desk.node.decide(fact::AirwayEventsSet{
        {{TongueOedema, 1.0}, {PharyngealSwelling, 1.0}, {LaryngealOedema, 1.0}}, {}});
    desk.settle();
    const auto& tongue = desk.find<QLabel>("tongue_oedemaNow");
    QVERIFY(tongue.text().isEmpty() && tongue.toolTip().isEmpty());
    desk.enter("epiglottitis", QStringLiteral("100"));
    desk.settle();
    for (const char* name : {"tongue_oedemaNow", "pharyngeal_swellingNow", "epiglottitisNow"})
        QCOMPARE(desk.text(name), QStringLiteral("drawn 67\u00a0%"));
    QVERIFY(tongue.toolTip().contains(QStringLiteral("share its room")));
    QVERIFY(desk.text("laryngeal_oedemaNow").isEmpty());
    QCOMPARE(desk.box("tongue_oedema").value(), 100);
    desk.enter("airwayOver", QStringLiteral("10"));
    desk.enter("pharyngeal_swelling", QStringLiteral("0"));
    desk.settle();
    desk.settle(std::chrono::seconds{5}); // at 50 % of 2.5 together
    QCOMPARE(desk.text("pharyngeal_swellingNow"), QStringLiteral("drawn 40\u00a0%"));
    QCOMPARE(desk.text("tongue_oedemaNow"), QStringLiteral("drawn 80\u00a0%"));
    desk.settle(std::chrono::seconds{5});
    QVERIFY(tongue.text().isEmpty() && tongue.toolTip().isEmpty());
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

void TestAirwayPanel::endsAtOnceWhatGoesSlowly()
{
    Desk desk;
    auto& clear = desk.find<QPushButton>("clearAirway");
    desk.node.decide(fact::AirwayEventsSet{{{TongueOedema, 1.0}}, {}});
    desk.settle();
    desk.enter("airwayOver", QStringLiteral("600"));
    clear.click();
    desk.settle();
    desk.settle(std::chrono::seconds{60});
    QVERIFY(desk.decided().empty());
    QCOMPARE(desk.text("tongue_oedemaNow"), QStringLiteral("now 90\u00a0%"));
    QVERIFY(clear.isEnabled());
    desk.box("airwayOver").setValue(0);
    clear.click();
    desk.settle();
    QVERIFY(desk.text("tongue_oedemaNow").isEmpty());
    QVERIFY(!clear.isEnabled());
}

void TestAirwayPanel::takesFluidsAwayByTheButtonOfTheirGroup()
{
    Desk desk;
    const auto& suction = desk.find<QPushButton>("suction");
    desk.panel.showGroup("larynx");
    QVERIFY(!suction.isVisible());
    desk.panel.showGroup("fluids");
    QVERIFY(suction.isVisible() && !suction.isEnabled());
    desk.node.decide(fact::AirwayEventsSet{{{Laryngospasm, 1.0}, {Vomit, 0.5}}, {}});
    desk.settle();
    QVERIFY(suction.isEnabled());
    QTest::keyClick(&desk.find<QPushButton>("suction"), Qt::Key_Space);
    desk.settle();
    QCOMPARE(desk.decided(), (AirwayEvents{{Laryngospasm, 1.0}}));
    desk.settle(kSuction);
    QVERIFY(!suction.isEnabled());
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

/// Before it is chosen, and what is set where it is none.
void TestAirwayPanel::tellsWhatAPresetSets()
{
    Desk desk;
    const auto& presets = desk.find<QComboBox>("airwayPreset");
    for (const AirwayPreset& preset : airwayPresets()) {
        const int place = presets.findText(presetText(preset));
        const QString told = presets.itemData(place, Qt::ToolTipRole).toString();
        QVERIFY(told.startsWith(eventsText(preset.events)));
        QVERIFY(told.endsWith(limitsText(preset)));
    }
    const AirwayEvents bloody{{Laryngospasm, 0.5}, {Blood, 0.3}};
    desk.model.setEvents(bloody);
    QCOMPARE(presets.accessibleDescription(), eventsText(bloody));
}

void TestAirwayPanel::saysWhatOfAPresetIsNotDrawn()
{
    Desk desk;
    const auto& condition = desk.find<QLabel>("airwayPresetCondition");
    desk.model.setEvents(presetNamed("trauma_collar")->events);
    desk.settle();
    QVERIFY(condition.isVisible());
    QVERIFY(condition.text().contains(QStringLiteral("No collar is drawn")));
    desk.model.setEvents(presetNamed("obese")->events);
    desk.settle();
    QVERIFY(!condition.isVisible());
}

/// As long as the preset stands and the head does not lie so; of one that is named for the eye, as
/// the live picture is the camera's.
void TestAirwayPanel::saysOfWhatAPresetsGradeIsPromised()
{
    Desk desk;
    const auto& condition = desk.find<QLabel>("airwayPresetCondition");
    QVERIFY(!condition.isVisible());
    desk.model.setEvents(presetNamed("cormack_lehane_4")->events);
    desk.settle();
    QVERIFY(condition.isVisible());
    QCOMPARE(condition.text(),
             QStringLiteral("Grade 4 is promised only of an adult with the head in the position "
                            "Sniffing, to the eye that looks past a Macintosh 3 lifted as usual. "
                            "The picture of the laryngoscope is of its camera, which sees more."));
    QVERIFY(
        desk.find<QComboBox>("airwayPreset").accessibleDescription().endsWith(condition.text()));
    desk.head.setPosition(kSniffing); // of which its stiff neck leaves little
    desk.settle();
    QVERIFY(condition.isVisible());
    desk.model.setEvents(presetNamed("cormack_lehane_1")->events);
    desk.settle();
    QCOMPARE(condition.text(),
             QStringLiteral("Grade 1 is promised only of an adult with the head in the position "
                            "Neutral, in the camera of a Macintosh 3 lifted as usual."));
    desk.head.setPosition({});
    desk.settle();
    QVERIFY(!condition.isVisible());
    desk.model.setEvents(presetNamed("spasm")->events); // promises none
    desk.settle();
    QVERIFY(!condition.isVisible());
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

/// By 22 degrees (TestNeckField).
void TestAirwayPanel::saysThatAnInfantsNeckFlexesNoFarther()
{
    Desk desk;
    desk.lay(test::landmarksOf("newborn, 50 cm, girl"));
    const auto& limit = desk.find<QLabel>("headPositionLimit");
    QVERIFY(!limit.isVisible());
    desk.head.setPosition(kSniffing);
    desk.settle();
    QCOMPARE(desk.find<QComboBox>("headPosition").currentText(), QStringLiteral("Sniffing"));
    QCOMPARE(desk.text("headPositionNow"), QStringLiteral("neck 22° flexed\nhead 24° extended"));
    QVERIFY(limit.isVisible());
    QCOMPARE(limit.text(), QStringLiteral("This patient's neck flexes no farther."));
    const int least = desk.panel.minimumSizeHint().width();
    QVERIFY2(least <= kColumn - 20, qPrintable(QString::number(least)));
    desk.head.setPosition(kHeadExtended);
    desk.settle();
    QVERIFY(!limit.isVisible());
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

/// And over the headings of the groups.
void TestAirwayPanel::leadsFromTheTimeOverTheHeadToTheEventsByTab()
{
    Desk desk;
    desk.node.decide(fact::AirwayEventsSet{{{Laryngospasm, 1.0}}, {}}); // there is one to clear
    desk.settle();
    desk.box("airwayOver").setFocus();
    for (const char* name :
         {"airwayOver", "clearAirway", "headPosition", "airwayGroup_mouth", "airwayGroup_throat",
          "airwayGroup_larynx", "airwayGroup_neck", "airwayGroup_fluids", "airwayGroup_helper",
          "airwayGroup_all", "tongue_oedema"}) {
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
    QCOMPARE(desk.first(), QStringLiteral("airwayGroup_all"));
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
    QCOMPARE(desk.text("angio_oedemaNotShown"),
             QStringLiteral("Shown in part: this patient has no tongue of its own."));
    QVERIFY(desk.box("angio_oedema").isEnabled());
    QVERIFY(!desk.find<QLabel>("airwayNotShown").isVisible());
    QCOMPARE(desk.first(), QStringLiteral("angio_oedema"));
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

/// Also each label has the words of the field, over two lines where it is long.
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
                QCOMPARE(label->text().simplified(), eventText(event));
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

/// With the longest words.
void TestAirwayPanel::fitsIntoItsColumn()
{
    Desk desk;
    AirwayEvents all;
    for (int kind = 0; kind < kAirwayEventKinds; ++kind)
        all.push_back({static_cast<AirwayEventKind>(kind), 0.5});
    desk.node.decide(fact::AirwayEventsSet{all, {}});
    desk.settle();
    desk.enter("airwayOver", QStringLiteral("600"));
    desk.enter("pharyngeal_swelling", QStringLiteral("100"));
    desk.enter("external_pressure", QStringLiteral("100"));
    desk.settle();
    desk.head.setPosition(kSniffing);
    desk.settle();
    desk.settle(std::chrono::minutes{1});
    QVERIFY(!desk.text("pharyngeal_swellingNow").isEmpty());
    const int least = desk.panel.minimumSizeHint().width();
    QVERIFY2(least <= kColumn - 20, qPrintable(QString::number(least)));
}

CARINA_SCREEN_TEST(TestAirwayPanel)

} // namespace carina::airway_panel_test

#include "tst_airway_panel.moc"
