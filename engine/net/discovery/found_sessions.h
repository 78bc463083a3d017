#pragma once

#include "engine/core/session_time.h"
#include "engine/net/discovery/session_notice.h"

#include <map>

namespace carina
{

/// A session and the address that its host answered from.
struct FoundSession {
    SessionNotice notice;
    std::string address; ///< IPv4, as JoinSettings takes it

    [[nodiscard]] bool isOnThisComputer() const { return address.starts_with("127."); }

    friend auto operator<=>(const FoundSession&, const FoundSession&) = default;
};

/// The sessions that answered lately. A host that is heard at several addresses of one computer is
/// one session: this computer's own address counts before the others, then the one heard first.
class FoundSessions
{
public:
    static constexpr Duration kForgottenAfter = std::chrono::milliseconds{3500};
    /// Whoever answers cannot fill the memory.
    static constexpr std::size_t kMost = 64;

    /// @returns whether list() changed.
    bool heard(const FoundSession& found, LocalTime now);
    /// Drops those that have not answered for kForgottenAfter. @returns whether list() changed.
    bool forget(LocalTime now);
    /// By name, then by session.
    [[nodiscard]] std::vector<FoundSession> list() const;

private:
    struct Heard {
        FoundSession found;
        LocalTime last{};
    };
    std::map<SessionKey, Heard> m_sessions;
};

} // namespace carina
