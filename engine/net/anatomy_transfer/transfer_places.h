#pragma once

#include "engine/core/session_time.h"
#include "engine/net/entry/psk_identity.h"
#include "engine/net/entry/source_limiter.h"

#include <optional>
#include <span>

namespace carina
{

/// A connection over which a host sends a set, for the decision who has a place.
struct TransferPlace {
    Credential who;              ///< that its key proved
    SourcePrefix from{};         ///< its address
    Duration held{};             ///< for how long it has had its place
    double bytesPerSecond = 0.0; ///< that it took lately
};

struct PlaceVerdict {
    bool isAdmitted = false;
    std::optional<std::size_t> ended{}; ///< the place that ends for it
};

inline constexpr std::size_t kMostTransfers = 32; ///< at once
/// Of one IPv4 address or IPv6 /64: a class behind one router takes the places in turn.
inline constexpr std::size_t kMostTransfersOfAddress = 8;
/// Of one participant's token: a program that was started again need not wait for the end of what
/// it began before. A code has as many as an address.
inline constexpr std::size_t kMostTransfersOfToken = 2;
/// A place is safe for so long from those who have no more than one less: at its even share of the
/// rate, 512 kB/s, a set of 15 MB is sent in it.
inline constexpr Duration kTransferTurn = std::chrono::seconds{30};

/// Whether one more connection has a place beside those that have one, and which of them ends for
/// it where its address has eight, or all together 32. That is the slowest of the address that has
/// most (within one address: of the credential that has most), if this has two more than the
/// newcomer's; otherwise the slowest of those whose turn is over. Whoever loses a place goes on
/// later where it was (SetFetch).
[[nodiscard]] PlaceVerdict placeFor(const TransferPlace& newcomer,
                                    std::span<const TransferPlace> places);

} // namespace carina
