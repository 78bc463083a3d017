#include "engine/io/site/stale_marks.h"

#include <algorithm>

namespace carina
{

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

} // namespace carina
