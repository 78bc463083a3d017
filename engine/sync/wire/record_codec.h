#pragma once

#include "engine/core/byte_buffer.h"
#include "engine/sync/wire/datagram.h"

namespace carina
{

/// Writes one byte of kind and the fields of the record, as in docs/protocol.md.
///
/// @pre the numbers are finite and within their ranges; bodies of facts and proposals have 1 to
///      kLargestFactBody bytes. A reason for refusal without a code on the wire is sent as
///      NotPermitted.
void writeRecord(ByteWriter& out, const WireRecord& record);

/// The result is valid only if in.ok() is true afterwards.
[[nodiscard]] WireRecord readRecord(ByteReader& in);

} // namespace carina
