#include "ui/tracker/tracker_panel.h"

#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSignalSpy>
#include <QTableWidget>

namespace carina::tracker_panel_test
{
namespace
{

ToolStatus seen(const char* name)
{
    return {.name = QString::fromLatin1(name),
            .isVisible = true,
            .state = QStringLiteral("visible"),
            .rate_Hz = 59.7,
            .age_s = 0.016,
            .error_mm = 0.123,
            .expected_mm = 0.081,
            .expected_deg = 0.043,
            .predicted_mm = 0.42,
            .held_mm = 2.94,
            .deviation_mm = 0.53};
}

ToolStatus unseen(const char* name)
{
    return {
        .name = QString::fromLatin1(name), .state = QStringLiteral("out of view"), .age_s = 3.5};
}

QString rowOf(const TrackerPanel& panel, int row)
{
    const auto* table = panel.findChild<QTableWidget*>(QStringLiteral("toolTable"));
    QStringList cells;
    for (int column = 0; column < table->columnCount(); ++column)
        cells << table->item(row, column)->text();
    return cells.join(QLatin1Char{'|'});
}

} // namespace

class TrackerPanelTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tellsOfEachToolHowItIsSeen()
    {
        TrackerPanel panel{[]() -> std::optional<TrackerSight> {
            return TrackerSight{{}, {seen("Tube"), unseen("Stylus")}};
        }};
        QCOMPARE(rowOf(panel, 0),
                 QStringLiteral("Tube|✓ visible|60|0.02|0.12|0.08, 0.04°|0.4 (2.9) ± 0.5|–"));
        QCOMPARE(rowOf(panel, 1), QStringLiteral("Stylus|▲ out of view|–|3.50|–|–|–|–"));
        QVERIFY(panel.findChild<QLabel*>(QStringLiteral("trouble"))->text().isEmpty());
    }

    void showsTheRowsOfAllToolsWithoutScrolling()
    {
        std::vector<ToolStatus> tools(9, seen("Tube"));
        TrackerPanel panel{[&] { return std::optional{TrackerSight{{}, tools}}; }};
        panel.resize(panel.minimumSizeHint());
        panel.setVisible(true);
        const auto& table = *panel.findChild<QTableWidget*>(QStringLiteral("toolTable"));
        QTRY_VERIFY(table.viewport()->height() > 0);
        QVERIFY(table.visualItemRect(table.item(8, 0)).bottom() <= table.viewport()->height());
    }

    void offersToPredictAndToSmooth()
    {
        TrackerPanel panel{[]() -> std::optional<TrackerSight> { return TrackerSight{}; }};
        QVERIFY(!panel.findChild<QCheckBox*>(QStringLiteral("predict"))); // not for choice
        std::vector<PoseTreatment> chosen;
        panel.offer({{.predicts = true, .smooths = false},
                     [&](const PoseTreatment& each) { chosen.push_back(each); }});
        auto* predict = panel.findChild<QCheckBox*>(QStringLiteral("predict"));
        auto* smooth = panel.findChild<QCheckBox*>(QStringLiteral("smooth"));
        QVERIFY(predict->isChecked() && !smooth->isChecked());
        smooth->click();
        predict->click();
        QCOMPARE(chosen.size(), std::size_t{2});
        QVERIFY((chosen[0] == PoseTreatment{.predicts = true, .smooths = true}));
        QVERIFY((chosen[1] == PoseTreatment{.predicts = false, .smooths = true}));
    }

    void saysWhatKeepsTheTrackerFromTracking()
    {
        std::optional<TrackerSight> sight{{QStringLiteral("It does not answer."), {}}};
        TrackerPanel panel{[&] { return sight; }};
        const auto* trouble = panel.findChild<QLabel*>(QStringLiteral("trouble"));
        QCOMPARE(trouble->text(), QStringLiteral("It does not answer."));
        sight.reset();
        panel.look();
        QCOMPARE(trouble->text(), QStringLiteral("This program has no tracker."));
        sight = TrackerSight{}; // before the program knows the session time
        panel.look();
        QVERIFY(trouble->text().isEmpty());
        sight = TrackerSight{.isPlaced = false};
        panel.look();
        QVERIFY(trouble->text().contains(QStringLiteral("carina-registration")));
    }

    void tellsWhereInTheWorkingVolumeToolsAre()
    {
        TrackerSight sight{{}, {seen("Tube"), seen("Head")}, KnownVolume::PolarisPyramid};
        sight.tools[0].p_T = Vec3{0.0, 0.0, -1.05};
        sight.tools[1].p_T = Vec3{0.0, 0.0, -2.5};
        TrackerPanel panel{[&] { return std::optional{sight}; }};
        QCOMPARE(rowOf(panel, 0),
                 QStringLiteral("Tube|✓ visible|60|0.02|0.12|0.08, 0.04°|0.4 (2.9) ± 0.5|100"));
        QCOMPARE(rowOf(panel, 1),
                 QStringLiteral("Head|✓ visible|60|0.02|0.12|0.08, 0.04°|0.4 (2.9) ± 0.5|-100"));
        // A person knows that theirs sees farther; the same tracker does not undo that.
        auto& volume = *panel.findChild<QComboBox*>(QStringLiteral("volume"));
        volume.setCurrentIndex(volume.findData(int(KnownVolume::PolarisExtended)));
        panel.look();
        QCOMPARE(rowOf(panel, 1),
                 QStringLiteral("Head|✓ visible|60|0.02|0.12|0.08, 0.04°|0.4 (2.9) ± 0.5|500"));
        sight.usualVolume = KnownVolume::None;
        panel.look();
        QCOMPARE(rowOf(panel, 1),
                 QStringLiteral("Head|✓ visible|60|0.02|0.12|0.08, 0.04°|0.4 (2.9) ± 0.5|–"));
        QVERIFY(!panel.findChild<QWidget*>(QStringLiteral("places"))->isVisibleTo(&panel));
    }

    void tellsOnceThatAToolIsLost()
    {
        TrackerSight sight{{}, {seen("Tube"), unseen("Stylus")}};
        TrackerPanel panel{[&] { return std::optional{sight}; }};
        QSignalSpy lost{&panel, &TrackerPanel::lost};
        sight.tools[0] = unseen("Tube");
        panel.look();
        QVERIFY(lost.isEmpty()); // it may have been hidden for a moment
        panel.look();
        panel.look();
        QCOMPARE(lost.size(), 1); // and the stylus was never there
        QCOMPARE(lost[0][0].toString(), QStringLiteral("Tube"));
        sight.tools[0] = seen("Tube");
        panel.look();
        sight.tools[0] = unseen("Tube");
        panel.look();
        panel.look();
        QCOMPARE(lost.size(), 2);
    }

    void soundsUnlessItIsSilencedAlsoAtTheNextStart()
    {
        const test::ScratchFolder folder;
        TrackerSight sight{{}, {seen("Tube")}};
        sight.tools[0].role = ToolRole::Tube;
        const auto loseAndFind = [&sight](TrackerPanel& panel) {
            sight.tools[0].isVisible = true;
            panel.look();
            sight.tools[0].isVisible = false;
            panel.look();
            panel.look();
            sight.tools[0].isVisible = true;
            panel.look();
        };
        const auto see = [&sight] { return std::optional{sight}; };
        {
            TrackerPanel panel{see, KeptSound{folder.path()}};
            QSignalSpy sounded{&panel, &TrackerPanel::sounded};
            auto* box = panel.findChild<QCheckBox*>(QStringLiteral("sound"));
            QVERIFY(box->isChecked());
            loseAndFind(panel);
            QCOMPARE(sounded.size(), 2); // lost and back differ
            QCOMPARE(sounded[0][0].toInt(), TrackerPanel::kBeepsWhenLost);
            QCOMPARE(sounded[1][0].toInt(), TrackerPanel::kBeepsWhenBack);
            QVERIFY(sounded[0][0] != sounded[1][0]);
            box->click();
            loseAndFind(panel);
            QCOMPARE(sounded.size(), 2);
        }
        TrackerPanel next{see, KeptSound{folder.path()}};
        const QSignalSpy sounded{&next, &TrackerPanel::sounded};
        QVERIFY(!next.findChild<QCheckBox*>(QStringLiteral("sound"))->isChecked());
        loseAndFind(next);
        QVERIFY(sounded.isEmpty());
    }

    void soundsOfWhatIsNeededOnly()
    {
        TrackerSight sight{{}, {seen("Stylus")}};
        sight.tools[0].role = ToolRole::Stylus;
        const auto see = [&sight] { return std::optional{sight}; };
        TrackerPanel session{see};
        TrackerPanel wizard{see, KeptSound{}, ToolUse::Registration};
        const QSignalSpy inSession{&session, &TrackerPanel::sounded};
        const QSignalSpy inWizard{&wizard, &TrackerPanel::sounded};
        sight.tools[0].isVisible = false;
        for (int look = 0; look < 2; ++look) {
            session.look();
            wizard.look();
        }
        QVERIFY(inSession.isEmpty());
        QCOMPARE(inWizard.size(), 1);
    }
};

CARINA_SCREEN_TEST(TrackerPanelTest)

} // namespace carina::tracker_panel_test

#include "tst_tracker_panel.moc"
