#include "apps/lab/vision/accuracy_figures.h"
#include "apps/lab/vision/camera_uses.h"
#include "engine/vision/printed_tools.h"

#include <QJsonArray>

#include <array>
#include <cmath>
#include <numbers>

namespace carina::lab
{
namespace
{

namespace accuracy_option
{
constexpr Option kTool{"tool", "NAME",
                       "of carina-lab print-markers: manikin, chin, tube, stylus or laryngoscope "
                       "(tube)"};
constexpr Option kSide{"side-mm", "MM", "a single flat marker of this side instead, 1 to 1000"};
constexpr Option kWidth{"width", "PIXELS", "of the pictures, 160 to 4000 (1280); 16:9"};
constexpr Option kView{"view", "DEG", "of the camera, across the width, 20 to 120 (60)"};
constexpr Option kPoses{"poses", "N", "at each distance, 1 to 10000 (100)"};
constexpr Option kTilt{"tilt", "DEG", "most, of a pose, 0 to 80 (50)"};
constexpr Option kNoise{"noise", "GREY", "of a pixel, of 255, 0 to 50 (2)"};
constexpr Option kSeed{"seed", "N", "of the poses and the noise (1)"};
} // namespace accuracy_option

namespace accuracy_key
{
constexpr Key kTool{"tool", "as given"};
constexpr Key kFocal{"focal_px", "of the camera"};
constexpr Key kDistances{"distances", "one object for each:"};
constexpr Key kCorner{"corner_px", "error of a corner along each axis, RMS", 1};
constexpr Key kSchema{"schema", "carina.camera-accuracy/1"};
} // namespace accuracy_key

constexpr std::array kDistances{0.3, 0.5, 0.7, 1.0, 1.4}; ///< metres

CameraModel cameraOf(int width, double view_deg)
{
    const int height = width * 9 / 16;
    const double focal = 0.5 * width / std::tan(0.5 * view_deg * std::numbers::pi / 180.0);
    return {.width = width,
            .height = height,
            .focal = {focal, focal},
            .centre = {0.5 * (width - 1), 0.5 * (height - 1)},
            .distortion = {0.05, -0.1, 0.001, -0.001, 0.0}};
}

Result<void> takeBody(const Words& words, AccuracyTrial& trial)
{
    if (words.has(accuracy_option::kSide)) {
        const auto side = words.number(accuracy_option::kSide, 1.0, 1000.0);
        if (!side)
            return tl::unexpected(side.error());
        trial.body = {{0, 1e-3 * *side, {}}};
        return {};
    }
    const QString name = words.has(accuracy_option::kTool) ? words.text(accuracy_option::kTool)
                                                           : QStringLiteral("tube");
    QStringList known;
    for (const PrintedTool& tool : printedTools()) {
        known += QString::fromStdString(tool.name).toLower();
        if (known.back() != name)
            continue;
        trial.body = tool.body;
        trial.isTurning = tool.isSleeve;
        return {};
    }
    return words.unknownWord(accuracy_option::kTool, known);
}

} // namespace

Result<QJsonObject> measureAccuracy(const Words& words)
{
    const auto width = words.whole(accuracy_option::kWidth, 160, 4000, 1280);
    const auto view = words.number(accuracy_option::kView, 20.0, 120.0, 60.0);
    const auto poses = words.whole(accuracy_option::kPoses, 1, 10000, 100);
    const auto tilt = words.number(accuracy_option::kTilt, 0.0, 80.0, 50.0);
    const auto noise = words.number(accuracy_option::kNoise, 0.0, 50.0, 2.0);
    const auto seed = words.whole(accuracy_option::kSeed, 0, 1'000'000, 1);
    for (const auto* whole : {&width, &poses, &seed})
        if (!*whole)
            return tl::unexpected(whole->error());
    for (const auto* number : {&view, &tilt, &noise})
        if (!*number)
            return tl::unexpected(number->error());
    AccuracyTrial trial{.camera = cameraOf(int(*width), *view),
                        .dictionary = kPrintedDictionary,
                        .body = {},
                        .rendering = {.noise = *noise, .seed = std::uint32_t(*seed)},
                        .tilt = degrees(*tilt),
                        .poses = int(*poses),
                        .seed = std::uint32_t(*seed)};
    if (const auto taken = takeBody(words, trial); !taken)
        return tl::unexpected(taken.error());
    QJsonArray distances;
    for (const double distance : kDistances) {
        trial.distance = distance;
        const MarkerAccuracy accuracy = markerAccuracy(trial);
        QJsonObject object = accuracyFigures(accuracy);
        object[accuracy_key::kCorner] = accuracy.cornerRms;
        distances.append(object);
    }
    return QJsonObject{{accuracy_key::kSchema, QLatin1StringView{accuracy_key::kSchema.help}},
                       {accuracy_key::kTool, words.text(accuracy_option::kTool)},
                       {accuracy_key::kFocal, trial.camera.focal.x()},
                       {accuracy_key::kDistances, distances}};
}

Use accuracyUse()
{
    return {.lines = {"accuracy [--tool NAME | --side-mm MM] [--width PIXELS] [--view DEG]",
                      "accuracy [--poses N] [--tilt DEG] [--noise GREY] [--seed N]"},
            .text = "Renders a marked tool at poses drawn at random, finds its pose in "
                    "each picture by itself, and compares with the true one.",
            .options = {accuracy_option::kTool, accuracy_option::kSide, accuracy_option::kWidth,
                        accuracy_option::kView, accuracy_option::kPoses, accuracy_option::kTilt,
                        accuracy_option::kNoise, accuracy_option::kSeed},
            .schema = accuracy_key::kSchema,
            .keys = withAccuracyKeys({accuracy_key::kTool, accuracy_key::kFocal,
                                      accuracy_key::kDistances, accuracy_key::kCorner})};
}

} // namespace carina::lab
