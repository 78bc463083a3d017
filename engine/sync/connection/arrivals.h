#pragma once

#include "engine/sync/actions/host_actions.h"
#include "engine/sync/wire/datagram.h"

#include <map>
#include <optional>

namespace carina
{

/// Result of admitting a participant.
struct Admission {
    ParticipantId participant;
    /// The fact that the participant joined; it is welcomed once this is in the log. The number
    /// modulo 2^16 is the epoch of the participant's streams: it increases with each joining, also
    /// across a restart of the host.
    FactNumber joined;
};

/// Whom a join would be admitted as.
struct Identity {
    ParticipantId participant;
    bool isProven = false; ///< by a secret that only this participant and the host should have
};

/// A program that is admitted, and whose fact is on its way to the disk.
struct Arrival {
    BundleHeader header; ///< of its last Hello
    LocalTime heard;
    Hello hello;
    Admission admission;
};

/// The programs that are admitted and not welcomed yet, by the address they ask from.
class Arrivals
{
public:
    /// Notes a Hello from an address from which a program arrives; one of another program there has
    /// to ask again. @returns whether one arrives from there.
    [[nodiscard]] bool hears(PeerAddress from, const BundleHeader& header, const Hello& hello,
                             LocalTime now);
    /// In place of the same participant's program from another address.
    void add(PeerAddress from, const Arrival& arrival);
    void forget(ParticipantId participant);
    /// @returns who arrived from there, if anybody did.
    std::optional<ParticipantId> drop(PeerAddress from);
    /// Removes those whose fact this is.
    [[nodiscard]] std::map<PeerAddress, Arrival> takeWaitingFor(FactNumber joined);

    /// Whether a program from this address is one of them.
    [[nodiscard]] bool contains(PeerAddress from) const { return m_arrivals.contains(from); }
    /// One whose fact is in a log of this length, if there is any.
    [[nodiscard]] std::optional<PeerAddress> stored(FactNumber logEnd) const;
    [[nodiscard]] const Arrival& at(PeerAddress from) const { return m_arrivals.at(from); }
    [[nodiscard]] bool isHere(ParticipantId participant) const;
    /// Whether a program from another address keeps this participant from one with that join: it
    /// was heard less than `held` ago, and is not the same run of a program with the same proof.
    [[nodiscard]] bool keepsOut(PeerAddress from, const Identity& who, ProposalId join,
                                Duration held, LocalTime now) const;

private:
    std::map<PeerAddress, Arrival> m_arrivals;
};

} // namespace carina
