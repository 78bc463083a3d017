#include "engine/audio/auscultation.h"

#include "engine/core/expects.h"

#include <cmath>

namespace carina
{

AuscultationGains auscultate(const AuscultationDistances& distances, double scale)
{
    CARINA_EXPECTS(scale > 0.0);
    if (distances.skin > kAuscultationContact)
        return {};
    const auto gain = [scale](Length distance) {
        const double deviations = distance / (scale * kAuscultationReach);
        return kThroughChest + (1.0 - kThroughChest) * std::exp(-0.5 * deviations * deviations);
    };
    return {gain(distances.right), gain(distances.left), gain(distances.stomach),
            gain(distances.heart), gain(distances.trachea)};
}

} // namespace carina
