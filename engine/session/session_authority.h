#pragma once

#include "engine/core/result.h"
#include "engine/session/name_index.h"
#include "engine/session/session_state.h"

#include <map>
#include <optional>
#include <vector>

namespace carina
{

/// Shortest time from the decision on a change to its effect; longer where a path is slower, so
/// that a change reaches every site before it takes effect.
inline constexpr Duration kShortestLead = std::chrono::milliseconds{100};

/// The decisions of the session host: who may do what, the number of each fact and its effect time.
/// Without socket, clock and disk; the caller stores each fact before it calls commit().
class SessionAuthority
{
public:
    /// Resumes from a log. @pre the facts are numbered 1, 2, 3, ...
    explicit SessionAuthority(const std::vector<Fact>& log);

    [[nodiscard]] const SessionState& state() const { return m_state; }

    /// The fact that a proposal becomes, not yet committed.
    ///
    /// A change of the patient or the phase takes effect at now + max(kShortestLead, slowestPath),
    /// so that it takes effect everywhere at the same time, and never before an earlier such fact,
    /// so that of two changes the later decided one holds. Facts about participants, objects and
    /// stations take effect now.
    ///
    /// A ParticipantJoined with participant 0 gets the id of the participant with the same name and
    /// role, else the next free one; an ObjectShared with object 0 that of the object with the same
    /// owner, kind and name, likewise. Other ids must exist. An ObjectHandedOver is refused unless
    /// it names the present epoch of the ownership.
    ///
    /// The station of a StationAdded, and of a ParticipantJoined at kNoStation, is given by
    /// settledStation. A change of the patient at kAllStations is one fact, and so has one effect
    /// time, for all stations that are open then.
    ///
    /// @param proposal its author decides what is permitted. The host itself (0) may propose
    ///        everything, a participant not yet admitted (kNobody) may join, instructors may
    ///        propose everything but SessionCreated, the parts of a checkpoint,
    ///        ParticipantJoined, ParticipantLeft, ParticipantFellSilent and TokenReplaced, trainees
    ///        may state how their registration stands and choose where others see them, and for the
    ///        station they are at share objects as themselves, hand these over to an instructor or
    ///        to who asked, ask for ownership, report breaths of the manikin, set cuff and stylet,
    ///        squeeze the bag and end a try while they are at work, take up work that nobody does
    ///        and pass on their own, observers may propose nothing and own nothing, and who is
    ///        muted nothing either, but for how their registration stands. IntubationNoted is of
    ///        who is at work at the station alone.
    /// @returns NotPermitted where the author's role does not permit it, for more objects than a
    ///          participant may share or own, for an object that passes to a trainee of another
    ///          station, and where the host or the last instructor is to be muted or removed;
    ///          Muted; SessionFull, NameUnclear, SessionLocked and Banned for a join; NameUnclear
    ///          for an object; NameUnclear, StationCount and StationOccupied for a station;
    ///          SessionEnded after the end, except for facts about participants, entry, shared
    ///          objects and lessons; OutOfRange for a parameter outside the range of a patient, an
    ///          unknown participant or object, a phase that cannot follow the present one, a breath
    ///          of the manikin or a step of an intubation too soon after the last, and what
    ///          changes nothing (checkNews);
    ///          StationUnknown for a station that is not open; OwnerChanged for an object that has
    ///          changed its owner meanwhile, and for work that another has taken meanwhile.
    [[nodiscard]] Result<Fact> judge(const Proposal& proposal, SessionTime now,
                                     Duration slowestPath) const;

    /// The fact that a repeated proposal became before; nothing for a new one.
    [[nodiscard]] std::optional<FactNumber> settled(ProposalId id) const;

    /// Applies a fact that is on disk now.
    void commit(const Fact& fact);

private:
    SessionState m_state;
    NameIndex m_names; // of all participants there ever were
    SessionTime m_latestEffect = SessionTime::min();
    std::map<ProposalId, FactNumber> m_settled; // ordered: programs choose the ids
};

} // namespace carina
