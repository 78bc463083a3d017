#pragma once

#include "engine/core/result.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace carina::transfer
{

/// The messages of the connection over which an anatomy set is transferred
/// (docs/anatomy-transfer.md). A frame is one byte of kind, u32 the length of its body, and the
/// body.

inline constexpr std::uint8_t kVersion = 1;
inline constexpr std::size_t kHeaderBytes = 5;
inline constexpr std::size_t kMostBody = std::size_t{64} << 10U;

/// A client requests a set; the first frame of a connection, sent once.
struct Want {
    std::uint8_t version = kVersion;
    std::string contentHash; ///< empty in a frame of another version
};

/// The host has the set, in this form.
struct Offer {
    std::uint64_t bytes = 0;
    std::string digest;
    std::string licence;
};

enum class Reason : std::uint8_t {
    NotNamed = 1,     ///< no station of the session uses this patient
    Withdrawn = 2,    ///< a station uses it, but the host no longer has it
    OtherVersion = 3, ///< of these frames
    Busy = 4,         ///< too many requests at once: try again later
};

/// The host refuses, and ends the connection.
struct Refusal {
    Reason reason = Reason::NotNamed;
};

/// The client requests the offered set, from this byte on.
struct Get {
    std::uint64_t offset = 0;
};

/// The next bytes of the set; in a decoded frame they refer to the buffer that was decoded.
struct Chunk {
    std::span<const std::byte> bytes;
};

using Frame = std::variant<Want, Offer, Refusal, Get, Chunk>;

/// @pre hashes satisfy isSetHash, a licence has at most 1024 bytes, a chunk 1 to kMostBody.
[[nodiscard]] std::vector<std::byte> encode(const Frame& frame);

/// Decodes the first frame of `bytes` and removes it from them; nothing while it is incomplete. The
/// header is checked before the body is there, so that a peer cannot announce more than kMostBody.
/// @returns PacketMalformed
[[nodiscard]] Result<std::optional<Frame>> takeFrame(std::span<const std::byte>& bytes);

} // namespace carina::transfer
