#include "engine/sync/byte_buffer.h"

namespace carina
{

std::span<const std::byte> ByteReader::bytes(std::size_t count)
{
    require(count <= m_rest.size(), "length");
    if (!ok())
        return {};
    const auto taken = m_rest.first(count);
    m_rest = m_rest.subspan(count);
    return taken;
}

void ByteReader::require(bool holds, const char* rule)
{
    if (!holds && ok())
        m_brokenRule = rule;
}

std::uint64_t ByteReader::littleEndian(std::size_t count)
{
    std::uint64_t bits = 0;
    std::size_t shift = 0;
    for (const std::byte b : bytes(count)) {
        bits |= std::to_integer<std::uint64_t>(b) << shift;
        shift += 8;
    }
    return bits;
}

} // namespace carina
