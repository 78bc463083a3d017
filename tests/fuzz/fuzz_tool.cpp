// Any bytes as the definition of a tool of NDI (.rom): refused with a reason, or read as markers
// near the tool, and kept byte by byte. The first byte says whether the checksum is made right, so
// that what stands behind it is reached.

#include "engine/core/expects.h"
#include "engine/tracking/ndi/tool_definition.h"

#include <algorithm>
#include <numeric>

namespace
{

using namespace carina;

constexpr std::size_t kChecksumAt = 4;
constexpr std::size_t kSummedFrom = 6;

/// Of the length of a definition, and with the checksum of what it holds.
std::vector<std::uint8_t> made(std::vector<std::uint8_t> bytes)
{
    bytes.resize(NdiToolDefinition::kBytes);
    const unsigned sum = std::accumulate(bytes.begin() + kSummedFrom, bytes.end(), 0U);
    bytes[kChecksumAt] = static_cast<std::uint8_t>(sum);
    bytes[kChecksumAt + 1] = static_cast<std::uint8_t>(sum >> 8U);
    return bytes;
}

} // namespace

// libFuzzer calls it by this name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0)
        return 0;
    std::vector<std::uint8_t> octets{data + 1, data + size};
    if (data[0] % 2 == 1)
        octets = made(std::move(octets));
    const auto bytes = std::as_bytes(std::span{octets});
    const auto tool = NdiToolDefinition::read(bytes);
    if (!tool) {
        CARINA_EXPECTS(!tool.error().detail.empty());
        return 0;
    }
    CARINA_EXPECTS(std::ranges::equal(tool->bytes(), bytes));
    const auto markers = tool->markers();
    CARINA_EXPECTS(!markers.empty() && markers.size() <= NdiToolDefinition::kMostMarkers);
    for (const ToolMarker& marker : markers)
        CARINA_EXPECTS(marker.p_OQ.cwiseAbs().maxCoeff() <= 2.0 && marker.normal_O.allFinite());
    (void)kindName(tool->kind());
    CARINA_EXPECTS(tool->maker().size() <= 12 && tool->partNumber().size() <= 20);
    return 0;
}
