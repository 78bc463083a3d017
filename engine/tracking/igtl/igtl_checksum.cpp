#include "engine/tracking/igtl/igtl_checksum.h"

#include <array>

namespace carina
{
namespace
{

constexpr std::uint64_t kEcmaPolynomial = 0x42F0E1EBA9EA3693;
constexpr unsigned kTopByte = 56;

/// The remainder of each byte.
constexpr std::array<std::uint64_t, 256> ecmaTable()
{
    std::array<std::uint64_t, 256> table{};
    for (std::uint64_t byte = 0; byte < table.size(); ++byte) {
        std::uint64_t remainder = byte << kTopByte;
        for (int bit = 0; bit < 8; ++bit)
            remainder = (remainder << 1U) ^ ((remainder >> 63U) != 0 ? kEcmaPolynomial : 0U);
        table[byte] = remainder;
    }
    return table;
}

constexpr auto kEcmaTable = ecmaTable();

} // namespace

std::uint64_t igtlChecksum(std::span<const std::byte> body)
{
    std::uint64_t sum = 0;
    for (const std::byte b : body)
        sum = kEcmaTable[(sum >> kTopByte) ^ std::to_integer<std::uint64_t>(b)] ^ (sum << 8U);
    return sum;
}

} // namespace carina
