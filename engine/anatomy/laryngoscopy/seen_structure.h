#pragma once

#include "engine/anatomy/anatomy.h"

#include <array>
#include <cstdint>

namespace carina
{

/// What a person tells apart in the picture of a laryngoscope.
enum class SeenStructure : std::uint8_t {
    Nothing, ///< darkness, or what has no name there
    Teeth,
    Jaw,
    Tongue,
    HardPalate,
    SoftPalate, ///< with the uvula
    Pharynx,
    Epiglottis,
    AryepiglotticFold,
    VestibularFold,
    Arytenoid, ///< with the tubercles on it
    VocalFold,
    LaryngealCartilage, ///< thyroid and cricoid cartilage, and the hyoid bone
    Trachea,
    Oesophagus,
    Blade,
    Tube,        ///< nothing is told of what it covers
    Fluid,       ///< secretions, blood or vomit
    ForeignBody, ///< a solid that does not belong there
};
inline constexpr std::size_t kSeenStructures = 19;

/// The name of a structure in JSON ("vocal_folds").
[[nodiscard]] const char* structureName(SeenStructure structure);

/// What a part of a patient is in such a picture, by its role and name.
[[nodiscard]] SeenStructure structureOf(const AnatomyPart& part);

/// Whether it lies above the glottis, so that what is behind it of the glottis is hidden.
[[nodiscard]] bool hidesGlottis(SeenStructure structure);

} // namespace carina
