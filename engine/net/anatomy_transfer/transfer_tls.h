#pragma once

#include <QByteArray>
#include <QSslConfiguration>

namespace carina::transfer
{

/// TLS 1.2 for transferring a set: ECDHE-PSK-CHACHA20-POLY1305 only, without certificates or
/// session tickets.
/// @param hint PSK identity hint: the session id, sent by a host before encryption; empty at a
///        client
[[nodiscard]] QSslConfiguration tlsConfiguration(const QByteArray& hint);

} // namespace carina::transfer
