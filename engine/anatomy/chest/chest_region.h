#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/geometry/deformation/airway_tissue.h"
#include "engine/geometry/deformation/throat_formula.h"

namespace carina
{

/// Regions of the body; all parts of a region move in the same way with breathing and the jaw.
enum class ChestRegion : std::uint8_t {
    Still,          ///< skull, spine, and unrecognised parts: do not move
    RightUpperLung, ///< upper and middle lobe; also a lung without lobes
    RightLowerLung, ///< lower lobe, which slides along the oblique fissure
    LeftUpperLung,
    LeftLowerLung,
    Bronchi,     ///< main bronchi and the bronchial tree
    Diaphragm,   ///< moves with the base of the lungs
    Wall,        ///< ribs and sternum, on which the lungs slide
    LooseTooth,  ///< the right upper central incisor, which an event loosens; else as Teeth
    Teeth,       ///< do not breathe; events move those of the upper jaw
    Skin,        ///< breathes with the wall; events move it where it covers neck and lips
    Mediastinum, ///< trachea, oesophagus, heart, vessels; upper parts follow the jaw and events
    Throat,      ///< tongue, hyoid and muscles: follow the jaw, give way to a blade
    Pharynx,     ///< follows jaw and blade, except its posterior wall and the palate's front
    Larynx,      ///< and epiglottis: as Throat, but tilted by a blade
};
inline constexpr std::size_t kChestRegions = 15;

/// The region of a role.
[[nodiscard]] ChestRegion regionOf(PartRole role);

/// The region of a part: that of its role. But mucosa that hangs from the skull is neither taken
/// along by the jaw nor pushed by a blade's face: arches of the palate and tonsils move as the
/// palate does, gum and lip of the upper jaw as the skin before them; and one incisor is of its
/// own. Names tell, as sets have them.
[[nodiscard]] ChestRegion regionOf(const AnatomyPart& part);

/// Whether a part is fixed to the mandible and goes with it alone, as a rigid body: this itself,
/// and the lower teeth, gums and lip, by the names that anatomy sets give them.
[[nodiscard]] bool movesWithMandible(const AnatomyPart& part);

/// The kind of tissue as which a region follows the jaw; nothing for a region that does not.
[[nodiscard]] std::optional<ThroatTissue> tissueOf(ChestRegion region);

/// The kind of tissue as which events, or a blade too, move a region; nothing for a region that
/// they do not.
[[nodiscard]] std::optional<AirwayTissue> airwayTissueOf(ChestRegion region);

} // namespace carina
