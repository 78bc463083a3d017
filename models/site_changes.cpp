#include "models/site_changes.h"

#include "engine/core/expects.h"
#include "engine/registration/leave_one_out.h"
#include "engine/registration/manikin_fit.h"
#include "engine/registration/registration_error.h"

#include <algorithm>

namespace carina
{
namespace
{

/// The deepest cause stays: a result from before the tracker was changed is of no use whatever else
/// has changed since.
void makeStale(std::optional<StaleCause>& stale, StaleCause cause)
{
    stale = std::min(stale.value_or(cause), cause);
}

void makeFitStale(Site& site, StaleCause cause)
{
    if (site.registration)
        makeStale(site.registration->stale, cause);
    if (site.verification)
        makeStale(site.verification->stale, cause);
}

void makeTouchesStale(Site& site, StaleCause cause)
{
    for (TouchedPoint& touch : site.touched)
        makeStale(touch.stale, cause);
    makeFitStale(site, cause);
}

void putTouch(std::vector<TouchedPoint>& touched, const std::string& landmark,
              const StylusTouch& touch)
{
    std::erase_if(touched, [&](const TouchedPoint& before) { return before.landmark == landmark; });
    touched.push_back({.landmark = landmark,
                       .p_TQ = touch.point.p_FQ,
                       .spread = touch.point.spread,
                       .q_TS = touch.q_TS});
}

/// Touches that count, with the places of their landmarks.
struct FreshTouches {
    std::vector<const TouchedPoint*> touches;
    std::vector<TouchedLandmark> landmarks;
};

FreshTouches freshOnes(const Site& site)
{
    FreshTouches fresh;
    for (const Landmark& landmark : site.catalogue.value_or(LandmarkCatalogue{}).landmarks) {
        const TouchedPoint* touch = touchOf(site, landmark.name);
        if (!touch || touch->stale)
            continue;
        fresh.touches.push_back(touch);
        fresh.landmarks.push_back({.p_AQ = landmark.p_AQ, .p_TQ = touch->p_TQ});
    }
    return fresh;
}

std::vector<LandmarkResidual> residualsOf(const FreshTouches& fresh, const ManikinFit& fitted)
{
    std::vector<LandmarkPair> pairs;
    for (const TouchedLandmark& landmark : fresh.landmarks)
        pairs.push_back({landmark.p_AQ, landmark.p_TQ});
    const auto leftOut = leaveOneOut(pairs);
    std::vector<LandmarkResidual> residuals;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        residuals.push_back({.landmark = fresh.touches[i]->landmark,
                             .residual = fitted.fit.residuals[i],
                             .leftOut = leftOut ? (*leftOut)[i] : std::nullopt});
    return residuals;
}

Result<RegistrationError> errorOf(const FreshTouches& fresh, const ManikinFit& fitted,
                                  const Mat3& tip_S)
{
    const Mat3 R_AT = fitted.X_AT().rotation().toRotationMatrix();
    std::vector<Vec3> places;
    std::vector<Mat3> held;
    for (std::size_t i = 0; i < fresh.touches.size(); ++i) {
        places.push_back(fresh.landmarks[i].p_AQ);
        held.push_back(R_AT * fresh.touches[i]->q_TS.toRotationMatrix());
    }
    return registrationError(places, held, tip_S, metres(fitted.fit.rms));
}

} // namespace

Site withTracker(Site site, std::string tracker)
{
    if (site.tracker == tracker)
        return site;
    site.tracker = std::move(tracker);
    makeTouchesStale(site, StaleCause::Tracker);
    return site;
}

Site withStylus(Site site, StylusTip stylus)
{
    std::erase_if(site.styluses, [&](const StylusTip& tip) {
        return tip.tool == stylus.tool || tip.tool.empty();
    });
    site.styluses.push_back(std::move(stylus));
    makeTouchesStale(site, StaleCause::Stylus);
    return site;
}

Site withStylusAxis(Site site, const std::string& tool, StylusAxis axis)
{
    for (StylusTip& tip : site.styluses)
        if (&tip == site.stylus(tool))
            tip.axis = axis;
    return site;
}

Site withLandmarks(Site site, LandmarkCatalogue catalogue)
{
    if (site.catalogue == catalogue)
        return site;
    const LandmarkCatalogue before = site.catalogue.value_or(LandmarkCatalogue{});
    std::erase_if(site.touched, [&](TouchedPoint& touch) {
        const auto now = std::ranges::find(catalogue.landmarks, touch.landmark, &Landmark::name);
        if (now == catalogue.landmarks.end())
            return true;
        if (std::ranges::count(before.landmarks, *now) == 0)
            makeStale(touch.stale, StaleCause::Landmarks);
        return false;
    });
    site.catalogue = std::move(catalogue);
    makeFitStale(site, StaleCause::Landmarks);
    return site;
}

Site withTouch(Site site, const std::string& landmark, const StylusTouch& touch)
{
    putTouch(site.touched, landmark, touch);
    makeFitStale(site, StaleCause::Touches);
    return site;
}

Site withOrder(Site site, const std::vector<std::size_t>& touchOf)
{
    const Site before = site;
    const FreshTouches fresh = freshOnes(before);
    CARINA_EXPECTS(fresh.touches.size() == touchOf.size());
    for (std::size_t i = 0; i < touchOf.size(); ++i) {
        const std::string& landmark = fresh.touches[i]->landmark;
        TouchedPoint touch = *fresh.touches[touchOf[i]];
        touch.landmark = landmark;
        *std::ranges::find(site.touched, landmark, &TouchedPoint::landmark) = std::move(touch);
    }
    makeFitStale(site, StaleCause::Touches);
    return site;
}

Result<Site> withFit(Site site, const FitInputs& inputs)
{
    const FreshTouches fresh = freshOnes(site);
    const Result<ManikinFit> fitted = fitManikin(fresh.landmarks);
    if (!fitted)
        return tl::unexpected(fitted.error());
    const StylusTip* stylus = site.stylus(inputs.tool);
    const auto error = errorOf(fresh, *fitted, stylus ? stylus->covariance_S : Mat3::Zero());
    if (!error)
        return tl::unexpected(error.error());
    SiteRegistration registration{.X_AM = fitted->fit.X_AM,
                                  .X_AT = fitted->X_AT(),
                                  .rms = fitted->fit.rms,
                                  .residuals = residualsOf(fresh, *fitted),
                                  .covariance_A = error->covariance_A,
                                  .fle = error->fle.rms.si,
                                  .degrees = error->fle.degrees,
                                  .madeAt = inputs.at,
                                  .operatorName = site.operatorName};
    if (inputs.X_TJ)
        registration.X_JM = inputs.X_TJ->inverse() * fitted->X_TM;
    if (inputs.X_TB)
        registration.X_BM = inputs.X_TB->inverse() * fitted->X_TM;
    site.registration = std::move(registration);
    if (site.verification)
        makeStale(site.verification->stale, StaleCause::Fit);
    return site;
}

Site withSwab(Site site, const std::string& surface, std::size_t points,
              const SurfaceRefinement& refinement)
{
    CARINA_EXPECTS(site.registration);
    SiteRegistration& registration = *site.registration;
    const RigidTransform X_MT = registration.X_AM.inverse() * registration.X_AT;
    registration.X_AM = refinement.X_AM;
    registration.X_AT = refinement.X_AM * X_MT;
    registration.covariance_A = refinedCovariance(registration.covariance_A, refinement);
    registration.swab = SiteSwab{.surface = surface,
                                 .points = int(points),
                                 .outliers = refinement.outliers,
                                 .startRms = refinement.startRms,
                                 .rms = refinement.rms,
                                 .moved = refinement.moved};
    if (site.verification)
        makeStale(site.verification->stale, StaleCause::Fit);
    return site;
}

Site withRelayTouch(Site site, const std::string& landmark, const StylusTouch& touch)
{
    CARINA_EXPECTS(site.relay);
    putTouch(*site.relay, landmark, touch);
    return site;
}

Site withRelay(Site site, const ReRegistration& relay, std::string at)
{
    CARINA_EXPECTS(site.registration && site.relay);
    SiteRegistration& registration = *site.registration;
    const RigidTransform X_TnowT = relay.X_AT.inverse() * registration.X_AT;
    for (TouchedPoint& touch : site.touched) {
        touch.p_TQ = X_TnowT * touch.p_TQ;
        touch.q_TS = X_TnowT.rotation() * touch.q_TS;
    }
    if (site.verification) {
        for (VerifiedPoint& point : site.verification->points)
            point.p_TQ = X_TnowT * point.p_TQ;
        makeStale(site.verification->stale, StaleCause::Fit);
    }
    registration.X_AT = relay.X_AT;
    registration.covariance_A = relay.covariance_A;
    registration.relays.push_back({.at = std::move(at),
                                   .operatorName = site.operatorName,
                                   .landmarks = int(site.relay->size()),
                                   .rms = relay.rms});
    site.relay.reset();
    return site;
}

Site withVerified(Site site, VerifiedPoint point)
{
    CARINA_EXPECTS(site.registration);
    if (!site.verification || site.verification->stale)
        site.verification = SiteVerification{};
    site.verification->verdict = Verdict::Open;
    site.verification->at.clear();
    auto& points = site.verification->points;
    std::erase_if(points, [&](const VerifiedPoint& before) { return before.name == point.name; });
    points.push_back(std::move(point));
    return site;
}

Site withVerdict(Site site, Verdict verdict, std::string at)
{
    CARINA_EXPECTS(site.verification);
    site.verification->verdict = verdict;
    site.verification->at = std::move(at);
    site.verification->operatorName = site.operatorName;
    return site;
}

const TouchedPoint* touchOf(const Site& site, const std::string& landmark)
{
    const auto touch = std::ranges::find(site.touched, landmark, &TouchedPoint::landmark);
    return touch == site.touched.end() ? nullptr : &*touch;
}

std::size_t freshTouches(const Site& site) { return freshOnes(site).touches.size(); }

std::vector<LandmarkPair> touchedPairs(const Site& site)
{
    std::vector<LandmarkPair> pairs;
    for (const TouchedLandmark& landmark : freshOnes(site).landmarks)
        pairs.push_back({landmark.p_AQ, landmark.p_TQ});
    return pairs;
}

} // namespace carina
