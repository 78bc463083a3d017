#pragma once

#include "engine/core/result.h"
#include "engine/sync/facts/fact_record.h"
#include "engine/sync/wire/event_cpo.h"

#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// What a host needs beside the facts to resume its clock after a crash.
struct ClockAnchor {
    std::string bootId; ///< of the machine's run; CLOCK_MONOTONIC means nothing across boots
    Duration offset{};  ///< session time less local time
};

/// Where a session host keeps its log. Implemented on SQLite in engine/io.
class FactStore
{
public:
    virtual ~FactStore() = default;

    /// All facts, in order. @returns StoreCorrupt when a number is missing.
    [[nodiscard]] virtual Result<std::vector<FactRecord>> load() = 0;
    /// On return the fact survives kill -9 and power loss. @returns StoreFailed otherwise.
    [[nodiscard]] virtual Result<void> append(const FactRecord& fact) = 0;

    [[nodiscard]] virtual Result<std::optional<ClockAnchor>> clockAnchor() = 0;
    [[nodiscard]] virtual Result<void> setClockAnchor(const ClockAnchor& anchor) = 0;

    /// The actions in force that were kept, in any order.
    /// @returns StoreCorrupt for one that is none.
    [[nodiscard]] virtual Result<std::vector<EventCpo>> actions() = 0;
    /// In place of the last on the same object. On return it survives kill -9 and power loss.
    [[nodiscard]] virtual Result<void> keepAction(const EventCpo& event) = 0;
};

} // namespace carina
