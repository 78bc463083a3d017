#pragma once

#include "engine/io/anatomy_set/imported_set.h"

#include <span>

namespace carina
{

/// One surface of a set in the frame F of its files, with what is known of it.
struct RecognisedSurface {
    std::string file; ///< relative to the set's folder
    std::string name;
    std::string conceptId;
    PartRole role = PartRole::Other;
    TriangleMesh mesh;
    std::vector<Rgb> colors{}; ///< one per vertex, or none
};

/// Finds the unit and the axes of a set from what its surfaces are.
///
/// Unit: that of metres, centimetres and millimetres in which the trachea is 3 to 25 cm long;
/// without one a lung or lobe 4 to 40 cm, a mandible 4 to 20 cm, the whole 0.2 to 2 m. Axes: up
/// leads from the thorax to the head, left from the parts named right to those named left, back
/// from airway, heart and jaw to spine and oesophagus; each along the axis it is nearest to. What
/// the parts leave open is as in LPS files (+x left, +y posterior, +z superior), right-handed.
///
/// @returns OutOfRange when no unit makes it a person.
[[nodiscard]] Result<SetFrame> findSetFrame(std::span<const RecognisedSurface> surfaces);

} // namespace carina
