#include "apps/lab/commands.h"
#include "engine/io/site/devices/camera_file.h"
#include "tests/support/test_class.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonObject>
#include <QTemporaryDir>

namespace carina::lab::camera_calibrate_test
{
namespace
{

constexpr double kFocalTolerance = 0.01; ///< share

double firstOf(const QJsonObject& object, const char* key)
{
    return object[QLatin1StringView{key}].toArray().at(0).toDouble(std::nan(""));
}

} // namespace

/// Pictures of the board that the laboratory renders, calibrated with by the laboratory.
class TestCameraCalibrate : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        const auto rendered = cameraCommand().run(
            {QStringLiteral("video"), m_folder.path(), QStringLiteral("--seconds"),
             QStringLiteral("1"), QStringLiteral("--rate"), QStringLiteral("1"),
             QStringLiteral("--width"), QStringLiteral("640"), QStringLiteral("--board"),
             QStringLiteral("40")});
        QVERIFY2(rendered, rendered ? "" : rendered.error().detail.c_str());
        m_boards = m_folder.filePath(QStringLiteral("board"));
    }

    void findsTheRenderedCamera()
    {
        const QString out = m_folder.filePath(QStringLiteral("found.json"));
        const auto found = cameraCommand().run(
            {QStringLiteral("calibrate"), m_boards, QStringLiteral("--out"), out});
        QVERIFY2(found, found ? "" : found.error().detail.c_str());
        const QString told = (*found)[QStringLiteral("warnings")].toArray().at(0).toString();
        QVERIFY2((*found)[QStringLiteral("acceptable")].toBool(), qPrintable(told));
        QVERIFY((*found)[QStringLiteral("reprojection_px")].toDouble() < 0.5);
        const auto truth =
            readCameraFile(m_folder.filePath(QStringLiteral("tracker-camera.json")).toStdString());
        const auto written = readCameraFile(out.toStdString());
        QVERIFY(truth && written);
        const double focal = truth->model.focal.x();
        QVERIFY(std::abs(firstOf(*found, "focal_px") - focal) < kFocalTolerance * focal);
        QCOMPARE(written->model.focal.x(), firstOf(*found, "focal_px"));
        QVERIFY(written->pictures >= 10 && !written->madeAt.empty());
    }

    /// Such a file is read as OpenCV's, by its name.
    void writesNothingOverAFileOfOpenCv()
    {
        const QString out = m_folder.filePath(QStringLiteral("lens.yml"));
        const auto found = cameraCommand().run(
            {QStringLiteral("calibrate"), m_boards, QStringLiteral("--out"), out});
        QVERIFY(!found);
        QVERIFY2(found.error().detail.find(".json") != std::string::npos,
                 found.error().detail.c_str());
        QVERIFY(!QFile::exists(out));
    }

    void refusesTooFewAndWritesNothing()
    {
        const QDir boards{m_boards};
        const QTemporaryDir few;
        for (const QString& name : boards.entryList(QDir::Files).first(4))
            QVERIFY(QFile::copy(boards.filePath(name), few.filePath(name)));
        const QString out = few.filePath(QStringLiteral("found.json"));
        const auto refused = cameraCommand().run(
            {QStringLiteral("calibrate"), few.path(), QStringLiteral("--out"), out});
        QVERIFY(refused);
        QVERIFY(!(*refused)[QStringLiteral("acceptable")].toBool());
        QVERIFY((*refused)[QStringLiteral("focal_px")].isNull());
        QVERIFY((*refused)[QStringLiteral("warnings")].toArray().at(0).toString().contains(
            QStringLiteral("too few pictures")));
        QVERIFY(!QFile::exists(out));
    }

    void refusesWhatItCannotUse()
    {
        QCOMPARE(cameraCommand().run({}).error().code, Errc::WrongOption);
        QCOMPARE(cameraCommand()
                     .run({QStringLiteral("calibrate"), QStringLiteral("none.avi")})
                     .error()
                     .code,
                 Errc::FileNotFound);
        QCOMPARE(cameraCommand()
                     .run({QStringLiteral("calibrate"), m_boards, QStringLiteral("--columns"),
                           QStringLiteral("20"), QStringLiteral("--rows"), QStringLiteral("20")})
                     .error()
                     .code,
                 Errc::WrongOption);
    }

private:
    QTemporaryDir m_folder;
    QString m_boards;
};

CARINA_TEST(TestCameraCalibrate)

} // namespace carina::lab::camera_calibrate_test

#include "tst_camera_calibrate.moc"
