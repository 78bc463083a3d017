// Any bytes as the description of a tracker: refused with a reason, or read as tools that are told
// apart, whose definitions lie beside it.

#include "engine/core/expects.h"
#include "engine/io/site/devices/tracker_file.h"
#include "tests/fuzz/file_of_input.h"

#include <set>

namespace
{

constexpr std::string_view kCamera =
    "image_width: 640\nimage_height: 480\ncamera_matrix: x\n data: [ "
    "500, 0, 320, 0, 500, 240, 0, 0, 1 ]\n"
    "distortion_coefficients: x\n data: [ 0, 0, 0, 0, 0 ]\n";
constexpr std::string_view kMarkers =
    R"({"schema": "carina.markers/1", "dictionary": "4x4_50", "markers": [{"id": 6, "side_mm": 30,
    "X_BK_mm": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}]})";

} // namespace

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace carina;
    static const fuzz::OwnFolder folder;
    static const auto definition = [] {
        const ToolMarker markers[] = {{{0, 0, 0}}, {{0.05, 0, 0}}, {{0, 0.08, 0}}};
        const auto tool =
            NdiToolDefinition::make(NdiToolDefinition::Kind::Pointer, markers, "Carina", "tube");
        return folder.holding("tube.rom", tool->bytes().data(), tool->bytes().size());
    }();
    static const auto camera = folder.holding("camera.yml", kCamera.data(), kCamera.size());
    static const auto markers = folder.holding("markers.json", kMarkers.data(), kMarkers.size());
    const auto tracker = readTrackerFile(folder.holding("tracker.json", data, size));
    if (!tracker) {
        CARINA_EXPECTS(!tracker.error().detail.empty());
        return 0;
    }
    CARINA_EXPECTS(!tracker->address.empty() && !tracker->tools.empty());
    std::set<std::string> names;
    for (const DescribedTool& tool : tracker->tools) {
        CARINA_EXPECTS(names.insert(tool.name).second);
        CARINA_EXPECTS(!tool.definition || tool.definition->partNumber() == "tube");
        CARINA_EXPECTS(tool.body.has_value() == (tracker->kind == TrackerKind::Camera));
    }
    return 0;
}
