#include "tests/support/patience.h"
#include "ui/tracker/tracker_dialog.h"

#include "engine/core/monotonic_clock.h"
#include "tests/evaluation/polaris/served_device.h"
#include "tests/support/test_class.h"
#include "ui/tracker/tracker_tools.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QTableWidget>
#include <QTcpServer>
#include <QTemporaryDir>

namespace carina::tracker_dialog_test
{
namespace
{

std::vector<OfferedAddress> onePort()
{
    return {{QStringLiteral("/dev/ttyUSB0"), QStringLiteral("/dev/ttyUSB0 (FT232R USB UART)")}};
}

template <class Widget> Widget& find(const QWidget& window, const char* name)
{
    return *window.findChild<Widget*>(QLatin1String{name});
}

void choose(const QWidget& dialog, TrackerSource source)
{
    dialog.findChild<QAbstractButton*>(QStringLiteral("source%1").arg(int(source)))->click();
}

} // namespace

class TrackerDialogTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theSimulatedTrackerNeedsNothingElse()
    {
        TrackerDialog dialog{{}, onePort()};
        dialog.show();
        QVERIFY(find<QAbstractButton>(dialog, "use").isEnabled());
        QVERIFY(!find<QComboBox>(dialog, "address").isVisible());
        QTest::keyClick(&dialog, Qt::Key_Return);
        QTRY_COMPARE(dialog.result(), int(QDialog::Accepted));
        QVERIFY(dialog.choice().isSimulated());
    }

    void offersTheSerialPortsThatWereFound()
    {
        TrackerDialog dialog{{}, onePort()};
        dialog.show();
        choose(dialog, TrackerSource::Polaris);
        QVERIFY(find<QComboBox>(dialog, "address").isVisible());
        QVERIFY(find<QLabel>(dialog, "ports").text().contains(QLatin1Char{'1'}));
        QCOMPARE(dialog.form().address, QStringLiteral("/dev/ttyUSB0"));
        QVERIFY(find<QAbstractButton>(dialog, "use").isEnabled());
        find<QAbstractButton>(dialog, "use").click();
        QTRY_COMPARE(dialog.result(), int(QDialog::Accepted));
        const auto& described = std::get<TrackerDescription>(dialog.choice().device);
        QCOMPARE(described.address, std::string{"/dev/ttyUSB0"});
        QCOMPARE(described.tools.size(), std::size_t{1});
        QCOMPARE(described.tools[0].role, ToolRole::Stylus);
    }

    void keepsHowAPolarisIsAsked()
    {
        TrackerDialog dialog{
            {.source = TrackerSource::Polaris, .poses = NdiPoseReply::Bx2, .fastestRate = 14400},
            onePort()};
        QCOMPARE(dialog.form().poses, NdiPoseReply::Bx2);
        QCOMPARE(dialog.form().fastestRate, 14400); // is in no list
        auto& poses = find<QComboBox>(dialog, "poses");
        poses.setCurrentIndex(poses.findData(int(NdiPoseReply::Tx)));
        auto& rate = find<QComboBox>(dialog, "fastestRate");
        rate.setCurrentIndex(rate.findData(115200));
        find<QAbstractButton>(dialog, "use").click();
        QTRY_COMPARE(dialog.result(), int(QDialog::Accepted));
        const auto& described = std::get<TrackerDescription>(dialog.choice().device);
        QCOMPARE(described.poses, NdiPoseReply::Tx);
        QCOMPARE(described.fastestRate, 115200);
    }

    void readsARecordingWhileItsWindowIsAlive()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("poses.tum"));
        QFile written{file};
        QVERIFY(written.open(QIODevice::WriteOnly));
        QVERIFY(written.write("0 0 0 -1 0 0 0 1\n0.1 0 0 -1 0 0 0 1\n") > 0);
        written.close();
        TrackerDialog dialog{{.source = TrackerSource::Recording, .recording = file}, {}};
        dialog.accept();
        QVERIFY(dialog.result() != int(QDialog::Accepted));
        QVERIFY(find<QLabel>(dialog, "missing").text().startsWith(QStringLiteral("Reading")));
        QVERIFY(!find<QAbstractButton>(dialog, "use").isEnabled());
        QTRY_COMPARE(dialog.result(), int(QDialog::Accepted));
        const auto& played = std::get<PlayedRecording>(dialog.choice().device);
        QCOMPARE(played.sequence.tools.at(0).samples.size(), std::size_t{2});
    }

    void choosesWhatTheSimulatedTrackerHasToCopeWith()
    {
        TrackerDialog dialog{{.simulated = {.hidden = {ToolRole::Jaw}}}, {}};
        dialog.show();
        auto& rate = find<QDoubleSpinBox>(dialog, "simulatedRate");
        QVERIFY(rate.isVisible());
        rate.setValue(30.0);
        find<QDoubleSpinBox>(dialog, "simulatedDropouts").setValue(5.0);
        auto& tube =
            *dialog.findChild<QComboBox*>(QStringLiteral("sight%1").arg(int(ToolRole::Tube)));
        tube.setCurrentIndex(2); // half of its markers
        find<QCheckBox>(dialog, "simulatedLaryngoscope").click();
        QCOMPARE(dialog.form().simulated, (SimulatedOptions{.rate_Hz = 30.0,
                                                            .dropouts_percent = 5.0,
                                                            .hidden = {ToolRole::Jaw},
                                                            .partly = {ToolRole::Tube},
                                                            .laryngoscope = true}));
        QVERIFY(find<QLabel>(dialog, "simulatedWords")
                    .text()
                    .endsWith(QStringLiteral(
                        "--tracker simulated:rate=30,hidden=jaw,partly=tube,dropouts=5,"
                        "with=laryngoscope")));
        find<QAbstractButton>(dialog, "use").click();
        QTRY_COMPARE(dialog.result(), int(QDialog::Accepted));
        const auto& device = std::get<SimulatedDevice>(dialog.choice().device);
        QCOMPARE(device.settings.rate, hertz(30.0));
        QCOMPARE(device.settings.dropouts, 0.05);
        QCOMPARE(device.settings.occlusions.size(), std::size_t{2});
    }

    void takesAWebcamThatNoFileDescribes()
    {
        TrackerDialog dialog{
            {}, {}, {{QStringLiteral("/dev/video4"), QStringLiteral("/dev/video4 (Webcam)")}}};
        dialog.show();
        choose(dialog, TrackerSource::Webcam);
        auto& webcam = find<QComboBox>(dialog, "webcam");
        QVERIFY(webcam.isVisible());
        QCOMPARE(dialog.form().webcam, QStringLiteral("/dev/video4"));
        webcam.setEditText({});
        QVERIFY(!find<QAbstractButton>(dialog, "use").isEnabled());
        QVERIFY(!find<QAbstractButton>(dialog, "calibrateWebcam").isEnabled());
        webcam.setEditText(QStringLiteral("1"));
        QVERIFY(find<QAbstractButton>(dialog, "calibrateWebcam").isEnabled());
        find<QAbstractButton>(dialog, "use").click();
        QTRY_COMPARE(dialog.result(), int(QDialog::Accepted));
        const auto& described = std::get<TrackerDescription>(dialog.choice().device);
        QCOMPARE(described.address, std::string{"/dev/video1"});
        QVERIFY(!described.tools.empty() && described.tools[0].body);
    }

    void recordsTheBytesOfADeviceAndPlaysThem()
    {
        const QTemporaryDir folder;
        const QString port = folder.filePath(QStringLiteral("port"));
        const QString file = folder.filePath(QStringLiteral("device.log"));
        const ServedDevice device{
            PolarisLine::terminal(port.toStdString()).value(),
            {.wired = {{}}},
            [](const std::string&, LocalTime) {
                return std::optional{PolarisPose{Quat::Identity(), {0.0, 0.0, -1500.0}, 0.1}};
            }};
        TrackerDialog dialog{{.source = TrackerSource::Polaris, .address = port}, {}};
        dialog.offerToRecord();
        dialog.show();
        auto& conversation = find<QLineEdit>(dialog, "conversation");
        QVERIFY(conversation.isVisible());
        choose(dialog, TrackerSource::Simulated);
        QVERIFY(!conversation.isVisible());
        choose(dialog, TrackerSource::Polaris);
        conversation.setText(file);
        find<QAbstractButton>(dialog, "use").click();
        QTRY_COMPARE(dialog.result(), int(QDialog::Accepted));
        {
            const auto tracker = makeTracker(dialog.choice(), [] {
                return std::optional{SessionTime{monotonicNow().time_since_epoch()}};
            });
            QVERIFY2(tracker, tracker ? "" : tracker.error().detail.c_str());
            QVERIFY((*tracker)->start());
            const auto tools = (*tracker)->tools();
            QTRY_VERIFY_WITH_TIMEOUT(tools.at(0).history->samples().size() > 5, kPatience_ms);
            (*tracker)->stop();
        }
        TrackerDialog later{{.source = TrackerSource::Recording, .recording = file}, {}};
        later.accept();
        QTRY_COMPARE_WITH_TIMEOUT(later.result(), int(QDialog::Accepted), kPatience_ms);
        const auto& played = std::get<PlayedRecording>(later.choice().device);
        QVERIFY(played.sequence.tools.at(0).samples.size() > 5);
    }

    void offersToRecordWhereThatIsForUse()
    {
        TrackerDialog dialog{{.source = TrackerSource::Polaris}, onePort()};
        dialog.show();
        QVERIFY(!find<QLineEdit>(dialog, "conversation").isVisible());
    }

    void takesNothingThatWasChangedWhileItWasRead()
    {
        TrackerDialog dialog{{}, onePort()};
        dialog.show();
        dialog.accept();
        choose(dialog, TrackerSource::Polaris);
        QTRY_VERIFY(find<QAbstractButton>(dialog, "use").isEnabled());
        QVERIFY(dialog.result() != int(QDialog::Accepted));
    }

    void saysWhatIsMissing()
    {
        TrackerDialog dialog{{}, {}};
        choose(dialog, TrackerSource::Polaris);
        QVERIFY(find<QLabel>(dialog, "ports").text().startsWith(QStringLiteral("No serial port")));
        QVERIFY(!find<QLabel>(dialog, "missing").text().isEmpty());
        QVERIFY(!find<QAbstractButton>(dialog, "use").isEnabled());
        QVERIFY(!find<QAbstractButton>(dialog, "try").isEnabled());
        find<QComboBox>(dialog, "address").setEditText(QStringLiteral("192.0.2.7:8765"));
        QCOMPARE(find<QLabel>(dialog, "missing").text(), QString{});
        QVERIFY(find<QAbstractButton>(dialog, "use").isEnabled());
        find<QAbstractButton>(dialog, "removeTool").click();
        QVERIFY(!find<QAbstractButton>(dialog, "use").isEnabled());
    }

    void toolsAreAddedEachForAnotherRole()
    {
        TrackerDialog dialog{{.source = TrackerSource::Polaris}, onePort()};
        find<QAbstractButton>(dialog, "addPluggedIn").click();
        dialog.findChild<TrackerTools*>()->addDefinition(QStringLiteral("/media/tube.rom"));
        QCOMPARE(dialog.form().tools,
                 (std::vector<FormTool>{{ToolRole::Stylus, {}},
                                        {ToolRole::Jaw, {}},
                                        {ToolRole::Tube, QStringLiteral("/media/tube.rom")}}));
        auto& table = find<QTableWidget>(dialog, "tools");
        qobject_cast<QComboBox*>(table.cellWidget(1, 0))->setCurrentIndex(0);
        QVERIFY(find<QLabel>(dialog, "missing").text().contains(QStringLiteral("Stylus")));
        QCOMPARE(table.item(2, 1)->text(), QStringLiteral("tube.rom"));
    }

    void staysOpenWhereAFileCannotBeRead()
    {
        TrackerDialog dialog{{.source = TrackerSource::Description,
                              .description = QStringLiteral("/nowhere/tracker.json")},
                             {}};
        dialog.show();
        find<QAbstractButton>(dialog, "use").click();
        QTRY_VERIFY(
            find<QLabel>(dialog, "missing").text().contains(QStringLiteral("tracker.json")));
        QVERIFY(dialog.isVisible());
    }

    void tellsWhatAnswersBeforeItIsUsed()
    {
        QTcpServer taken;
        taken.listen(QHostAddress::LocalHost);
        const std::uint16_t port = taken.serverPort();
        taken.close();
        TrackerDialog dialog{
            {.source = TrackerSource::Polaris, .address = QStringLiteral("127.0.0.1:%1").arg(port)},
            {}};
        const auto& found = find<QLabel>(dialog, "found");
        find<QAbstractButton>(dialog, "try").click();
        QTRY_VERIFY_WITH_TIMEOUT(found.text().startsWith(QStringLiteral("▲ No tracker answers")),
                                 kPatience_ms);
        const ServedDevice device{
            PolarisLine::tcp(port).value(),
            {.wired = {{}}, .hasRate = false},
            [](const std::string&, LocalTime) {
                return std::optional{PolarisPose{Quat::Identity(), {0.0, 0.0, -1500.0}, 0.1}};
            }};
        QTRY_VERIFY_WITH_TIMEOUT(found.text().contains(QStringLiteral("✓ Stylus: visible")),
                                 kPatience_ms);
        find<QComboBox>(dialog, "address").setEditText(QStringLiteral("192.0.2.7:8765"));
        QCOMPARE(found.text(), QString{}); // it was of another address
    }

    /// So that a program that uses the same device lets go of it.
    void tellsWhenADeviceIsTried()
    {
        TrackerDialog dialog{
            {.source = TrackerSource::Polaris, .address = QStringLiteral("127.0.0.1:1")}, {}};
        dialog.show();
        std::vector<bool> told;
        connect(&dialog, &TrackerDialog::devicesWanted, this,
                [&](bool areWanted) { told.push_back(areWanted); });
        find<QAbstractButton>(dialog, "try").click();
        QCOMPARE(told, std::vector{true});
        find<QComboBox>(dialog, "address").setEditText(QStringLiteral("127.0.0.1:2"));
        QCOMPARE(told, (std::vector{true, false}));
        find<QAbstractButton>(dialog, "try").click();
        dialog.reject();
        QCOMPARE(told, (std::vector{true, false, true, false}));
    }

    /// Also on a low screen, and as small again as before once another source is chosen.
    void fitsTheScreenAndWhatItShows()
    {
        TrackerDialog dialog{{}, onePort()};
        dialog.offerToRecord();
        dialog.show();
        const int before = dialog.height();
        choose(dialog, TrackerSource::Polaris);
        QTRY_VERIFY(find<QAbstractButton>(dialog, "addDefinition").isVisible());
        QVERIFY(dialog.height() > before);
        QVERIFY(dialog.geometry().bottom() <= dialog.screen()->availableGeometry().bottom());
        const QPushButton& use = find<QPushButton>(dialog, "use");
        QTRY_VERIFY(dialog.rect().contains({use.mapTo(&dialog, QPoint{}), use.size()}));
        for (const QPushButton* button : dialog.findChildren<QPushButton*>())
            if (button->isVisible())
                QVERIFY2(button->width() >= button->minimumSizeHint().width(),
                         qPrintable(button->text()));
        choose(dialog, TrackerSource::Simulated);
        QTRY_COMPARE(dialog.height(), before);
    }

    void everyControlHasANameForAScreenReader()
    {
        const TrackerDialog dialog{{.source = TrackerSource::Polaris}, onePort()};
        for (const QLineEdit* edit : dialog.findChildren<QLineEdit*>())
            if (qobject_cast<QComboBox*>(edit->parentWidget()) == nullptr
                && qobject_cast<QAbstractSpinBox*>(edit->parentWidget()) == nullptr)
                QVERIFY2(!edit->accessibleName().isEmpty(), qPrintable(edit->objectName()));
        for (const QComboBox* box : dialog.findChildren<QComboBox*>())
            QVERIFY2(!box->accessibleName().isEmpty(), qPrintable(box->objectName()));
        for (const QAbstractSpinBox* box : dialog.findChildren<QAbstractSpinBox*>())
            QVERIFY2(!box->accessibleName().isEmpty(), qPrintable(box->objectName()));
        QVERIFY(!find<QTableWidget>(dialog, "tools").accessibleName().isEmpty());
    }
};

CARINA_SCREEN_TEST(TrackerDialogTest)

} // namespace carina::tracker_dialog_test

#include "tst_tracker_dialog.moc"
