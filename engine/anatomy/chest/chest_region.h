#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/geometry/deformation/throat_formula.h"

namespace carina
{

/// Parts of the body that breathing and the lower jaw move in the same way.
enum class ChestRegion : std::uint8_t {
    Still,          ///< skull, teeth, spine, what is not recognised
    RightUpperLung, ///< upper and middle lobe, and a lung that is given whole
    RightLowerLung, ///< lower lobe, which slides along the oblique fissure
    LeftUpperLung,
    LeftLowerLung,
    Bronchi,     ///< within both lungs, and the main bronchi that lead there
    Diaphragm,   ///< goes with the base of the lungs
    Wall,        ///< ribs, sternum and skin, on which the lungs slide
    Mediastinum, ///< trachea, oesophagus, heart and vessels; what is high enough follows the jaw
    Throat,      ///< tongue, epiglottis, larynx and muscles: they follow the jaw
    Pharynx,     ///< follows the jaw, too, but for its wall behind and for the palate
};
inline constexpr std::size_t kChestRegions = 11;

[[nodiscard]] ChestRegion regionOf(PartRole role);

/// As what a region follows the jaw; nothing for one that does not.
[[nodiscard]] std::optional<ThroatTissue> tissueOf(ChestRegion region);

} // namespace carina
