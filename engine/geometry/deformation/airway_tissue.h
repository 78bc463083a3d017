#pragma once

#include <cstdint>

namespace carina
{

/// Kinds of soft tissue of the airway, by how a laryngoscope's blade and events move them; bits of
/// AirwayTissues.
enum class AirwayTissue : std::uint8_t {
    Throat,  ///< tongue, muscles, lining of the mouth: a blade's face pushes it away
    Pharynx, ///< its walls, and the palate: goes with the larynx and with the tongue's base above
    Larynx,  ///< with epiglottis and cords: leans over as a blade pulls or lifts the epiglottis
};

using AirwayTissues = std::uint8_t;
[[nodiscard]] constexpr AirwayTissues only(AirwayTissue tissue)
{
    return static_cast<AirwayTissues>(1U << static_cast<unsigned>(tissue));
}
inline constexpr AirwayTissues kAllAirwayTissues = 7;

} // namespace carina
