#include "engine/net/session_node.h"

#include "engine/net/client_driver.h"
#include "engine/net/host_driver.h"
#include "engine/net/secure/client_transport.h"
#include "engine/net/secure/host_transport.h"
#include "engine/net/session_identity.h"
#include "engine/net/threaded_node.h"
#include "engine/session/fact_rules.h"

#include <algorithm>

namespace carina
{
namespace
{

/// Where any port will do: one that is free for UDP may be taken for TCP.
constexpr int kPortTries = 16;

/// The two ports of a host, of the same number.
struct HostPorts {
    std::unique_ptr<HostTransport> transport;
    std::unique_ptr<SetServer> sets; ///< none where no sets are handed out
};

Result<HostPorts> bindPorts(const HostSettings& settings)
{
    for (int i = 1;; ++i) {
        auto transport = HostTransport::bind(settings.port, settings.open);
        if (!transport)
            return tl::unexpected(transport.error());
        if (settings.anatomyCache.empty())
            return HostPorts{*std::move(transport), nullptr};
        auto sets = SetServer::listen((*transport)->port(), settings.open, settings.anatomyCache);
        if (sets)
            return HostPorts{*std::move(transport), *std::move(sets)};
        if (settings.port != 0 || i == kPortTries)
            return tl::unexpected(sets.error());
    }
}

bool isNamed(const NodeBoard& board, const std::string& contentHash)
{
    const auto state = board.state();
    return std::ranges::any_of(state->stations(), [&](const auto& station) {
        return station.second.anatomyHash == contentHash;
    });
}

/// Lets those in whose keys the driver knows.
void admit(const HostPorts& ports, const HostAccess& access, const NodeBoard& board)
{
    const auto keyOf = [&access](const PskIdentity& identity) { return access.keyOf(identity); };
    ports.transport->admit(access.sessionId(), keyOf);
    if (ports.sets)
        ports.sets->admit(access.sessionId(), keyOf,
                          [&board](const std::string& hash) { return isNamed(board, hash); });
}

} // namespace

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
        auto ports = bindPorts(settings);
        if (!ports)
            return tl::unexpected(ports.error());
        auto driver = HostDriver::open(settings, std::move(store), board, now);
        if (!driver)
            return tl::unexpected(driver.error());
        admit(*ports, (*driver)->access(), board);
        return ThreadedNode::Parts{*std::move(driver), std::move(ports->transport), settings.open,
                                   std::move(ports->sets)};
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
