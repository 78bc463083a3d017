#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace carina
{

/// The unencrypted header of a DTLS 1.2 record (RFC 6347, 4.1).
struct DtlsRecord {
    enum class Type : std::uint8_t {
        ChangeCipherSpec = 20,
        Alert = 21,
        Handshake = 22,
        ApplicationData = 23
    };
    Type type = Type::ApplicationData;
    std::uint16_t epoch = 0; ///< 0 until the keys are agreed
    std::size_t size = 0;    ///< including the header
};

/// The first record of a datagram; nothing where it is not complete.
[[nodiscard]] std::optional<DtlsRecord> firstRecord(std::span<const std::uint8_t> datagram);

/// Whether a datagram begins with an unencrypted ClientHello, the start of a handshake.
[[nodiscard]] bool isClientHello(std::span<const std::uint8_t> datagram);
/// Whether a ClientHello holds a cookie (RFC 6347, 4.2.1), of whatever value.
[[nodiscard]] bool holdsCookie(std::span<const std::uint8_t> clientHello);
/// Whether a datagram contains an encrypted handshake record: the end of a client's part of it.
[[nodiscard]] bool holdsFinished(std::span<const std::uint8_t> datagram);

/// The unencrypted alert "decrypt_error", by which a host reports that a client's key is wrong.
[[nodiscard]] std::span<const std::uint8_t> wrongKeyAlert();
[[nodiscard]] bool isWrongKeyAlert(std::span<const std::uint8_t> datagram);
/// Whether a datagram is the unencrypted alert "handshake_failure", by which a host reports that it
/// supports none of the offered ciphers: only one of host and client uses a certificate.
[[nodiscard]] bool isNoCipherAlert(std::span<const std::uint8_t> datagram);

} // namespace carina
