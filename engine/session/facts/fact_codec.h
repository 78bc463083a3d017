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
/// the order of engine/session/facts/facts.h. The kind is the place of the fact in FactBody,
/// from 1. Numbers are little endian, ids two bytes, enumerators one, quantities a 64-bit IEEE 754
/// number in SI; strings are a length of one byte and that many bytes of UTF-8.
///
/// @pre no string is longer than 255 bytes; checkBody refuses those long before.
[[nodiscard]] std::vector<std::byte> encodeBody(const FactBody& body);

/// Inverse of encodeBody: what it accepts, encodes to the same bytes again.
/// @returns PacketMalformed for an unknown kind, a wrong length, broken UTF-8, a number that is not
///          finite or an enumerator that does not exist.
[[nodiscard]] Result<FactBody> decodeBody(std::span<const std::byte> bytes);

[[nodiscard]] FactRecord toRecord(const Fact& fact);
/// @returns what decodeBody or checkBody object to: a fact, unlike a proposal, has been judged, so
///          one with impossible values comes from a broken log or host and is not applied.
[[nodiscard]] Result<Fact> fromRecord(const FactRecord& record);
[[nodiscard]] ProposalRecord toRecord(const Proposal& proposal);
/// @returns what decodeBody objects to.
[[nodiscard]] Result<Proposal> fromRecord(const ProposalRecord& record);

} // namespace carina
