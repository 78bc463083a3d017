#include "engine/registration/error/localisation_error.h"

#include "engine/core/expects.h"

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

LocalisationError pooled(const LocalisationError& a, const LocalisationError& b)
{
    if (a.degrees == kKnownExactly)
        return a;
    if (b.degrees == kKnownExactly)
        return b;
    const double degrees = a.degrees + b.degrees;
    const double squares = a.degrees * a.rms.si * a.rms.si + b.degrees * b.rms.si * b.rms.si;
    return {metres(std::sqrt(squares / degrees)), degrees};
}

} // namespace carina
