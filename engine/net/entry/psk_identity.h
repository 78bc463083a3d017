#pragma once

#include "engine/core/ids.h"
#include "engine/session/facts/facts.h"

#include <optional>
#include <string>
#include <string_view>

namespace carina
{

/// Who a peer has proved to be: the holder of a role's code, or of one participant's token.
struct Credential {
    Role role = Role::Observer;
    std::optional<ParticipantId> participant;

    friend bool operator==(const Credential&, const Credential&) = default;
};

/// Under which name a peer offers its key. It travels in the clear.
struct PskIdentity {
    Credential who;
    std::string sessionId;

    friend bool operator==(const PskIdentity&, const PskIdentity&) = default;
};

/// "trainee:<session id>:7"; "new" stands for the number of one who comes with a code.
[[nodiscard]] std::string toText(const PskIdentity& identity);
/// Nothing for a text that toText does not make.
[[nodiscard]] std::optional<PskIdentity> pskIdentity(std::string_view text);

/// "instructor", "trainee" or "observer".
[[nodiscard]] std::string_view roleWord(Role role);
[[nodiscard]] std::optional<Role> roleOfWord(std::string_view word);

/// 32 lower-case hexadecimal digits.
[[nodiscard]] bool isSessionId(std::string_view text);

} // namespace carina
