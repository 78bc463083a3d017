#include "engine/lungs/mechanics/ventilatory_drive.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr double kRateShare = 0.25;     // of the rise of the effort
constexpr double kMostOfStrength = 0.5; // that a patient uses for breathing
/// Of the strength, what exhausted muscles have lost.
constexpr double kLostStrength = 0.5;

/// Effort that is wanted, as a multiple of the quiet one.
double demandOf(const DriveState& state)
{
    return 1.0 + kDriveGain * std::max(0.0, state.carbonDioxide - 1.0 - kDriveThreshold);
}

} // namespace

double carbonDioxideAfter(double seconds, double before, VolumeFlow wanted, VolumeFlow alveolar)
{
    CARINA_EXPECTS(wanted.si > 0.0);
    // The implicit Euler step is stable for breaths of any length.
    const double share = seconds / kStoreTime;
    const double after = (before + share) / (1.0 + share * (alveolar / wanted));
    return std::clamp(after, 0.0, kMostCarbonDioxide);
}

double drivenRate(const DriveState& state)
{
    return std::min(kMostRate, 1.0 + kRateShare * (demandOf(state) - 1.0));
}

double drivenEffort(const DriveState& state, Pressure quiet, double strength, double exhausted)
{
    const double most =
        std::max(1.0, kMostOfStrength * strength * kGreatestInspiratoryPressure.si / quiet.si);
    const double fresh = std::min(demandOf(state), most);
    const double tired = std::min(fresh, exhausted);
    return fresh + state.tiredness * (tired - fresh);
}

double tirednessAfter(double seconds, const DriveState& before, Pressure mean, double strength)
{
    constexpr double kMinute = 60.0; // s
    const double left = strength * (1.0 - kLostStrength * before.tiredness);
    const double index = mean.si / std::max(1.0, left * kGreatestInspiratoryPressure.si);
    if (index > kFatigueIndex)
        return std::min(1.0, before.tiredness + seconds * std::pow(index, 3.6) / (0.1 * kMinute));
    if (before.carbonDioxide < kRecoveringCarbonDioxide)
        return std::max(0.0, before.tiredness - seconds / kRecovery);
    return before.tiredness;
}

} // namespace carina
