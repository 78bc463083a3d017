#include "engine/registration/fit/manikin_scale.h"

#include "engine/registration/error/error_bound.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr std::size_t kFewestForScale = 4;

Vec3 meanOf(std::span<const LandmarkPair> pairs, Vec3 LandmarkPair::*point)
{
    Vec3 mean = Vec3::Zero();
    for (const LandmarkPair& pair : pairs)
        mean += pair.*point / double(pairs.size());
    return mean;
}

} // namespace

bool ManikinScale::isOff() const
{
    const double off = std::abs(scale - 1.0);
    if (off <= kNoticedScale)
        return false;
    // Student's t: an error of one direction.
    const Mat3 alongOneAxis = Vec3{deviation * deviation, 0.0, 0.0}.asDiagonal();
    return off > errorBound(alongOneAxis, degrees, 1.0 - kScaleFalseAlarm).si;
}

Result<ManikinScale> manikinScale(std::span<const LandmarkPair> pairs)
{
    const Result<RigidFit> fit = fitRigid(pairs);
    if (!fit)
        return tl::unexpected(fit.error());
    if (pairs.size() < kFewestForScale)
        return fail(Errc::TooFewLandmarks, "a scale needs four landmarks");
    const Vec3 p_A_mean = meanOf(pairs, &LandmarkPair::p_AQ);
    const Vec3 p_M_mean = meanOf(pairs, &LandmarkPair::p_MQ);
    const Quat& R_AM = fit->X_AM.rotation();
    double products = 0.0;
    double squares_A = 0.0;
    double squares_M = 0.0;
    for (const LandmarkPair& pair : pairs) {
        const Vec3 d_A = pair.p_AQ - p_A_mean;
        const Vec3 d_AM = R_AM * (pair.p_MQ - p_M_mean);
        products += d_A.dot(d_AM);
        squares_A += d_A.squaredNorm();
        squares_M += d_AM.squaredNorm();
    }
    const double scale = products / squares_A;
    const double degrees = 3.0 * double(pairs.size()) - 7.0;
    const double remaining = std::max(0.0, squares_M - scale * products);
    return ManikinScale{scale, std::sqrt(remaining / degrees / squares_A), degrees};
}

std::vector<LandmarkPair> withAnatomyScaled(std::span<const LandmarkPair> pairs, double scale)
{
    const Vec3 p_A_mean = meanOf(pairs, &LandmarkPair::p_AQ);
    std::vector<LandmarkPair> scaled{pairs.begin(), pairs.end()};
    for (LandmarkPair& pair : scaled)
        pair.p_AQ = p_A_mean + scale * (pair.p_AQ - p_A_mean);
    return scaled;
}

} // namespace carina
