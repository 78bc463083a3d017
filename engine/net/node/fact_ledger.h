#pragma once

#include "engine/session/session_authority.h"
#include "engine/sync/facts/fact_record.h"

#include <deque>

namespace carina
{

/// The facts of a host between their decision and the disk: the session by all that is decided, the
/// session by what is stored, and what is between the two. Without disk and thread.
class FactLedger
{
public:
    struct Entry {
        Fact fact;
        FactRecord record;
    };

    /// @param authority by a log that is stored
    explicit FactLedger(SessionAuthority authority)
        : m_decided{authority}, m_stored{std::move(authority)}
    {
    }

    [[nodiscard]] const SessionAuthority& decided() const { return m_decided; }
    [[nodiscard]] const SessionAuthority& stored() const { return m_stored; }
    /// Facts that are decided and not stored.
    [[nodiscard]] std::size_t unstored() const { return m_unstored.size(); }
    /// One of these; nullptr where it is none of them.
    [[nodiscard]] const FactRecord* unstored(FactNumber number) const;

    /// A fact that is decided; stored later. @pre it was judged by decided()
    void enter(const Fact& fact);
    /// The facts that were not handed over to the disk yet; they count as handed over.
    [[nodiscard]] std::vector<FactRecord> handOver();
    /// How many were handed over since this was asked last: they are stored now, or given up.
    [[nodiscard]] std::size_t takeHandedOver() { return std::exchange(m_handedOver, 0); }
    /// The oldest is on disk. @pre unstored() > 0
    Entry storeOldest();
    /// What is decided cannot be stored: everything is as it was before. @returns what is undone
    std::vector<FactRecord> giveUp();

private:
    SessionAuthority m_decided;
    SessionAuthority m_stored;
    std::deque<Entry> m_unstored;
    std::size_t m_handedOver = 0; // the first of them
};

} // namespace carina
