#pragma once

#include "engine/anatomy/events/airway_event.h"
#include "engine/core/session_time.h"
#include "engine/geometry/deformation/neck_field.h"

namespace carina::fact
{

/// The events of the patient's airway; they replace the previous ones. Each severity, that of what
/// is left out being 0, goes evenly over a time from what it is to what is said here.
struct AirwayEventsSet {
    AirwayEvents events;
    Duration over{};

    friend bool operator==(const AirwayEventsSet&, const AirwayEventsSet&) = default;
};

/// How head and neck of patient and manikin are to lie. Each angle goes evenly over a time from
/// what it is to what is said here; the patient follows as far as events let it (withinMotion).
struct HeadPositionSet {
    HeadPosition position;
    Duration over{};

    friend bool operator==(const HeadPositionSet&, const HeadPositionSet&) = default;
};

} // namespace carina::fact
