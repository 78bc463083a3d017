// Any bytes as a sequence of Plus or 3D Slicer: refused with a reason, or read as tools whose poses
// are proper, in ascending order of time.

#include "engine/core/expects.h"
#include "engine/tracking/sequence_file.h"

#include <cmath>
#include <cstdint>
#include <sstream>

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace carina;
    std::istringstream input{std::string{reinterpret_cast<const char*>(data), size}};
    const auto sequence = readSequence(input, "fuzz");
    if (!sequence) {
        CARINA_EXPECTS(!sequence.error().detail.empty());
        return 0;
    }
    CARINA_EXPECTS(!sequence->tools.empty());
    for (const RecordedTool& tool : sequence->tools)
        for (std::size_t i = 0; i < tool.samples.size(); ++i) {
            const PoseSample& sample = tool.samples[i];
            CARINA_EXPECTS(i == 0 || sample.time >= tool.samples[i - 1].time);
            CARINA_EXPECTS(sample.X_FO.translation().allFinite()
                           && std::abs(sample.X_FO.rotation().norm() - 1.0) < 1e-9);
        }
    return 0;
}
