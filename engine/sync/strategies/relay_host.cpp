#include "engine/sync/strategies/relay_host.h"

#include "engine/sync/strategies/relayed_message.h"

namespace carina
{

std::unique_ptr<StarNode> RelayHost::make(const std::vector<ParticipantId>& participants, LocalTime)
{
    return std::make_unique<RelayHost>(participants);
}

void RelayHost::receive(ParticipantId from, std::span<const std::byte> bytes, LocalTime)
{
    const auto message = decodeRelayed(bytes);
    if (!message || message->from != from)
        return;
    for (const ParticipantId to : m_participants)
        if (to != from && (message->to == to || message->to == kAllOthers))
            send(to, {bytes.begin(), bytes.end()});
}

} // namespace carina
