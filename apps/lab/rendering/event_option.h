#pragma once

#include "apps/lab/command/command.h"
#include "engine/anatomy/events/airway_event.h"

namespace carina::lab
{

inline constexpr Option kEvent{
    "event", "NAME[=S]",
    "what makes the airway difficult: tongue_oedema, pharyngeal_swelling, epiglottitis, "
    "laryngeal_oedema, laryngospasm, floppy_epiglottis, anterior_larynx, angio_oedema, "
    "laryngeal_web, tracheal_stenosis, tracheal_deviation, goitre, neck_obesity, "
    "prominent_incisors, trismus, stiff_neck, burn, secretions, blood, vomit, foreign_body, "
    "fragile_teeth or swallowing (so much of a swallow), or external_pressure (BURP), with its "
    "severity; may be given once for each",
    true};
inline constexpr Option kEventSeverity{"severity", "0..1",
                                       "of each event that is given without one; 1 unless given"};

inline constexpr Option kPreset{
    "preset", "NAME",
    "in place of events: those of a preset of the console. clear, cormack_lehane_1, "
    "cormack_lehane_2, cormack_lehane_3, cormack_lehane_4, swollen_mouth, anaphylaxis, "
    "swollen_lips, angio_oedema, acute_epiglottitis, burn, anterior_floppy, spasm, web, "
    "anterior_pressed, obese, pregnant, trauma_collar, goitre, after_tracheostomy or overjet"};

/// The events that kPreset, or kEvent and kEventSeverity ask for.
/// @returns WrongOption for a name there is not, one that is given twice, a severity that is none,
///          a severity without an event, and a preset beside events
[[nodiscard]] Result<AirwayEvents> eventsOption(const Words& words);

/// The same of kEvent, but where none is asked for all there are, with the severity of
/// kEventSeverity.
/// @returns likewise, but for a severity without an event
[[nodiscard]] Result<AirwayEvents> eachEventOption(const Words& words);

} // namespace carina::lab
