#pragma once

#include "engine/core/pauses.h"
#include "engine/physiology/vitals.h"

#include <optional>
#include <utility>

namespace carina
{

/// What a try did to the oxygen of a patient.
struct OxygenFigures {
    double first = 0.0;  ///< saturation at its beginning, 0 to 1
    double lowest = 1.0; ///< 0 to 1
    SessionTime lowestAt{};
    Duration below{};                       ///< time below kLowSaturation
    std::optional<SessionTime> fellBelow{}; ///< for the first time

    friend bool operator==(const OxygenFigures&, const OxygenFigures&) = default;
};

inline constexpr double kLowSaturation = 0.90;

/// Measures the saturation of the arterial blood during a try. It is the true one: what the
/// oximeter shows comes later, and often only after the try. Between two additions it is that of
/// the earlier one.
class OxygenMeter
{
public:
    /// @param pauses that do not count as time
    explicit OxygenMeter(Pauses pauses = {}) : m_pauses{std::move(pauses)} {}

    /// What is not later than the last is ignored.
    void add(SessionTime t, const Vitals& vitals);

    /// Nothing before the first addition.
    [[nodiscard]] const std::optional<OxygenFigures>& figures() const { return m_figures; }

private:
    Pauses m_pauses;
    std::optional<OxygenFigures> m_figures;
    SessionTime m_last{};
    double m_lastSaturation = 1.0;
};

} // namespace carina
