#pragma once

#include <QByteArray>
#include <QSslConfiguration>

namespace carina::carriage
{

/// TLS 1.2 by which a set travels: ECDHE-PSK-CHACHA20-POLY1305 and nothing else, without
/// certificates, tickets or a second handshake.
/// @param hint the session id, which a host tells before anything is encrypted; empty at a client
[[nodiscard]] QSslConfiguration tlsConfiguration(const QByteArray& hint);

} // namespace carina::carriage
