#pragma once

#include <QHostAddress>

namespace carina
{

/// The broadcast address of the loopback network: reaches every program of this computer and no
/// other.
[[nodiscard]] inline QHostAddress loopbackBroadcast()
{
    return QHostAddress{QStringLiteral("127.255.255.255")};
}

} // namespace carina
