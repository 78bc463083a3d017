#pragma once

#include "engine/net/entry/access_key.h"

#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace carina::lab
{

/// Derives each key once, so that the time of a join is that of joining.
inline DeriveKey derivedOnce()
{
    struct Known {
        std::mutex mutex;
        std::map<std::string, AccessKey> keys;
    };
    return [known = std::make_shared<Known>()](const JoinCode& code,
                                               const SessionKey& session) -> Result<AccessKey> {
        const std::lock_guard lock{known->mutex};
        if (const auto key = known->keys.find(code.text()); key != known->keys.end())
            return key->second;
        return deriveByArgon2id(code, session).map([&](const AccessKey& key) {
            return known->keys.emplace(code.text(), key).first->second;
        });
    };
}

} // namespace carina::lab
