#pragma once

#include "engine/anatomy/events/airway_event.h"

#include <QString>

namespace carina
{

[[nodiscard]] QString eventText(AirwayEventKind kind);
/// One sentence: what is to be seen of it, and what it does to an intubation.
[[nodiscard]] QString eventEffect(AirwayEventKind kind);
/// Several with their severities: "Tongue oedema 60 % + Laryngospasm 100 %"; "Clear" of none.
[[nodiscard]] QString eventsText(const AirwayEvents& events);

} // namespace carina
