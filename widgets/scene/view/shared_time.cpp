#include "widgets/scene/view/shared_time.h"

#include <algorithm>
#include <cmath>

namespace carina
{

void SharedTime::took(const void* view, LocalTime now, Duration drawing, Duration interval)
{
    const auto [known, isNew] = m_views.try_emplace(view, View{now, interval});
    View& it = known->second;
    it.interval = interval;
    const double since = toSeconds(now - it.at);
    if (isNew || !(since > 0.0))
        return;
    const double weight = 1.0 - std::exp(-since / toSeconds(kOver));
    it.share += weight * (std::min(toSeconds(drawing) / since, 1.0) - it.share);
    it.at = now;
}

double SharedTime::leftFor(Duration interval) const
{
    double left = 1.0;
    for (const auto& [view, other] : m_views)
        if (other.interval > interval)
            left -= other.share;
    return std::max(left, kLeastLeft);
}

} // namespace carina
