#include "engine/session/airway/airway_rules.h"

#include "engine/session/facts/number_check.h"

namespace carina
{

Result<void> checkAirway(const fact::AirwayEventsSet& fact)
{
    for (const AirwayEvent& event : fact.events)
        if (const auto verdict = checkNumber("severity", event.severity, 0.0, 1.0, ""); !verdict)
            return verdict;
    if (!areProper(fact.events))
        return fail(Errc::OutOfRange, "events of an airway out of order, or one twice");
    return checkNumber("time over which an airway changes", toSeconds(fact.over), 0.0,
                       toSeconds(kLongestAirwayChange), " s");
}

} // namespace carina
