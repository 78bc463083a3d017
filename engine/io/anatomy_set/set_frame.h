#pragma once

#include "engine/io/anatomy_set/imported_set.h"

#include <span>

namespace carina
{

/// One surface of a set in the frame F of its files, with its recognised role.
struct RecognisedSurface {
    std::string file; ///< relative to the set's folder
    std::string name;
    std::string conceptId;
    PartRole role = PartRole::Other;
    TriangleMesh mesh;
    std::vector<Rgb> colors{}; ///< one per vertex, or none
};

/// Finds unit and axes of a set from the roles of its surfaces.
///
/// Unit: that of metres, centimetres and millimetres in which the trachea is 3 to 25 cm long;
/// without a trachea a lung or lobe 4 to 40 cm, a mandible 4 to 20 cm, or the whole set 0.2 to 2 m.
/// Axes: superior points from the thorax to the head, left from the parts of the right side to
/// those of the left, posterior from airway, heart and jaw to spine and oesophagus; each is the
/// nearest axis of the files.
///
/// What the parts do not determine follows from the file format. A set of glTF files only is in
/// metres, up to 10 m, and +x left, +y superior, +z anterior, as glTF 2.0 specifies (section 3.4:
/// +y up, the front faces +z). Other files are as in LPS (+x left, +y posterior, +z superior),
/// right-handed.
///
/// @returns OutOfRange where no unit gives the size of a person.
[[nodiscard]] Result<SetFrame> findSetFrame(std::span<const RecognisedSurface> surfaces);

} // namespace carina
