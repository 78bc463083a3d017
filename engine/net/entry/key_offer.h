#pragma once

#include "engine/net/entry/access_key.h"
#include "engine/net/entry/psk_identity.h"

namespace carina
{

/// What a client proves itself with.
struct KeyOffer {
    PskIdentity identity;
    AccessKey key{};
};

} // namespace carina
