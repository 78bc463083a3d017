#include "engine/io/site/devices/camera_file.h"

#include "engine/io/files/json_fields.h"
#include "engine/io/files/whole_file.h"
#include "engine/io/site/devices/camera_yaml.h"

#include <algorithm>
#include <iterator>

namespace carina
{
namespace
{

const QString kCameraSchema = QStringLiteral("carina.camera/1");

Result<CalibratedCamera> readCameraJson(const std::filesystem::path& file)
{
    const auto object = readJsonFile(file, kCameraSchema);
    if (!object)
        return tl::unexpected(object.error());
    std::optional<Error> fault;
    JsonFields fields{*object, fault};
    fields.allowOnly({"schema", "width", "height", "focal_px", "centre_px", "distortion", "rms_px",
                      "pictures", "made_at"});
    CalibratedCamera camera;
    camera.model.width = fields.count("width");
    camera.model.height = fields.count("height");
    const std::vector<double> focal = fields.numbers("focal_px", 2);
    const std::vector<double> centre = fields.numbers("centre_px", 2);
    const std::vector<double> distortion =
        fields.numbers("distortion", camera.model.distortion.size());
    if (fields.has("rms_px"))
        camera.rms = fields.amount("rms_px");
    if (fields.has("pictures"))
        camera.pictures = fields.count("pictures");
    if (fields.has("made_at"))
        camera.madeAt = fields.text("made_at");
    if (fault)
        return fail(fault->code, file.string() + ": " + fault->detail);
    camera.model.focal = {focal[0], focal[1]};
    camera.model.centre = {centre[0], centre[1]};
    std::ranges::copy(distortion, camera.model.distortion.begin());
    return camera;
}

QJsonArray pairOf(const Vec2& v) { return {v.x(), v.y()}; }

} // namespace

bool isOpenCvCamera(const std::filesystem::path& file)
{
    return file.extension() == ".yml" || file.extension() == ".yaml";
}

Result<CalibratedCamera> readCameraFile(const std::filesystem::path& file)
{
    auto camera = isOpenCvCamera(file)
                      ? readWholeFile(file, kDescriptionLimit)
                            .and_then([&](const std::string& text) {
                                return cameraFromYaml(text).map_error([&](const Error& error) {
                                    return Error{error.code, file.string() + ": " + error.detail};
                                });
                            })
                            .map([](const CameraModel& model) { return CalibratedCamera{model}; })
                      : readCameraJson(file);
    if (camera && !isUsable(camera->model))
        return fail(Errc::FileMalformed, file.string() + ": no camera takes such pictures");
    return camera;
}

Result<void> writeCameraFile(const std::filesystem::path& file, const CalibratedCamera& camera)
{
    if (isOpenCvCamera(file))
        return fail(Errc::FileUnwritable, file.string() + ": its name has to end in .json");
    QJsonArray distortion;
    std::ranges::copy(camera.model.distortion, std::back_inserter(distortion));
    QJsonObject object{{QStringLiteral("schema"), kCameraSchema},
                       {QStringLiteral("width"), camera.model.width},
                       {QStringLiteral("height"), camera.model.height},
                       {QStringLiteral("focal_px"), pairOf(camera.model.focal)},
                       {QStringLiteral("centre_px"), pairOf(camera.model.centre)},
                       {QStringLiteral("distortion"), distortion}};
    if (camera.pictures > 0) {
        object[QStringLiteral("rms_px")] = camera.rms;
        object[QStringLiteral("pictures")] = camera.pictures;
    }
    if (!camera.madeAt.empty())
        object[QStringLiteral("made_at")] = QString::fromStdString(camera.madeAt);
    return writeJsonFile(file, object);
}

} // namespace carina
