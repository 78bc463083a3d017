#pragma once

#include "engine/net/entry/token_folder.h"

#include <span>
#include <vector>

namespace carina
{

/// Datagrams about tokens, inside the encrypted path. They begin with "CT" where those of
/// engine/sync begin with "CA".

/// Request of an admitted client for its token; repeated until the token arrives.
[[nodiscard]] std::vector<std::byte> encodeTokenRequest();
/// Whether a datagram is a token request.
[[nodiscard]] bool isTokenRequest(std::span<const std::byte> bytes);

/// The host's answer.
[[nodiscard]] std::vector<std::byte> encodeToken(const TokenFolder::Token& token);
/// Nothing for any other datagram.
[[nodiscard]] std::optional<TokenFolder::Token> decodeToken(std::span<const std::byte> bytes);

} // namespace carina
