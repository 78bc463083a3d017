#pragma once

#include "engine/core/session_time.h"
#include "engine/net/discovery/session_notice.h"

#include <map>

namespace carina
{

/// A session and the address from which its host answered.
struct FoundSession {
    SessionNotice notice;
    std::string address; ///< IPv4, as JoinSettings takes it

    [[nodiscard]] bool isOnThisComputer() const { return address.starts_with("127."); }

    friend auto operator<=>(const FoundSession&, const FoundSession&) = default;
};

/// The sessions that answered recently. A session that answers from several addresses is listed
/// once: with the loopback address if there is one, else with the first one heard.
class FoundSessions
{
public:
    /// A session that has not answered for this long is removed.
    static constexpr Duration kForgottenAfter = std::chrono::milliseconds{3500};
    /// Most sessions stored, so that forged answers cannot exhaust the memory.
    static constexpr std::size_t kMost = 64;

    /// Notes an answer. @returns whether list() changed.
    bool heard(const FoundSession& found, LocalTime now);
    /// Removes sessions that have not answered for kForgottenAfter. @returns whether list()
    /// changed.
    bool forget(LocalTime now);
    /// Sorted by name, then by session id.
    [[nodiscard]] std::vector<FoundSession> list() const;

private:
    struct Heard {
        FoundSession found;
        LocalTime last{};
    };
    std::map<SessionKey, Heard> m_sessions;
};

} // namespace carina
