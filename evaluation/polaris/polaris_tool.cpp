#include "evaluation/polaris/polaris_tool.h"

#include "evaluation/polaris/polaris_bytes.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace carina
{
namespace
{

using polaris::written;

constexpr std::size_t kFileBytes = 752;
constexpr std::size_t kSumAt = 4;
constexpr std::size_t kSummedFrom = 6;
constexpr std::size_t kTypeAt = 12;
constexpr std::size_t kRevisionAt = 16;
constexpr std::size_t kSerialAt = 20;
constexpr std::size_t kAngleAt = 24;
constexpr std::size_t kCountAt = 28;
constexpr std::size_t kFewestAt = 32;
constexpr std::size_t kErrorAt = 36;
constexpr std::size_t kMarkersAt = 72;
constexpr std::size_t kNormalsAt = 312;
constexpr std::size_t kMakerAt = 580;
constexpr std::size_t kMakerBytes = 12;
constexpr std::size_t kPartNumberAt = 592;
constexpr std::size_t kPartNumberBytes = 20;

constexpr unsigned kMostMarkers = 20;
constexpr double kFarthest_mm = 2000.0;

tl::unexpected<Error> wrong(std::string what) { return fail(Errc::FileMalformed, std::move(what)); }

unsigned byteIn(const std::string& bytes, std::size_t at)
{
    return static_cast<unsigned char>(bytes[at]);
}

/// Four bytes, the least significant first.
unsigned wholeIn(const std::string& bytes, std::size_t at)
{
    unsigned value = 0;
    for (std::size_t i = 4; i-- > 0;)
        value = 256 * value + byteIn(bytes, at + i);
    return value;
}

double realIn(const std::string& bytes, std::size_t at)
{
    return double(std::bit_cast<float>(wholeIn(bytes, at)));
}

Vec3 vectorIn(const std::string& bytes, std::size_t at)
{
    return {realIn(bytes, at), realIn(bytes, at + 4), realIn(bytes, at + 8)};
}

/// Up to the first byte that does not print.
std::string textIn(const std::string& bytes, std::size_t at, std::size_t most)
{
    const std::string field = bytes.substr(at, most);
    return {field.begin(),
            std::ranges::find_if(field, [](char each) { return each < ' ' || each > '~'; })};
}

/// Eight digits, as PHINF has them.
std::string digitsIn(const std::string& bytes, std::size_t at)
{
    return written("%08X", wholeIn(bytes, at));
}

std::string informationIn(const std::string& bytes)
{
    std::string maker = textIn(bytes, kMakerAt, kMakerBytes);
    maker.resize(kMakerBytes, ' ');
    return digitsIn(bytes, kTypeAt) + maker + written("%03u", byteIn(bytes, kRevisionAt))
           + digitsIn(bytes, kSerialAt);
}

unsigned sumOf(const std::string& bytes)
{
    unsigned sum = 0;
    for (std::size_t i = kSummedFrom; i < kFileBytes; ++i)
        sum += byteIn(bytes, i);
    return sum & 0xFFFFU;
}

} // namespace

Result<PolarisTool> polarisTool(const std::string& bytes)
{
    if (bytes.size() != kFileBytes)
        return wrong("it has " + std::to_string(bytes.size()) + " bytes, not 752");
    if (!bytes.starts_with(std::string{"NDI\0", 4}))
        return wrong("it does not begin with NDI");
    if (const unsigned stated = wholeIn(bytes, kSumAt) & 0xFFFFU; stated != sumOf(bytes))
        return wrong("its checksum is " + written("%04X", stated) + ", and that of its bytes "
                     + written("%04X", sumOf(bytes)));
    const unsigned count = wholeIn(bytes, kCountAt);
    if (count == 0 || count > kMostMarkers)
        return wrong("it states " + std::to_string(count) + " markers, not 1 to 20");
    PolarisTool tool{.information = informationIn(bytes),
                     .partNumber = textIn(bytes, kPartNumberAt, kPartNumberBytes),
                     .fewestMarkers = wholeIn(bytes, kFewestAt),
                     .largestError_mm = realIn(bytes, kErrorAt),
                     .largestAngle_deg = double(wholeIn(bytes, kAngleAt))};
    if (tool.fewestMarkers > count)
        return wrong("a pose needs " + std::to_string(tool.fewestMarkers) + " markers, and it has "
                     + std::to_string(count));
    for (std::size_t i = 0; i < count; ++i) {
        tool.markers.push_back(
            {vectorIn(bytes, kMarkersAt + 12 * i), vectorIn(bytes, kNormalsAt + 12 * i)});
        const PolarisTool::Marker& marker = tool.markers.back();
        if (!marker.normal.allFinite() || !(marker.p_mm.norm() <= kFarthest_mm))
            return wrong("its marker " + std::to_string(i + 1)
                         + " is not within 2 m of its origin");
    }
    return tool;
}

bool haveSameMarkers(const PolarisTool& one, const PolarisTool& other)
{
    return std::ranges::equal(one.markers, other.markers,
                              [](const auto& a, const auto& b) { return a.p_mm == b.p_mm; });
}

} // namespace carina
