// Any bytes as a device set of PLUS: refused with a reason, or read as a tracker with tools.

#include "engine/core/expects.h"
#include "engine/io/site/devices/plus_device_set.h"
#include "tests/fuzz/file_of_input.h"

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
    const auto tracker = readPlusDeviceSet(folder.holding("set.xml", data, size));
    if (!tracker) {
        CARINA_EXPECTS(!tracker.error().detail.empty());
        return 0;
    }
    CARINA_EXPECTS(!tracker->tools.empty() && tracker->tools.size() <= 64);
    for (const DescribedTool& tool : tracker->tools)
        CARINA_EXPECTS(!tool.name.empty()
                       && (!tool.definition || tool.definition->partNumber() == "tube"));
    return 0;
}
