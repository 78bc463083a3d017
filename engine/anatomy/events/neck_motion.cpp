#include "engine/anatomy/events/neck_motion.h"

#include <algorithm>

namespace carina
{
namespace
{

Angle withinShare(Angle angle, double share, Angle least, Angle most)
{
    return radians(std::clamp(angle.si, share * least.si, share * most.si));
}

} // namespace

HeadPosition withinMotion(const HeadPosition& position, const AirwayEvents& events)
{
    const auto stiff = std::ranges::find(events, AirwayEventKind::StiffNeck, &AirwayEvent::kind);
    if (stiff == events.end())
        return position;
    const double share = 1.0 - stiff->severity;
    return {withinShare(position.flexion, share, kLeastFlexion, kMostFlexion),
            withinShare(position.extension, share, kLeastExtension, kMostExtension)};
}

} // namespace carina
