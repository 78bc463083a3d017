#pragma once

#include "engine/sync/wire/datagram.h"

#include <string>

namespace carina
{

/// 128 random bits in hex, for a new session.
[[nodiscard]] std::string newSessionId();

/// The same bits as they travel. Of a text that is not one of newSessionId, what of it is hex.
[[nodiscard]] SessionKey sessionKey(const std::string& sessionId);

} // namespace carina
