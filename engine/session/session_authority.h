#pragma once

#include "engine/core/result.h"
#include "engine/session/session_state.h"

#include <unordered_map>

namespace carina
{

/// What the session host decides: who may do what, under which number and from when on. No socket,
/// no clock, no disk; whoever drives it stores each fact before committing it here.
class SessionAuthority
{
public:
    /// Resumes from a log. @pre the facts are numbered 1, 2, 3, ...
    explicit SessionAuthority(const std::vector<Fact>& log);

    [[nodiscard]] const SessionState& state() const;

    /// The fact that a proposal becomes, not yet committed.
    ///
    /// The effect time is now + max(100 ms, slowestPath), so that it takes effect everywhere at
    /// once. A ParticipantJoined with participant 0 is given the id of the participant with the
    /// same name and role, else the next free one; an ObjectShared with object 0 that of the same
    /// owner, kind and name.
    ///
    /// @param author the role behind this id decides; the host itself (0) may everything.
    /// @returns NotPermitted where the author's role may not do this; SessionEnded after the end;
    ///          OutOfRange for a parameter outside the range a patient can have.
    [[nodiscard]] Result<Fact> judge(const Proposal& proposal, SessionTime now,
                                     Duration slowestPath) const;

    /// The fact that came of a proposal before, for one that is repeated.
    [[nodiscard]] std::optional<FactNumber> settled(ProposalId id) const;

    /// Takes over a fact that is on disk now.
    void commit(const Fact& fact);
};

} // namespace carina
