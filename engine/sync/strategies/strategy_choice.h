#pragma once

#include "engine/core/session_time.h"

#include <cstdint>

namespace carina
{

/// The ways of keeping acted-on objects alike. The number is on the wire and on disk: add new ones
/// at the end.
enum class StrategyKind : std::uint8_t {
    SessionClock,
    LocalLag,
    AsaAdaptive,
    AsaFixed,
    DeadReckoning,
    Interpolation,
    Event,
    None,
};

/// What the Adaptive Synchronization Algorithm leaves to its user; see ProbeTrigger.
struct AsaParameters {
    std::uint16_t delays = 100; ///< p: how many delays its history holds
    double start = 1.0;         ///< gamma_0 at first, probes per second
    double lowest = 1.0;        ///< per second
    double highest = 20.0;      ///< per second

    friend bool operator==(const AsaParameters&, const AsaParameters&) = default;
};

/// How a session keeps acted-on objects alike.
struct StrategyChoice {
    StrategyKind kind = StrategyKind::SessionClock;
    AsaParameters asa{};                                 ///< of the ASA
    Duration longestLag = std::chrono::milliseconds{16}; ///< of local lag; 0 to kLongestLocalLag

    friend bool operator==(const StrategyChoice&, const StrategyChoice&) = default;
};

/// By how much own actions may begin later than asked for.
[[nodiscard]] constexpr Duration longestLagOf(const StrategyChoice& choice)
{
    return choice.kind == StrategyKind::LocalLag ? choice.longestLag : Duration{};
}

inline constexpr Duration kLongestLocalLag = std::chrono::milliseconds{100};

} // namespace carina
