#include "apps/lab/network/handshake_experiment.h"

#include "engine/net/secure/client_transport.h"
#include "engine/net/secure/host_transport.h"
#include "evaluation/network/lossy_relay.h"
#include "evaluation/network/transport_pump.h"

#include <QCoreApplication>
#include <QEventLoop>

#include <algorithm>
#include <ctime>

namespace carina::lab
{
namespace
{

constexpr const char* kSession = "000102030405060708090a0b0c0d0e0f";
constexpr int kDatagrams = 5000;
constexpr std::size_t kDatagramBytes = 481; ///< a bundle of ten objects

class Counter : public TransportListener
{
public:
    void connected(PeerAddress address, const Credential&, LocalTime) override { peer = address; }
    void receive(PeerAddress, std::span<const std::byte>, LocalTime) override { ++received; }
    void disconnected(PeerAddress, LocalTime) override { peer.reset(); }
    void refused(const Error&, LocalTime) override {}

    std::optional<PeerAddress> peer;
    int received = 0;
};

/// A host whose one key everybody has, for nothing is derived here.
struct Host {
    explicit Host(std::unique_ptr<HostTransport> bound) : transport{std::move(bound)}
    {
        transport->admit(kSession, [this](const PskIdentity&) {
            return HostTransport::KeyAnswer{HostTransport::KeyAnswer::State::Known, key};
        });
    }

    AccessKey key{};
    Counter counter;
    std::unique_ptr<HostTransport> transport;
    TransportPump pump{*transport, counter};
};

struct Client {
    Client(std::uint16_t port, const AccessKey& key)
        : credentials{Role::Trainee, JoinCode::random(), TokenFolder{{}, Role::Trainee, "Lab"},
                      [key](const JoinCode&, const SessionKey&) { return Result<AccessKey>{key}; }},
          transport{QHostAddress{QHostAddress::LocalHost}, port, credentials, monotonicNow()}
    {
        // So that no first try is spent on learning the session.
        credentials.accepted({{{Role::Trainee, ParticipantId{1}}, kSession}, key});
        credentials.keepToken({ParticipantId{1}, key});
    }
    void waitUntilIn()
    {
        while (!counter.peer)
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }

    Counter counter;
    ClientCredentials credentials;
    ClientTransport transport;
    TransportPump pump{transport, counter};
};

Duration processorTime()
{
    return std::chrono::microseconds{std::clock() * 1'000'000 / CLOCKS_PER_SEC};
}

void measureDatagrams(Host& host, HandshakeFigures& figures)
{
    LossyRelay relay{host.transport->port(), {}, 0};
    Client client{relay.port(), host.key};
    client.waitUntilIn();
    const std::vector<std::byte> bytes(kDatagramBytes);
    client.transport.send(*client.counter.peer, bytes);
    while (host.counter.received == 0)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    figures.overhead = relay.toHost().back().bytes.size() - static_cast<qsizetype>(kDatagramBytes);

    Client direct{host.transport->port(), host.key};
    direct.waitUntilIn();
    host.counter.received = 0;
    const Duration begin = processorTime();
    Duration sending{};
    for (int sent = 0; sent < kDatagrams; ++sent) {
        const Duration before = processorTime();
        direct.transport.send(*direct.counter.peer, bytes);
        sending += processorTime() - before;
        host.pump.serve();
    }
    figures.passCost = (processorTime() - begin) / kDatagrams;
    figures.sendCost = sending / kDatagrams;
}

} // namespace

Result<HandshakeFigures> measureHandshakes(const HandshakeSettings& settings)
{
    auto bound = HostTransport::bind(0, false);
    if (!bound)
        return tl::unexpected(bound.error());
    Host host{*std::move(bound)};
    HandshakeFigures figures;
    for (int join = 0; join < settings.joins; ++join) {
        const PathProfile path{.delay = settings.roundTrip / 2, .loss = settings.loss};
        LossyRelay relay{
            host.transport->port(), {path, path}, settings.seed + static_cast<std::uint32_t>(join)};
        const LocalTime begin = monotonicNow();
        Client client{relay.port(), host.key};
        client.waitUntilIn();
        figures.taken.push_back(monotonicNow() - begin);
        figures.tries += client.transport.tries();
    }
    std::ranges::sort(figures.taken);
    measureDatagrams(host, figures);
    return figures;
}

} // namespace carina::lab
