#pragma once

#include "engine/geometry/rotation.h"
#include "models/site/site_changes.h"
#include "models/site/site_fit.h"

namespace carina::test
{

inline const std::string kTool = "Stylus";
inline const std::string kTracker = "Tracker A";
inline const RigidTransform kX_TA{rotationFromVector({0.2, 1.0, -0.4}), {0.05, -0.1, -1.1}};

inline const LandmarkCatalogue& eightLandmarks()
{
    static const LandmarkCatalogue catalogue =
        ribCageAndJawCatalogue(ribCageCatalogue(metres(1.7), "0f3a"), furtherPlaces(metres(1.7)));
    return catalogue;
}

inline StylusTip someTip()
{
    return {.p_SQ = {0.001, -0.002, -0.15},
            .rms = 0.3e-3,
            .calibratedAt = "2004-03-27T10:00:00Z",
            .tool = kTool,
            .covariance_S = 1e-8 * Mat3::Identity(),
            .poses = 300};
}

/// The stylus at a place of the anatomy, off it by so much.
inline StylusTouch touchAt(const Vec3& p_AQ, const Vec3& off_A = Vec3::Zero())
{
    return {.point = {.p_FQ = kX_TA * Vec3{p_AQ + off_A}, .spread = 0.2e-3, .samples = 60},
            .q_TS = rotationFromVector({0.3, 0.1, 10.0 * p_AQ.x()})};
}

/// With tracker, stylus and landmarks.
inline Site preparedSite()
{
    Site site;
    site.operatorName = "A. Frei";
    return withLandmarks(withStylus(withTracker(std::move(site), kTracker), someTip()),
                         eightLandmarks());
}

/// And the first landmarks touched, each a little off its place.
inline Site touchedSite(std::size_t count = 8)
{
    Site site = preparedSite();
    const LandmarkCatalogue catalogue = eightLandmarks();
    for (std::size_t i = 0; i < count; ++i) {
        const Landmark& landmark = catalogue.landmarks[i];
        const Vec3 off_A{i % 2 ? 0.4e-3 : -0.4e-3, i % 3 ? 0.3e-3 : -0.3e-3, 0.2e-3};
        site = withTouch(std::move(site), landmark.name, touchAt(landmark.p_AQ, off_A));
    }
    return site;
}

inline Site fittedSite()
{
    return withFit(touchedSite(), {.tool = kTool, .at = "2004-03-27T10:15:00Z"}).value();
}

inline VerifiedPoint checkedPoint(const char* name)
{
    return {.name = name,
            .p_AQ = {0.0, -0.1, 0.17},
            .p_TQ = kX_TA * Vec3{0.0, -0.1, 0.171},
            .error = 1e-3,
            .bound = 2e-3};
}

inline Site verifiedSite(Verdict verdict = Verdict::Good)
{
    Site site = withVerified(fittedSite(), checkedPoint("Upper incisors"));
    site = withVerified(std::move(site), checkedPoint("Left clavicle"));
    return verdict == Verdict::Open ? site
                                    : withVerdict(std::move(site), verdict, "2004-03-27T10:30:00Z");
}

} // namespace carina::test
