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
/// each lobe different, arteries red, veins blue. Arteries and veins are distinguished by name. The
/// colours of adjacent parts differ by at least 14 in CIELAB, also for people with any of the three
/// dichromacies.
[[nodiscard]] Appearance appearanceOf(const AnatomyPart& part);

/// The region under which a part of this role is listed: that of its OrganGroup.
[[nodiscard]] BodyRegion bodyRegionOf(PartRole role);

} // namespace carina
