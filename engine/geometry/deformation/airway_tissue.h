#pragma once

#include <cstdint>

namespace carina
{

/// Kinds of tissue of the airway, by how a laryngoscope's blade and events move them; bits of
/// AirwayTissues. A blade moves the last three alone.
enum class AirwayTissue : std::uint8_t {
    LooseTooth, ///< of the upper jaw, the one that an event loosens
    Teeth,      ///< all others of the upper jaw
    Skin,       ///< without what lies beneath it
    Windpipe,   ///< trachea, and what lies along it
    Throat,     ///< tongue, muscles, lining of the mouth: a blade's face pushes it away
    Pharynx, ///< its walls, and the palate: goes with the larynx and with the tongue's base above
    Larynx,  ///< with epiglottis and cords: leans over as a blade pulls or lifts the epiglottis
};

using AirwayTissues = std::uint8_t;
[[nodiscard]] constexpr AirwayTissues only(AirwayTissue tissue)
{
    return static_cast<AirwayTissues>(1U << static_cast<unsigned>(tissue));
}
inline constexpr auto kUpperTeethTissues =
    AirwayTissues(only(AirwayTissue::LooseTooth) | only(AirwayTissue::Teeth));
/// What a blade moves, too.
inline constexpr auto kThroatTissues = AirwayTissues(
    only(AirwayTissue::Throat) | only(AirwayTissue::Pharynx) | only(AirwayTissue::Larynx));
inline constexpr auto kAllAirwayTissues = AirwayTissues(
    kThroatTissues | kUpperTeethTissues | only(AirwayTissue::Skin) | only(AirwayTissue::Windpipe));

} // namespace carina
