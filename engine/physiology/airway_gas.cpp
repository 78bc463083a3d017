#include "engine/physiology/airway_gas.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

void add(LungGas& gas, double volume_ml, const GasShares& shares)
{
    gas.oxygen_ml += volume_ml * shares.oxygen;
    gas.carbonDioxide_ml += volume_ml * shares.carbonDioxide;
    gas.nitrogen_ml += volume_ml * (1.0 - shares.oxygen - shares.carbonDioxide);
}

GasShares between(const GasShares& from, const GasShares& to, double share)
{
    return {std::lerp(from.oxygen, to.oxygen, share),
            std::lerp(from.carbonDioxide, to.carbonDioxide, share)};
}

/// What leaves at one end of the airway while gas enters at the other.
GasShares through(AirwayGas& gas, double volume_ml, double deadSpace_ml, const GasShares& entering,
                  bool inwards)
{
    constexpr double kMostRounds = 64.0;
    constexpr auto kCells = static_cast<double>(kAirwayCells);
    const double rounds =
        std::clamp(std::ceil(volume_ml / deadSpace_ml * kCells), 1.0, kMostRounds);
    const double share = std::min(1.0, volume_ml / deadSpace_ml * kCells / rounds);
    const auto cell = [&](std::size_t fromEntrance) -> GasShares& {
        return gas.airway[inwards ? fromEntrance : kAirwayCells - 1 - fromEntrance];
    };
    LungGas left;
    for (double round = 0.0; round < rounds; round += 1.0) {
        add(left, 1.0, cell(kAirwayCells - 1));
        for (std::size_t i = kAirwayCells - 1; i > 0; --i)
            cell(i) = between(cell(i), cell(i - 1), share);
        cell(0) = between(cell(0), entering, share);
    }
    return sharesOf(left);
}

/// Gas that leaves a lung now.
GasShares leaving(const LungGas& lung, double slant, double exhaled)
{
    GasShares shares = sharesOf(lung);
    shares.carbonDioxide *= 1.0 - slant * (1.0 - exhaled);
    return shares;
}

/// Follows where in a breath the patient is; it is a new one when gas comes in again after at least
/// a fifth of the present one has left.
void followBreath(AirwayGas& gas, double moved_ml)
{
    constexpr double kLeastExhaled = 0.2;
    if (moved_ml > 0.0) {
        if (gas.exhaled_ml > kLeastExhaled * gas.inhaled_ml)
            gas.inhaled_ml = gas.exhaled_ml = 0.0;
        gas.inhaled_ml += moved_ml;
    } else {
        gas.exhaled_ml -= moved_ml;
    }
}

} // namespace

double totalOf(const LungGas& gas)
{
    return gas.oxygen_ml + gas.carbonDioxide_ml + gas.nitrogen_ml;
}

GasShares sharesOf(const LungGas& gas)
{
    const double total = totalOf(gas);
    return total > 0.0 ? GasShares{gas.oxygen_ml / total, gas.carbonDioxide_ml / total}
                       : GasShares{};
}

double exhaledShare(const AirwayGas& gas)
{
    return gas.inhaled_ml > 0.0 ? std::min(1.0, gas.exhaled_ml / gas.inhaled_ml) : 1.0;
}

void fill(AirwayGas& gas, const std::array<double, 2>& volume_ml, const GasShares& alveolar)
{
    for (std::size_t i = 0; i < 2; ++i) {
        gas.lungs[i] = {};
        add(gas.lungs[i], volume_ml[i], alveolar);
    }
    gas.airway.fill(alveolar);
    gas.filled = true;
}

double move(AirwayGas& gas, const GasMove& how)
{
    std::array<double, 2> moved{};
    LungGas fromLungs;
    double in = 0.0;
    double out = 0.0;
    const double exhaled = exhaledShare(gas);
    for (std::size_t i = 0; i < 2; ++i) {
        moved[i] = std::clamp(how.volume_ml[i] - totalOf(gas.lungs[i]), -how.passable_ml[i],
                              how.passable_ml[i]);
        in += std::max(0.0, moved[i]);
        out += std::max(0.0, -moved[i]);
        if (moved[i] >= 0.0)
            continue;
        const GasShares shares = leaving(gas.lungs[i], how.slant[i], exhaled);
        add(fromLungs, -moved[i], shares);
        add(gas.lungs[i], moved[i], shares);
    }
    const double net = in - out;
    if (net > 0.0)
        add(fromLungs, net, through(gas, net, how.deadSpace_ml, how.supplied, true));
    const GasShares atCarina = sharesOf(fromLungs);
    if (net < 0.0)
        (void)through(gas, -net, how.deadSpace_ml, atCarina, false);
    for (std::size_t i = 0; i < 2; ++i)
        if (moved[i] > 0.0)
            add(gas.lungs[i], moved[i], atCarina);
    followBreath(gas, net);
    return net;
}

} // namespace carina
