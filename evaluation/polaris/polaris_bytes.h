#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>

/// How a Polaris writes what it answers.
namespace carina::polaris
{

/// The CRC-16 that is at the end of each command and reply.
[[nodiscard]] unsigned crcOf(const std::string& bytes);

/// A reply in text, with its checksum and CR.
[[nodiscard]] std::string asText(const std::string& content);
/// A reply in binary, with its header and both checksums.
[[nodiscard]] std::string asBinary(const std::string& body);
[[nodiscard]] std::string error(unsigned code);

/// So many bytes, the least significant first.
[[nodiscard]] std::string little(std::uint64_t value, int bytes);
/// Four bytes of a number with a point.
[[nodiscard]] std::string real(double value);

/// Nothing where not all is hexadecimal digits, capital letters.
[[nodiscard]] std::optional<unsigned> hexadecimal(const std::string& digits);

/// At most 95 characters.
template <class... Values> std::string written(const char* format, Values... values)
{
    std::array<char, 96> text{};
    // NOLINTNEXTLINE(*-vararg): digits, as the table has them
    const int length = std::snprintf(text.data(), text.size(), format, values...);
    return {text.data(), std::size_t(length > 0 ? length : 0)};
}

} // namespace carina::polaris
