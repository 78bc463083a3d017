#pragma once

#include "engine/net/node/node_driver.h"

#include <QObject>
#include <QTimer>

namespace carina
{

/// Serves a driver on the thread it lives on: its transport and one timer.
class NodeLoop : public QObject
{
public:
    /// From now on.
    void drive(std::unique_ptr<NodeDriver> driver, std::unique_ptr<SecureTransport> transport);
    [[nodiscard]] NodeDriver& driver() { return *m_driver; }
    /// Reads, lets the driver advance, sends and sleeps until there is more.
    void serve();
    /// Sends the driver's last words and ends it.
    void close();

private:
    /// @param made when, as their headers say
    void send(NodeDriver::Datagrams datagrams, LocalTime made);
    void sleepUntil(LocalTime wake, LocalTime now);

    QTimer m_timer{this};
    std::unique_ptr<NodeDriver> m_driver;
    std::unique_ptr<SecureTransport> m_transport; // may use what the driver owns
};

} // namespace carina
