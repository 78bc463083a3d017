// Any bytes as a trajectory in TUM form: refused with a reason, or read as poses that are proper,
// in ascending order of time.

#include "engine/core/expects.h"
#include "engine/tracking/tum_file.h"

#include <cmath>
#include <cstdint>
#include <sstream>

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace carina;
    std::istringstream input{std::string{reinterpret_cast<const char*>(data), size}};
    const auto samples = readTum(input, "fuzz");
    if (!samples) {
        CARINA_EXPECTS(!samples.error().detail.empty());
        return 0;
    }
    CARINA_EXPECTS(!samples->empty() && samples->front().time == SessionTime{});
    for (std::size_t i = 0; i < samples->size(); ++i) {
        const PoseSample& sample = (*samples)[i];
        CARINA_EXPECTS(i == 0 || sample.time > (*samples)[i - 1].time);
        CARINA_EXPECTS(sample.X_FO.translation().allFinite()
                       && std::abs(sample.X_FO.rotation().norm() - 1.0) < 1e-9);
    }
    return 0;
}
