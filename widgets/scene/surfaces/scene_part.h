#pragma once

#include "engine/anatomy/chest/chest_region.h"
#include "engine/geometry/mesh/triangle_mesh.h"
#include "engine/geometry/mesh/vertex_color.h"

#include <QColor>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace carina
{

/// What a surface is made of, as far as it is drawn differently. The first three are opaque; the
/// others are blended, from back to front. Surfaces are closed and face outward, or are seen into
/// where they are not; tools are drawn from both sides.
enum class MaterialGroup : std::uint8_t {
    Bone,
    SoftTissue, ///< tongue, epiglottis, bronchial tree
    Tool,       ///< tubes, blades, styluses
    Airway,     ///< larynx, trachea and bronchi: seen into
    Lung,       ///< seen into
    Veil,       ///< what lies around the airway and lungs, as ribs, heart, muscles: seen through
    Skin,       ///< a faint outline
    Ghost,      ///< an outline of what a person wants to see through
};

/// The layers in which visible pixels are counted: 0 holds all opaque groups, the others one each.
inline constexpr int kLayers = 6;
[[nodiscard]] constexpr int layerOf(MaterialGroup group)
{
    return std::max(0, static_cast<int>(group) - static_cast<int>(MaterialGroup::Tool));
}

/// How a surface meets the picture.
enum class DrawLayer : std::uint8_t {
    Closed,  ///< opaque, seen from outside: half of its triangles need no drawing
    Open,    ///< opaque, seen from both sides, as tubes are
    Blended, ///< translucent: its triangles are drawn from back to front, after all others
};
inline constexpr std::size_t kDrawLayers = 3;
[[nodiscard]] constexpr DrawLayer drawLayerOf(MaterialGroup group)
{
    if (layerOf(group) > 0)
        return DrawLayer::Blended;
    return group == MaterialGroup::Tool ? DrawLayer::Open : DrawLayer::Closed;
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
    /// How far each level departs from the finest, metres, 0 first. A level that has none here is
    /// drawn only where it is asked for.
    std::vector<double> deviations{};
    /// In place of `color`: one per vertex of each level, or none.
    std::vector<std::vector<Rgb>> colors{};
    /// Drawn in the same level as all others that share it, and as the frame source is asked for:
    /// those whose volume matters.
    bool sharesLevel = false;
};

} // namespace carina
