#include "engine/registration/calibration/tip_check.h"

#include "engine/registration/error/error_bound.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr Length kNegligibleTipError = millimetres(0.01);

} // namespace

TipCheck checkTip(const Vec3& p_NQ_tip, const Mat3& covariance_N, Length fle, double degrees,
                  const Vec3& p_NQ)
{
    TipCheck check{metres((p_NQ - p_NQ_tip).norm()), kLeastTipBound};
    const Mat3 covariance = covariance_N + (fle.si * fle.si / 3.0) * Mat3::Identity();
    if (std::sqrt(covariance.trace()) > kNegligibleTipError.si)
        check.bound = std::max(errorBound(covariance, degrees), kLeastTipBound);
    return check;
}

} // namespace carina
