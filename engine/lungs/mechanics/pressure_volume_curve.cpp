#include "engine/lungs/mechanics/pressure_volume_curve.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

double logit(double share) { return std::log(share / (1.0 - share)); }

/// The share of the span, held where the curve is curved.
double curvedShare(double share) { return std::clamp(share, kStraightShare, 1.0 - kStraightShare); }

} // namespace

PressureVolumeCurve PressureVolumeCurve::through(Volume floor, Volume ceiling, Volume volume,
                                                 Pressure pressure, Compliance compliance)
{
    CARINA_EXPECTS(floor < volume && volume < ceiling && compliance.si > 0.0);
    const Volume span = ceiling - floor;
    const double share = (volume - floor) / span;
    const Pressure width{share * (1.0 - share) * span.si / compliance.si};
    return {floor, span, pressure - logit(share) * width, width};
}

Pressure PressureVolumeCurve::pressureAt(Volume volume) const
{
    const double share = (volume - floor) / span;
    const double curved = curvedShare(share);
    return centre + (logit(curved) + (share - curved) / (curved * (1.0 - curved))) * width;
}

Volume PressureVolumeCurve::volumeAt(Pressure pressure) const
{
    const double x = (pressure - centre) / width;
    const double share = 1.0 / (1.0 + std::exp(-x));
    const double curved = curvedShare(share);
    const double beyond = curved == share ? 0.0 : (x - logit(curved)) * curved * (1.0 - curved);
    return floor + (curved + beyond) * span;
}

Compliance PressureVolumeCurve::complianceAt(Volume volume) const
{
    const double curved = curvedShare((volume - floor) / span);
    return {curved * (1.0 - curved) * span.si / width.si};
}

} // namespace carina
