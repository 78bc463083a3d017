#include "engine/session/airway/airway_rules.h"

#include "engine/session/facts/number_check.h"

namespace carina
{
namespace
{

Result<void> checkAngle(const char* what, Angle angle, Angle least, Angle most)
{
    return checkNumber(what, inDegrees(angle), inDegrees(least), inDegrees(most), " deg");
}

Result<void> checkChangeTime(const char* what, Duration over)
{
    return checkNumber(what, toSeconds(over), 0.0, toSeconds(kLongestAirwayChange), " s");
}

} // namespace

Result<void> checkAirway(const fact::AirwayEventsSet& fact)
{
    for (const AirwayEvent& event : fact.events)
        if (const auto verdict = checkNumber("severity", event.severity, 0.0, 1.0, ""); !verdict)
            return verdict;
    if (!areProper(fact.events))
        return fail(Errc::OutOfRange, "events of an airway out of order, or one twice");
    return checkChangeTime("time over which an airway changes", fact.over);
}

Result<void> checkAirway(const fact::HeadPositionSet& fact)
{
    const HeadPosition& position = fact.position;
    return checkAngle("flexion of the neck", position.flexion, kLeastFlexion, kMostFlexion)
        .and_then([&] {
            return checkAngle("extension of the head", position.extension, kLeastExtension,
                              kMostExtension);
        })
        .and_then([&] {
            return checkChangeTime("time over which the head changes its position", fact.over);
        });
}

} // namespace carina
