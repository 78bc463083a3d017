#pragma once

#include "engine/core/result.h"
#include "engine/sync/wire/datagram.h"

#include <functional>
#include <span>

namespace carina
{

inline constexpr std::size_t kBundleHeaderBytes = 34;

/// Room for the records that follow is reserved already.
/// @pre times lie within kLargestWireTime and the echo's hold within kLongestHold.
[[nodiscard]] std::vector<std::byte> encodeHeader(const BundleHeader& header);

/// A datagram leaves later than its header says: it waited for others to leave. Changes when it was
/// sent and how long it held its echo, which is left out where it would exceed kLongestHold. Bytes
/// that do not begin with a header stay as they are. @pre by >= 0
void leaveLater(std::span<std::byte> datagram, Duration by);

/// Takes a datagram apart. What it allocates is bounded by the datagram's own length.
///
/// The author of a ProposalRecord does not travel, the host knows it; it is decoded as kNobody.
///
/// @returns PacketMalformed, naming the rule that was broken, for anything that is not exactly a
///          header and whole records: wrong lengths, unknown kinds, flags or enumerators, numbers
///          that are not finite or out of range, rotations that are none; VersionMismatch for a
///          Carina datagram of another version.
[[nodiscard]] Result<Datagram> decodeDatagram(std::span<const std::byte> bytes);

/// Packs records, in their order, into as few datagrams as hold them; none makes one of a header
/// alone.
/// @param nextHeader called once for each datagram
[[nodiscard]] std::vector<std::vector<std::byte>>
packDatagrams(std::span<const WireRecord> records, const std::function<BundleHeader()>& nextHeader);

} // namespace carina
