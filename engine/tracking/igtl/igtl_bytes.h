#pragma once

#include "engine/core/byte_buffer.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace carina
{

/// Appends numbers as OpenIGTLink has them: big endian.
class IgtlWriter
{
public:
    explicit IgtlWriter(std::vector<std::byte>& out) : m_out{out} {}

    template <std::integral Number> void number(Number value)
    {
        const auto bits = static_cast<std::uint64_t>(value);
        for (std::size_t shift = 8 * sizeof value; shift > 0; shift -= 8)
            m_out.push_back(static_cast<std::byte>((bits >> (shift - 8)) & 0xFFU));
    }
    void real(float value) { number(std::bit_cast<std::uint32_t>(value)); }
    void reals(std::span<const float> values)
    {
        for (const float value : values)
            real(value);
    }
    void bytes(std::string_view text)
    {
        for (const char c : text)
            m_out.push_back(static_cast<std::byte>(c));
    }
    /// A text in a field of fixed width, filled up with zeros; what is longer is cut.
    void field(std::string_view text, std::size_t width)
    {
        bytes(text.substr(0, width));
        m_out.resize(m_out.size() + width - std::min(width, text.size()));
    }

private:
    std::vector<std::byte>& m_out;
};

/// Reads what IgtlWriter wrote, from untrusted bytes; fails as ByteReader does.
class IgtlBytes
{
public:
    explicit IgtlBytes(std::span<const std::byte> bytes) : m_bytes{bytes} {}

    template <std::integral Number> Number number()
    {
        std::uint64_t bits = 0;
        for (const std::byte b : m_bytes.bytes(sizeof(Number)))
            bits = (bits << 8U) | std::to_integer<std::uint64_t>(b);
        return static_cast<Number>(bits);
    }
    float real() { return std::bit_cast<float>(number<std::uint32_t>()); }
    template <std::size_t Count> std::array<float, Count> reals()
    {
        std::array<float, Count> values{};
        for (float& value : values)
            value = real();
        return values;
    }
    std::string bytes(std::size_t count)
    {
        const auto taken = m_bytes.bytes(count);
        return {reinterpret_cast<const char*>(taken.data()), taken.size()};
    }
    /// A text in a field of fixed width, up to its first zero.
    std::string field(std::size_t width)
    {
        std::string text = bytes(width);
        text.resize(std::min(text.find('\0'), text.size()));
        return text;
    }
    /// The next bytes, to be read on their own.
    IgtlBytes part(std::size_t count) { return IgtlBytes{m_bytes.bytes(count)}; }

    void require(bool holds, const char* rule) { m_bytes.require(holds, rule); }
    [[nodiscard]] bool ok() const { return m_bytes.ok(); }
    /// @pre !ok()
    [[nodiscard]] const char* brokenRule() const { return m_bytes.brokenRule(); }
    [[nodiscard]] std::size_t remaining() const { return m_bytes.remaining(); }

private:
    ByteReader m_bytes;
};

} // namespace carina
