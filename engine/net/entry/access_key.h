#pragma once

#include "engine/core/result.h"
#include "engine/sync/wire/datagram.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace carina
{

class JoinCode;

/// A pre-shared key of 256 bits: derived from a join code, or a token.
using AccessKey = std::array<std::byte, 32>;

/// A key from the system's cryptographic random number generator.
[[nodiscard]] AccessKey randomKey();

[[nodiscard]] std::string toHex(const AccessKey& key);
[[nodiscard]] std::optional<AccessKey> keyFromHex(const std::string& hex);

/// Derives the key of a code in a session. Slow on purpose; called on its own thread.
using DeriveKey = std::function<Result<AccessKey>(const JoinCode&, const SessionKey&)>;

/// Argon2id (RFC 9106) of the code's ten characters with the session's 128 bits as salt and the
/// "moderate" limits of libsodium: 256 MiB and 3 passes, about a second. Other threads of the
/// program never wait for the memory.
/// @returns NotEnoughMemory
[[nodiscard]] Result<AccessKey> deriveByArgon2id(const JoinCode& code, const SessionKey& session);

} // namespace carina
