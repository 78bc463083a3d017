#include "engine/registration/error/localisation_error.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>

namespace carina
{

Length LocalisationError::limit(double share) const
{
    if (degrees == kKnownExactly)
        return rms;
    return (1.0 / std::sqrt(chiSquaredShare(degrees, 1.0 - share))) * rms;
}

LocalisationError localisationError(Length fre, std::size_t landmarks)
{
    CARINA_EXPECTS(landmarks >= 3);
    const auto count = static_cast<double>(landmarks);
    return {(1.0 / std::sqrt(1.0 - 2.0 / count)) * fre, 3.0 * count - 6.0};
}

PooledLocalisation pooled(const LocalisationError& now, std::span<const LocalisationError> earlier)
{
    CARINA_EXPECTS(now.rms.si > 0.0 && now.degrees != kKnownExactly);
    PooledLocalisation result;
    double degrees = now.degrees;
    double squares = now.degrees * now.rms.si * now.rms.si;
    for (const LocalisationError& each : earlier) {
        CARINA_EXPECTS(each.rms.si > 0.0 && each.degrees != kKnownExactly);
        const double ratio = std::pow(each.rms / now.rms, 2);
        const double tail = varianceRatioTail(ratio, each.degrees, now.degrees);
        if (2.0 * std::min(tail, 1.0 - tail) < kDisagreeShare) {
            ++result.disagreeing;
            continue;
        }
        ++result.pooled;
        degrees += each.degrees;
        squares += each.degrees * each.rms.si * each.rms.si;
    }
    result.fle = {metres(std::sqrt(squares / degrees)), degrees};
    return result;
}

} // namespace carina
