#include "tests/support/patience.h"
#include "ui/registration/devices_box.h"

#include "engine/io/site/site_file.h"
#include "tests/engine/io/site/site_text.h"
#include "tests/models/registration/registration_site.h"
#include "tests/models/tracker/two_trackers.h"
#include "tests/support/test_class.h"
#include "ui/tracker/device_calibration_dialog.h"
#include "ui/tracker/tracker_dialog.h"

#include <QApplication>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QRadioButton>

#include <fstream>

namespace carina::devices_box_test
{
namespace
{

using test::TwoTrackers;

/// The box on a site without devices, beside which two are described.
struct BoxDesk {
    QTemporaryDir folder;
    WrittenTracker tracker;
    TwoTrackers trackers;
    std::vector<bool> lent; ///< what the program's tracker was asked for
    SiteEditor editor{path("site.json"), Site{}, &QDateTime::currentDateTimeUtc};
    DeviceTask task{editor,
                    path("site.json"),
                    {.tracker = &tracker,
                     .trackerName = QStringLiteral("Written tracker"),
                     .clock = [] { return std::optional{SessionTime{}}; },
                     .make = trackers.make(),
                     .track = [this](bool tracks) -> Result<void> {
                         lent.push_back(tracks);
                         return {};
                     }}};
    DevicesBox box{task};

    BoxDesk()
    {
        describe("first.json", "first:1", "{'name': 'jaw', 'role': 'jaw'}");
        describe("second.json", "second:1", "{'name': 'tube', 'role': 'tube'}");
        QObject::connect(&editor, &SiteEditor::changed, &box, [this] {
            task.follow();
            box.refresh();
        });
        box.show();
        QApplication::setActiveWindow(&box); // the display has no window manager
    }
    [[nodiscard]] std::filesystem::path path(const char* name) const
    {
        return folder.filePath(QLatin1String{name}).toStdString();
    }
    void describe(const char* name, const std::string& address, const std::string& tool) const
    {
        std::ofstream{path(name)} << test::json("{'schema': 'carina.tracker/1', 'kind': 'ndi', "
                                                "'address': '"
                                                + address + "', 'tools': [" + tool + "]}");
    }
    [[nodiscard]] QPushButton& button(const char* name) const
    {
        return *box.findChild<QPushButton*>(QLatin1String{name});
    }
    [[nodiscard]] QListWidget& list() const
    {
        return *box.findChild<QListWidget*>(QStringLiteral("devices"));
    }
    template <class Dialog> [[nodiscard]] Dialog* dialog() const
    {
        for (Dialog* each : box.findChildren<Dialog*>())
            if (each->isVisible())
                return each;
        return nullptr;
    }
    /// In the window that asks for a device. @returns false where it does not ask.
    [[nodiscard]] bool choose(const char* file) const
    {
        auto* asked = dialog<TrackerDialog>();
        if (asked == nullptr)
            return false;
        asked
            ->findChild<QRadioButton*>(
                QStringLiteral("source%1").arg(int(TrackerSource::Description)))
            ->click();
        asked->findChild<QLineEdit*>(QStringLiteral("description"))
            ->setText(QString::fromStdString(path(file).string()));
        asked->findChild<QPushButton*>(QStringLiteral("use"))->click();
        return QTest::qWaitFor([this] { return dialog<TrackerDialog>() == nullptr; }, kPatience_ms);
    }
    /// In the window that calibrates. @returns false where it does not, or refuses.
    [[nodiscard]] bool calibrate()
    {
        auto* window = dialog<DeviceCalibrationDialog>();
        if (window == nullptr)
            return false;
        window->findChild<QPushButton*>(QStringLiteral("begin"))->click();
        trackers.run(*window->findChild<DeviceCalibration*>(), 31.0);
        auto* store = window->findChild<QPushButton*>(QStringLiteral("store"));
        if (!store->isEnabled())
            return false;
        store->click();
        return true;
    }
    /// As a person does both, one after the other.
    [[nodiscard]] bool addBoth()
    {
        button("addDevice").click();
        if (!choose("first.json"))
            return false;
        button("addDevice").click();
        return choose("second.json") && calibrate();
    }
    [[nodiscard]] std::vector<SiteDevice> stored() const
    {
        return readSiteFile(path("site.json")).value().devices;
    }
};

} // namespace

/// The devices of a site without a terminal.
class TestDevicesBox : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void addsTwoDevicesAndCalibratesOneToTheOther()
    {
        BoxDesk desk;
        QVERIFY(!desk.list().isVisible());
        QVERIFY(desk.addBoth());
        QCOMPARE(desk.stored().size(), 2U);
        constexpr double kWithin_mm = 0.5;
        QVERIFY(test::millimetresOff(desk.stored()[1].frame->place.X_FD) < kWithin_mm);
        QCOMPARE(desk.list().count(), 2);
        QVERIFY2(desk.list().item(1)->text().startsWith(QStringLiteral("NDI tracker at second:1")),
                 qPrintable(desk.list().item(1)->text()));
        QVERIFY(desk.list().item(1)->text().contains(QStringLiteral("(RMS)")));
        QCOMPARE(desk.lent, (std::vector<bool>{false, true}));
    }

    void storesNothingWhereTheCalibrationIsCancelled()
    {
        BoxDesk desk;
        desk.button("addDevice").click();
        QVERIFY(desk.choose("first.json"));
        desk.button("addDevice").click();
        QVERIFY(desk.choose("second.json"));
        auto* window = desk.dialog<DeviceCalibrationDialog>();
        QVERIFY(window);
        window->findChild<QPushButton*>(QStringLiteral("begin"))->click();
        desk.trackers.run(*window->findChild<DeviceCalibration*>(), 20.0);
        window->reject();
        QCOMPARE(desk.stored().size(), 1U);
        QCOMPARE(desk.lent, (std::vector<bool>{false, true})); // it tracks again
        QCOMPARE(desk.trackers.inUse(), 0U);
    }

    void removesAndCalibratesTheOneThatIsChosen()
    {
        BoxDesk desk;
        QVERIFY(desk.addBoth());
        for (const char* name : {"calibrateDevice", "replaceDevice", "removeDevice"})
            QVERIFY2(!desk.button(name).isEnabled(), name); // none is chosen
        desk.list().setCurrentRow(0);
        for (const char* name : {"calibrateDevice", "replaceDevice", "removeDevice"})
            QVERIFY2(!desk.button(name).isEnabled(), name);
        QVERIFY(!desk.button("removeDevice").accessibleDescription().isEmpty());
        desk.list().setFocus();
        QTest::keyClick(&desk.list(), Qt::Key_Down);
        desk.button("calibrateDevice").click();
        QVERIFY(desk.calibrate());
        QCOMPARE(desk.stored().size(), 2U);
        desk.button("removeDevice").click();
        QCOMPARE(desk.stored().size(), 1U);
        desk.editor.undo();
        QCOMPARE(desk.stored().size(), 2U);
        QCOMPARE(desk.list().count(), 2);
    }

    void offersToTrackWithTheDevices()
    {
        BoxDesk desk;
        QVERIFY(!desk.button("trackWithDevices").isVisible());
        desk.button("addDevice").click();
        QVERIFY(desk.choose("first.json"));
        QVERIFY(desk.button("trackWithDevices").isVisible());
        bool isWanted = false;
        QObject::connect(&desk.box, &DevicesBox::trackWanted, &desk.box,
                         [&isWanted] { isWanted = true; });
        desk.button("trackWithDevices").click();
        QVERIFY(isWanted);
    }
};

CARINA_SCREEN_TEST(TestDevicesBox)

} // namespace carina::devices_box_test

#include "tst_devices_box.moc"
