#pragma once

#include "engine/net/secure/access_key.h"
#include "engine/net/secure/psk_identity.h"

namespace carina
{

/// What a client proves itself with.
struct KeyOffer {
    PskIdentity identity;
    AccessKey key{};
};

} // namespace carina
