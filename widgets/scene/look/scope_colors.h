#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/anatomy/laryngoscopy/seen_structure.h"
#include "widgets/scene/surfaces/scene_part.h"

#include <span>

namespace carina
{

/// Whether colorTissue colours it: tissue and teeth.
[[nodiscard]] bool isColored(SeenStructure structure);

/// Colours what a laryngoscope shows, vertex by vertex: mucosa in the colour of its structure,
/// darker and redder in hollows, and the trachea with pale rings of cartilage, which are open
/// behind.
///
/// Hollows are those between parts of one region and body: these move together, so that what hides
/// a place in the surfaces does so whatever jaw and blade do.
///
/// @param structures by the id of a part
void colorTissue(std::span<ScenePart> parts, std::span<const SeenStructure> structures,
                 const AirwayLandmarks& landmarks);

} // namespace carina
