#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string>

namespace carina::test
{

/// Little-endian bytes, written one after another as NDI's tables of its binary replies list them.
class WireBytes
{
public:
    WireBytes& u8(std::uint32_t value) { return append(value, 1); }
    WireBytes& u16(std::uint32_t value) { return append(value, 2); }
    WireBytes& u32(std::uint32_t value) { return append(value, 4); }
    WireBytes& real(float value) { return u32(std::bit_cast<std::uint32_t>(value)); }
    WireBytes& bytes(const WireBytes& other)
    {
        m_bytes += other.m_bytes;
        return *this;
    }

    [[nodiscard]] const std::string& text() const { return m_bytes; }
    [[nodiscard]] std::span<const std::byte> span() const
    {
        return std::as_bytes(std::span{m_bytes});
    }
    [[nodiscard]] std::uint32_t size() const { return std::uint32_t(m_bytes.size()); }

private:
    WireBytes& append(std::uint32_t value, int count)
    {
        for (int i = 0; i < count; ++i)
            m_bytes += static_cast<char>((value >> (8 * i)) & 0xFFU);
        return *this;
    }

    std::string m_bytes;
};

} // namespace carina::test
