#pragma once

#include "engine/net/entry/hello_limiter.h"

#include <QHostAddress>

namespace carina
{

/// An address and a UDP port, spelled in one way only: an IPv4 address mapped into IPv6 is the IPv4
/// address.
struct Endpoint {
    std::array<std::uint8_t, 16> address{}; ///< as IPv6
    std::uint16_t port = 0;

    friend auto operator<=>(const Endpoint&, const Endpoint&) = default;
};

/// An IPv4 address that came mapped into IPv6, as itself; all others unchanged.
[[nodiscard]] QHostAddress normalised(const QHostAddress& address);
[[nodiscard]] Endpoint endpoint(const QHostAddress& address, std::uint16_t port);
[[nodiscard]] SourcePrefix sourcePrefix(const Endpoint& source);

} // namespace carina
