#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace carina
{

/// What a DTLS 1.2 record (RFC 6347, 4.1) tells without being decrypted.
struct DtlsRecord {
    enum class Type : std::uint8_t {
        ChangeCipherSpec = 20,
        Alert = 21,
        Handshake = 22,
        ApplicationData = 23
    };
    Type type = Type::ApplicationData;
    std::uint16_t epoch = 0; ///< 0 until the keys are agreed on
    std::size_t size = 0;    ///< with its header
};

/// The record at the beginning; nothing where there is none whole.
[[nodiscard]] std::optional<DtlsRecord> firstRecord(std::span<const std::uint8_t> datagram);

/// A datagram that begins with a ClientHello in the clear: a client that starts.
[[nodiscard]] bool isClientHello(std::span<const std::uint8_t> datagram);
/// One of its records belongs to a handshake and is encrypted: it ends a client's part of one.
[[nodiscard]] bool holdsFinished(std::span<const std::uint8_t> datagram);

/// The alert in the clear, "decrypt_error", by which a host says that a client has another key.
[[nodiscard]] std::span<const std::uint8_t> wrongKeyAlert();
[[nodiscard]] bool isWrongKeyAlert(std::span<const std::uint8_t> datagram);
/// The alert in the clear, "handshake_failure", by which a host says that it speaks none of the
/// ciphers offered: it has a certificate and was greeted without one in mind, or the other way
/// round.
[[nodiscard]] bool isNoCipherAlert(std::span<const std::uint8_t> datagram);

} // namespace carina
