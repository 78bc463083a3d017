#include "ui/tracker/device_calibration_dialog.h"

#include "tests/models/tracker/two_trackers.h"
#include "tests/support/test_class.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace carina::device_calibration_dialog_test
{
namespace
{

using test::TwoTrackers;

/// The dialog before two simulated trackers, worked by keys.
struct DialogDesk {
    TwoTrackers trackers;
    DeviceCalibrationDialog dialog{TwoTrackers::devices(), trackers.make()};

    DialogDesk()
    {
        dialog.show();
        QApplication::setActiveWindow(&dialog); // the display has no window manager
    }
    template <class Widget> [[nodiscard]] Widget& find(const char* name) const
    {
        return *dialog.findChild<Widget*>(QLatin1String{name});
    }
    [[nodiscard]] QString text() const { return find<QLabel>("text").text(); }
    void press(Qt::Key key)
    {
        QWidget* focus = QApplication::focusWidget();
        QTest::keyClick(focus ? focus : &dialog, key);
    }
    /// Tab until that has the focus. @returns false where it never gets it.
    [[nodiscard]] bool tabTo(const char* name)
    {
        for (int i = 0; i < 20; ++i) {
            if (find<QWidget>(name).hasFocus())
                return true;
            press(Qt::Key_Tab);
        }
        return false;
    }
    void run(double seconds) { trackers.run(*dialog.findChild<DeviceCalibration*>(), seconds); }
};

} // namespace

class TestDeviceCalibrationDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void calibratesByKeysAlone()
    {
        DialogDesk desk;
        QVERIFY(!desk.find<QPushButton>("store").isEnabled());
        QCOMPARE(desk.find<QComboBox>("toolOfFirst").count(), 1);
        QCOMPARE(desk.find<QComboBox>("toolOfSecond").count(), 3);
        QVERIFY(desk.tabTo("toolOfSecond"));
        QVERIFY(desk.tabTo("begin"));
        desk.press(Qt::Key_Space);
        QVERIFY(!desk.find<QComboBox>("toolOfSecond").isEnabled());
        desk.run(31.0);
        QVERIFY2(desk.text().startsWith(QStringLiteral("✓ Accepted")), qPrintable(desk.text()));
        QVERIFY(desk.tabTo("store"));
        desk.press(Qt::Key_Space);
        QCOMPARE(desk.dialog.result(), int(QDialog::Accepted));
        constexpr double kWithin_mm = 0.5;
        QVERIFY(test::millimetresOff(desk.dialog.found().place.X_FD) < kWithin_mm);
    }

    void showsHowFarItIs()
    {
        DialogDesk desk;
        desk.trackers.swing = {0.5, 0.0, 0.0};
        desk.find<QPushButton>("begin").click();
        desk.run(10.0);
        QVERIFY(desk.find<QLabel>("amount0").text().startsWith(QStringLiteral("✓")));
        QVERIFY(desk.find<QLabel>("amount0").text().contains(QStringLiteral("° (RMS)")));
        QVERIFY(desk.find<QLabel>("amount1").text().startsWith(QStringLiteral("○")));
        QVERIFY(desk.find<QLabel>("amount3").text().endsWith(QStringLiteral("mm")));
        QVERIFY(std::abs(desk.find<QProgressBar>("time").value() - 10) <= 1);
        QVERIFY(desk.text().contains(QStringLiteral("about other axes")));
    }

    void storesNothingThatWasRefused()
    {
        DialogDesk desk;
        desk.trackers.swing = {0.5, 0.0, 0.0};
        desk.find<QPushButton>("begin").click();
        desk.run(31.0);
        QVERIFY2(desk.text().contains(QStringLiteral("about one axis only")),
                 qPrintable(desk.text()));
        QVERIFY(!desk.find<QPushButton>("store").isEnabled());
        QVERIFY(desk.find<QPushButton>("begin").isEnabled()); // again
        desk.dialog.accept();
        QVERIFY(desk.dialog.isVisible());
    }

    void endsAtOnceByEscape()
    {
        DialogDesk desk;
        desk.find<QPushButton>("begin").click();
        desk.run(5.0);
        QCOMPARE(desk.trackers.inUse(), 2U);
        desk.press(Qt::Key_Escape);
        QVERIFY(!desk.dialog.isVisible());
        QCOMPARE(desk.dialog.result(), int(QDialog::Rejected));
        QCOMPARE(desk.trackers.inUse(), 0U);
    }

    void namesWhatItShows()
    {
        const DialogDesk desk;
        for (const QWidget* widget : desk.dialog.findChildren<QWidget*>())
            if (qobject_cast<const QProgressBar*>(widget) || qobject_cast<const QComboBox*>(widget))
                QVERIFY2(!widget->accessibleName().isEmpty(), qPrintable(widget->objectName()));
        QVERIFY(!desk.find<QLabel>("text").accessibleName().isEmpty());
    }
};

CARINA_SCREEN_TEST(TestDeviceCalibrationDialog)

} // namespace carina::device_calibration_dialog_test

#include "tst_device_calibration_dialog.moc"
