#include "tests/support/patience.h"
#include "ui/tracker/calibration_dialog.h"

#include "tests/engine/vision/board_pictures.h"
#include "tests/support/test_class.h"

#include <QAbstractButton>
#include <QLabel>
#include <QTemporaryDir>

namespace carina::calibration_dialog_test
{
namespace
{

template <class Widget> Widget& find(const QWidget& window, const char* name)
{
    return *window.findChild<Widget*>(QLatin1String{name});
}

} // namespace

class TestCalibrationDialog : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void savesWhatThePicturesDetermine()
    {
        const QTemporaryDir folder;
        QVERIFY(vision_test::writeBoards(folder.path(), 30));
        const QString file = folder.filePath(QStringLiteral("camera.json"));
        CalibrationDialog dialog{{folder.path(), file, {640, 480}}};
        dialog.show();
        QVERIFY(!find<QAbstractButton>(dialog, "save").isEnabled());
        QTRY_VERIFY_WITH_TIMEOUT(find<QAbstractButton>(dialog, "save").isEnabled(), kPatience_ms);
        for (int i = 0; i < 9; ++i)
            QTRY_VERIFY(find<QLabel>(dialog, qPrintable(QStringLiteral("ninth%1").arg(i)))
                            .text()
                            .startsWith(QStringLiteral("✓")));
        find<QAbstractButton>(dialog, "save").click();
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
        QVERIFY(QFile::exists(file));
    }

    void saysWhereItCannotSave()
    {
        const QTemporaryDir folder;
        QVERIFY(vision_test::writeBoards(folder.path(), 30));
        CalibrationDialog dialog{
            {folder.path(), folder.filePath(QStringLiteral("000.png/camera.json")), {640, 480}}};
        dialog.show();
        QTRY_VERIFY_WITH_TIMEOUT(find<QAbstractButton>(dialog, "save").isEnabled(), kPatience_ms);
        find<QAbstractButton>(dialog, "save").click();
        QVERIFY(dialog.isVisible());
        QVERIFY(find<QLabel>(dialog, "text").text().contains(QStringLiteral("camera.json")));
    }

    void saysThatNoCameraIsThere()
    {
        CalibrationDialog dialog{{QStringLiteral("/dev/no-such-camera"), {}, {640, 480}}};
        dialog.show();
        QTRY_VERIFY_WITH_TIMEOUT(find<QLabel>(dialog, "text")
                                     .text()
                                     .startsWith(QStringLiteral("▲ The camera gives no picture")),
                                 kPatience_ms);
        QVERIFY(!find<QAbstractButton>(dialog, "save").isEnabled());
    }
};

CARINA_SCREEN_TEST(TestCalibrationDialog)

} // namespace carina::calibration_dialog_test

#include "tst_calibration_dialog.moc"
