#pragma once

#include "engine/core/result.h"
#include "engine/session/facts/facts.h"
#include "engine/sync/facts/fact_record.h"

#include <cstddef>
#include <span>
#include <vector>

namespace carina
{

/// The body of a fact as bytes (layout in docs/protocol.md): one byte of kind, then its fields in
/// the order of engine/session/facts/fact_fields.h. The kind is the index of the fact in FactBody,
/// from 1. Numbers are little endian, ids two bytes, enumerators one, quantities a 64-bit IEEE 754
/// number in SI units; strings are a length of one byte and that many bytes of UTF-8.
///
/// @pre no string is longer than 255 bytes; checkBody refuses shorter ones already.
[[nodiscard]] std::vector<std::byte> encodeBody(const FactBody& body);

/// Inverse of encodeBody: accepted bytes are exactly those that encodeBody makes of the result.
/// @returns PacketMalformed for an unknown kind, a wrong length, invalid UTF-8, a number that is
///          not finite or an unknown enumerator.
[[nodiscard]] Result<FactBody> decodeBody(std::span<const std::byte> bytes);

[[nodiscard]] FactRecord toRecord(const Fact& fact);
/// @returns the errors of decodeBody and checkBody: unlike a proposal a fact has been judged, so
///          one with impossible values comes from a faulty log or host and must not be applied.
[[nodiscard]] Result<Fact> fromRecord(const FactRecord& record);
[[nodiscard]] ProposalRecord toRecord(const Proposal& proposal);
/// @returns the errors of decodeBody. Values are not checked: SessionAuthority::judge does that.
[[nodiscard]] Result<Proposal> fromRecord(const ProposalRecord& record);

} // namespace carina
