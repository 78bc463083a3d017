#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace carina
{

/// The checksum of a body in OpenIGTLink: CRC-64 with the polynomial 42F0E1EBA9EA3693 of ECMA-182,
/// most significant bit first, from 0.
[[nodiscard]] std::uint64_t igtlChecksum(std::span<const std::byte> body);

} // namespace carina
