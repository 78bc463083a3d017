#include "engine/lungs/breathing_pattern.h"

#include "engine/core/expects.h"

#include <cmath>
#include <numbers>

namespace carina
{
namespace
{

/// Share of the tidal volume drawn in after a share f of inspiration.
double inspiredShare(double f) { return 0.5 * (1.0 - std::cos(std::numbers::pi * f)); }

/// Share of the tidal volume still in after a share e of expiration.
double remainingShare(double e)
{
    const double atEnd = std::exp(-kExpiratoryDecay);
    return (std::exp(-kExpiratoryDecay * e) - atEnd) / (1.0 - atEnd);
}

} // namespace

Volume inspiredVolume(const BreathingPattern& pattern, double phase)
{
    const double inspiration = pattern.inspiratoryFraction;
    CARINA_EXPECTS(phase >= 0.0 && phase <= 1.0);
    CARINA_EXPECTS(inspiration >= 0.1 && inspiration <= 0.9);
    const double share = phase <= inspiration
                             ? inspiredShare(phase / inspiration)
                             : remainingShare((phase - inspiration) / (1.0 - inspiration));
    return share * pattern.tidalVolume;
}

} // namespace carina
