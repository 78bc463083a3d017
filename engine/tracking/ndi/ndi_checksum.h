#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace carina
{

/// The CRC-16 of NDI's commands and replies: x^16 + x^15 + x^2 + 1, bits reflected (0xA001), from
/// 0, without a final exclusive or. Of "RESET" it is BE6F.
[[nodiscard]] std::uint16_t ndiChecksum(std::span<const std::byte> bytes);
[[nodiscard]] std::uint16_t ndiChecksum(std::string_view text);

/// As it stands behind a text: four capital hexadecimal digits.
[[nodiscard]] std::string ndiChecksumText(std::string_view text);

} // namespace carina
