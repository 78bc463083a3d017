#pragma once

#include "engine/net/node/fact_ledger.h"
#include "engine/net/node/host_access.h"
#include "engine/net/node/host_paths.h"
#include "engine/net/node/origins.h"

#include <functional>
#include <map>

namespace carina
{

/// Why a participant who was removed does not come in.
[[nodiscard]] Error removalError(const SessionState& state, const Removal& removal);

/// Who comes into a host's session, and as whom: by what its path proved, by the facts, and by how
/// many come.
class HostEntry
{
public:
    /// New participants of a role from one address in a second; twice as many at once.
    static constexpr int kNewcomers = 40;
    /// The same from all addresses together: one does not use up what all have.
    static constexpr double kNewcomersOfAll = 2.0 * kNewcomers;

    /// Enters what is decided on a join. @returns the number of its fact
    using Decide = std::function<Result<FactNumber>(const Proposal&)>;

    /// All outlive it.
    HostEntry(const FactLedger& ledger, HostAccess& access, HostPaths& paths)
        : m_ledger{ledger}, m_access{access}, m_paths{paths}
    {
    }

    /// Whom a Hello over this path would be admitted as.
    /// @param log the facts that are stored
    [[nodiscard]] Result<Identity> identify(PeerAddress from, const Hello& hello,
                                            const std::vector<FactRecord>& log,
                                            SessionTime session) const;
    /// @param log the facts that are stored
    [[nodiscard]] Result<std::optional<Admission>> admit(PeerAddress from, const Hello& hello,
                                                         const std::vector<FactRecord>& log,
                                                         SessionTime session, LocalTime now,
                                                         const Decide& decide);

    /// What was decided and not stored is undone.
    void giveUp() { m_origins.forgetOthersThan(m_ledger.stored().state()); }

private:
    /// The proposal to join at the station that is wanted. @returns StationUnknown.
    [[nodiscard]] Result<Proposal> joinOf(const Hello& hello) const;
    /// @returns SessionLocked for who did not prove who it is; Removed for a run of a program that
    ///          was removed.
    [[nodiscard]] Result<void> checkReturn(PeerAddress from, ParticipantId id,
                                           ProposalId join) const;
    /// Whether the proposal became the fact that this participant joined.
    [[nodiscard]] bool isJoinOf(ProposalId proposal, ParticipantId participant,
                                const std::vector<FactRecord>& log) const;

    const FactLedger& m_ledger;
    HostAccess& m_access;
    HostPaths& m_paths;
    /// Whether one more who is new may come in now; counts it if so.
    [[nodiscard]] bool takesNewcomer(const Origins::Comer& comer, LocalTime now);

    /// Those of a role, so that one's do not keep out another's.
    struct Newcomers {
        SourceLimiter ofEach{{2 * kNewcomers, Duration{std::chrono::seconds{1}} / kNewcomers}};
        TokenBucket ofAll{};
    };

    Origins m_origins;
    std::map<Role, Newcomers> m_newcomers;
};

} // namespace carina
