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
/// Objects that an instructor has been given who did not ask for them: what two trainees can share.
/// They are then the instructor's to give back, and 224 trainees could give ever more.
inline constexpr std::size_t kMostGiven = 16;
/// Groups of organs that a trainee may hold.
inline constexpr std::size_t kMostGroupsHeld = 4;

/// Open stations of a session.
inline constexpr std::size_t kMostStations = 8;
/// Over its whole life: what happened at them stays in its log.
inline constexpr std::size_t kMostStationsEver = 64;

/// Names that a session takes of a role, over its whole life: they stay in its log. Those of one
/// role leave room for the others, so that who has an observer's code keeps nobody else out.
[[nodiscard]] std::size_t mostNamesOf(Role role);
/// Of the participants of a role that are present at once, with those whose place is kept.
[[nodiscard]] std::size_t mostPresentOf(Role role);
/// How long the place of one who has gone is kept at most: that of who was there for less is kept
/// for as long as they were, so that names which come and go in turn hold no more places than those
/// who stay.
inline constexpr Duration kPlaceKept = std::chrono::minutes{2};

/// Of the names of a role, those that one address may bring in the life of a host's program, and of
/// its places, present or kept, those that one may have when somebody comes who has none: of the
/// rest nobody behind that address keeps out people elsewhere. A class of 216 has room.
[[nodiscard]] std::size_t mostNamesFrom(Role role);
[[nodiscard]] std::size_t mostPresentFrom(Role role);

} // namespace carina
