// Any bytes as the description of a tracker: refused with a reason, or read as tools that are told
// apart, whose definitions lie beside it.

#include "engine/core/expects.h"
#include "engine/io/site/tracker_file.h"
#include "tests/fuzz/file_of_input.h"

#include <set>

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
    }
    return 0;
}
