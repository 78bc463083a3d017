#include "engine/registration/fit/manikin_fit.h"

#include "engine/registration/fit/site_frame.h"

#include <vector>

namespace carina
{

Result<ManikinFit> fitManikin(std::span<const TouchedLandmark> landmarks)
{
    std::vector<Vec3> p_TQ;
    for (const TouchedLandmark& landmark : landmarks)
        p_TQ.push_back(landmark.p_TQ);
    const Result<RigidTransform> X_TM = siteFrame(p_TQ);
    if (!X_TM)
        return tl::unexpected(X_TM.error());
    const RigidTransform X_MT = X_TM->inverse();
    std::vector<LandmarkPair> pairs;
    for (const TouchedLandmark& landmark : landmarks)
        pairs.push_back({.p_AQ = landmark.p_AQ, .p_MQ = X_MT * landmark.p_TQ});
    const Result<RigidFit> fit = fitRigid(pairs);
    if (!fit)
        return tl::unexpected(fit.error());
    return ManikinFit{*X_TM, *fit};
}

} // namespace carina
