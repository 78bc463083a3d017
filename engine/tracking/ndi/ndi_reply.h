#pragma once

#include "engine/core/result.h"
#include "engine/tracking/ndi/ndi_checksum.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace carina
{

/// One whole reply of a tracker of NDI, its checksums found right and left out.
struct NdiReply {
    enum class Form : std::uint8_t {
        Text,   ///< ended by CR
        Binary, ///< of BX or BX2, with its length ahead
    };

    Form form = Form::Text;
    std::string bytes;

    friend bool operator==(const NdiReply&, const NdiReply&) = default;
};

/// The longest reply that is read. A tracker has at most 255 tools, of which each takes less than
/// 256 bytes in the replies that are asked for here, which are without positions of markers.
inline constexpr std::size_t kLongestNdiReply = 64 * 1024;

/// A text with its checksum behind it, without the CR. @returns DeviceReplyDamaged
[[nodiscard]] Result<std::string_view> checkedText(std::string_view text);

/// The code of a reply ERRORnn.
[[nodiscard]] std::optional<std::uint8_t> errorCode(const NdiReply& reply);

/// Whether a command was done: OKAY, perhaps with a warning.
[[nodiscard]] bool isFine(const NdiReply& reply);

/// Why a command was not done, for a reply that is not fine.
[[nodiscard]] std::string whyRefused(const NdiReply& reply);

/// Finds replies in a stream of bytes, whatever the pieces in which it arrives. Without a clock:
/// whoever waited in vain for the rest of a reply calls clear().
class NdiReplyReader
{
public:
    /// Appends what arrived. Beyond kLongestNdiReply nothing is kept: the next() is a refusal then.
    void take(std::span<const std::byte> arrived);
    void take(std::string_view arrived) { take(std::as_bytes(std::span{arrived})); }

    /// The next reply, or why the bytes in its place are none; nothing while more has to arrive.
    /// Reading goes on behind a refused reply: behind the next CR, or behind as many bytes as a
    /// binary one announces where its header is right.
    /// @returns DeviceReplyDamaged; the detail says which check failed.
    [[nodiscard]] std::optional<Result<NdiReply>> next();

    /// Forgets the beginning of a reply that did not go on.
    void clear() { m_bytes.clear(); }
    [[nodiscard]] bool isEmpty() const { return m_bytes.empty(); }

private:
    [[nodiscard]] std::optional<Result<NdiReply>> nextText();
    [[nodiscard]] std::optional<Result<NdiReply>> nextBinary(std::size_t lengthBytes);
    [[nodiscard]] std::string taken(std::size_t count);

    std::string m_bytes;
    bool m_overflowed = false;
};

} // namespace carina
