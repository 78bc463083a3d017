#pragma once

#include "engine/core/result.h"
#include "engine/session/session_state.h"

#include <optional>
#include <unordered_map>
#include <vector>

namespace carina
{

/// A change reaches every site before it takes effect, or this late where all sites are near.
inline constexpr Duration kShortestLead = std::chrono::milliseconds{100};

/// What the session host decides: who may do what, under which number and from when on. No socket,
/// no clock, no disk; whoever drives it stores each fact before committing it here.
class SessionAuthority
{
public:
    /// Resumes from a log. @pre the facts are numbered 1, 2, 3, ...
    explicit SessionAuthority(const std::vector<Fact>& log);

    [[nodiscard]] const SessionState& state() const { return m_state; }

    /// The fact that a proposal becomes, not yet committed.
    ///
    /// What drives a patient or the phase takes effect at now + max(100 ms, slowestPath), so that
    /// it takes effect everywhere at once, and never before an earlier such fact, so that of two
    /// changes the later decided one holds. Who and what is there takes effect now.
    ///
    /// A ParticipantJoined with participant 0 is given the id of the participant with the same name
    /// and role, else the next free one; an ObjectShared with object 0 that of the same owner, kind
    /// and name. Ids other than 0 must be known. An ObjectHandedOver ends the ownership of its
    /// epoch or none.
    ///
    /// @param proposal its author decides. The host itself (0) may everything, who is not
    ///        admitted yet (kNobody) may join, instructors may all but create the session and leave
    ///        checkpoints, trainees may join, leave, share objects as themselves, hand these over
    ///        and tell of the breaths of the manikin at their station, observers only join and
    ///        leave, and own nothing.
    /// @returns NotPermitted where the author's role may not do this; SessionEnded after the end;
    ///          OutOfRange for a parameter outside the range a patient can have, an unknown
    ///          station, participant or object, and a phase that cannot follow the present one;
    ///          OwnerChanged for an object that has passed to somebody else meanwhile.
    [[nodiscard]] Result<Fact> judge(const Proposal& proposal, SessionTime now,
                                     Duration slowestPath) const;

    /// The fact that came of a proposal before, for one that is repeated.
    [[nodiscard]] std::optional<FactNumber> settled(ProposalId id) const;

    /// Takes over a fact that is on disk now.
    void commit(const Fact& fact);

private:
    SessionState m_state;
    SessionTime m_latestEffect = SessionTime::min();
    std::unordered_map<ProposalId, FactNumber> m_settled;
};

} // namespace carina
