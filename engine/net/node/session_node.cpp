#include "engine/net/node/session_node.h"

#include "engine/net/entry/session_identity.h"
#include "engine/net/node/client_driver.h"
#include "engine/net/node/host_driver.h"
#include "engine/net/node/threaded_node.h"
#include "engine/net/secure/client_transport.h"
#include "engine/net/secure/host_transport.h"
#include "engine/session/facts/fact_rules.h"

#include <algorithm>

namespace carina
{
namespace
{

/// Attempts to find a free port: one that is free for UDP may be in use for TCP.
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

/// Whether the participant is not one who was removed, and has not come in again. A code is
/// nobody's.
bool isWelcome(const NodeBoard& board, const Credential& who)
{
    if (!who.participant)
        return true;
    const auto state = board.state();
    const auto known = state->participants().find(*who.participant);
    return known == state->participants().end() || !known->second.removal;
}

/// Lets those in whose keys the driver knows. There is no certificate where sets are handed out, so
/// beside one only a token opens that door.
void admit(const HostPorts& ports, const HostAccess& access, const NodeBoard& board,
           bool hasCertificate)
{
    ports.transport->admit(access.sessionId(), [&access](const PskIdentity& identity) {
        return access.keyOf(identity);
    });
    const auto keyOf = [&access, hasCertificate](const PskIdentity& identity) {
        return identity.who.participant || !hasCertificate ? access.keyOf(identity)
                                                           : HostTransport::KeyAnswer{};
    };
    if (ports.sets)
        ports.sets->admit(
            access.sessionId(), keyOf,
            [&board](const std::string& hash) { return isNamed(board, hash); },
            [&board](const Credential& who) { return isWelcome(board, who); });
}

Result<std::optional<HostCertificate>> certificateIn(const std::optional<CertificateFiles>& files)
{
    if (!files)
        return std::nullopt;
    return HostCertificate::read(files->certificate, files->privateKey)
        .map([](const HostCertificate& read) { return std::optional{read}; });
}

Result<std::optional<ExpectedCertificate>> expectationOf(const JoinSettings& settings)
{
    const auto& expected = settings.certificate;
    if (!expected)
        return std::nullopt;
    return ExpectedCertificate::read(expected->name.empty() ? settings.address : expected->name,
                                     expected->authority)
        .map([](const ExpectedCertificate& read) { return std::optional{read}; });
}

} // namespace

Result<std::unique_ptr<SessionNode>> SessionNode::host(const HostSettings& settings,
                                                       std::unique_ptr<FactStore> store)
{
    const auto valid =
        checkBody(fact::SessionCreated{settings.sessionName, newSessionId()})
            .and_then([&] {
                return checkBody(
                    fact::ParticipantJoined{{}, Role::Instructor, settings.participantName});
            })
            .and_then([&] { return checkBody(fact::StationAdded{settings.firstStation}); });
    if (!valid)
        return tl::unexpected(valid.error());
    return ThreadedNode::start([&](NodeBoard& board, LocalTime now) -> Result<ThreadedNode::Parts> {
        const auto certificate = certificateIn(settings.certificate);
        if (!certificate)
            return tl::unexpected(certificate.error());
        auto ports = bindPorts(settings);
        if (!ports)
            return tl::unexpected(ports.error());
        if (*certificate)
            ports->transport->present(**certificate);
        auto driver = HostDriver::open(settings, std::move(store), board, now);
        if (!driver)
            return tl::unexpected(driver.error());
        admit(*ports, (*driver)->access(), board, certificate->has_value());
        return ThreadedNode::Parts{*std::move(driver), std::move(ports->transport), settings.open,
                                   std::move(ports->sets),
                                   *certificate ? (*certificate)->name : std::string{}};
    });
}

Result<std::unique_ptr<SessionNode>> SessionNode::join(const JoinSettings& settings)
{
    const fact::ParticipantJoined joined{ParticipantId{}, settings.role, settings.participantName};
    const auto valid =
        checkBody(joined).and_then([&] { return checkBody(fact::StationAdded{settings.station}); });
    if (!valid)
        return tl::unexpected(valid.error());
    const QHostAddress host{QString::fromStdString(settings.address)};
    if (host.isNull())
        return fail(Errc::WrongAddress, settings.address);
    const auto expected = expectationOf(settings);
    if (!expected)
        return tl::unexpected(expected.error());
    return ThreadedNode::start([&](NodeBoard& board, LocalTime now) -> Result<ThreadedNode::Parts> {
        auto driver = std::make_unique<ClientDriver>(settings, board, now);
        auto transport = std::make_unique<ClientTransport>(host, settings.port,
                                                           driver->credentials(), now, *expected);
        transport->onMoved([driver = driver.get()](const std::string& address, std::uint16_t port) {
            driver->hostMoved(address, port);
        });
        return ThreadedNode::Parts{std::move(driver), std::move(transport)};
    });
}

} // namespace carina
