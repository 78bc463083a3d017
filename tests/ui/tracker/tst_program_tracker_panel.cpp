#include "ui/tracker/program_tracker_panel.h"

#include "tests/support/soon.h"
#include "tests/support/test_class.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>

namespace carina::program_tracker_panel_test
{
namespace
{

QPushButton* buttonIn(const QWidget& panel, const char* name)
{
    return panel.findChild<QPushButton*>(QLatin1String{name});
}

} // namespace

class ProgramTrackerPanelTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysWhatToDoWithoutATracker()
    {
        std::optional<TrackerSight> sight;
        const ProgramTrackerPanel panel{{.sight = [&] { return sight; }, .canBeGiven = true}};
        const auto* invitation = panel.findChild<QLabel*>(QStringLiteral("trackerInvitation"));
        const QSignalSpy wanted{&panel, &ProgramTrackerPanel::wanted};
        const QSignalSpy unwanted{&panel, &ProgramTrackerPanel::unwanted};
        QVERIFY(invitation->isVisibleTo(&panel));
        QVERIFY(!buttonIn(panel, "withoutTracker")->isEnabled());
        buttonIn(panel, "connectTracker")->click();
        QVERIFY(test::soon([&] { return wanted.size() == 1; }));
        sight = TrackerSight{};
        QVERIFY(test::soon([&] { return buttonIn(panel, "withoutTracker")->isEnabled(); }));
        QVERIFY(!invitation->isVisibleTo(&panel));
        buttonIn(panel, "withoutTracker")->click();
        QCOMPARE(unwanted.size(), 1);
    }

    void offersNoneToWhoCannotHaveOne()
    {
        const ProgramTrackerPanel panel{ProgramTracker{}};
        QVERIFY(!buttonIn(panel, "connectTracker") && !buttonIn(panel, "withoutTracker"));
        QVERIFY(!buttonIn(panel, "record"));
        QCOMPARE(panel.findChild<QLabel*>(QStringLiteral("trouble"))->text(),
                 QStringLiteral("This program has no tracker."));
    }
};

CARINA_SCREEN_TEST(ProgramTrackerPanelTest)

} // namespace carina::program_tracker_panel_test

#include "tst_program_tracker_panel.moc"
