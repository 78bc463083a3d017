#pragma once

#include "apps/lab/attack/intruder.h"

#include <span>

namespace carina::lab
{

/// What an attacker knows of a session.
struct Target {
    std::uint16_t port = 0;
    JoinCodes codes;
    DeriveKey derive;
    std::string victim;   ///< name of a trainee who is present
    std::string attacker; ///< name under which it comes in itself
};

/// With which attacks draw at random.
inline constexpr unsigned kAttackSeed = 20;

/// With the code of a role.
[[nodiscard]] WayIn wayIn(const Target& target, Role role);

/// An attack under way.
class Attack
{
public:
    virtual ~Attack() = default;
    /// Sends what a turn has time for; to be called in a loop that also works the events.
    virtual void step() = 0;
    /// Datagrams, handshakes or Hellos sent, as the attack counts.
    [[nodiscard]] virtual std::int64_t sent() const = 0;
    /// Whether the host took it for a participant that it is not.
    [[nodiscard]] virtual bool isTakenForAnother() const { return false; }
};

struct AttackKind {
    const char* name;
    const char* what; ///< for the help: what is done, and with whose code
    double mostFacts; ///< that may come of it, whatever its length
    double factsPerS; ///< and beside these, in a second
    double mostPaths; ///< that it leaves at the host for a while
    std::unique_ptr<Attack> (*begin)(const Target& target);
};

[[nodiscard]] std::span<const AttackKind> attackKinds();

} // namespace carina::lab
