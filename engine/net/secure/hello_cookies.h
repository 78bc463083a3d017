#pragma once

#include "engine/net/secure/dtls.h"

#include <memory>
#include <optional>

namespace carina
{

/// Proves the source of a ClientHello by a cookie (RFC 6347, 4.2.1): the HMAC-SHA-256 of address
/// and port under a secret. Nothing is stored for a source. The secret is another one each minute,
/// and the one before it holds for a minute more: a ClientHello that somebody captured begins no
/// handshake later than that.
class HelloCookies
{
public:
    /// Much longer than the slowest client needs to come back with its cookie.
    static constexpr Duration kPeriod = std::chrono::minutes{1};

    HelloCookies();
    ~HelloCookies();

    /// Looks at the cookie of a ClientHello; one that has none, or another, is sent its cookie.
    /// @returns how the cookie was made, for the QDtls that takes this ClientHello: it looks once
    ///          more.
    [[nodiscard]] std::optional<QDtls::GeneratorParameters>
    check(QUdpSocket& socket, const RawDatagram& hello, LocalTime now);

private:
    class SilentSocket;

    void renew(LocalTime now);

    std::unique_ptr<SilentSocket> m_silent; // first: the others keep a pointer to it
    std::unique_ptr<QDtlsClientVerifier> m_verifier;
    std::unique_ptr<QDtlsClientVerifier> m_former; // null where its period is over
    LocalTime m_nextSecret = LocalTime::min();
};

} // namespace carina
