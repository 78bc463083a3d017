#pragma once

#include "engine/sync/byte_buffer.h"
#include "engine/sync/datagram.h"

namespace carina
{

/// One byte of kind and the record's fields, as in docs/protocol.md.
///
/// @pre the numbers are finite and within their ranges; bodies of facts and proposals have 1 to
///      kLargestFactBody bytes; a reason for refusal is one of those that travel.
void writeRecord(ByteWriter& out, const WireRecord& record);

/// Meaningless when in.ok() is false afterwards.
[[nodiscard]] WireRecord readRecord(ByteReader& in);

} // namespace carina
