#pragma once

#include "engine/net/entry/source_limiter.h"

#include <QHostAddress>

namespace carina
{

/// An IP address and UDP port in a unique form: an IPv4 address mapped into IPv6 equals the IPv4
/// address.
struct Endpoint {
    std::array<std::uint8_t, 16> address{}; ///< as IPv6
    std::uint16_t port = 0;

    friend auto operator<=>(const Endpoint&, const Endpoint&) = default;
};

/// An IPv4 address mapped into IPv6 as plain IPv4; any other address unchanged.
[[nodiscard]] QHostAddress normalised(const QHostAddress& address);
[[nodiscard]] Endpoint endpoint(const QHostAddress& address, std::uint16_t port);
[[nodiscard]] SourcePrefix sourcePrefix(const Endpoint& source);

} // namespace carina
