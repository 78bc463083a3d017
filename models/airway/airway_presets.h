#pragma once

#include "engine/anatomy/events/airway_event.h"

#include <QString>

#include <span>
#include <string_view>

namespace carina
{

/// Events of an airway that come together, with their severities: of ours, named after what they
/// are. What is not among them is clear.
struct AirwayPreset {
    std::string_view name; ///< "anaphylaxis"
    const char* text;      ///< to be translated by presetText()
    AirwayEvents events;   ///< areProper, none of severity 0
};

/// All of them, as they are offered; the first is the clear airway.
[[nodiscard]] std::span<const AirwayPreset> airwayPresets();
/// Nothing where none is called so.
[[nodiscard]] const AirwayPreset* presetNamed(std::string_view name);
/// The preset with just these events and severities; nothing where there is none.
[[nodiscard]] const AirwayPreset* presetOf(const AirwayEvents& events);
/// Its name as shown: "Anaphylaxis".
[[nodiscard]] QString presetText(const AirwayPreset& preset);

} // namespace carina
