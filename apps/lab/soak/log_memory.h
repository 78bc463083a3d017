#pragma once

#include "engine/sync/facts/fact_record.h"

#include <span>

namespace carina::lab
{

/// What a session's log takes of the memory of its programs: the facts, and the state that follows
/// from them as often as a program has it.
struct LogMemory {
    double host_bytes = 0.0;
    double participant_bytes = 0.0;
};

/// Makes all of it once more and counts the bytes of its blocks in the heap. Counts what other
/// threads take meanwhile, too. @pre each record is a fact (fromRecord)
[[nodiscard]] LogMemory memoryOf(std::span<const FactRecord> log);

} // namespace carina::lab
