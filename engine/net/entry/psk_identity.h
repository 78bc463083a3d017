#pragma once

#include "engine/core/ids.h"
#include "engine/session/facts/facts.h"

#include <optional>
#include <string>
#include <string_view>

namespace carina
{

/// What a peer's key authenticates it as: holder of a role's code, or of one participant's token.
struct Credential {
    Role role = Role::Observer;
    std::optional<ParticipantId> participant;

    friend bool operator==(const Credential&, const Credential&) = default;
};

/// The PSK identity under which a peer offers its key. It is sent unencrypted.
struct PskIdentity {
    Credential who;
    std::string sessionId;

    friend bool operator==(const PskIdentity&, const PskIdentity&) = default;
};

/// "trainee:<session id>:7"; "new" in place of the number for a peer with a code.
[[nodiscard]] std::string toText(const PskIdentity& identity);
/// Inverse of toText; nothing for other texts.
[[nodiscard]] std::optional<PskIdentity> pskIdentity(std::string_view text);

/// "instructor", "trainee" or "observer".
[[nodiscard]] std::string_view roleWord(Role role);
[[nodiscard]] std::optional<Role> roleOfWord(std::string_view word);

/// Whether the text is 32 lower-case hexadecimal digits.
[[nodiscard]] bool isSessionId(std::string_view text);

} // namespace carina
