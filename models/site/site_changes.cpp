#include "models/site/site_changes.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

void makeToolsStale(Site& site, StaleCause cause)
{
    for (SiteTool& tool : site.tools)
        makeStale(tool.stale, cause);
}

void putTouch(std::vector<TouchedPoint>& touched, const std::string& landmark,
              const StylusTouch& touch)
{
    std::erase_if(touched, [&](const TouchedPoint& before) { return before.landmark == landmark; });
    touched.push_back({.landmark = landmark,
                       .p_TQ = touch.point.p_FQ,
                       .spread = touch.point.spread,
                       .q_TS = touch.q_TS});
    if (touch.seenError)
        touched.back().seenError = touch.seenError->si;
}

} // namespace

Site withTracker(Site site, std::string tracker)
{
    if (site.tracker == tracker)
        return site;
    site.tracker = std::move(tracker);
    site.relay.reset();
    makeTouchesStale(site, StaleCause::Tracker);
    makeToolsStale(site, StaleCause::Tracker);
    return site;
}

Site withStylus(Site site, StylusTip stylus)
{
    std::erase_if(site.styluses, [&](const StylusTip& tip) {
        return tip.tool == stylus.tool || tip.tool.empty();
    });
    site.styluses.push_back(std::move(stylus));
    site.relay.reset();
    makeTouchesStale(site, StaleCause::Stylus);
    makeToolsStale(site, StaleCause::Stylus);
    return site;
}

Site withTool(Site site, SiteTool tool)
{
    std::erase_if(site.tools, [&](const SiteTool& before) { return before.role == tool.role; });
    site.tools.push_back(std::move(tool));
    return site;
}

Site withToolCheck(Site site, ToolRole role, SiteToolCheck check)
{
    for (SiteTool& tool : site.tools) {
        if (tool.role != role)
            continue;
        if (!check.tip.isBent() && tool.stale == StaleCause::Stylus)
            tool.stale.reset();
        tool.check = check;
    }
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
    site.relay.reset();
    makeFitStale(site, StaleCause::Landmarks);
    return site;
}

bool isLaidAnew(const Site& site)
{
    return site.registration && !site.registration->stale && !site.registration->relays.empty();
}

Site withTouch(Site site, const std::string& landmark, const StylusTouch& touch)
{
    if (isLaidAnew(site)) // touches of before are no better known than where it lies now
        makeTouchesStale(site, StaleCause::Manikin);
    putTouch(site.touched, landmark, touch);
    makeFitStale(site, StaleCause::Touches);
    return site;
}

Site withOrder(Site site, const std::vector<std::size_t>& touchOf)
{
    const Site before = site;
    const auto fresh = freshTouches(before);
    CARINA_EXPECTS(fresh.size() == touchOf.size());
    for (std::size_t i = 0; i < touchOf.size(); ++i) {
        const std::string& landmark = fresh[i]->landmark;
        TouchedPoint touch = *fresh[touchOf[i]];
        touch.landmark = landmark;
        *std::ranges::find(site.touched, landmark, &TouchedPoint::landmark) = std::move(touch);
    }
    makeFitStale(site, StaleCause::Touches);
    return site;
}

Site withRelayTouch(Site site, const std::string& landmark, const StylusTouch& touch)
{
    CARINA_EXPECTS(site.relay);
    putTouch(*site.relay, landmark, touch);
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

std::vector<const TouchedPoint*> freshTouches(const Site& site)
{
    std::vector<const TouchedPoint*> fresh;
    for (const Landmark& landmark : site.catalogue.value_or(LandmarkCatalogue{}).landmarks)
        if (const TouchedPoint* touch = touchOf(site, landmark.name); touch && !touch->stale)
            fresh.push_back(touch);
    return fresh;
}

std::vector<LandmarkPair> touchedPairs(const Site& site)
{
    std::vector<LandmarkPair> pairs;
    for (const TouchedPoint* touch : freshTouches(site)) {
        const auto& landmarks = site.catalogue->landmarks;
        pairs.push_back(
            {std::ranges::find(landmarks, touch->landmark, &Landmark::name)->p_AQ, touch->p_TQ});
    }
    return pairs;
}

} // namespace carina
