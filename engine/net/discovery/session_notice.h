#pragma once

#include "engine/sync/wire/datagram.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace carina
{

/// The UDP port at which hosts answer discovery questions.
inline constexpr std::uint16_t kDiscoveryPort = 47604;

/// What is public about a session on the network; joining it still requires a code.
struct SessionNotice {
    SessionKey session{};   ///< the session id
    std::string name;       ///< 1 to 64 bytes of UTF-8
    std::uint16_t port = 0; ///< UDP, not 0

    friend auto operator<=>(const SessionNotice&, const SessionNotice&) = default;
};

/// Who is looked for.
struct SessionQuestion {
    std::uint32_t nonce = 0; ///< repeated in the answers
    /// Only the session with this id answers; all zeros: every session that is announced to all.
    SessionKey session{};

    friend bool operator==(const SessionQuestion&, const SessionQuestion&) = default;
};

/// The discovery question (docs/protocol.md, "Discovery"). It is longer than any answer, so that
/// questions with a forged source address cannot amplify traffic.
[[nodiscard]] std::vector<std::byte> encodeQuestion(const SessionQuestion& question);
/// Nothing for any other bytes.
[[nodiscard]] std::optional<SessionQuestion> decodeQuestion(std::span<const std::byte> bytes);

/// @pre the notice is within the limits of SessionNotice.
[[nodiscard]] std::vector<std::byte> encodeAnswer(std::uint32_t nonce, const SessionNotice& notice);
/// Nothing for bytes that do not answer the question with this nonce.
[[nodiscard]] std::optional<SessionNotice> decodeAnswer(std::span<const std::byte> bytes,
                                                        std::uint32_t nonce);

} // namespace carina
