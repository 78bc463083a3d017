#include "models/site/site_fit.h"

#include "engine/core/expects.h"
#include "engine/registration/error/leave_one_out.h"
#include "engine/registration/error/registration_error.h"
#include "engine/registration/fit/manikin_fit.h"
#include "engine/tracking/markers/tool_error.h"
#include "models/site/site_changes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

constexpr std::size_t kMostLocalisations = 20; ///< of one person; the newest are kept

std::vector<LandmarkResidual> residualsOf(const Site& site, const ManikinFit& fitted)
{
    const auto touches = freshTouches(site);
    const auto pairs = touchedPairs(site);
    const auto leftOut = leaveOneOut(pairs);
    std::vector<LandmarkResidual> residuals;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        residuals.push_back({.landmark = touches[i]->landmark,
                             .residual = fitted.fit.residuals[i],
                             .leftOut = leftOut ? (*leftOut)[i] : std::nullopt});
    return residuals;
}

/// Whether the last estimate is of touches that are in this fit, too.
bool sharesTouches(const Site& site)
{
    return !site.localisations.empty()
           && std::ranges::any_of(freshTouches(site),
                                  [](const TouchedPoint* touch) { return touch->isFitted; });
}

/// Whether the last estimate is that of another person, who is known.
bool isAnothers(const Site& site)
{
    const std::string& name = site.localisations.back().operatorName;
    return !name.empty() && name != site.operatorName;
}

/// What is known of this person's error from other registrations.
std::vector<LocalisationError> earlierErrors(const Site& site)
{
    std::vector<LocalisationError> earlier;
    for (const SiteLocalisation& each : site.localisations)
        if (!site.operatorName.empty() && each.operatorName == site.operatorName)
            earlier.push_back({metres(each.rms), each.degrees});
    return earlier;
}

/// The error with which the tracker sees the tip of a stylus that is held as at a touch.
std::optional<Length> errorHeldSo(const TouchedPoint& touch, const TrackedTool& stylus,
                                  const Vec3& p_SQ)
{
    PoseSample held{.X_FO = {touch.q_TS, touch.p_TQ - touch.q_TS * p_SQ}};
    if (const auto newest = stylus.history ? stylus.history->newest() : std::nullopt)
        held.covariance_O = newest->covariance_O;
    const auto error = predictedError(stylus, held);
    return error ? std::optional{error->at(p_SQ)} : std::nullopt;
}

/// The error with which the tracker saw the tip at each touch: what was noted then, or else what is
/// to be expected of such a touch now.
std::vector<std::optional<Length>> seenErrors(const Site& site, const FitInputs& inputs)
{
    const StylusTip* tip = site.stylus(inputs.tool);
    std::vector<std::optional<Length>> errors;
    for (const TouchedPoint* touch : freshTouches(site)) {
        auto& error = errors.emplace_back();
        if (touch->seenError)
            error = metres(*touch->seenError);
        else if (tip && inputs.stylus)
            error = errorHeldSo(*touch, *inputs.stylus, tip->p_SQ);
    }
    return errors;
}

Result<RegistrationError> errorOf(const Site& site, const ManikinFit& fitted,
                                  const FitInputs& inputs)
{
    const StylusTip* stylus = site.stylus(inputs.tool);
    const Mat3 tip_S = stylus ? stylus->covariance_S : Mat3::Zero();
    const Mat3 R_AT = fitted.X_AT().rotation().toRotationMatrix();
    std::vector<Vec3> places;
    std::vector<Mat3> held;
    for (const LandmarkPair& pair : touchedPairs(site))
        places.push_back(pair.p_AQ);
    for (const TouchedPoint* touch : freshTouches(site))
        held.push_back(R_AT * touch->q_TS.toRotationMatrix());
    return registrationError(places, held, tip_S, metres(fitted.fit.rms), earlierErrors(site),
                             seenErrors(site, inputs));
}

/// How the manikin lies in the probes on it.
void noteProbes(SiteRegistration& registration, const FitInputs& inputs, const RigidTransform& X_TM)
{
    if (inputs.X_TJ)
        registration.X_JM = inputs.X_TJ->inverse() * X_TM;
    if (inputs.X_TB)
        registration.X_BM = inputs.X_TB->inverse() * X_TM;
}

/// For the registrations after this one.
void noteLocalisation(Site& site, const LocalisationError& own)
{
    for (TouchedPoint& touch : site.touched)
        touch.isFitted = touch.isFitted || !touch.stale;
    site.localisations.push_back({.rms = own.rms.si,
                                  .degrees = own.degrees,
                                  .at = site.registration->madeAt,
                                  .operatorName = site.operatorName});
    if (site.localisations.size() > kMostLocalisations)
        site.localisations.erase(site.localisations.begin());
}

/// How far its touches stay from their landmarks, once it was refined.
void renewResiduals(Site& site)
{
    SiteRegistration& registration = *site.registration;
    double squares = 0.0;
    for (LandmarkResidual& residual : registration.residuals) {
        const TouchedPoint* touch = touchOf(site, residual.landmark);
        const auto& landmarks = site.catalogue->landmarks;
        const auto place = std::ranges::find(landmarks, residual.landmark, &Landmark::name);
        if (touch && place != landmarks.end())
            residual.residual = (place->p_AQ - registration.X_AT * touch->p_TQ).norm();
        squares += residual.residual * residual.residual / double(registration.residuals.size());
    }
    registration.rms = std::sqrt(squares);
}

} // namespace

FitInputs fitInputs(const StylusWatch& watch, std::string at)
{
    return {.tool = watch.tool(),
            .X_TJ = watch.probe(ToolRole::Jaw),
            .X_TB = watch.probe(ToolRole::Manikin),
            .stylus = watch.stylusTool(),
            .at = std::move(at)};
}

Result<Site> withFit(Site site, const FitInputs& inputs)
{
    std::vector<TouchedLandmark> landmarks;
    for (const LandmarkPair& pair : touchedPairs(site))
        landmarks.push_back({.p_AQ = pair.p_AQ, .p_TQ = pair.p_MQ});
    const Result<ManikinFit> fitted = fitManikin(landmarks);
    if (!fitted)
        return tl::unexpected(fitted.error());
    const bool isShared = sharesTouches(site);
    const bool isMixed = isShared && isAnothers(site); // so that it is an estimate of neither
    if (isShared && !isMixed)
        site.localisations.pop_back();
    const auto error = errorOf(site, *fitted, inputs);
    if (!error)
        return tl::unexpected(error.error());
    SiteRegistration registration{.X_AM = fitted->fit.X_AM,
                                  .X_AT = fitted->X_AT(),
                                  .rms = fitted->fit.rms,
                                  .residuals = residualsOf(site, *fitted),
                                  .covariance_A = error->covariance_A,
                                  .fle = error->touch.fle.rms.si,
                                  .degrees = error->touch.fle.degrees,
                                  .pooled = error->touch.pooled,
                                  .disagreeing = error->touch.disagreeing,
                                  .madeAt = inputs.at,
                                  .operatorName = site.operatorName};
    noteProbes(registration, inputs, fitted->X_TM);
    site.registration = std::move(registration);
    if (!isMixed)
        noteLocalisation(site, error->own);
    if (site.verification)
        makeStale(site.verification->stale, StaleCause::Fit);
    return site;
}

Site withSwab(Site site, const std::string& tool, const std::string& surface, std::size_t points,
              const SurfaceRefinement& refinement)
{
    CARINA_EXPECTS(site.registration);
    SiteRegistration& registration = *site.registration;
    const RigidTransform X_MT = registration.X_AM.inverse() * registration.X_AT;
    registration.X_AM = refinement.X_AM;
    registration.X_AT = refinement.X_AM * X_MT;
    const StylusTip* tip = site.stylus(tool);
    registration.covariance_A = refinedCovariance(registration.covariance_A, refinement,
                                                  tip ? tip->covariance_S : Mat3::Zero());
    registration.swab = SiteSwab{.surface = surface,
                                 .points = int(points),
                                 .outliers = refinement.outliers,
                                 .startRms = refinement.startRms,
                                 .rms = refinement.rms,
                                 .moved = refinement.moved};
    renewResiduals(site);
    if (site.verification)
        makeStale(site.verification->stale, StaleCause::Fit);
    return site;
}

Site withRelay(Site site, const ReRegistration& relay, const FitInputs& inputs)
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
        makeStale(site.verification->stale, StaleCause::Manikin);
    }
    registration.X_AT = relay.X_AT;
    registration.covariance_A = relay.covariance_A;
    noteProbes(registration, inputs, relay.X_TM);
    registration.relays.push_back({.at = inputs.at,
                                   .operatorName = site.operatorName,
                                   .landmarks = int(site.relay->size()),
                                   .rms = relay.rms});
    site.relay.reset();
    site.step = SiteStep::Verify;
    return site;
}

} // namespace carina
