#pragma once

#include "engine/anatomy/anatomy.h"

namespace carina
{

/// Parts of the body that breathing moves in the same way.
enum class ChestRegion : std::uint8_t {
    Still,          ///< head, neck, spine
    RightUpperLung, ///< upper and middle lobe, and a lung that is given whole
    RightLowerLung, ///< lower lobe, which slides along the oblique fissure
    LeftUpperLung,
    LeftLowerLung,
    Bronchi,     ///< within both lungs, and the main bronchi that lead there
    Diaphragm,   ///< goes with the base of the lungs
    Wall,        ///< ribs, sternum and skin, on which the lungs slide
    Mediastinum, ///< trachea, oesophagus, heart and vessels
};
inline constexpr std::size_t kChestRegions = 9;

[[nodiscard]] ChestRegion regionOf(PartRole role);

} // namespace carina
