#pragma once

#include "engine/anatomy/events/airway_event.h"
#include "engine/anatomy/laryngoscopy/upper_airway.h"
#include "engine/geometry/deformation/airway_field.h"

#include <string_view>

namespace carina
{

/// Where in a quiet breath the cords are as apart as in the surfaces: 0 is the narrowest of an
/// expiration and 1 the widest of an inspiration, 5.7 and 10.1 mm in grown people (12 of them, by
/// bronchoscopy; Brancatisano et al., J Appl Physiol 1983;54:1269); the surfaces have 9 mm.
inline constexpr double kInspirationAsMade = 0.75;

/// What events, and breathing, change of the tissue of an upper airway as it is in the surfaces.
/// Lengths are in proportion to the patient; docs/laryngoscopy.md has them, and their sources. Of
/// TongueOedema, PharyngealSwelling, Epiglottitis and FloppyEpiglottis each does less where their
/// severities are more than 2 together: they share the room of the throat (asDrawn).
///
/// - TongueOedema: the tongue grows to all sides and most upward, and its base to the back;
/// - PharyngealSwelling: the side walls come together about the level of the uvula, and the back
///   wall comes forward;
/// - Epiglottitis: the epiglottis thickens to both sides;
/// - LaryngealOedema: the aryepiglottic folds come together, and the arytenoids bulge forward;
/// - Laryngospasm: the cords come together, whatever the breath;
/// - FloppyEpiglottis: the upper part of the epiglottis, with the tongue's base before it, falls to
///   the back and to the feet;
/// - AnteriorLarynx: cords and foot of the epiglottis lie farther to the front, vallecula, tip of
///   the epiglottis and trachea where they were;
/// - AngioOedema: lips and tongue, where the patient has them, swell, the latter in front, and the
///   entrance of the larynx as in LaryngealOedema;
/// - LaryngealWeb: the cords are joined from the commissure on, whatever the breath;
/// - ExternalPressure: the larynx goes to the back, up and to the patient's right; vallecula, tip
///   of the epiglottis and trachea stay;
/// - TrachealStenosis: the trachea's wall comes together from all sides kNarrowingOfWindpipe below
///   the cords;
/// - TrachealDeviation: the trachea, with what lies along it, goes to the patient's right between
///   larynx and lungs;
/// - Goitre: the skin before it bulges, and the trachea is narrowed from the sides and goes a
///   little to the patient's right;
/// - NeckObesity: the walls of the pharynx come nearer, the base of the tongue grows, and the skin
///   of the neck goes outward;
/// - ProminentIncisors: the upper front teeth stand out, with gums and lip;
/// - Trismus: nothing of this; it limits the jaw (mostMouthOpening);
/// - StiffNeck: nothing of this; it limits head and neck (withinMotion);
/// - Burn: tongue, pharynx, epiglottis and entrance of the larynx swell as of the first four, are
///   red, and black with soot in places;
/// - Secretions, Blood, Vomit and ForeignBody: nothing of this; they lie in the throat
///   (airway_contents.h);
/// - Swallowing, of so much of a swallow (swallow.h): the cords shut first, whatever the breath;
///   then larynx, hyoid bone and trachea go up and to the front, the epiglottis falls back, pharynx
///   and entrance of the larynx narrow, and the palate goes up and back;
/// - FragileTeeth: one upper incisor leans out of the row; and who presses them is warned earlier.
///
/// Three also change colours: AngioOedema makes pale what it swells, Epiglottitis reddens, and so
/// does Burn.
///
/// An event that canShow() denies changes nothing.
/// @pre areProper(events), and inspiration within 0 to 1
[[nodiscard]] AirwayField airwayChanges(const UpperAirway& airway, const AirwayEvents& events,
                                        double inspiration = kInspirationAsMade);

/// Whether the surfaces have what an event changes.
[[nodiscard]] bool canShow(const UpperAirway& airway, AirwayEventKind kind);

/// What surfaces need to have for an event beside what every one needs: "a tongue"; may be empty.
[[nodiscard]] std::string_view partNeeded(AirwayEventKind kind);

} // namespace carina
