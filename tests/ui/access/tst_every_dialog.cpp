#include "models/console/kept_console.h"
#include "tests/engine/io/mesh/surface_files.h"
#include "tests/engine/net/node/free_port.h"
#include "tests/models/fake_session_node.h"
#include "tests/models/tracker/two_trackers.h"
#include "tests/support/scratch_folder.h"
#include "tests/ui/access/control_walk.h"
#include "ui/import/import_dialog.h"
#include "ui/instructor/save_view_dialog.h"
#include "ui/join/join_dialog.h"
#include "ui/panels/people/remove_dialog.h"
#include "ui/panels/session/station_dialog.h"
#include "ui/panels/session/strategy_dialog.h"
#include "ui/start/leave_question.h"
#include "ui/tracker/calibration_dialog.h"
#include "ui/tracker/device_calibration_dialog.h"
#include "ui/tracker/tool_layout_dialog.h"
#include "ui/tracker/tracker_dialog.h"

#include <QApplication>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>

#include <filesystem>
#include <vector>

namespace carina::every_dialog_test
{
namespace
{

using test::FakeSessionNode;
using test::soon;
using test::verifyControls;

QPushButton& buttonOf(const QDialog& dialog, const char* name)
{
    return *dialog.findChild<QPushButton*>(QLatin1String{name});
}

/// As it is for who has filled it in.
/// @param goesOn the button that can be pressed then
void verifyFilled(QDialog& dialog, const char* goesOn)
{
    dialog.show();
    QVERIFY(buttonOf(dialog, goesOn).isEnabled());
    verifyControls(dialog);
}

/// A tool definition of three markers. @returns its file
QString writeTool(const test::ScratchFolder& folder)
{
    const std::vector<ToolMarker> markers{{{0, 0, 0}}, {{0.05, 0, 0}}, {{0, 0.08, 0.01}}};
    const auto tool =
        NdiToolDefinition::make(NdiToolDefinition::Kind::Pointer, markers, "Carina", "tube");
    const auto& bytes = tool.value().bytes();
    return folder.write("tube.rom", QByteArrayView{reinterpret_cast<const char*>(bytes.data()),
                                                   static_cast<qsizetype>(bytes.size())});
}

} // namespace

/// Each control of each dialog has a name, and is reached by the keyboard.
class TestEveryDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void thatSavesAView()
    {
        KeptConsole kept{QString{}};
        const SavedViews views{kept};
        SaveViewDialog dialog{views};
        dialog.findChild<QLineEdit*>(QStringLiteral("viewName"))
            ->setText(QStringLiteral("Glottis"));
        verifyFilled(dialog, "saveView");
    }

    void thatAddsAStation() { verifyStationDialog(kNoStation); }
    void thatRenamesAStation() { verifyStationDialog(FakeSessionNode::kStation); }

    void thatRemovesAParticipant()
    {
        RemoveDialog dialog{QStringLiteral("Tom")};
        verifyFilled(dialog, "remove");
    }

    void thatChoosesAStrategy_data()
    {
        QTest::addColumn<StrategyKind>("kind");
        QTest::newRow("local lag") << StrategyKind::LocalLag;
        QTest::newRow("ASA") << StrategyKind::AsaAdaptive;
    }
    void thatChoosesAStrategy()
    {
        QFETCH(const StrategyKind, kind);
        StrategyChoice choice;
        choice.kind = kind;
        StrategyDialog dialog{choice};
        verifyFilled(dialog, "use");
    }

    void thatAsksBeforeLeaving()
    {
        QStringList faults{QStringLiteral("Nothing is asked")};
        QTimer::singleShot(0, this, [&faults] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                faults = test::faultsOfControls(*box);
                box->reject();
            }
        });
        const Leaving leaving =
            askBeforeLeaving(QStringLiteral("Tom waits until it goes on."), true, nullptr);
        QCOMPARE(faults, QStringList{});
        QVERIFY(leaving == Leaving::Stay);
    }

    void thatConnectsATracker_data()
    {
        QTest::addColumn<TrackerSource>("source");
        QTest::newRow("simulated") << TrackerSource::Simulated;
        QTest::newRow("Polaris") << TrackerSource::Polaris;
        QTest::newRow("OpenIGTLink") << TrackerSource::OpenIgtLink;
        QTest::newRow("webcam") << TrackerSource::Webcam;
        QTest::newRow("recording") << TrackerSource::Recording;
        QTest::newRow("description") << TrackerSource::Description;
    }
    void thatConnectsATracker()
    {
        QFETCH(const TrackerSource, source);
        TrackerForm form;
        form.source = source;
        form.server = QStringLiteral("192.0.2.7:18944");
        form.served = {{QStringLiteral("Stylus"), ToolRole::Stylus}};
        const std::vector<OfferedAddress> offered{
            OfferedAddress{QStringLiteral("/dev/ttyUSB0"), QStringLiteral("FT232R")}};
        TrackerDialog dialog{form, offered};
        dialog.offerToRecord();
        dialog.show();
        verifyControls(dialog);
    }

    void thatShowsTheMarkersOfATool()
    {
        const test::ScratchFolder folder;
        ToolLayoutDialog dialog;
        dialog.openFile(writeTool(folder));
        verifyFilled(dialog, "layoutSave");
    }

    void thatCalibratesACamera()
    {
        CalibrationDialog dialog{{QStringLiteral("/dev/no-such-camera"), {}, {640, 480}}};
        verifyFilled(dialog, "begin");
    }

    void thatCalibratesADevice()
    {
        test::TwoTrackers trackers;
        DeviceCalibrationDialog dialog{test::TwoTrackers::devices(), trackers.make()};
        verifyFilled(dialog, "begin");
    }

    void thatImportsAPatient()
    {
        const test::ScratchFolder folder;
        const std::filesystem::path set = folder.path().toStdString() + "/Somebody";
        test::writeFile(set / "Trachea.obj", test::objOf({100.0F, -5.0F, -5.0F, 1300.0F}));
        test::writeFile(set / "blob.obj", test::objOf({200.0F, 20.0F, -50.0F, 1100.0F}));
        SetImport reading{set, folder.path().toStdString() + "/cache"};
        ImportDialog dialog{reading};
        dialog.show();
        QVERIFY(soon([&dialog] { return buttonOf(dialog, "use").isEnabled(); },
                     std::chrono::seconds{20}));
        verifyFilled(dialog, "use");
    }

    void thatJoinsASession()
    {
        FoundSessionsModel sessions{freePort()};
        Entrance entrance{JoinSettings{}};
        const JoinForm form{QStringLiteral("192.0.2.7"),
                            QStringLiteral("45000"),
                            QStringLiteral("7K3QM-XW2PD"),
                            QStringLiteral("Anna"),
                            Role::Observer,
                            QStringLiteral("carina.hospital.example")};
        JoinDialog dialog{sessions, entrance, form};
        verifyFilled(dialog, "join");
    }

private:
    static void verifyStationDialog(StationId station)
    {
        FakeSessionNode node;
        SessionModel session{node};
        const StationsModel stations{session};
        StationDialog dialog{stations, station};
        dialog.findChild<QLineEdit*>(QStringLiteral("name"))->setText(QStringLiteral("Room 5"));
        verifyFilled(dialog, "accept");
    }
};

CARINA_SCREEN_TEST(TestEveryDialog)

} // namespace carina::every_dialog_test

#include "tst_every_dialog.moc"
