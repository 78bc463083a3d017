#pragma once

#include <QHostAddress>

namespace carina
{

/// Where every program of this computer hears, and no other computer's.
[[nodiscard]] inline QHostAddress loopbackBroadcast()
{
    return QHostAddress{QStringLiteral("127.255.255.255")};
}

} // namespace carina
