#pragma once

#include "engine/sync/wire/datagram.h"

#include <functional>
#include <span>

namespace carina
{

/// Packs records, in their order, into as few datagrams as hold them; none makes one of a header
/// alone.
/// @param nextHeader called once for each datagram
[[nodiscard]] std::vector<std::vector<std::byte>>
packDatagrams(std::span<const WireRecord> records, const std::function<BundleHeader()>& nextHeader);

} // namespace carina
