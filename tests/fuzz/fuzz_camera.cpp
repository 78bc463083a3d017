// Any bytes as the calibration of a camera, in both forms, and as the markers of a body: refused
// with a reason, or read as what can be used, written, and read again.

#include "engine/core/expects.h"
#include "engine/io/site/devices/camera_file.h"
#include "engine/io/site/devices/camera_yaml.h"
#include "engine/io/site/devices/marker_file.h"
#include "tests/fuzz/file_of_input.h"

namespace
{

using namespace carina;

void takeAsCamera(const fuzz::OwnFolder& folder, const std::filesystem::path& file)
{
    const auto camera = readCameraFile(file);
    if (!camera) {
        CARINA_EXPECTS(!camera.error().detail.empty());
        return;
    }
    CARINA_EXPECTS(isUsable(camera->model));
    CARINA_EXPECTS(sightOf(camera->model, {1e4, -1e4}).allFinite());
    const auto again = folder.holding("again.json", "", 0);
    CARINA_EXPECTS(writeCameraFile(again, *camera).has_value());
    const auto read = readCameraFile(again);
    CARINA_EXPECTS(read && read->model.distortion == camera->model.distortion);
}

void takeAsMarkers(const fuzz::OwnFolder& folder, const std::filesystem::path& file)
{
    const auto body = readMarkerFile(file);
    if (!body) {
        CARINA_EXPECTS(!body.error().detail.empty());
        return;
    }
    CARINA_EXPECTS(checkBody(body->markers, sizeOf(body->dictionary)).has_value());
    const auto again = folder.holding("again.json", "", 0);
    CARINA_EXPECTS(writeMarkerFile(again, *body).has_value());
    const auto read = readMarkerFile(again);
    CARINA_EXPECTS(read && read->markers.size() == body->markers.size());
}

} // namespace

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const fuzz::OwnFolder folder;
    const std::string_view text{reinterpret_cast<const char*>(data), size};
    if (!text.starts_with('{')) {
        const auto camera = cameraFromYaml(text);
        CARINA_EXPECTS(camera || !camera.error().detail.empty());
        if (camera && isUsable(*camera))
            CARINA_EXPECTS(sightOf(*camera, {0.0, 0.0}).allFinite());
        return 0;
    }
    const auto file = folder.holding("input.json", data, size);
    takeAsCamera(folder, file);
    takeAsMarkers(folder, file);
    return 0;
}
