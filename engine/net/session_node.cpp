#include "engine/net/session_node.h"

#include "engine/net/client_driver.h"
#include "engine/net/host_driver.h"
#include "engine/net/secure/client_transport.h"
#include "engine/net/secure/host_transport.h"
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
    return ThreadedNode::start([&](NodeBoard& board, LocalTime now) -> Result<ThreadedNode::Parts> {
        auto transport = HostTransport::bind(settings.port, settings.open);
        if (!transport)
            return tl::unexpected(transport.error());
        auto driver = HostDriver::open(settings, std::move(store), board, now);
        if (!driver)
            return tl::unexpected(driver.error());
        const HostAccess& access = (*driver)->access();
        (*transport)->admit(access.sessionId(), [&access](const PskIdentity& identity) {
            return access.keyOf(identity);
        });
        return ThreadedNode::Parts{*std::move(driver), *std::move(transport), settings.open};
    });
}

Result<std::unique_ptr<SessionNode>> SessionNode::join(const JoinSettings& settings)
{
    const fact::ParticipantJoined joined{ParticipantId{}, settings.role, settings.participantName};
    if (const auto valid = checkBody(joined); !valid)
        return tl::unexpected(valid.error());
    const QHostAddress host{QString::fromStdString(settings.address)};
    if (host.isNull())
        return fail(Errc::OutOfRange, "the address '" + settings.address + "'");
    return ThreadedNode::start([&](NodeBoard& board, LocalTime now) -> Result<ThreadedNode::Parts> {
        auto driver = std::make_unique<ClientDriver>(settings, board, now);
        auto transport =
            std::make_unique<ClientTransport>(host, settings.port, driver->credentials(), now);
        return ThreadedNode::Parts{std::move(driver), std::move(transport)};
    });
}

} // namespace carina
