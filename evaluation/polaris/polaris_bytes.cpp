#include "evaluation/polaris/polaris_bytes.h"

#include <bit>

namespace carina::polaris
{
namespace
{

// The check table of the CRC: a byte at a time.
const std::array<std::uint16_t, 256>& crcTable()
{
    static const auto table = [] {
        std::array<std::uint16_t, 256> made{};
        for (unsigned i = 0; i < made.size(); ++i) {
            unsigned value = i;
            for (int bit = 0; bit < 8; ++bit)
                value = (value % 2 == 1) ? value / 2 ^ 0xA001U : value / 2;
            made[i] = static_cast<std::uint16_t>(value);
        }
        return made;
    }();
    return table;
}

} // namespace

unsigned crcOf(const std::string& bytes)
{
    unsigned crc = 0;
    for (const char c : bytes)
        crc = crcTable()[(crc ^ static_cast<unsigned char>(c)) & 0xFFU] ^ (crc >> 8U);
    return crc;
}

std::string asText(const std::string& content)
{
    return content + written("%04X", crcOf(content)) + "\r";
}

std::string asBinary(const std::string& body)
{
    const std::string begin = little(0xA5C4, 2) + little(body.size(), 2);
    return begin + little(crcOf(begin), 2) + body + little(crcOf(body), 2);
}

std::string error(unsigned code) { return "ERROR" + written("%02X", code); }

std::string little(std::uint64_t value, int bytes)
{
    std::string out;
    for (int i = 0; i < bytes; ++i)
        out += char(value >> (8 * i) & 0xFFU);
    return out;
}

std::string real(double value) { return little(std::bit_cast<std::uint32_t>(float(value)), 4); }

std::optional<unsigned> hexadecimal(const std::string& digits)
{
    unsigned value = 0;
    if (digits.empty() || digits.find_first_not_of("0123456789ABCDEF") != std::string::npos)
        return std::nullopt;
    for (const char c : digits)
        value = 16 * value + unsigned(c <= '9' ? c - '0' : c - 'A' + 10);
    return value;
}

} // namespace carina::polaris
