#pragma once

#include "engine/core/result.h"
#include "engine/sync/wire/datagram.h"

#include <functional>
#include <span>

namespace carina
{

inline constexpr std::size_t kBundleHeaderBytes = 34;

/// The header as bytes, with capacity reserved for the records that follow.
/// @pre times lie within kLargestWireTime and the echo's hold within kLongestHold.
[[nodiscard]] std::vector<std::byte> encodeHeader(const BundleHeader& header);

/// Corrects the header of a datagram that leaves later than it says, because it was queued: sending
/// time and hold of the echo increase by `by`; an echo whose hold would exceed kLongestHold is
/// removed. Bytes that do not begin with a header are not changed. @pre by >= 0
void leaveLater(std::span<std::byte> datagram, Duration by);

/// Decodes a datagram. The memory that it allocates is bounded by the length of the datagram.
///
/// The author of a ProposalRecord is not transmitted and is decoded as kNobody; the host derives it
/// from the connection.
///
/// @returns PacketMalformed, naming the rule that was broken, for anything but a header and whole
///          records: wrong lengths, unknown kinds, flags or enumerators, numbers not finite or out
///          of range, invalid rotations; VersionMismatch for a Carina datagram of another version.
[[nodiscard]] Result<Datagram> decodeDatagram(std::span<const std::byte> bytes);

/// Packs records, in their order, into as few datagrams as possible. Without records the result is
/// one datagram of a header alone.
/// @param nextHeader called once for each datagram
[[nodiscard]] std::vector<std::vector<std::byte>>
packDatagrams(std::span<const WireRecord> records, const std::function<BundleHeader()>& nextHeader);

} // namespace carina
