#include "apps/lab/vision/camera_uses.h"
#include "engine/vision/printed_tools.h"
#include "evaluation/vision/marker_accuracy.h"

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
constexpr Key kDistance{"distance_mm", "of the body's origin from the camera", 1};
constexpr Key kPoses{"poses", "that were rendered", 1};
constexpr Key kSeen{"seen", "of these, with a pose that is given", 1};
constexpr Key kAmbiguous{"ambiguous", "of these, two poses fit: none is given", 1};
constexpr Key kWrong{"wrong", "of those given, off by more than 10 degrees; not in what follows",
                     1};
constexpr Key kAcross{"across_mm",
                      "error of the position along each axis across the line of sight, "
                      "RMS",
                      1};
constexpr Key kAlong{"along_mm", "error of it along the line of sight, RMS", 1};
constexpr Key kRotation{"rotation_deg", "error of the rotation, RMS", 1};
constexpr Key kReprojection{"reprojection_px", "distance of corners from the pose's, RMS", 1};
constexpr Key kCorner{"corner_px", "error of a corner along each axis, RMS", 1};
constexpr Key kNormalised{"normalised_square",
                          "squared error over the stated covariance, for each of six degrees of "
                          "freedom, mean: 1 where the covariance is right",
                          1};
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

QJsonObject objectOf(const MarkerAccuracy& at)
{
    return {{accuracy_key::kDistance, 1e3 * at.distance},
            {accuracy_key::kPoses, at.poses},
            {accuracy_key::kSeen, at.seen},
            {accuracy_key::kAmbiguous, at.ambiguous},
            {accuracy_key::kWrong, at.wrong},
            {accuracy_key::kAcross, 1e3 * at.acrossRms},
            {accuracy_key::kAlong, 1e3 * at.alongRms},
            {accuracy_key::kRotation, inDegrees(radians(at.rotationRms))},
            {accuracy_key::kReprojection, at.reprojectionRms},
            {accuracy_key::kCorner, at.cornerRms},
            {accuracy_key::kNormalised, at.normalisedSquare}};
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
        distances.append(objectOf(markerAccuracy(trial)));
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
            .keys = {accuracy_key::kTool, accuracy_key::kFocal, accuracy_key::kDistances,
                     accuracy_key::kDistance, accuracy_key::kPoses, accuracy_key::kSeen,
                     accuracy_key::kAmbiguous, accuracy_key::kWrong, accuracy_key::kAcross,
                     accuracy_key::kAlong, accuracy_key::kRotation, accuracy_key::kReprojection,
                     accuracy_key::kCorner, accuracy_key::kNormalised}};
}

} // namespace carina::lab
