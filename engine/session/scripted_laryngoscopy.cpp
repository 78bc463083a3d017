#include "engine/session/scripted_laryngoscopy.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{
namespace
{

/// When in a period, from 0 to 1, a step is reached.
struct Reached {
    double phase;
    LaryngoscopyStep step;
};
constexpr std::array kReached{
    Reached{0.00, LaryngoscopyStep::Teeth},      Reached{0.10, LaryngoscopyStep::Uvula},
    Reached{0.20, LaryngoscopyStep::Epiglottis}, Reached{0.30, LaryngoscopyStep::Partial},
    Reached{0.36, LaryngoscopyStep::Full},       Reached{0.74, LaryngoscopyStep::Full},
    Reached{0.80, LaryngoscopyStep::Partial},    Reached{0.86, LaryngoscopyStep::Epiglottis},
    Reached{0.93, LaryngoscopyStep::Uvula},      Reached{1.00, LaryngoscopyStep::Teeth}};

double shareOfPeriod(SessionTime t, Duration period)
{
    const double periods = toSeconds(t.time_since_epoch() % period) / toSeconds(period);
    return periods - std::floor(periods);
}

/// The number of the step, and between two of them a rise with no speed at either end.
double progressAt(double phase)
{
    const auto* next = std::ranges::upper_bound(kReached, phase, {}, &Reached::phase);
    if (next == kReached.end())
        return double(kReached.back().step);
    const Reached& from = *std::prev(next);
    const double share = (phase - from.phase) / (next->phase - from.phase);
    return std::lerp(double(from.step), double(next->step), share * share * (3.0 - 2.0 * share));
}

} // namespace

LaryngoscopyPose scriptedLaryngoscopy(const LaryngoscopyScript& script, SessionTime t,
                                      const NeckField& neck)
{
    return laryngoscopyPose(script.airway, script.throat, script.blade,
                            progressAt(shareOfPeriod(t, script.period)), script.lift, script.held,
                            neck);
}

} // namespace carina
