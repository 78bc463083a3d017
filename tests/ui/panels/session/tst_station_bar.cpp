#include "tests/models/fake_session_node.h"
#include "tests/support/soon.h"
#include "tests/support/test_class.h"
#include "ui/panels/session/station_bar.h"
#include "ui/panels/session/station_dialog.h"
#include "widgets/second_press.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabBar>
#include <QToolButton>

namespace carina::station_bar_test
{

using test::FakeSessionNode;

constexpr StationId kRoom{1};

class TestStationBar : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasATabForEachStation();
    void choosesTheStationByKeyboard();
    void addsAStationByKeyboard();
    void offersPatientsFromInfantToAdult();
    void takesNoNameThatIsThereAndNoUnknownPatient();
    void namesAStationAnew();
    void closesOnTheSecondPressOnly();
    void closesNoStationThatWasNotAskedAbout();
    void offersAllStationsWhereThereAreSeveral();
    void showsNamesThatTellStationsApart();
    void choosesTheStationFromAListWhereThereAreMany();
};

namespace
{

struct Bar {
    FakeSessionNode node;
    SessionModel session{node};
    StationsModel stations{session};
    StationBar bar;
    QTabBar& tabs = *bar.findChild<QTabBar*>();
    QCheckBox& forAll = *bar.findChild<QCheckBox*>();

    Bar() { bar.setModel(stations); }
    [[nodiscard]] QToolButton& button(const char* name) const
    {
        return *bar.findChild<QToolButton*>(QLatin1String{name});
    }
    static void press(QWidget& widget)
    {
        QTest::keyClick(&widget, Qt::Key_Space);
        QCoreApplication::sendPostedEvents();
        QCoreApplication::sendPostedEvents(); // what the models proposed then
    }
    /// As long as a person pauses who means it.
    static void pause()
    {
        bool isOver = false;
        QTimer::singleShot(SecondPress::kLeastPause + std::chrono::milliseconds{100}, qApp,
                           [&isOver] { isOver = true; });
        QVERIFY(test::soon([&isOver] { return isOver; }));
    }
    void addRoom()
    {
        node.addStation("Room & hall");
        QCoreApplication::sendPostedEvents();
    }
    QComboBox& list = *bar.findChild<QComboBox*>(QStringLiteral("stationList"));
    void show()
    {
        bar.resize(1000, 40);
        bar.show();
        QVERIFY(QTest::qWaitForWindowExposed(&bar));
    }
    void resizeTo(int width)
    {
        bar.resize(width, bar.height());
        QCoreApplication::sendPostedEvents();
    }
    [[nodiscard]] StationDialog& asked() const { return *bar.findChild<StationDialog*>(); }
    template <class Widget> [[nodiscard]] Widget& field(const char* name) const
    {
        return *asked().findChild<Widget*>(QLatin1String{name});
    }
};

} // namespace

void TestStationBar::hasATabForEachStation()
{
    Bar bar;
    QCOMPARE(bar.tabs.count(), 1);
    QCOMPARE(bar.tabs.tabText(0), QStringLiteral("Station 1: 3 here"));
    bar.addRoom();
    QCOMPARE(bar.tabs.count(), 2);
    QCOMPARE(bar.tabs.tabText(1), QStringLiteral("Room && hall: 0 here")); // no mnemonic
    QCOMPARE(bar.tabs.currentIndex(), 0);
    QCOMPARE(bar.stations.shown(), FakeSessionNode::kStation); // nothing was chosen
    bar.stations.show(kRoom);
    QCOMPARE(bar.tabs.currentIndex(), 1);
}

void TestStationBar::choosesTheStationByKeyboard()
{
    Bar bar;
    bar.addRoom();
    QTest::keyClick(&bar.tabs, Qt::Key_Right);
    QCOMPARE(bar.stations.shown(), kRoom);
    QTest::keyClick(&bar.tabs, Qt::Key_Left);
    QCOMPARE(bar.stations.shown(), FakeSessionNode::kStation);
}

void TestStationBar::addsAStationByKeyboard()
{
    Bar bar;
    Bar::press(bar.button("add"));
    QTest::keyClicks(&bar.field<QLineEdit>("name"), QStringLiteral("Room 5"));
    auto& patient = bar.field<QComboBox>("patient");
    patient.setEditText(QStringLiteral("8 years, 128 cm, girl"));
    Bar::press(bar.field<QPushButton>("accept"));
    const auto state = bar.node.state();
    QCOMPARE(state->stations().at(kRoom).name, std::string{"Room 5"});
    QCOMPARE(state->stations().at(kRoom).anatomyName, std::string{"8 years, 128 cm, girl"});
    QCOMPARE(bar.tabs.currentIndex(), 1);
}

void TestStationBar::offersPatientsFromInfantToAdult()
{
    Bar bar;
    Bar::press(bar.button("add"));
    auto& patient = bar.field<QComboBox>("patient");
    bar.field<QLineEdit>("name").setText(QStringLiteral("Room 5"));
    for (int place = 0; place < patient.count(); ++place) {
        patient.setCurrentIndex(place);
        QVERIFY2(bar.field<QPushButton>("accept").isEnabled(), qPrintable(patient.currentText()));
    }
    QVERIFY(patient.findText(QStringLiteral("1 year"), Qt::MatchStartsWith) >= 0);
}

void TestStationBar::takesNoNameThatIsThereAndNoUnknownPatient()
{
    Bar bar;
    Bar::press(bar.button("add"));
    auto& name = bar.field<QLineEdit>("name");
    auto& accept = bar.field<QPushButton>("accept");
    QVERIFY(!accept.isEnabled()); // no name yet
    name.setText(QStringLiteral("station 1"));
    QVERIFY(!accept.isEnabled());
    QVERIFY(bar.field<QLabel>("fault").text().contains(QStringLiteral("Station 1")));
    name.setText(QStringLiteral("Room 5"));
    QVERIFY(accept.isEnabled());
    QVERIFY(bar.field<QLabel>("fault").text().isEmpty());
    bar.field<QComboBox>("patient").setEditText(QStringLiteral("somebody"));
    QVERIFY(!accept.isEnabled());
    QVERIFY(!bar.field<QLabel>("fault").text().isEmpty());
}

void TestStationBar::namesAStationAnew()
{
    Bar bar;
    bar.addRoom();
    bar.stations.show(kRoom);
    Bar::press(bar.button("rename"));
    auto& name = bar.field<QLineEdit>("name");
    QCOMPARE(name.text(), QStringLiteral("Room & hall"));
    QVERIFY(bar.field<QComboBox>("patient").isHidden());
    name.setText(QStringLiteral("Hall"));
    Bar::press(bar.field<QPushButton>("accept"));
    QCOMPARE(bar.tabs.tabText(1), QStringLiteral("Hall: 0 here"));
}

void TestStationBar::closesOnTheSecondPressOnly()
{
    Bar bar;
    auto& close = bar.button("close");
    QVERIFY(!close.isEnabled()); // the only station
    bar.addRoom();
    QVERIFY(!close.isEnabled()); // participants are there
    QVERIFY(close.toolTip().contains(QStringLiteral("Tom")));
    bar.stations.show(kRoom);
    QVERIFY(close.isEnabled());
    Bar::press(close);
    QCOMPARE(close.text(), QStringLiteral("Really?"));
    QVERIFY(bar.node.state()->isOpen(kRoom));
    Bar::press(close); // a double click
    QVERIFY(bar.node.state()->isOpen(kRoom));
    Bar::pause();
    Bar::press(close);
    QVERIFY(!bar.node.state()->isOpen(kRoom));
    QCOMPARE(bar.tabs.count(), 1);
    QCOMPARE(close.text(), QStringLiteral("Close"));
}

// Between the presses another station came to be shown.
void TestStationBar::closesNoStationThatWasNotAskedAbout()
{
    Bar bar;
    bar.addRoom();
    bar.node.addStation("Hall");
    QCoreApplication::sendPostedEvents();
    bar.stations.show(kRoom);
    Bar::press(bar.button("close"));
    bar.stations.show(StationId{2});
    Bar::pause();
    QCOMPARE(bar.button("close").text(), QStringLiteral("Close"));
    Bar::press(bar.button("close"));
    QVERIFY(bar.node.state()->isOpen(kRoom));
    QVERIFY(bar.node.state()->isOpen(StationId{2}));
}

void TestStationBar::offersAllStationsWhereThereAreSeveral()
{
    Bar bar;
    QVERIFY(!bar.forAll.isEnabled());
    bar.addRoom();
    QVERIFY(bar.forAll.isEnabled());
    Bar::press(bar.forAll);
    QVERIFY(bar.stations.isForAll());
    Bar::press(bar.forAll);
    QVERIFY(!bar.stations.isForAll());
}

/// Each tab is in sight, whole, with its number of participants and enough of its name.
void TestStationBar::showsNamesThatTellStationsApart()
{
    const QString longName = QStringLiteral("The room at the end of the long corridor");
    Bar bar;
    bar.addRoom();
    bar.node.addStation(qPrintable(longName));
    QCoreApplication::sendPostedEvents();
    bar.show();
    int whole = 0;
    int elided = 0;
    int listed = 0;
    for (int width = 1400; width > 300; width -= 20) {
        bar.resizeTo(width);
        QVERIFY(bar.tabs.isVisible() != bar.list.isVisible());
        if (bar.list.isVisible()) {
            ++listed;
            continue;
        }
        QCOMPARE(listed, 0); // there was less room
        QCOMPARE(bar.tabs.tabText(0), QStringLiteral("Station 1: 3 here"));
        for (int tab = 0; tab < bar.tabs.count(); ++tab) {
            QVERIFY(bar.tabs.rect().contains(bar.tabs.tabRect(tab)));
            QVERIFY(bar.tabs.tabText(tab).endsWith(QStringLiteral(" here")));
        }
        const bool isElided = bar.tabs.tabText(2).contains(QChar{0x2026});
        QCOMPARE(bar.tabs.tabText(2).startsWith(longName), !isElided);
        QVERIFY(bar.tabs.tabToolTip(2).contains(longName));
        ++(isElided ? elided : whole);
    }
    QVERIFY(whole > 0 && elided > 0 && listed > 0);
}

void TestStationBar::choosesTheStationFromAListWhereThereAreMany()
{
    Bar bar;
    for (const char* name : {"Room 2", "Room 3", "Room 4", "Room 5", "Room 6", "Room 7", "Room 8"})
        bar.node.addStation(name);
    QCoreApplication::sendPostedEvents();
    bar.show();
    bar.resizeTo(600);
    QVERIFY(bar.list.isVisible());
    QCOMPARE(bar.list.count(), 8);
    QCOMPARE(bar.list.currentText(), QStringLiteral("Station 1: 3 here"));
    QTest::keyClick(&bar.list, Qt::Key_Down);
    QCOMPARE(bar.stations.shown(), kRoom);
    bar.stations.show(FakeSessionNode::kStation);
    QCOMPARE(bar.list.currentIndex(), 0);
    QCOMPARE(bar.list.accessibleName(), QStringLiteral("Station that is shown"));
}

CARINA_SCREEN_TEST(TestStationBar)

} // namespace carina::station_bar_test

#include "tst_station_bar.moc"
