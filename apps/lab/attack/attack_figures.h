#pragma once

#include "apps/lab/attack/attacks.h"
#include "apps/lab/attack/witness.h"

#include <array>
#include <map>
#include <optional>
#include <vector>

namespace carina::lab
{

/// What one attack did to a session.
struct AttackFigures {
    const AttackKind* kind = nullptr;
    Duration length{};     ///< of the attack
    int guests = 0;        ///< who took part besides
    std::int64_t sent = 0; ///< as the attack counts
    bool isTakenForAnother = false;
    ShownPlaces usual{};           ///< in a period of the trainee's motion, before anybody attacked
    Seen before{};                 ///< in as much time before it as an attack lasts at least
    Seen during{};                 ///< in the time of the attack
    std::int64_t patientsLaid = 0; ///< in it, because the attacker chose them
    /// How long a newcomer of each role took meanwhile; nothing: not within 10 s.
    std::map<Role, std::optional<Duration>> joined{};
    std::int64_t putOut = 0; ///< of those who only take part, how many were not present throughout
    std::int64_t moved = 0;  ///< objects of others that an observer was shown elsewhere than before
    std::vector<Measured> measured{}; ///< by the attack
    std::int64_t facts = 0;           ///< by which the log is longer afterwards
    std::int64_t paths = 0;           ///< over which nobody came in, at most at once
    /// By which console and trainee hold more afterwards; nothing where that was not measured.
    std::vector<std::optional<double>> memory_kb{};
    /// The same of the same attack once more; empty where it was not repeated, or was weaker.
    std::vector<std::optional<double>> memoryAgain_kb{};
};

/// The drift that is usual in a session at the phases of the motion that were seen in the attack.
[[nodiscard]] double usualDriftOf_mm(const AttackFigures& figures);

/// How often the trainee's tube may be elsewhere from one sample to the next: once for each patient
/// that the attacker had laid. Nobody else lays one in that time.
[[nodiscard]] std::int64_t mostJumpsOf(const AttackFigures& figures);

/// Facts that may come of it, and without how many it was no such attack.
[[nodiscard]] double mostFactsOf(const AttackFigures& figures);
[[nodiscard]] double leastFactsOf(const AttackFigures& figures);

/// The longest gap between two samples that may be, however many take part.
inline constexpr double kMostGap_ms = 100.0;

/// The memory that may come of it at console and trainee: what programs that draw vary by, and the
/// facts and paths that came of the attack.
[[nodiscard]] std::array<double, 2> mostMemoryOf_kb(const AttackFigures& figures);

/// The least that the console would have to keep of each datagram, handshake or Hello sent, in
/// bytes, for its memory to exceed that.
[[nodiscard]] double leastLeakOf_bytes(const AttackFigures& figures);

/// Whether the attack did what it is for, and the host kept to what it promises of it.
[[nodiscard]] bool holdsOwn(const AttackFigures& figures);

/// Whether no more memory is held than may come of the attack, or no more for a second one like it:
/// what is needed for the first time, and heaps that have grown, stay; what is forgotten to be
/// given back is kept each time.
[[nodiscard]] bool holdsMemory(const AttackFigures& figures);

/// Whether the session held, and the attack did what it is for.
[[nodiscard]] bool holds(const AttackFigures& figures);

} // namespace carina::lab
