#pragma once

#include "evaluation/network/precise_timer.h"
#include "evaluation/network/virtual_link.h"

#include <QUdpSocket>

#include <map>
#include <queue>
#include <vector>

namespace carina
{

/// A UDP relay on loopback between clients and a host, which delays, drops and duplicates datagrams
/// like a VirtualLink in each direction. Each client's datagrams reach the host from a separate
/// port.
class LossyRelay : public QObject
{
public:
    struct Paths {
        PathProfile toHost;
        PathProfile toClients;
    };
    /// A datagram that was forwarded to the host.
    struct Passed {
        std::uint16_t clientPort = 0;
        QByteArray bytes;
    };

    /// The seeds of the two VirtualLinks.
    [[nodiscard]] static std::uint64_t seedToHost(std::uint64_t seed) { return seed; }
    [[nodiscard]] static std::uint64_t seedToClients(std::uint64_t seed) { return ~seed; }

    /// Until beginAt() the paths are at a time long before their time 0. @pre a port is free.
    LossyRelay(std::uint16_t hostPort, const Paths& paths, std::uint64_t seed);

    [[nodiscard]] std::uint16_t port() const { return m_front.localPort(); }
    /// Sets the paths' time 0 on the machine's clock. @pre within an hour from now; called once.
    void beginAt(LocalTime machine) { m_begin = machine; }
    /// While it is cut, all datagrams are dropped.
    void setCut(bool cut) { m_cut = cut; }

    [[nodiscard]] const std::vector<Passed>& toHost() const { return m_toHost; }
    /// Bytes of all datagrams received from either side.
    [[nodiscard]] std::uint64_t bytes() const { return m_bytes; }
    /// Sends a forwarded datagram again from the port of its client.
    void replay(const Passed& passed);

private:
    struct Client {
        std::uint16_t port = 0;
        QUdpSocket socket; // towards the host
    };
    struct Waiting {
        LocalTime due; ///< on the machine's clock
        std::uint64_t order = 0;
        bool isToHost = false;
        Passed datagram;

        friend bool operator>(const Waiting& a, const Waiting& b)
        {
            return a.due != b.due ? a.due > b.due : a.order > b.order;
        }
    };

    void readClients();
    void readHost(Client& client);
    void carry(VirtualLink& link, bool isToHost, const Passed& datagram);
    void sendDue();
    [[nodiscard]] Client& clientAt(std::uint16_t port);

    std::uint16_t m_hostPort;
    VirtualLink m_inward;
    VirtualLink m_outward;
    LocalTime m_begin;
    bool m_cut = false;
    QUdpSocket m_front;
    std::map<std::uint16_t, std::unique_ptr<Client>> m_clients;
    std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> m_waiting;
    std::uint64_t m_order = 0;
    std::vector<Passed> m_toHost;
    std::uint64_t m_bytes = 0;
    PreciseTimer m_timer;
};

} // namespace carina
