#pragma once

#include "engine/core/ids.h"

#include <cstdint>
#include <string>

namespace carina
{

enum class Role : std::uint8_t { Instructor, Trainee, Observer };

/// Facts about who may take part. Station and effect time of the enclosing Fact have no meaning.
namespace fact
{

/// A muted participant sees everything; nothing that it sends changes or moves anything. It holds
/// until it is taken back, also when the participant comes in again.
struct ParticipantMuted {
    ParticipantId participant;
    bool muted = true;

    friend bool operator==(const ParticipantMuted&, const ParticipantMuted&) = default;
};
/// A participant has to leave. Without a ban its user may join again.
struct ParticipantRemoved {
    ParticipantId participant;
    bool banned = false;
    std::string reason; ///< shown to the participant; may be empty

    friend bool operator==(const ParticipantRemoved&, const ParticipantRemoved&) = default;
};
/// A participant who was banned may join again.
struct BanLifted {
    ParticipantId participant;

    friend bool operator==(const BanLifted&, const BanLifted&) = default;
};
/// A locked session admits nobody new.
struct SessionLocked {
    bool locked = true;

    friend bool operator==(const SessionLocked&, const SessionLocked&) = default;
};
/// A role has a new join code, which only the host knows; the old one is void.
struct RoleCodeChanged {
    Role role = Role::Trainee;

    friend bool operator==(const RoleCodeChanged&, const RoleCodeChanged&) = default;
};
/// Two programs had a participant's token at the same time. It was replaced, and the program that
/// came in last has the new one.
struct TokenReplaced {
    ParticipantId participant;

    friend bool operator==(const TokenReplaced&, const TokenReplaced&) = default;
};

} // namespace fact

} // namespace carina
