#include "apps/lab/commands.h"
#include "apps/lab/vision/camera_uses.h"

namespace carina::lab
{
namespace
{

constexpr const char* kCameraReminder =
    "camera needs find PLACE, calibrate PLACE, video DIR or accuracy.";

Result<QJsonObject> runCamera(const Words& words)
{
    const QString verb = words.files().value(0);
    const bool hasPlace = words.files().size() == 2;
    if (hasPlace && verb == QLatin1String{"find"})
        return findMarkers(words);
    if (hasPlace && verb == QLatin1String{"calibrate"})
        return calibrateCamera(words);
    if (hasPlace && verb == QLatin1String{"video"})
        return renderVideo(words);
    if (!hasPlace && verb == QLatin1String{"accuracy"})
        return measureAccuracy(words);
    return fail(Errc::WrongOption, kCameraReminder);
}

} // namespace

Command cameraCommand()
{
    return {.name = "camera",
            .theme = "tracking",
            .summary = "finds markers in pictures, calibrates a camera, renders videos of markers",
            .uses = {findUse(), calibrateUse(), videoUse(), accuracyUse()},
            .mostFiles = 2,
            .reminder = kCameraReminder,
            .experiment = runCamera};
}

} // namespace carina::lab
