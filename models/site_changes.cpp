#include "models/site_changes.h"

#include "engine/registration/manikin_fit.h"

#include <algorithm>

namespace carina
{

Site withTracker(Site site, std::string tracker)
{
    if (site.tracker == tracker)
        return site;
    site.tracker = std::move(tracker);
    site.touched.clear();
    site.registration.reset();
    return site;
}

Site withStylus(Site site, StylusTip stylus)
{
    site.stylus = std::move(stylus);
    site.touched.clear();
    site.registration.reset();
    return site;
}

Site withLandmarks(Site site, LandmarkCatalogue catalogue)
{
    if (site.catalogue == catalogue)
        return site;
    const auto& before = site.catalogue ? site.catalogue->landmarks : catalogue.landmarks;
    std::erase_if(site.touched, [&](const TouchedPoint& touch) {
        const auto was = std::ranges::find(before, touch.landmark, &Landmark::name);
        return was == before.end() || std::ranges::count(catalogue.landmarks, *was) == 0;
    });
    site.catalogue = std::move(catalogue);
    site.registration.reset();
    return site;
}

Site withTouch(Site site, const std::string& landmark, const DwellPoint& point_T)
{
    std::erase_if(site.touched,
                  [&](const TouchedPoint& touch) { return touch.landmark == landmark; });
    site.touched.push_back({landmark, point_T.p_FQ, point_T.spread});
    site.registration.reset();
    return site;
}

Result<Site> withFit(Site site, const std::optional<RigidTransform>& X_TJ)
{
    std::vector<TouchedLandmark> landmarks;
    std::vector<LandmarkResidual> residuals;
    for (const Landmark& landmark : site.catalogue.value_or(LandmarkCatalogue{}).landmarks) {
        if (const TouchedPoint* touch = touchOf(site, landmark.name)) {
            landmarks.push_back({.p_AQ = landmark.p_AQ, .p_TQ = touch->p_TQ});
            residuals.push_back({.landmark = landmark.name});
        }
    }
    const Result<ManikinFit> fitted = fitManikin(landmarks);
    if (!fitted)
        return tl::unexpected(fitted.error());
    for (std::size_t i = 0; i < residuals.size(); ++i)
        residuals[i].residual = fitted->fit.residuals[i];
    site.registration = SiteRegistration{.X_AM = fitted->fit.X_AM,
                                         .X_AT = fitted->X_AT(),
                                         .rms = fitted->fit.rms,
                                         .residuals = std::move(residuals)};
    if (X_TJ)
        site.registration->X_JM = X_TJ->inverse() * fitted->X_TM;
    return site;
}

const TouchedPoint* touchOf(const Site& site, const std::string& landmark)
{
    const auto touch = std::ranges::find(site.touched, landmark, &TouchedPoint::landmark);
    return touch == site.touched.end() ? nullptr : &*touch;
}

} // namespace carina
