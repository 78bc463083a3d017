#include "apps/lab/commands.h"
#include "engine/io/site/devices/camera_file.h"
#include "engine/io/site/devices/tracker_file.h"
#include "engine/vision/marker_detector.h"
#include "engine/vision/printed_tools.h"
#include "tests/support/test_class.h"
#include "tests/widgets/report/pdf_reader.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonObject>

namespace carina::lab::print_markers_command_test
{
namespace
{

constexpr int kDotsPerInch = 200;
constexpr double kMillimetresPerDot = 25.4 / kDotsPerInch;
constexpr double kTolerance_mm = 0.2;

/// A page as pdftoppm prints it, counted from 1.
GreyPicture printedPage(const QString& pdf, int page)
{
    const QTemporaryDir folder;
    const QString name = folder.filePath(QStringLiteral("page"));
    test::printedBy(QStringLiteral("pdftoppm"),
                    {QStringLiteral("-png"), QStringLiteral("-singlefile"), QStringLiteral("-f"),
                     QString::number(page), QStringLiteral("-r"), QString::number(kDotsPerInch),
                     pdf, name});
    const QImage image =
        QImage{name + QStringLiteral(".png")}.convertToFormat(QImage::Format_Grayscale8);
    GreyPicture picture{image.width(), image.height(), {}};
    for (int y = 0; y < image.height(); ++y)
        picture.pixels.insert(picture.pixels.end(), image.constScanLine(y),
                              image.constScanLine(y) + image.width());
    return picture;
}

double sideOf(const DetectedMarker& marker, std::size_t from)
{
    return kMillimetresPerDot * (marker.corners[(from + 1) % 4] - marker.corners[from]).norm();
}

} // namespace

/// The printed sheets, read by pdftoppm and the detector.
class TestPrintMarkersCommand : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        if (!test::hasPdfReader())
            QSKIP("poppler-utils is not installed");
        const auto printed = printMarkersCommand().run({m_folder.path()});
        QVERIFY2(printed, printed ? "" : printed.error().detail.c_str());
        m_pdf = (*printed)[QStringLiteral("pdf")].toString();
        QCOMPARE((*printed)[QStringLiteral("pieces")].toArray().size(),
                 qsizetype(printedTools().size()) + 1);
    }

    /// Every marker is on its page, the right way up, of its size and at its place.
    void hasEveryMarkerTrueToScale()
    {
        for (std::size_t i = 0; i < printedTools().size(); ++i) {
            const PrintedTool& tool = printedTools()[i];
            const auto seen = seenMarkers(printedPage(m_pdf, int(i) + 1), kPrintedDictionary);
            QCOMPARE(seen.size(), tool.body.size());
            for (const DetectedMarker& marker : seen) {
                const auto of = std::ranges::find(tool.body, marker.id, &BodyMarker::id);
                QVERIFY2(of != tool.body.end(), tool.name.c_str());
                for (std::size_t edge = 0; edge < 4; ++edge)
                    QVERIFY2(std::abs(sideOf(marker, edge) - 1e3 * of->side) < kTolerance_mm,
                             tool.name.c_str());
                QVERIFY(marker.corners[0].y() < marker.corners[3].y());
                QVERIFY(marker.corners[0].x() < marker.corners[1].x());
            }
        }
    }

    /// On a sheet the markers are as far apart as the tracker takes them to be.
    void hasTheMarkersOfASheetInTheirPlaces()
    {
        const PrintedTool& chest = printedTools()[0];
        const auto seen = seenMarkers(printedPage(m_pdf, 1), kPrintedDictionary);
        const auto cornerOf = [&](int id) {
            return std::ranges::find(seen, id, &DetectedMarker::id)->corners[0];
        };
        const auto truth = [&](int id) {
            return cornersOf(*std::ranges::find(chest.body, id, &BodyMarker::id))[0];
        };
        for (int id = 1; id < 4; ++id) {
            const Vec2 apart = kMillimetresPerDot * (cornerOf(id) - cornerOf(0));
            const Vec3 due = 1e3 * (truth(id) - truth(0));
            QVERIFY(std::abs(apart.x() - due.x()) < kTolerance_mm);
            QVERIFY(std::abs(apart.y() + due.y()) < kTolerance_mm);
        }
    }

    /// The faces of a sleeve follow each other to the right, a face's width apart.
    void hasTheFacesOfASleeveSideBySide()
    {
        const PrintedTool& tube = printedTools()[2];
        const auto seen = seenMarkers(printedPage(m_pdf, 3), kPrintedDictionary);
        for (int i = 0; i < 3; ++i) {
            const auto at = [&](int id) {
                return std::ranges::find(seen, id, &DetectedMarker::id)->corners[0];
            };
            const int id = tube.body[std::size_t(i)].id;
            const Vec2 apart = kMillimetresPerDot * (at(id + 1) - at(id));
            QVERIFY(std::abs(apart.x() - inMillimetres(tube.width)) < kTolerance_mm);
            QVERIFY(std::abs(apart.y()) < kTolerance_mm);
        }
    }

    void describesWhatItPrints()
    {
        const auto tracker =
            readTrackerFile(m_folder.filePath(QStringLiteral("tracker.json")).toStdString());
        QVERIFY2(tracker, tracker ? "" : tracker.error().detail.c_str());
        QVERIFY(tracker->kind == TrackerKind::Camera);
        QCOMPARE(tracker->address, std::string{"/dev/video0"});
        QCOMPARE(tracker->tools.size(), printedTools().size());
        for (std::size_t i = 0; i < tracker->tools.size(); ++i)
            QCOMPARE(tracker->tools[i].body->markers.size(), printedTools()[i].body.size());
    }

    void keepsACalibrationThatIsThere()
    {
        const QTemporaryDir folder;
        QVERIFY(printMarkersCommand().run({folder.path()}));
        const auto file = folder.filePath(QStringLiteral("tracker-camera.json")).toStdString();
        auto camera = readCameraFile(file);
        QVERIFY2(camera, camera ? "" : camera.error().detail.c_str());
        camera->model.focal *= 0.9;
        camera->pictures = 12;
        QVERIFY(writeCameraFile(file, *camera));
        QVERIFY(printMarkersCommand().run({folder.path()}));
        const auto kept = readCameraFile(file);
        QVERIFY(kept);
        QCOMPARE(kept->model.focal, camera->model.focal);
        QCOMPARE(kept->pictures, 12);
        const auto tracker =
            readTrackerFile(folder.filePath(QStringLiteral("tracker.json")).toStdString());
        QVERIFY(tracker);
        QCOMPARE(tracker->camera.focal, camera->model.focal);
    }

private:
    QTemporaryDir m_folder;
    QString m_pdf;
};

CARINA_SCREEN_TEST(TestPrintMarkersCommand)

} // namespace carina::lab::print_markers_command_test

#include "tst_print_markers_command.moc"
