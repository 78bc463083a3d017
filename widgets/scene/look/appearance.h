#pragma once

#include "widgets/scene/surfaces/scene_part.h"

#include "engine/anatomy/anatomy.h"

namespace carina
{

/// How a part of a patient is drawn.
struct Appearance {
    MaterialGroup group = MaterialGroup::SoftTissue;
    QColor color;
};

/// The usual colours of anatomical atlases, muted: bones ivory, cartilage pale blue, lungs pink and
/// each lobe different, arteries red, veins blue. Vessels are told apart by name. What lies side by
/// side differs for people with any of the three dichromacies, too, by 14 in CIELAB.
[[nodiscard]] Appearance appearanceOf(const AnatomyPart& part);

} // namespace carina
