// Any bytes as Carina's record of poses: refused with a reason, or read as proper poses, which are
// the same once they were written and read again.

#include "engine/core/expects.h"
#include "engine/tracking/record/pose_record.h"

#include <cmath>
#include <cstdint>
#include <sstream>

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace carina;
    std::istringstream input{std::string{reinterpret_cast<const char*>(data), size}};
    const auto sequence = pose_record::read(input, "fuzz");
    if (!sequence) {
        CARINA_EXPECTS(!sequence.error().detail.empty());
        return 0;
    }
    std::string text = pose_record::beginning();
    for (const RecordedTool& tool : sequence->tools) {
        CARINA_EXPECTS(!tool.samples.empty());
        for (const PoseSample& sample : tool.samples) {
            CARINA_EXPECTS(sample.X_FO.translation().allFinite()
                           && std::abs(sample.X_FO.rotation().norm() - 1.0) < 1e-9);
            text += pose_record::line(tool, sample);
        }
    }
    std::istringstream written{text};
    const auto again = pose_record::read(written, "written");
    CARINA_EXPECTS(again && again->tools.size() == sequence->tools.size());
    return 0;
}
