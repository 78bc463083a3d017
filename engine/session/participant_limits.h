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

/// What the host takes from all participants of a role together who come from one address: enough
/// for a class behind one router, and no more for one person under many names.
[[nodiscard]] SharedLimits sharedLimitsOf(Role role);

/// Objects that one participant may share in the life of a session, and own at once, without
/// what was lifted out.
[[nodiscard]] std::size_t mostObjectsOf(Role role);
/// Of these, a trainee's of one kind: who acts in `carina-lab drift --live` has
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

/// Names that a session takes of a role, over its whole life: they stay in its log. Those of one
/// role leave room for the others, so that who has an observer's code keeps nobody else out.
[[nodiscard]] std::size_t mostNamesOf(Role role);
/// Of the participants of a role that are present at once.
[[nodiscard]] std::size_t mostPresentOf(Role role);

} // namespace carina
