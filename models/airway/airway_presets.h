#pragma once

#include "engine/anatomy/events/airway_event.h"
#include "engine/anatomy/laryngoscopy/glottic_view.h"
#include "models/patient/laryngoscopy.h"

#include <QString>

#include <random>
#include <span>
#include <string_view>
#include <vector>

namespace carina
{

/// Between what severities an event is in people whom a preset stands for.
struct SeverityRange {
    AirwayEventKind kind = AirwayEventKind::TongueOedema;
    double least = 0.0;
    double most = 1.0;
    const char* source = ""; ///< why this event is among them; how severe it is, is of ours
};

/// How a grade is looked at: by which eye, and how the head lies but for what a stiff neck keeps.
struct GradedLook {
    ScopeEye eye = ScopeEye::Video;
    HeadPosition head{};
};

/// Events of an airway that come together, with their severities: of ours, named after what they
/// are. What is not among them is clear.
struct AirwayPreset {
    std::string_view name; ///< "anaphylaxis"
    const char* text;      ///< to be translated by presetText()
    AirwayEvents events;   ///< areProper, none of severity 0
    /// The grade of Cormack and Lehane that it is named for, 1 to 4, where 2 is 2a and 2b; 0: none.
    int grade = 0;
    /// Of one that is named for a grade: in the order of the kinds; `events` are their middles.
    std::vector<SeverityRange> ranges{};
    GradedLook look{};         ///< in which it has that grade
    const char* notDrawn = ""; ///< of what its name says; to be translated by limitsText()
};

/// All of them, as they are offered; the first is the clear airway.
[[nodiscard]] std::span<const AirwayPreset> airwayPresets();
/// Nothing where none is called so.
[[nodiscard]] const AirwayPreset* presetNamed(std::string_view name);
/// The preset with just these events and severities; nothing where there is none.
[[nodiscard]] const AirwayPreset* presetOf(const AirwayEvents& events);
/// Its name as shown: "Anaphylaxis".
[[nodiscard]] QString presetText(const AirwayPreset& preset);
/// Events that are set: "Anaphylaxis" where several are those of a preset, else eventsText().
[[nodiscard]] QString airwayText(const AirwayEvents& events);
/// The same for a line with little room: of more than two that are of no preset the most severe one
/// and how many more there are, "Angio-oedema 35 % + 3 more".
[[nodiscard]] QString shortAirwayText(const AirwayEvents& events);

/// Of what patient, with which blade and by which eye it has the grade that it is named for:
/// "Grade 1 is promised only of an adult with the head in the position Neutral, in the camera of a
/// Macintosh 3 lifted as usual."; of one that is named for none what of its name is not drawn, or
/// nothing.
[[nodiscard]] QString limitsText(const AirwayPreset& preset);

/// Another patient of the kind that a preset stands for: each severity is drawn evenly from its
/// range. Of a preset without ranges these are always its events.
[[nodiscard]] AirwayEvents drawnFrom(const AirwayPreset& preset, std::mt19937& random);
/// Whether a preset is named for this grade.
[[nodiscard]] bool isNamedFor(const AirwayPreset& preset, CormackLehane grade);

} // namespace carina
