#pragma once

#include <QHostAddress>
#include <QUdpSocket>

#include <cstdint>

namespace carina
{

/// A UDP port that nobody has.
inline std::uint16_t freePort()
{
    QUdpSocket socket;
    socket.bind(QHostAddress{QHostAddress::LocalHost}, 0);
    return socket.localPort();
}

} // namespace carina
