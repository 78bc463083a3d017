#pragma once

#include "engine/anatomy/chest_region.h"
#include "engine/geometry/triangle_mesh.h"

#include <QColor>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace carina
{

/// What a surface is made of, as far as it is drawn differently. Surfaces are drawn in this order.
/// The first three are opaque; each later group is blended over what was drawn before. Surfaces are
/// closed and face outward, or are seen into where they are not; tools are drawn from both sides.
enum class MaterialGroup : std::uint8_t {
    Bone,
    SoftTissue, ///< tongue, epiglottis, bronchial tree
    Tool,       ///< tubes, blades, styluses
    Airway,     ///< larynx, trachea and bronchi: seen into
    Lung,       ///< seen into
    Veil,       ///< what lies around the airway and lungs, as ribs, heart, muscles: seen through
    Skin,       ///< a faint outline
};
inline constexpr int kMaterialGroups = 7;

/// The layers in which a scene is drawn: 0 holds all opaque groups, the others one group each.
inline constexpr int kLayers = 5;
[[nodiscard]] constexpr int layerOf(MaterialGroup group)
{
    return std::max(0, static_cast<int>(group) - static_cast<int>(MaterialGroup::Tool));
}

/// One surface of a scene.
struct ScenePart {
    std::string name;     ///< as shown: "Trachea"
    std::uint16_t id = 0; ///< what visiblePixels() counts it under; unique in the scene
    MaterialGroup group = MaterialGroup::SoftTissue;
    QColor color;
    ChestRegion region = ChestRegion::Still; ///< how it breathes; for surfaces given in A

    /// Empty for a part that is fixed in A, with meshes given in A; else the moving body that it is
    /// fixed to, such as "tube" or "jaw", with meshes given in that body's frame.
    std::string body;
    /// Whether a view preset makes sure to show it whole. Not for a body that comes and goes.
    bool framed = true;

    /// At least one level of detail, finest first, each with normals. Shared with whoever works out
    /// volumes from the very same meshes.
    std::vector<std::shared_ptr<const TriangleMesh>> levels;
};

} // namespace carina
