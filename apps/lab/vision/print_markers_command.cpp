#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "apps/lab/vision/printed_pieces.h"
#include "engine/io/files/whole_file.h"
#include "engine/io/site/devices/printed_tracker.h"

#include <QJsonArray>

namespace carina::lab
{
namespace
{

namespace print_option
{
constexpr Option kCamera{"camera", "DEVICE", "the webcam that tracker.json names (/dev/video0)"};
} // namespace print_option

namespace print_key
{
constexpr Key kFolder{"folder", "DIR as given"};
constexpr Key kPdf{"pdf", "what to print"};
constexpr Key kTracker{"tracker", "the description of the tracker, for --tracker"};
constexpr Key kPieces{"pieces", "one object for each page:"};
constexpr Key kName{"name", "of the tool, or \"board\"", 1};
constexpr Key kMarkerSide{"marker_mm", "side of a marker; of the board, of a square", 1};
constexpr Key kMarkers{"markers", "their numbers; of the board none", 1};
constexpr Key kSchema{"schema", "carina.print-markers/1"};
} // namespace print_key

/// A calibration that is there already is kept.
Result<void> keepCalibration(TrackerDescription& described, const std::filesystem::path& file)
{
    std::error_code ignored;
    return std::filesystem::exists(file, ignored) ? takeCalibration(described, file)
                                                  : Result<void>{};
}

Result<QJsonObject> printMarkers(const Words& words)
{
    if (words.files().size() != 1)
        return words.refuse(QStringLiteral("needs DIR."));
    const std::filesystem::path folder{words.files()[0].toStdString()};
    if (const auto opened = openFolder(folder); !opened)
        return tl::unexpected(opened.error());
    std::vector<CutPiece> pieces;
    QJsonArray listed;
    TrackerDescription described = printedTracker(
        words.has(print_option::kCamera) ? words.text(print_option::kCamera).toStdString()
                                         : "/dev/video0");
    if (!described.address.starts_with("/dev/"))
        return words.refuse(QStringLiteral("takes a device such as /dev/video0 for --camera."));
    if (const auto taken = keepCalibration(described, folder / "tracker-camera.json"); !taken)
        return tl::unexpected(taken.error());
    for (const PrintedTool& tool : printedTools()) {
        pieces.push_back(pieceOf(tool));
        QJsonArray ids;
        for (const BodyMarker& marker : tool.body)
            ids.append(marker.id);
        listed.append(QJsonObject{{print_key::kName, QString::fromStdString(tool.name)},
                                  {print_key::kMarkerSide, 1e3 * tool.body.front().side},
                                  {print_key::kMarkers, ids}});
    }
    const CalibrationBoard board;
    pieces.push_back(pieceOf(board));
    listed.append(QJsonObject{{print_key::kName, QStringLiteral("board")},
                              {print_key::kMarkerSide, 1e3 * board.square},
                              {print_key::kMarkers, QJsonArray{}}});
    const auto pdf = folder / "markers.pdf";
    const auto tracker = folder / "tracker.json";
    const auto wrote = writeCuttingSheets(pdf, pieces).and_then([&] {
        return writeTrackerFile(tracker, described);
    });
    if (!wrote)
        return tl::unexpected(wrote.error());
    return QJsonObject{{print_key::kSchema, QLatin1StringView{print_key::kSchema.help}},
                       {print_key::kFolder, words.files()[0]},
                       {print_key::kPdf, QString::fromStdString(pdf.string())},
                       {print_key::kTracker, QString::fromStdString(tracker.string())},
                       {print_key::kPieces, listed}};
}

} // namespace

Command printMarkersCommand()
{
    return {
        .name = "print-markers",
        .theme = "tracking",
        .summary = "makes a PDF of markers to print, and their description",
        .uses = {{.lines = {"DIR [--camera DEVICE]"},
                  .text = "Writes DIR/markers.pdf: sheets for the manikin's chest and chin, "
                          "sleeves for tube, stylus and laryngoscope, and a board to calibrate "
                          "the camera with. DIR/tracker.json, which is written with the "
                          "markers of each tool, is for --tracker of carina-registration and "
                          "carina-trainee; until carina-lab camera calibrate has written "
                          "DIR/tracker-camera.json it assumes a usual webcam. A calibration that "
                          "is there already is kept.",
                  .options = {print_option::kCamera},
                  .schema = print_key::kSchema,
                  .keys = {print_key::kFolder, print_key::kPdf, print_key::kTracker,
                           print_key::kPieces, print_key::kName, print_key::kMarkerSide,
                           print_key::kMarkers}}},
        .mostFiles = 1,
        .reminder = "print-markers needs DIR.",
        .draws = true,
        .experiment = printMarkers};
}

} // namespace carina::lab
