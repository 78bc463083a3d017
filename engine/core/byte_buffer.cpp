#include "engine/core/byte_buffer.h"

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

} // namespace carina
