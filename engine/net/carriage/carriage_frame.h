#pragma once

#include "engine/core/result.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace carina::carriage
{

/// What two programs say over the connection by which an anatomy set travels
/// (docs/anatomy-transfer.md). A frame is one byte of kind, u32 the length of its body, and the
/// body.

inline constexpr std::uint8_t kVersion = 1;
inline constexpr std::size_t kHeaderBytes = 5;
inline constexpr std::size_t kMostBody = std::size_t{64} << 10U;

/// A client names the set it wants; once, first.
struct Want {
    std::uint8_t version = kVersion;
    std::string contentHash; ///< empty in another version than this
};

/// The host has it, in this form.
struct Offer {
    std::uint64_t bytes = 0;
    std::string digest;
    std::string licence;
};

enum class Reason : std::uint8_t {
    NotNamed = 1,     ///< no station of the session has this patient
    Withdrawn = 2,    ///< one has, but the host's computer has not got it any more
    OtherVersion = 3, ///< of these frames
    Busy = 4,         ///< too many ask at once: come again
};

/// The host's last word.
struct Refusal {
    Reason reason = Reason::NotNamed;
};

/// The client takes what was offered, from this byte on.
struct Get {
    std::uint64_t offset = 0;
};

/// The next bytes of it; in a decoded frame they lie where the frame was read from.
struct Chunk {
    std::span<const std::byte> bytes;
};

using Frame = std::variant<Want, Offer, Refusal, Get, Chunk>;

/// @pre hashes are such, a licence has at most 1024 bytes, a chunk 1 to kMostBody.
[[nodiscard]] std::vector<std::byte> encode(const Frame& frame);

/// The first frame of the bytes, which are left with what follows it; nothing while it is not there
/// whole. Looks at the header before it waits for the body, so that nobody makes it wait for more
/// than kMostBody.
/// @returns PacketMalformed
[[nodiscard]] Result<std::optional<Frame>> takeFrame(std::span<const std::byte>& bytes);

} // namespace carina::carriage
