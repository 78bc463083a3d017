#pragma once

#include "engine/net/node_driver.h"

#include <QObject>
#include <QTimer>
#include <QUdpSocket>

namespace carina
{

/// Serves a driver on the thread it lives on: a UDP socket on loopback and one timer.
class NodeLoop : public QObject
{
public:
    /// @returns AddressInUse with the port.
    [[nodiscard]] Result<std::uint16_t> bind(std::uint16_t port);
    /// From now on.
    void drive(std::unique_ptr<NodeDriver> driver);
    [[nodiscard]] NodeDriver& driver() { return *m_driver; }
    /// Reads, lets the driver advance, sends and sleeps until there is more.
    void serve();
    /// Sends the driver's last words and ends it.
    void close();

private:
    void readDatagrams();
    void send(const NodeDriver::Datagrams& datagrams);
    void sleepUntil(LocalTime wake, LocalTime now);

    QUdpSocket m_socket{this};
    QTimer m_timer{this};
    std::unique_ptr<NodeDriver> m_driver;
};

/// A port on loopback as the address that the cores know.
[[nodiscard]] PeerAddress loopbackAddress(std::uint16_t port);

} // namespace carina
