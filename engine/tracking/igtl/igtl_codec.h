#pragma once

#include "engine/core/result.h"
#include "engine/tracking/igtl/igtl_message.h"

#include <cstddef>
#include <span>
#include <vector>

namespace carina
{

/// The 58 bytes in front of each message of OpenIGTLink.
struct IgtlHeader {
    static constexpr std::size_t kBytes = 58;

    std::uint16_t version = 1;
    std::string type;
    std::string device;
    std::uint64_t stamp = 0;
    std::uint64_t bodyBytes = 0;
    std::uint64_t checksum = 0;

    /// @returns DeviceReplyDamaged where what follows cannot be found any more: for a version other
    ///          than 1 and 2, a type that is no printable text, and a body longer than
    ///          kLongestIgtlBody.
    /// @pre kBytes bytes
    [[nodiscard]] static Result<IgtlHeader> read(std::span<const std::byte> bytes);
};

/// The longest body, of whatever type, behind which the next message is looked for.
inline constexpr std::uint64_t kLongestIgtlBody = 256U << 20U;

/// Whether messages of this type are read; others are passed over.
[[nodiscard]] bool isReadIgtlType(const std::string& type);

/// The type of a message with this content: "TRANSFORM", "STT_TDATA" and so on.
[[nodiscard]] std::string typeOf(const IgtlContent& content);

/// Decodes a body. What is allocated for it is at most eleven times its size; the most for the
/// attributes of a surface, of which one has six bytes and a name.
///
/// @returns DeviceReplyDamaged for a wrong checksum, and for a length or number that contradicts
///          another one.
/// @pre isReadIgtlType(header.type); the body has header.bodyBytes bytes.
[[nodiscard]] Result<IgtlMessage> decodeIgtl(const IgtlHeader& header,
                                             std::span<const std::byte> body);

/// The bytes of a message. Metadata and id travel with version 2 only.
/// @pre the content is none that was skipped.
[[nodiscard]] std::vector<std::byte> encodeIgtl(const IgtlMessage& message);

} // namespace carina
