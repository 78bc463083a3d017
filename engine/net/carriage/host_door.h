#pragma once

#include "engine/net/entry/key_offer.h"

namespace carina
{

/// Where a participant finds the host of its session over TCP, and what it proves itself with
/// there.
struct HostDoor {
    std::string address; ///< IPv4 or IPv6
    std::uint16_t port = 0;
    KeyOffer offer;
};

} // namespace carina
