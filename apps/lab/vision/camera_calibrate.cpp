#include "apps/lab/vision/camera_uses.h"
#include "engine/core/monotonic_clock.h"
#include "engine/io/site/devices/camera_file.h"
#include "engine/vision/board_calibration.h"
#include "engine/vision/picture_source.h"

#include <QDateTime>
#include <QJsonArray>
#include <QSize>

#include <array>
#include <cstdio>

namespace carina::lab
{
namespace
{

namespace calibrate_option
{
constexpr Option kOut{"out", "FILE", "writes the calibration, such as DIR/tracker-camera.json"};
constexpr Option kSquare{"square-mm", "MM",
                         "side of a square of the board, measured, 5 to 200 (28)"};
constexpr Option kColumns{"columns", "N", "squares of the board, 3 to 20 (5)"};
constexpr Option kRows{"rows", "N", "squares of the board, 3 to 20 (7)"};
constexpr Option kWidth{"width", "PIXELS", "asked of a webcam, 160 to 4000 (1280)"};
constexpr Option kHeight{"height", "PIXELS", "asked of a webcam, 120 to 3000 (720)"};
constexpr Option kSeconds{"seconds", "N", "that a webcam is looked through, 5 to 600 (60)"};
} // namespace calibrate_option

namespace calibrate_key
{
constexpr Key kPlace{"place", "PLACE as given"};
constexpr Key kLooked{"looked_at", "pictures"};
constexpr Key kKept{"kept", "of these, with the board at a place of its own"};
constexpr Key kCoverage{"coverage", "corners in each ninth of the picture, three rows of three"};
constexpr Key kWidth{"width", "of a picture, pixels"};
constexpr Key kHeight{"height", "of a picture, pixels"};
constexpr Key kFocal{"focal_px", "[fx, fy]; null where it is not calibrated, as what follows"};
constexpr Key kCentre{"centre_px", "[cx, cy]"};
constexpr Key kDistortion{"distortion", "[k1, k2, p1, p2, k3]"};
constexpr Key kRms{"reprojection_px", "distance of corners from where the camera sees them, RMS"};
constexpr Key kSpread{"focal_spread_percent", "standard deviation of the focal length"};
constexpr Key kLeft{"left_out", "pictures that fit three times worse than most"};
constexpr Key kSchema{"schema", "carina.camera-calibrate/1"};
} // namespace calibrate_key

/// What a person does about a set of pictures that is refused.
const char* sentenceOf(CalibrationFault fault)
{
    switch (fault) {
    case CalibrationFault::TooFewPictures:
        return "The board is in too few pictures: show it at ten places or more, sharp, evenly "
               "lit, and with at least a third of it in the picture.";
    case CalibrationFault::NotAllOver:
        return "The board was not everywhere in the picture: hold it into each corner and along "
               "each side (coverage says where it is missing).";
    case CalibrationFault::NotTilted:
        return "The board was held too straight: tilt it by 30 to 45 degrees to the left, to the "
               "right, up and down.";
    case CalibrationFault::Contradictory:
        return "The pictures do not fit one camera: the board has to be flat and the pictures "
               "sharp; switch autofocus off, and leave zoom and focus as they are.";
    }
    return "";
}

/// Looks through a video or folder to its end, or at a webcam for some seconds.
Result<int> lookThroughBoards(const PicturePlace& place, double seconds,
                              BoardCalibration& calibration, QSize& size)
{
    auto source = PictureSource::open(place);
    if (!source)
        return tl::unexpected(source.error());
    const bool isCamera = place.kind == PicturePlace::Kind::Camera;
    const LocalTime end = monotonicNow() + fromSeconds(seconds);
    int looked = 0;
    while (!isCamera || monotonicNow() < end) {
        const auto taken = source->next();
        if (!taken)
            break;
        const QSize now{taken->picture.width, taken->picture.height};
        if (looked++ == 0)
            size = now;
        else if (now != size)
            return fail(Errc::OutOfRange, place.path.string() + ": pictures of several sizes");
        if (calibration.add(taken->picture) && isCamera)
            std::fprintf(stderr, "%d places of the board\n", calibration.pictures());
    }
    return looked;
}

QJsonArray coverageRows(const BoardCoverage& coverage)
{
    QJsonArray rows;
    for (std::size_t row = 0; row < 3; ++row)
        rows.append(QJsonArray{coverage[3 * row], coverage[3 * row + 1], coverage[3 * row + 2]});
    return rows;
}

void addCamera(QJsonObject& object, const BoardFit& fit)
{
    QJsonArray distortion;
    for (const double k : fit.camera.distortion)
        distortion.append(k);
    object[calibrate_key::kFocal] = QJsonArray{fit.camera.focal.x(), fit.camera.focal.y()};
    object[calibrate_key::kCentre] = QJsonArray{fit.camera.centre.x(), fit.camera.centre.y()};
    object[calibrate_key::kDistortion] = distortion;
    object[calibrate_key::kRms] = fit.rms;
    object[calibrate_key::kSpread] = 100.0 * fit.focalSpread;
    object[calibrate_key::kLeft] = fit.left;
}

struct CalibrationRequest {
    PicturePlace place{};
    CalibrationBoard board;
    double seconds = 60.0;
};

Result<CalibrationRequest> requestOf(const Words& words)
{
    const auto square = words.number(calibrate_option::kSquare, 5.0, 200.0, 28.0);
    const auto seconds = words.number(calibrate_option::kSeconds, 5.0, 600.0, 60.0);
    const auto columns = words.whole(calibrate_option::kColumns, 3, 20, 5);
    const auto rows = words.whole(calibrate_option::kRows, 3, 20, 7);
    const auto width = words.whole(calibrate_option::kWidth, 160, 4000, 1280);
    const auto height = words.whole(calibrate_option::kHeight, 120, 3000, 720);
    for (const auto* number : {&square, &seconds})
        if (!*number)
            return tl::unexpected(number->error());
    for (const auto* whole : {&columns, &rows, &width, &height})
        if (!*whole)
            return tl::unexpected(whole->error());
    CalibrationRequest request{
        .board = {.columns = int(*columns), .rows = int(*rows), .square = 1e-3 * *square},
        .seconds = *seconds};
    if (*columns * *rows / 2 > sizeOf(request.board.dictionary))
        return words.refuse(QStringLiteral("calibrate knows boards of at most 100 squares."));
    if (isOpenCvCamera(words.text(calibrate_option::kOut).toStdString()))
        return words.refuse(
            QStringLiteral("calibrate writes no YAML: give --out a name that ends in .json."));
    const std::filesystem::path path{words.files()[1].toStdString()};
    request.place = {
        .kind = kindOfPlace(path), .path = path, .width = int(*width), .height = int(*height)};
    return request;
}

} // namespace

Result<QJsonObject> calibrateCamera(const Words& words)
{
    const auto request = requestOf(words);
    if (!request)
        return tl::unexpected(request.error());
    BoardCalibration calibration{request->board};
    QSize size;
    const auto looked = lookThroughBoards(request->place, request->seconds, calibration, size);
    if (!looked)
        return tl::unexpected(looked.error());
    const auto fitted = calibration.fit();
    const auto* fit = std::get_if<BoardFit>(&fitted);
    QJsonArray warnings;
    if (fit == nullptr)
        warnings.append(QString::fromLatin1(sentenceOf(std::get<CalibrationFault>(fitted))));
    QJsonObject object{{calibrate_key::kSchema, QLatin1StringView{calibrate_key::kSchema.help}},
                       {calibrate_key::kPlace, words.files()[1]},
                       {calibrate_key::kLooked, *looked},
                       {calibrate_key::kKept, calibration.pictures()},
                       {calibrate_key::kCoverage, coverageRows(calibration.coverage())},
                       {calibrate_key::kWidth, size.width()},
                       {calibrate_key::kHeight, size.height()},
                       {kAcceptable, fit != nullptr},
                       {kWarnings, warnings}};
    if (fit == nullptr) {
        for (const Key& key :
             {calibrate_key::kFocal, calibrate_key::kCentre, calibrate_key::kDistortion,
              calibrate_key::kRms, calibrate_key::kSpread, calibrate_key::kLeft})
            object[key] = QJsonValue::Null;
        return object;
    }
    addCamera(object, *fit);
    if (words.has(calibrate_option::kOut)) {
        const auto wrote = writeCameraFile(
            words.text(calibrate_option::kOut).toStdString(),
            {.model = fit->camera,
             .rms = fit->rms,
             .pictures = fit->pictures,
             .madeAt = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString()});
        if (!wrote)
            return tl::unexpected(wrote.error());
    }
    return object;
}

Use calibrateUse()
{
    return {.lines = {"calibrate PLACE [--out FILE] [--square-mm MM] [--columns N] [--rows N]",
                      "calibrate [--width PIXELS] [--height PIXELS] [--seconds N]"},
            .text = "Looks for the board of carina-lab print-markers in the pictures of "
                    "PLACE, a webcam such as /dev/video0, a video, or a folder of PNG and "
                    "JPEG files, and calibrates the camera that took them. A set of "
                    "pictures that determines no camera is refused with the reason.",
            .options = {calibrate_option::kOut, calibrate_option::kSquare,
                        calibrate_option::kColumns, calibrate_option::kRows,
                        calibrate_option::kWidth, calibrate_option::kHeight,
                        calibrate_option::kSeconds},
            .schema = calibrate_key::kSchema,
            .keys = {calibrate_key::kPlace, calibrate_key::kLooked, calibrate_key::kKept,
                     calibrate_key::kCoverage, calibrate_key::kWidth, calibrate_key::kHeight,
                     calibrate_key::kFocal, calibrate_key::kCentre, calibrate_key::kDistortion,
                     calibrate_key::kRms, calibrate_key::kSpread, calibrate_key::kLeft, kAcceptable,
                     kWarnings}};
}

} // namespace carina::lab
