#pragma once

#include "engine/anatomy/events/airway_event.h"

#include <QString>

#include <span>
#include <string_view>

namespace carina
{

/// Events of the airway that are looked for in one place, in the order in which they are offered.
struct AirwayGroup {
    std::string_view name; ///< "larynx"
    const char* text;      ///< with its key; to be translated by groupText()
    std::span<const AirwayEventKind> kinds;
};

/// All of them, from the mouth down, and last what a helper does; each kind is in one of them.
[[nodiscard]] std::span<const AirwayGroup> airwayGroups();
/// Nothing where none is called so.
[[nodiscard]] const AirwayGroup* airwayGroupNamed(std::string_view name);
/// Its name as shown, with its key: "&Larynx".
[[nodiscard]] QString groupText(const AirwayGroup& group);

} // namespace carina
