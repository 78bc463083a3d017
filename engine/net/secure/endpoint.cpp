#include "engine/net/secure/endpoint.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr std::size_t kPrefixOfIpv6 = 8; // bytes

bool isMappedIpv4(const Endpoint& source)
{
    constexpr std::array<std::uint8_t, 12> kMapped{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xFF, 0xFF};
    return std::equal(kMapped.begin(), kMapped.end(), source.address.begin());
}

} // namespace

QHostAddress normalised(const QHostAddress& address)
{
    bool isIpv4 = false;
    const quint32 ipv4 = address.toIPv4Address(&isIpv4);
    return isIpv4 ? QHostAddress{ipv4} : address;
}

Endpoint endpoint(const QHostAddress& address, std::uint16_t port)
{
    const Q_IPV6ADDR bytes = address.toIPv6Address();
    Endpoint result{{}, port};
    std::copy(std::begin(bytes.c), std::end(bytes.c), result.address.begin());
    return result;
}

SourcePrefix sourcePrefix(const Endpoint& source)
{
    SourcePrefix prefix = source.address;
    if (!isMappedIpv4(source))
        std::fill(prefix.begin() + kPrefixOfIpv6, prefix.end(), std::uint8_t{0});
    return prefix;
}

} // namespace carina
