#include "engine/registration/error/leave_one_out.h"

#include "engine/registration/error/error_bound.h"
#include "engine/registration/error/registration_error.h"
#include "engine/registration/error/target_error.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace carina
{
namespace
{

/// How far a touch lies from where the fit of all others puts it, and how uncertain that is.
struct LeftOut {
    double distance = 0.0; ///< metres
    Mat3 covariance_A = Mat3::Zero();
    double degrees = 0.0;

    [[nodiscard]] double ratio() const { return distance / std::sqrt(covariance_A.trace()); }
};

std::optional<LeftOut> leftOut(const LandmarkPair& out, std::span<const LandmarkPair> others)
{
    const Result<RigidFit> fit = fitRigid(others);
    if (!fit)
        return std::nullopt;
    LocalisationError fle = localisationError(metres(fit->rms), others.size());
    fle.rms = std::max(fle.rms, kLeastFle);
    std::vector<Vec3> p_A;
    std::ranges::transform(others, std::back_inserter(p_A), &LandmarkPair::p_AQ);
    const auto covariance = fitCovariance(equalErrors(p_A, fle.rms));
    if (!covariance)
        return std::nullopt;
    return LeftOut{.distance = (out.p_AQ - fit->X_AM * out.p_MQ).norm(),
                   .covariance_A = pointCovariance(*covariance, out.p_AQ)
                                   + fle.rms.si * fle.rms.si / 3.0 * Mat3::Identity(),
                   .degrees = fle.degrees};
}

/// Calls a function with each pair's place, the pair, and all others.
template <typename Function>
void leaveEachOut(std::span<const LandmarkPair> pairs, Function&& function)
{
    // The one left out stands last; each change puts it back into the place of the next.
    std::vector<LandmarkPair> turn{pairs.begin(), pairs.end()};
    for (std::size_t i = 0; i < turn.size(); ++i) {
        std::swap(turn[i], turn.back());
        function(i, turn.back(), std::span<const LandmarkPair>{turn}.first(turn.size() - 1));
        std::swap(turn[i], turn.back());
    }
}

} // namespace

Result<std::vector<std::optional<double>>> leaveOneOut(std::span<const LandmarkPair> pairs)
{
    if (const Result<RigidFit> all = fitRigid(pairs); !all)
        return tl::unexpected(all.error());
    std::vector<std::optional<double>> distances;
    leaveEachOut(pairs, [&](std::size_t, const LandmarkPair& out, auto others) {
        const Result<RigidFit> fit = fitRigid(others);
        distances.push_back(fit ? std::optional{(out.p_AQ - fit->X_AM * out.p_MQ).norm()}
                                : std::nullopt);
    });
    return distances;
}

std::optional<OutlyingLandmark> outlyingLandmark(std::span<const LandmarkPair> pairs)
{
    std::optional<LeftOut> worst;
    std::size_t landmark = 0;
    leaveEachOut(pairs, [&](std::size_t i, const LandmarkPair& out, auto others) {
        const auto each = leftOut(out, others);
        if (each && (!worst || each->ratio() > worst->ratio())) {
            worst = each;
            landmark = i;
        }
    });
    if (!worst)
        return std::nullopt;
    const double share = 1.0 - kOutlierFalseAlarm / double(pairs.size());
    if (worst->distance <= errorBound(worst->covariance_A, worst->degrees, share).si)
        return std::nullopt;
    return OutlyingLandmark{landmark, metres(worst->distance)};
}

} // namespace carina
