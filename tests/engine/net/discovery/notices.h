#pragma once

#include "engine/net/discovery/session_notice.h"

namespace carina
{

/// A session whose id is this byte sixteen times.
inline SessionNotice noticeOf(std::uint8_t id, const std::string& name = "Ward 3",
                              std::uint16_t port = 45000)
{
    SessionNotice notice{{}, name, port};
    notice.session.fill(std::byte{id});
    return notice;
}

} // namespace carina
