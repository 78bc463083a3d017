#pragma once

#include "engine/net/entry/key_offer.h"

namespace carina
{

/// Where a participant reaches the host of its session over TCP, and the key it authenticates with.
struct HostDoor {
    std::string address; ///< IPv4 or IPv6
    std::uint16_t port = 0;
    KeyOffer offer;
};

} // namespace carina
