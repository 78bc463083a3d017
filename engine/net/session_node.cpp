#include "engine/net/session_node.h"

#include "engine/net/client_driver.h"
#include "engine/net/host_driver.h"
#include "engine/net/session_identity.h"
#include "engine/net/threaded_node.h"
#include "engine/session/fact_rules.h"

namespace carina
{

Result<std::unique_ptr<SessionNode>> SessionNode::host(const HostSettings& settings,
                                                       std::unique_ptr<FactStore> store)
{
    const auto valid =
        checkBody(fact::SessionCreated{settings.sessionName, newSessionId()}).and_then([&] {
            return checkBody(
                fact::ParticipantJoined{{}, Role::Instructor, settings.participantName});
        });
    if (!valid)
        return tl::unexpected(valid.error());
    return ThreadedNode::start(
        settings.port, [&](NodeBoard& board, LocalTime now) -> Result<std::unique_ptr<NodeDriver>> {
            return HostDriver::open(settings, std::move(store), board, now);
        });
}

Result<std::unique_ptr<SessionNode>> SessionNode::join(const JoinSettings& settings)
{
    const fact::ParticipantJoined joined{ParticipantId{}, settings.role, settings.participantName};
    if (const auto valid = checkBody(joined); !valid)
        return tl::unexpected(valid.error());
    return ThreadedNode::start(
        0, [&](NodeBoard& board, LocalTime now) -> Result<std::unique_ptr<NodeDriver>> {
            return std::make_unique<ClientDriver>(settings, loopbackAddress(settings.port), board,
                                                  now);
        });
}

} // namespace carina
