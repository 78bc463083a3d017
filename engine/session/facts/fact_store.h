#pragma once

#include "engine/core/result.h"
#include "engine/sync/facts/fact_record.h"
#include "engine/sync/wire/event_cpo.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace carina
{

/// What a host stores beside the facts to resume the session clock after a crash.
struct ClockAnchor {
    /// Of the machine's boot: CLOCK_MONOTONIC is only comparable within one boot.
    std::string bootId;
    Duration offset{}; ///< session time less local time
};

/// Persistent log of a session host. engine/io implements it on SQLite.
class FactStore
{
public:
    virtual ~FactStore() = default;

    /// All facts, in order. @returns StoreCorrupt where a number is missing or a fact was changed.
    [[nodiscard]] virtual Result<std::vector<FactRecord>> load() = 0;
    /// Appends facts in one transaction: on success they survive kill -9 and power loss, otherwise
    /// none of them is stored. @returns StoreFailed, also where they are not the next ones.
    [[nodiscard]] virtual Result<void> append(std::span<const FactRecord> facts) = 0;

    [[nodiscard]] virtual Result<std::optional<ClockAnchor>> clockAnchor() = 0;
    [[nodiscard]] virtual Result<void> setClockAnchor(const ClockAnchor& anchor) = 0;

    /// The stored actions, in no particular order.
    /// @returns StoreCorrupt for invalid contents.
    [[nodiscard]] virtual Result<std::vector<EventCpo>> actions() = 0;
    /// Stores actions in one transaction, each replacing the last on the same object. On success
    /// they survive kill -9 and power loss, otherwise none of them is stored.
    [[nodiscard]] virtual Result<void> keepActions(std::span<const EventCpo> events) = 0;

    /// Checks that the log still is where it was stored. Where somebody deleted, replaced or
    /// changed it meanwhile, everything is saved anew elsewhere; append does the same.
    /// @returns the new file, once; StoreFailed where it cannot be saved, and is tried again.
    [[nodiscard]] virtual Result<std::optional<std::filesystem::path>> keepWhole() = 0;
};

} // namespace carina
