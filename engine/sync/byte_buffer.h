#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace carina
{

/// Appends numbers to a buffer, little endian whatever the machine.
class ByteWriter
{
public:
    explicit ByteWriter(std::vector<std::byte>& out) : m_out{out} {}

    template <std::integral Number> void number(Number value) { littleEndian(value, sizeof value); }
    /// The lower 24 bits of a signed number.
    void int24(std::int32_t value) { littleEndian(value, 3); }
    void real(float value) { number(std::bit_cast<std::uint32_t>(value)); }
    void real(double value) { number(std::bit_cast<std::uint64_t>(value)); }
    void bytes(std::span<const std::byte> bytes)
    {
        m_out.insert(m_out.end(), bytes.begin(), bytes.end());
    }

private:
    template <std::integral Number> void littleEndian(Number value, std::size_t bytes)
    {
        auto bits = static_cast<std::uint64_t>(value);
        for (std::size_t i = 0; i < bytes; ++i, bits >>= 8)
            m_out.push_back(static_cast<std::byte>(bits & 0xFFU));
    }

    std::vector<std::byte>& m_out;
};

/// Reads what ByteWriter wrote, from bytes that nobody vouches for.
///
/// The first read past the end, or the first require() that does not hold, makes ok() false for
/// good; reads then give zero. So a decoder reads all its fields and asks once.
class ByteReader
{
public:
    explicit ByteReader(std::span<const std::byte> bytes) : m_rest{bytes} {}

    template <std::integral Number> Number number()
    {
        return static_cast<Number>(littleEndian(sizeof(Number)));
    }
    std::int32_t int24()
    {
        // Shifted up to the sign bit and back, so that the sign is extended.
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(littleEndian(3)) << 8U) >> 8;
    }
    float realFloat() { return std::bit_cast<float>(number<std::uint32_t>()); }
    double realDouble() { return std::bit_cast<double>(number<std::uint64_t>()); }
    /// The next `count` bytes, in place; empty when there are fewer.
    std::span<const std::byte> bytes(std::size_t count);

    /// Notes that the bytes break a rule of the format, named for the error's detail.
    void require(bool holds, const char* rule);

    [[nodiscard]] bool ok() const { return m_brokenRule == nullptr; }
    /// @pre !ok()
    [[nodiscard]] const char* brokenRule() const { return m_brokenRule; }
    [[nodiscard]] std::size_t remaining() const { return m_rest.size(); }

private:
    std::uint64_t littleEndian(std::size_t bytes);

    std::span<const std::byte> m_rest;
    const char* m_brokenRule = nullptr;
};

} // namespace carina
