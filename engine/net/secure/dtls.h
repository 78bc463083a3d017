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

/// Restricts an association to ECDHE-PSK-CHACHA20-POLY1305, which adds 29 bytes to a datagram, and
/// to packets that need no fragmentation.
/// @param hint PSK identity hint: the session id, sent by a host before encryption; empty at a
///        client
void prepareDtls(QDtls& dtls, const QByteArray& hint);
/// Restricts a host's association to ECDHE-ECDSA- or ECDHE-RSA-CHACHA20-POLY1305, which adds the
/// same 29 bytes, with this certificate; makes a client's association check the host's certificate
/// against what is expected. The name to check is the one of QDtls::setPeer.
void prepareDtls(QDtls& dtls, const HostCertificate& certificate);
void prepareDtls(QDtls& dtls, const ExpectedCertificate& expected);

/// Supplies the key that a QDtls requests during a handshake. @param identity empty at a host
void answerPsk(QSslPreSharedKeyAuthenticator& question, const std::string& identity,
               const AccessKey& key);

/// Bytes of a datagram that Carina sends, at most.
inline constexpr qsizetype kLongestRaw = 1200;
/// Whether a datagram of this size can be one of Carina's. For an empty one QDtls would fail an
/// assertion.
[[nodiscard]] constexpr bool isSizeOfRaw(qsizetype size) { return size > 0 && size <= kLongestRaw; }

/// A datagram as received. Its source address is normalised.
struct RawDatagram {
    QByteArray bytes;
    QHostAddress from;
    std::uint16_t port = 0;
    LocalTime arrived{};
};
/// The next datagram of a socket; nothing where there is none. Those whose size none of Carina's
/// has are skipped.
[[nodiscard]] std::optional<RawDatagram> readRaw(QUdpSocket& socket);

[[nodiscard]] std::span<const std::uint8_t> octets(const QByteArray& bytes);
[[nodiscard]] QByteArray viewOf(std::span<const std::byte> bytes);

} // namespace carina
