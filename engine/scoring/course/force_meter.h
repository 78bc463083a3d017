#pragma once

#include "engine/core/session_time.h"
#include "engine/core/units.h"

#include <optional>

namespace carina
{

/// A force above the first counts as a warning, and one above the second as a fault. Limits of
/// training, of ours, within what was measured on manikins and patients: no force is known that
/// breaks a tooth.
struct ForceLimits {
    Force warning;
    Force fault;
};
/// Beside what was measured: 36 to 58 N on manikins (Bucx 1995), 49 N in patients (Bucx 1994).
inline constexpr ForceLimits kIncisorLimits{newtons(20.0), newtons(40.0)};
/// Likewise: 60 to 74 N on manikins (Bucx 1995), a peak of 35 N in patients (Bucx 1992).
inline constexpr ForceLimits kTongueLimits{newtons(40.0), newtons(60.0)};

/// What pressed on one part of a patient during a try.
struct ForceFigures {
    Force peak{};
    SessionTime peakAt{};
    Force mean{};       ///< while there was any
    Duration touched{}; ///< for how long there was any
    Duration aboveWarning{};
    Duration aboveFault{};
    double impulse = 0.0; ///< newton seconds

    friend bool operator==(const ForceFigures&, const ForceFigures&) = default;
};

/// Measures the force on one part. Between two additions it is that of the earlier one, but for no
/// longer than kLongestGap.
class ForceMeter
{
public:
    static constexpr Duration kLongestGap = std::chrono::milliseconds{500}; ///< of ours

    explicit ForceMeter(const ForceLimits& limits) : m_limits{limits} {}

    /// What is not later than the last is ignored.
    void add(SessionTime t, Force force);

    /// Nothing presses any more that is known of, until the next addition.
    void pause() { m_force = {}; }

    /// Nothing before the first addition.
    [[nodiscard]] const std::optional<ForceFigures>& figures() const { return m_figures; }

private:
    void hold(Duration time);

    ForceLimits m_limits;
    std::optional<ForceFigures> m_figures;
    SessionTime m_last{};
    Force m_force{};
};

} // namespace carina
