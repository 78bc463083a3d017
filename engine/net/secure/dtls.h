#pragma once

#include "engine/core/session_time.h"
#include "engine/net/entry/certificates.h"
#include "engine/net/entry/key_offer.h"

#include <QByteArray>
#include <QDtls>
#include <QHostAddress>
#include <QUdpSocket>

#include <span>

namespace carina
{

/// Makes an association speak nothing but ECDHE-PSK-CHACHA20-POLY1305, which adds 29 bytes to a
/// datagram, in packets that need no fragments.
/// @param hint the session id, which a host tells before anything is encrypted; empty at a client
void prepareDtls(QDtls& dtls, const QByteArray& hint);
/// Makes a host's association speak nothing but ECDHE-ECDSA- or ECDHE-RSA-CHACHA20-POLY1305, which
/// adds the same 29 bytes, under this certificate; a client's, that it checks the host's against
/// what is expected. The name to look for is the one of QDtls::setPeer.
void prepareDtls(QDtls& dtls, const HostCertificate& certificate);
void prepareDtls(QDtls& dtls, const ExpectedCertificate& expected);

/// The key that a QDtls asks for while a handshake goes on. @param identity empty at a host
void answerPsk(QSslPreSharedKeyAuthenticator& question, const std::string& identity,
               const AccessKey& key);

/// The next datagram of a socket and where it came from, its address normalised; nothing when there
/// is none. One that is empty or longer than any of ours is passed over: QDtls asserts that it is
/// not given the former.
struct RawDatagram {
    QByteArray bytes;
    QHostAddress from;
    std::uint16_t port = 0;
    LocalTime arrived{};
};
[[nodiscard]] std::optional<RawDatagram> readRaw(QUdpSocket& socket);

[[nodiscard]] std::span<const std::uint8_t> octets(const QByteArray& bytes);
[[nodiscard]] QByteArray viewOf(std::span<const std::byte> bytes);

} // namespace carina
