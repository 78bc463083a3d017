#pragma once

#include "engine/net/node/node_driver.h"

#include <QObject>
#include <QTimer>

namespace carina
{

/// Runs a driver on its thread, with a transport and one timer.
class NodeLoop : public QObject
{
public:
    /// Sets driver and transport, from now on.
    void drive(std::unique_ptr<NodeDriver> driver, std::unique_ptr<SecureTransport> transport);
    [[nodiscard]] NodeDriver& driver() { return *m_driver; }
    /// Reads datagrams, advances the driver, sends, and sets the timer for the next wake-up.
    void serve();
    /// Sends the driver's last datagrams and ends it.
    void close();

private:
    /// @param made time in the headers of the datagrams
    void send(NodeDriver::Datagrams datagrams, LocalTime made);
    void sleepUntil(LocalTime wake, LocalTime now);

    QTimer m_timer{this};
    std::unique_ptr<NodeDriver> m_driver;
    std::unique_ptr<SecureTransport> m_transport; // may use what the driver owns
};

} // namespace carina
