// Any bytes as a recorded conversation with a device: refused with a reason, or replayed as poses
// that are proper, in order of time.

#include "engine/core/expects.h"
#include "engine/net/devices/device_replay.h"
#include "tests/fuzz/file_of_input.h"

#include <cmath>
#include <fstream>

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace carina;
    static const fuzz::OwnFolder folder;
    const auto file = folder.holding("device.log", data, size);
    std::ifstream input{file, std::ios::binary};
    const auto sequence = replayedConversation(input, file.string());
    if (!sequence) {
        CARINA_EXPECTS(!sequence.error().detail.empty());
        return 0;
    }
    for (const RecordedTool& tool : sequence->tools)
        for (std::size_t i = 0; i < tool.samples.size(); ++i) {
            const PoseSample& sample = tool.samples[i];
            CARINA_EXPECTS(i == 0 || sample.time >= tool.samples[i - 1].time);
            CARINA_EXPECTS(sample.X_FO.translation().allFinite()
                           && std::abs(sample.X_FO.rotation().norm() - 1.0) < 1e-6);
        }
    return 0;
}
