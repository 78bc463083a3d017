#include "engine/tracking/ndi/ndi_checksum.h"

#include <array>

namespace carina
{

std::uint16_t ndiChecksum(std::span<const std::byte> bytes)
{
    std::uint32_t crc = 0;
    for (const std::byte each : bytes) {
        crc ^= std::to_integer<std::uint32_t>(each);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xA001U : 0U);
    }
    return static_cast<std::uint16_t>(crc);
}

std::uint16_t ndiChecksum(std::string_view text)
{
    return ndiChecksum(std::as_bytes(std::span{text}));
}

std::string ndiChecksumText(std::string_view text)
{
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    const std::uint16_t crc = ndiChecksum(text);
    std::string written;
    for (int shift = 12; shift >= 0; shift -= 4)
        written += kDigits[(crc >> shift) & 0xF];
    return written;
}

} // namespace carina
