#pragma once

#include "engine/sync/wire/byte_buffer.h"
#include "engine/sync/wire/datagram.h"

namespace carina
{

/// One byte of kind and the record's fields, as in docs/protocol.md.
///
/// @pre the numbers are finite and within their ranges; bodies of facts and proposals have 1 to
///      kLargestFactBody bytes. A reason for refusal that does not travel becomes NotPermitted.
void writeRecord(ByteWriter& out, const WireRecord& record);

/// Meaningless when in.ok() is false afterwards.
[[nodiscard]] WireRecord readRecord(ByteReader& in);

} // namespace carina
