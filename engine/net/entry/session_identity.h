#pragma once

#include "engine/sync/wire/datagram.h"

#include <string>

namespace carina
{

/// 128 random bits in hexadecimal, for a new session.
[[nodiscard]] std::string newSessionId();

/// The same bits in binary form. Other characters than hexadecimal digits are skipped, missing
/// bytes are zero.
[[nodiscard]] SessionKey sessionKey(const std::string& sessionId);

} // namespace carina
