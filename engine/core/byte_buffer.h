#pragma once

#include "engine/core/expects.h"

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace carina
{

/// Encodes numbers as little-endian bytes on any machine and passes them to Sink::put.
template <class Sink> class NumberWriter
{
public:
    template <std::integral Number> void number(Number value) { littleEndian<sizeof value>(value); }
    /// The lower 24 bits of a signed number.
    void int24(std::int32_t value) { littleEndian<3>(value); }
    void real(float value) { number(std::bit_cast<std::uint32_t>(value)); }
    void real(double value) { number(std::bit_cast<std::uint64_t>(value)); }

private:
    template <std::size_t Bytes, std::integral Number> void littleEndian(Number value)
    {
        std::array<std::byte, Bytes> encoded;
        auto bits = static_cast<std::uint64_t>(value);
        for (std::byte& b : encoded) {
            b = static_cast<std::byte>(bits & 0xFFU);
            bits >>= 8;
        }
        static_cast<Sink*>(this)->put(encoded);
    }
};

/// Appends to a buffer.
class ByteWriter : public NumberWriter<ByteWriter>
{
public:
    explicit ByteWriter(std::vector<std::byte>& out) : m_out{out} {}

    void bytes(std::span<const std::byte> bytes)
    {
        m_out.insert(m_out.end(), bytes.begin(), bytes.end());
    }
    template <std::size_t Bytes> void put(const std::array<std::byte, Bytes>& encoded)
    {
        for (const std::byte b : encoded)
            m_out.push_back(b);
    }

private:
    std::vector<std::byte>& m_out;
};

/// Writes into a block of fixed size, three times as fast as into a growing buffer.
template <std::size_t Size> class BlockWriter : public NumberWriter<BlockWriter<Size>>
{
public:
    [[nodiscard]] std::span<const std::byte> bytes() const { return {m_block.data(), m_at}; }
    /// @pre there is room.
    template <std::size_t Bytes> void put(const std::array<std::byte, Bytes>& encoded)
    {
        CARINA_EXPECTS(m_at + Bytes <= Size);
        std::memcpy(m_block.data() + m_at, encoded.data(), Bytes);
        m_at += Bytes;
    }

private:
    std::array<std::byte, Size> m_block; // the first m_at are written
    std::size_t m_at = 0;
};

/// Reads what ByteWriter wrote, from untrusted bytes.
///
/// The first read beyond the end, or the first require() that fails, makes ok() false permanently;
/// reads then return zero. A decoder can therefore read all fields and check once at the end.
class ByteReader
{
public:
    explicit ByteReader(std::span<const std::byte> bytes) : m_rest{bytes} {}

    template <std::integral Number> Number number()
    {
        return static_cast<Number>(littleEndian<sizeof(Number)>());
    }
    std::int32_t int24()
    {
        // Shifted up to the sign bit and back, so that the sign is extended.
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(littleEndian<3>()) << 8U) >> 8;
    }
    float realFloat() { return std::bit_cast<float>(number<std::uint32_t>()); }
    double realDouble() { return std::bit_cast<double>(number<std::uint64_t>()); }
    /// The next `count` bytes, not copied; empty where fewer are left.
    std::span<const std::byte> bytes(std::size_t count);

    /// Checks a rule of the format. @param rule name of the rule, for the detail of the error
    void require(bool holds, const char* rule)
    {
        if (!holds && ok())
            m_brokenRule = rule;
    }

    [[nodiscard]] bool ok() const { return m_brokenRule == nullptr; }
    /// @pre !ok()
    [[nodiscard]] const char* brokenRule() const { return m_brokenRule; }
    [[nodiscard]] std::size_t remaining() const { return m_rest.size(); }

private:
    template <std::size_t Bytes> std::uint64_t littleEndian()
    {
        if (m_rest.size() < Bytes || !ok()) {
            require(false, "length");
            return 0;
        }
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < Bytes; ++i)
            bits |= std::to_integer<std::uint64_t>(m_rest[i]) << (8 * i);
        m_rest = m_rest.subspan(Bytes);
        return bits;
    }

    std::span<const std::byte> m_rest;
    const char* m_brokenRule = nullptr;
};

} // namespace carina
