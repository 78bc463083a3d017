#include "engine/tracking/igtl/igtl_reader.h"

#include <algorithm>

namespace carina
{

void IgtlReader::take(std::span<const std::byte> bytes)
{
    if (m_isLost)
        return;
    const auto skipped = std::min<std::uint64_t>(m_toSkip, bytes.size());
    m_toSkip -= skipped;
    bytes = bytes.subspan(skipped);
    m_kept.erase(m_kept.begin(), m_kept.begin() + static_cast<std::ptrdiff_t>(m_read));
    m_read = 0;
    m_kept.insert(m_kept.end(), bytes.begin(), bytes.end());
}

std::optional<Result<IgtlMessage>> IgtlReader::next()
{
    if (!m_header)
        if (auto begun = begin(); begun)
            return begun;
    if (!m_header || m_kept.size() - m_read < m_header->bodyBytes)
        return std::nullopt;
    const auto body = std::span{m_kept}.subspan(m_read, m_header->bodyBytes);
    m_read += body.size();
    auto message = decodeIgtl(*m_header, body);
    m_header.reset();
    return message;
}

/// Reads a header. @returns what is to be said of its message, if that is not read.
std::optional<Result<IgtlMessage>> IgtlReader::begin()
{
    if (m_isLost || m_toSkip > 0 || m_kept.size() - m_read < IgtlHeader::kBytes)
        return std::nullopt;
    const auto header = IgtlHeader::read(std::span{m_kept}.subspan(m_read, IgtlHeader::kBytes));
    if (!header) {
        m_isLost = true;
        m_kept.clear();
        m_read = 0;
        return tl::unexpected(header.error());
    }
    m_read += IgtlHeader::kBytes;
    const bool isRead = isReadIgtlType(header->type);
    if (isRead && header->bodyBytes + IgtlHeader::kBytes <= m_mostKept) {
        m_header = *header;
        return std::nullopt;
    }
    const auto there = std::min<std::uint64_t>(header->bodyBytes, m_kept.size() - m_read);
    m_read += there;
    m_toSkip = header->bodyBytes - there;
    if (isRead)
        return fail(Errc::DeviceReplyDamaged, header->type + ": longer than is read");
    return IgtlMessage{header->version,          header->device, header->stamp, 0, {},
                       IgtlSkipped{header->type}};
}

} // namespace carina
