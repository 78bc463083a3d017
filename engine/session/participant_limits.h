#pragma once

#include "engine/session/facts/facts.h"
#include "engine/sync/connection/peer_budget.h"

#include <cstddef>

namespace carina
{

/// What the host takes from a participant of a role. A trainee's program sends one datagram of its
/// streams and an acknowledgement at 60 Hz; an instructor's moves sliders, too; an observer only
/// acknowledges. docs/security.md has the table.
[[nodiscard]] PeerLimits limitsOf(Role role);

/// Objects that one participant may have shared, without what was lifted out.
[[nodiscard]] std::size_t mostObjectsOf(Role role);
/// Objects of one kind that a trainee may have shared: who acts in `carina-lab drift --live` has
/// two.
inline constexpr std::size_t kMostOfAKind = 2;
/// Objects of a station that can be lifted out.
inline constexpr std::size_t kMostLiftables = 12;
/// Groups of organs that a trainee may hold.
inline constexpr std::size_t kMostGroupsHeld = 4;

/// Open stations of a session.
inline constexpr std::size_t kMostStations = 8;
/// Over its whole life: what happened at them stays in its log.
inline constexpr std::size_t kMostStationsEver = 64;

/// Participants that a session takes, over its whole life: their numbers and names stay in its log.
inline constexpr std::size_t kMostParticipants = 1024;
/// Of the participants of a role that are present at once.
[[nodiscard]] std::size_t mostPresentOf(Role role);

} // namespace carina
