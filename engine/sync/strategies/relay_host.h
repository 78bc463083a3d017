#pragma once

#include "engine/sync/strategies/strategy.h"

namespace carina
{

/// A host that forwards relayed messages at once and unchanged, and keeps no state.
class RelayHost final : public StarNode
{
public:
    /// As SyncStrategy::makeHost.
    [[nodiscard]] static std::unique_ptr<StarNode>
    make(const std::vector<ParticipantId>& participants, LocalTime now);

    explicit RelayHost(std::vector<ParticipantId> participants)
        : m_participants{std::move(participants)}
    {
    }

    void receive(ParticipantId from, std::span<const std::byte> bytes, LocalTime now) override;
    void advance(LocalTime) override {}

private:
    std::vector<ParticipantId> m_participants;
};

} // namespace carina
