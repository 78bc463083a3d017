#pragma once

#include <compare>
#include <cstdint>
#include <functional>

namespace carina
{

/// A number that identifies a thing of one kind. Ids of different kinds are different types.
template <class Tag, class Number> struct Id {
    Number value{};

    friend constexpr auto operator<=>(const Id&, const Id&) = default;
};

/// One manikin with its tracker, tools and patient. The session host gives the numbers.
using StationId = Id<struct StationTag, std::uint16_t>;
/// In a change of the patient: each station that is open when the change is decided.
inline constexpr StationId kAllStations{0xFFFE};
/// In a fact that is of the session as a whole; in a proposal also where the host is to choose.
inline constexpr StationId kNoStation{0xFFFF};
/// One running program that takes part in a session. 0 is the session host.
using ParticipantId = Id<struct ParticipantTag, std::uint16_t>;
/// The id of a program that the session host has not admitted yet.
inline constexpr ParticipantId kNobody{0xFFFF};
/// One shared object (a tube, a head, a jaw), unique within the session.
using ObjectId = Id<struct ObjectTag, std::uint16_t>;
/// Position of a fact in the session's log, from 1 without gaps.
using FactNumber = Id<struct FactTag, std::uint64_t>;
/// Identifies one proposal of a fact; drawn at random by the proposer. A proposal is repeated until
/// it is acknowledged, also after a crash of either side, and with this id enters the log only
/// once.
using ProposalId = Id<struct ProposalTag, std::uint64_t>;

} // namespace carina

template <class Tag, class Number> struct std::hash<carina::Id<Tag, Number>> {
    std::size_t operator()(const carina::Id<Tag, Number>& id) const noexcept
    {
        return std::hash<Number>{}(id.value);
    }
};
