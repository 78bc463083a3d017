#include "tests/models/fake_session_node.h"
#include "tests/support/soon.h"
#include "tests/support/test_class.h"
#include "ui/panels/people/participants_panel.h"
#include "ui/panels/people/remove_dialog.h"

#include <QCheckBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScopeGuard>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QToolButton>

#include <algorithm>

namespace carina::participants_panel_test
{

using test::FakeSessionNode;

class TestParticipantsPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void offersNothingBeforeSomebodyIsChosen();
    void mutesByKeyboardAndTakesItBack();
    void removesWithAReasonAndLetsBackIn();
    void removesNobodyWhenCancelled();
    void removesNobodyByEnterAlone();
    void takesNoReasonThatIsTooLong();
    void givesTheWorkByKeyboard();
    void choosesAPlaceForSomebodyWhoseHeadIsShared();
    void locksTheSession();
    void keepsWhoWasChosenWhenSomebodyComesIn();
    void movesToAnotherStationWhereThereIsOne();
    void showsTheFiguresOfWhoIsChosen();
    void saysWhyWorkAndPlaceAreNotOffered();
    void needsNoScrollingInALowDock();
    void keepsItsHeadingsWhole();
    void keepsStatesInSightBesideALongName();
    void tellsOfRegistrationsWhereThereAreSome();
};

namespace
{

constexpr int kTraineeRow = 1;

struct Panel {
    FakeSessionNode node;
    SessionModel session{node};
    ParticipantsModel participants{session};
    ConductModel conduct{session};
    StationsModel stations{session};
    PeopleModel people{session, FakeSessionNode::kStation};
    ParticipantsPanel panel;
    QTableView& table = *panel.findChild<QTableView*>();
    QPushButton& mute = button("mute");
    QPushButton& remove = button("remove");
    QPushButton& work = button("work");
    QPushButton& place = button("place");
    QCheckBox& lock = *panel.findChild<QCheckBox*>(QStringLiteral("lock"));

    Panel() { panel.setModel(participants, conduct, stations, people); }
    [[nodiscard]] QPushButton& button(const char* name) const
    {
        return *panel.findChild<QPushButton*>(QLatin1String{name});
    }
    void chooseTom() const { table.setCurrentIndex(participants.index(kTraineeRow, 0)); }
    static void press(QWidget& widget)
    {
        QTest::keyClick(&widget, Qt::Key_Space);
        QCoreApplication::sendPostedEvents();
    }
    [[nodiscard]] RemoveDialog& asked() const { return *panel.findChild<RemoveDialog*>(); }
    [[nodiscard]] Participant tom() const
    {
        return node.state()->participants().at(FakeSessionNode::kTrainee);
    }
};

} // namespace

void TestParticipantsPanel::movesToAnotherStationWhereThereIsOne()
{
    Panel panel;
    auto& move = *panel.panel.findChild<QToolButton*>(QStringLiteral("move"));
    QVERIFY(move.isHidden());
    QVERIFY(panel.table.isColumnHidden(ParticipantsModel::Station));
    panel.node.addStation("Room & hall");
    QCoreApplication::sendPostedEvents();
    QVERIFY(!move.isHidden() && !move.isEnabled());
    QVERIFY(!panel.table.isColumnHidden(ParticipantsModel::Station));
    panel.chooseTom();
    QVERIFY(move.isEnabled());
    QCOMPARE(move.accessibleDescription(), QStringLiteral("Tom"));
    Q_EMIT move.menu()->aboutToShow();
    const QList<QAction*> offered = move.menu()->actions();
    QCOMPARE(offered.size(), 2);
    QVERIFY(offered[0]->isChecked() && !offered[0]->isEnabled()); // where he is
    QCOMPARE(offered[1]->text(), QStringLiteral("Room && hall"));
    offered[1]->trigger();
    QCOMPARE(panel.tom().station, StationId{1});
}

void TestParticipantsPanel::showsTheFiguresOfWhoIsChosen()
{
    Panel panel;
    const auto& figures = *panel.panel.findChild<QLabel*>(QStringLiteral("sameFigures"));
    panel.node.pathReports.push_back(
        {.peer = FakeSessionNode::kTrainee, .meanDelay = std::chrono::milliseconds{40}});
    const auto see = [&panel](double drift_mm) {
        panel.node.reports = {
            {FakeSessionNode::kTube, std::chrono::milliseconds{41}, 0.03, drift_mm, 100.0, 200.0}};
        panel.node.announce();
        QCoreApplication::sendPostedEvents();
    };
    see(8.9);
    QVERIFY(figures.text().isEmpty());
    panel.panel.choose(FakeSessionNode::kTrainee);
    QVERIFY2(figures.text().contains(QStringLiteral("8.9")), qPrintable(figures.text()));
    see(7.1);
    QVERIFY2(figures.text().contains(QStringLiteral("7.1")), qPrintable(figures.text()));
    panel.table.setCurrentIndex(panel.participants.index(0, 0)); // oneself
    QVERIFY(figures.text().isEmpty());
}

void TestParticipantsPanel::saysWhyWorkAndPlaceAreNotOffered()
{
    Panel panel;
    const auto& obstacles = *panel.panel.findChild<QLabel*>(QStringLiteral("obstacles"));
    QVERIFY(obstacles.text().isEmpty());
    panel.chooseTom();
    const QString atWork = QStringLiteral("Tom is at work already.");
    const QString noHead = QStringLiteral("Tom shares no head that could be placed.");
    QCOMPARE(obstacles.text(), atWork + QLatin1Char{' '} + noHead);
    QCOMPARE(panel.work.accessibleDescription(), atWork);
    QCOMPARE(panel.place.accessibleDescription(), noHead);
    panel.node.decide(fact::ObjectShared{{}, FakeSessionNode::kTrainee, ObjectKind::Head, "Head"});
    QCoreApplication::sendPostedEvents();
    QCOMPARE(obstacles.text(), atWork);
    QCOMPARE(panel.place.accessibleDescription(), QStringLiteral("Tom"));
    panel.node.decide(fact::ParticipantLeft{FakeSessionNode::kTrainee});
    QCoreApplication::sendPostedEvents();
    QCOMPARE(obstacles.text(), QStringLiteral("Tom is not here any more.")); // once
}

/// As in a console of 1280x800, with somebody chosen of whom there are figures.
void TestParticipantsPanel::needsNoScrollingInALowDock()
{
    Panel panel;
    panel.node.addStation("Room 5");
    panel.node.pathReports.push_back(
        {.peer = FakeSessionNode::kTrainee, .meanDelay = std::chrono::milliseconds{40}});
    panel.node.reports = {
        {FakeSessionNode::kTube, std::chrono::milliseconds{41}, 0.03, 8.9, 100.0, 200.0}};
    panel.node.announce();
    QCoreApplication::sendPostedEvents();
    QScrollArea dock;
    dock.setFrameShape(QFrame::NoFrame);
    dock.setWidgetResizable(true);
    dock.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    dock.setWidget(&panel.panel);
    const auto apart = qScopeGuard([&dock] { dock.takeWidget(); });
    dock.resize(430, 300);
    dock.show();
    QVERIFY(QTest::qWaitForWindowExposed(&dock));
    panel.chooseTom();
    QVERIFY(!panel.panel.findChild<QLabel*>(QStringLiteral("sameFigures"))->text().isEmpty());
    QCoreApplication::processEvents();
    QCOMPARE(dock.verticalScrollBar()->maximum(), 0);
    for (const QWidget* each : std::initializer_list<const QWidget*>{
             &panel.mute, &panel.remove, &panel.work, &panel.place, &panel.lock}) {
        const QRect at{each->mapTo(&panel.panel, QPoint{}), each->size()};
        QVERIFY2(panel.panel.rect().contains(at), qPrintable(each->objectName()));
    }
}

/// However narrow it is: then it is scrolled.
void TestParticipantsPanel::keepsItsHeadingsWhole()
{
    Panel panel;
    panel.node.decide(fact::RegistrationStated{{RegistrationState::Missing, {}, {}}},
                      FakeSessionNode::kTrainee);
    panel.panel.resize(240, 300);
    panel.panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel.panel));
    QCoreApplication::processEvents();
    const QHeaderView& header = *panel.table.horizontalHeader();
    int seen = 0;
    for (int column = 0; column < header.count(); ++column) {
        if (header.isSectionHidden(column))
            continue;
        ++seen;
        QVERIFY2(
            header.sectionSize(column) >= header.sectionSizeHint(column),
            qPrintable(
                panel.participants.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString()));
    }
    QCOMPARE(seen, 7);
}

/// Which is whole, in several lines.
void TestParticipantsPanel::keepsStatesInSightBesideALongName()
{
    const QString name = QStringLiteral("Maximiliane-Charlotte von Hohenlohe-Abcd");
    constexpr int kLongRow = 3;
    Panel panel;
    panel.node.decide(fact::ParticipantJoined{{}, Role::Trainee, name.toStdString()});
    QCoreApplication::sendPostedEvents();
    QCOMPARE(panel.participants.rowCount(), kLongRow + 1);
    panel.panel.resize(1200, 400);
    panel.panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel.panel));
    QCoreApplication::processEvents();
    const QTableView& table = panel.table;
    const int around = panel.panel.width() - table.viewport()->width();
    const int beside = table.columnWidth(ParticipantsModel::State)
                       + table.columnWidth(ParticipantsModel::Delay)
                       + table.columnWidth(ParticipantsModel::Same);
    const int third = std::max(100, table.fontMetrics().horizontalAdvance(name) / 3);
    panel.panel.resize(around + beside + third, 400);
    const auto isInSight = [&table](int column) {
        const int left = table.columnViewportPosition(column);
        return left >= 0 && left + table.columnWidth(column) <= table.viewport()->width();
    };
    const auto height = [&table](int row) { return table.rowHeight(row); };
    QVERIFY(test::soon([&] {
        return isInSight(ParticipantsModel::State) && isInSight(ParticipantsModel::Delay)
               && isInSight(ParticipantsModel::Same) && height(kLongRow) > height(kTraineeRow);
    }));
    QVERIFY(height(kLongRow)
            >= static_cast<const QAbstractItemView&>(table).sizeHintForRow(kLongRow));
    panel.panel.resize(1200, 400); // there is room for it
    QVERIFY(test::soon([&] { return height(kLongRow) == height(kTraineeRow); }));
}

void TestParticipantsPanel::tellsOfRegistrationsWhereThereAreSome()
{
    Panel panel;
    QVERIFY(panel.table.isColumnHidden(ParticipantsModel::Registration));
    panel.node.decide(fact::RegistrationStated{{RegistrationState::Missing, {}, {}}},
                      FakeSessionNode::kTrainee);
    QCoreApplication::sendPostedEvents();
    QVERIFY(!panel.table.isColumnHidden(ParticipantsModel::Registration));
    panel.node.decide(fact::ParticipantLeft{FakeSessionNode::kTrainee});
    QCoreApplication::sendPostedEvents();
    QVERIFY(panel.table.isColumnHidden(ParticipantsModel::Registration));
}

void TestParticipantsPanel::offersNothingBeforeSomebodyIsChosen()
{
    const Panel panel;
    QVERIFY(!panel.mute.isEnabled() && !panel.remove.isEnabled());
    QVERIFY(panel.lock.isEnabled());
    panel.table.setCurrentIndex(panel.participants.index(0, 0)); // oneself
    QVERIFY(!panel.mute.isEnabled() && !panel.remove.isEnabled());
    panel.chooseTom();
    QVERIFY(panel.mute.isEnabled() && panel.remove.isEnabled());
    QCOMPARE(panel.remove.accessibleDescription(), QStringLiteral("Tom"));
}

void TestParticipantsPanel::mutesByKeyboardAndTakesItBack()
{
    Panel panel;
    panel.chooseTom();
    Panel::press(panel.mute);
    QVERIFY(panel.tom().muted);
    QCOMPARE(panel.mute.text(), QStringLiteral("Un&mute"));
    Panel::press(panel.mute);
    QVERIFY(!panel.tom().muted);
    QCOMPARE(panel.mute.text(), QStringLiteral("&Mute"));
}

void TestParticipantsPanel::removesWithAReasonAndLetsBackIn()
{
    Panel panel;
    QSignalSpy banned{&panel.panel, &ParticipantsPanel::banned};
    panel.chooseTom();
    Panel::press(panel.remove);
    RemoveDialog& dialog = panel.asked();
    QVERIFY(panel.tom().present); // not before it is confirmed
    QTest::keyClicks(dialog.findChild<QLineEdit*>(), QStringLiteral("too loud "));
    Panel::press(*dialog.findChild<QCheckBox*>());
    Panel::press(*dialog.findChild<QPushButton*>(QStringLiteral("remove")));
    QVERIFY(!panel.tom().present);
    QVERIFY(panel.tom().removal->banned);
    QCOMPARE(banned.count(), 1); // the code is known to who is out
    QCOMPARE(banned.first().first().value<Role>(), Role::Trainee);
    QCOMPARE(panel.tom().removal->reason, std::string{"too loud"});
    QCOMPARE(panel.remove.text(), QStringLiteral("L&et back in"));
    QVERIFY(!panel.mute.isEnabled());
    Panel::press(panel.remove);
    QVERIFY(!panel.tom().removal->banned);
    QCOMPARE(panel.remove.text(), QStringLiteral("R&emove…"));
}

void TestParticipantsPanel::removesNobodyWhenCancelled()
{
    Panel panel;
    panel.chooseTom();
    Panel::press(panel.remove);
    QTest::keyClick(&panel.asked(), Qt::Key_Escape);
    QVERIFY(panel.tom().present && !panel.tom().removal);
}

void TestParticipantsPanel::removesNobodyByEnterAlone()
{
    Panel panel;
    panel.chooseTom();
    Panel::press(panel.remove);
    RemoveDialog& dialog = panel.asked();
    QVERIFY(QTest::qWaitForWindowExposed(&dialog)); // the default is settled when it is shown
    QTest::keyClick(dialog.findChild<QLineEdit*>(), Qt::Key_Return);
    QVERIFY(!dialog.isVisible());
    QVERIFY(panel.tom().present && !panel.tom().removal);
}

void TestParticipantsPanel::takesNoReasonThatIsTooLong()
{
    RemoveDialog dialog{QStringLiteral("Tom")};
    auto& reason = *dialog.findChild<QLineEdit*>();
    auto& remove = *dialog.findChild<QPushButton*>(QStringLiteral("remove"));
    reason.setText(QString(64, QLatin1Char('x')));
    QVERIFY(remove.isEnabled());
    reason.setText(QString(65, QLatin1Char('x')));
    QVERIFY(!remove.isEnabled());
    QVERIFY(!reason.accessibleName().isEmpty());
}

void TestParticipantsPanel::givesTheWorkByKeyboard()
{
    Panel panel;
    QVERIFY(!panel.work.isEnabled());
    panel.chooseTom(); // who is at work already
    QVERIFY(!panel.work.isEnabled());
    panel.table.setCurrentIndex(panel.participants.index(0, 0));
    QVERIFY(panel.work.isEnabled());
    QCOMPARE(panel.work.accessibleDescription(), QStringLiteral("Ina"));
    Panel::press(panel.work);
    QVERIFY(panel.node.state()->atWork(FakeSessionNode::kStation) == FakeSessionNode::kInstructor);
    QVERIFY(!panel.work.isEnabled());
}

void TestParticipantsPanel::choosesAPlaceForSomebodyWhoseHeadIsShared()
{
    Panel panel;
    panel.chooseTom();
    QVERIFY(!panel.place.isEnabled());
    panel.node.decide(fact::ObjectShared{{}, FakeSessionNode::kTrainee, ObjectKind::Head, "Head"});
    QCoreApplication::sendPostedEvents();
    QVERIFY(panel.place.isEnabled());
    const auto turn = [&] { return qRound(inDegrees(panel.tom().turn)); };
    const QList<QAction*> places = panel.place.menu()->actions();
    QCOMPARE(places.size(), 5);
    places[2]->trigger(); // at the patient's right
    QCOMPARE(turn(), -90);
    places[0]->trigger(); // as tracked
    QCOMPARE(turn(), 0);
}

void TestParticipantsPanel::locksTheSession()
{
    Panel panel;
    Panel::press(panel.lock);
    QVERIFY(panel.node.state()->isLocked());
    QVERIFY(panel.lock.isChecked());
    panel.node.decide(fact::SessionLocked{false}); // by another instructor
    QCoreApplication::sendPostedEvents();
    QVERIFY(!panel.lock.isChecked());
}

void TestParticipantsPanel::keepsWhoWasChosenWhenSomebodyComesIn()
{
    Panel panel;
    panel.chooseTom();
    panel.node.decide(fact::ParticipantJoined{{}, Role::Trainee, "Tess"});
    QCoreApplication::sendPostedEvents();
    QCOMPARE(panel.participants.rowCount(), 4);
    QCOMPARE(panel.table.currentIndex().row(), kTraineeRow);
    QVERIFY(panel.mute.isEnabled());
}

CARINA_SCREEN_TEST(TestParticipantsPanel)

} // namespace carina::participants_panel_test

#include "tst_participants_panel.moc"
