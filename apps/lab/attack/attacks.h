#pragma once

#include "apps/lab/attack/attackers/intruder.h"
#include "engine/sync/strategies/strategy_choice.h"

#include <limits>
#include <span>

namespace carina::lab
{

/// What an attacker knows of a session.
struct Target {
    std::uint16_t port = 0;
    JoinCodes codes;
    DeriveKey derive;
    std::string victim;                         ///< name of a trainee who is present
    std::string attacker;                       ///< name under which it comes in itself
    QHostAddress from{QHostAddress::LocalHost}; ///< where the attacker sits
};

/// With the code of a role.
[[nodiscard]] WayIn wayIn(const Target& target, Role role);

/// Something that an attack measures by itself, with its bounds.
struct Measured {
    const char* what;
    double figure;
    double least; ///< below it the attack did not do what it is for
    double most;  ///< above it the host did not hold; infinite: no bound
};

/// Something without which the attack did not do what it is for, and which may be ever so much.
[[nodiscard]] inline Measured atLeast(double least, const char* what, std::int64_t figure)
{
    return {what, static_cast<double>(figure), least, std::numeric_limits<double>::infinity()};
}

/// An attack under way.
class Attack
{
public:
    virtual ~Attack() = default;
    /// Sends what a turn has time for; to be called in a loop that also works the events.
    virtual void step() = 0;
    /// What really went out or came about, as the attack counts: datagrams over a path, paths that
    /// came to be encrypted, ClientHellos that the socket took, tokens that the host refused.
    [[nodiscard]] virtual std::int64_t sent() const = 0;
    /// Whether the host took it for a participant that it is not.
    [[nodiscard]] virtual bool isTakenForAnother() const { return false; }
    /// Patients that the host had laid because the attacker chose them. Each puts a trainee's tube
    /// elsewhere, once at most.
    [[nodiscard]] virtual std::int64_t patientsLaid() const { return 0; }
    /// Encrypted paths over which nobody came in, at most at once.
    [[nodiscard]] virtual std::int64_t mostPaths() const { return 0; }
    /// @param length of the attack so far
    [[nodiscard]] virtual std::vector<Measured> measured(Duration length) const
    {
        static_cast<void>(length);
        return {};
    }
};

struct AttackKind {
    const char* name;
    const char* what; ///< for the help: what is done, and with whose code
    std::unique_ptr<Attack> (*begin)(const Target& target);
    double mostFacts = 0.0;   ///< that may come of it, whatever its length
    double factsPerS = 0.0;   ///< and beside these, in a second
    double leastPerS = 0.0;   ///< facts in a second, without which it was no such attack
    double mostPaths = 0.0;   ///< over which nobody comes in, that the host keeps of it at once
    double leastSent = 100.0; ///< it goes on until it has sent as much
    StrategyKind strategy = StrategyKind::SessionClock; ///< of the session meanwhile
    std::optional<Role> spoils{}; ///< role whose code is void by it, so that nobody new comes in
    /// It comes from another address than all others, and is to keep out nobody new, even for a
    /// moment.
    bool isElsewhere = false;
    bool isAllOthers = false; ///< all that can act at the same time
    bool keepsOut = false;    ///< others of its address, who would come in late or find no place
    bool needsRoom = false;   ///< for so many names that the others would not all come in
};

/// How many can: not one that wants another strategy, nor one that voids the code by which others
/// come in, nor one that needs their room.
inline constexpr std::size_t kAttackersAtOnce = 18;
[[nodiscard]] bool actsBesideOthers(const AttackKind& kind);

[[nodiscard]] std::span<const AttackKind> attackKinds();

} // namespace carina::lab
