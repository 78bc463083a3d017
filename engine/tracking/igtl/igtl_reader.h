#pragma once

#include "engine/tracking/igtl/igtl_codec.h"

#include <optional>

namespace carina
{

/// The messages in a stream of OpenIGTLink, which comes in pieces of any size. A message of a type
/// that is not read is passed over, and one that is damaged or too long is refused; the next one
/// follows behind the number of bytes that its header states. Nothing is allocated for bytes that
/// have not come.
class IgtlReader
{
public:
    /// @param mostKept the longest message that is read, in bytes
    explicit IgtlReader(std::size_t mostKept) : m_mostKept{mostKept} {}

    /// Takes what has arrived. Call next() until it gives nothing: what is kept then is less than
    /// one message.
    void take(std::span<const std::byte> bytes);

    /// The next message, IgtlSkipped for one that is passed over, or DeviceReplyDamaged for one
    /// that is refused; nothing before its end has come.
    [[nodiscard]] std::optional<Result<IgtlMessage>> next();

    /// Whether the stream has no header where one is due: nothing more can be read of it.
    [[nodiscard]] bool isLost() const { return m_isLost; }
    /// Whether a message has come in part.
    [[nodiscard]] bool isWithin() const
    {
        return m_header || m_toSkip > 0 || m_read < m_kept.size();
    }

private:
    [[nodiscard]] std::optional<Result<IgtlMessage>> begin();

    std::size_t m_mostKept;
    std::vector<std::byte> m_kept; ///< from m_read on not yet read
    std::size_t m_read = 0;
    std::uint64_t m_toSkip = 0;
    std::optional<IgtlHeader> m_header; ///< whose body is to come
    bool m_isLost = false;
};

} // namespace carina
