#pragma once

#include "engine/core/result.h"
#include "engine/session/facts.h"
#include "engine/sync/fact_record.h"

#include <span>

namespace carina
{

/// The body of a fact as bytes (little endian, layout in docs/protocol.md): one byte of kind, then
/// its fields. Strings are a length of one byte and that many bytes of UTF-8.
[[nodiscard]] std::vector<std::byte> encodeBody(const FactBody& body);

/// @returns PacketMalformed for an unknown kind, a wrong length, broken UTF-8, a number that is not
///          finite or an enumerator that does not exist.
[[nodiscard]] Result<FactBody> decodeBody(std::span<const std::byte> bytes);

[[nodiscard]] FactRecord toRecord(const Fact& fact);
[[nodiscard]] Result<Fact> fromRecord(const FactRecord& record);
[[nodiscard]] ProposalRecord toRecord(const Proposal& proposal);
[[nodiscard]] Result<Proposal> fromRecord(const ProposalRecord& record);

} // namespace carina
