#pragma once

#include "engine/net/entry/access_key.h"
#include "engine/net/entry/psk_identity.h"

namespace carina
{

/// The pre-shared key that a client authenticates with, and its identity.
struct KeyOffer {
    PskIdentity identity;
    AccessKey key{};
};

} // namespace carina
