#pragma once

#include "engine/airway/monitor/intubation_monitor.h"

namespace carina
{

/// Finds that a tip that is in trachea or bronchus has come to rest at another depth than was noted
/// of it last: what is noted of a tube then says how deep it lies now, and not how deep it was when
/// a step last happened.
///
/// It rests once it has stayed for kRest where it came to, give or take kStill, along the tube and
/// above the carina. Then the mean over that time counts, so that neither noise nor a hand that
/// trembles moves it; it lies elsewhere from kElsewhere on. While measured and constrained shape
/// are apart no depth is claimed, and nothing found. All constants are of ours.
class RestWatch
{
public:
    static constexpr Length kStill = {2e-3};
    static constexpr Length kElsewhere = {2.5e-3};
    static constexpr Duration kRest = std::chrono::seconds{1};

    /// The monitor after each moment.
    /// @returns AtRest, with the mean depth, once it has come to rest elsewhere
    [[nodiscard]] std::optional<IntubationEvent> take(const IntubationMonitor& monitor);
    /// What is noted tells how deep the tip is.
    void note(const IntubationEvent& event);

private:
    TipReading m_noted{};
    std::optional<TipReading> m_place{}; ///< where it has been since then
    TipReading m_mean{};                 ///< since then
    SessionTime m_seen{};                ///< when the tip was seen last
    int m_samples = 0;
};

} // namespace carina
