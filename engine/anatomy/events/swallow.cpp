#include "engine/anatomy/events/swallow.h"

#include "engine/geometry/deformation/airway_formula.h"

#include <algorithm>

namespace carina
{

double swallowAt(SessionTime t)
{
    constexpr double kRises = 0.9; // seconds
    constexpr double kStays = 0.4;
    constexpr double kFalls = toSeconds(kSwallow) - kRises - kStays;
    const double at = toSeconds(t.time_since_epoch() % kSwallowEvery);
    return formula::step<double>(at / kRises).value
           - formula::step<double>((at - kRises - kStays) / kFalls).value;
}

double cordsInSwallow(double amount) { return std::min(amount / kCordsShutInSwallow, 1.0); }

double riseInSwallow(double amount)
{
    return std::max(amount - kCordsShutInSwallow, 0.0) / (1.0 - kCordsShutInSwallow);
}

} // namespace carina
