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

/// The material of a surface, which determines how it is drawn. The first three and fluids are
/// opaque; the others are blended from back to front. Surfaces are closed with outward normals, or
/// else open and "seen into": their inner face is drawn as well. Tools and fluids are drawn from
/// both sides.
enum class MaterialGroup : std::uint8_t {
    Bone,
    SoftTissue, ///< tongue, epiglottis, bronchial tree
    Tool,       ///< tubes, blades, styluses
    Airway,     ///< larynx, trachea and bronchi: seen into
    Lung,       ///< seen into
    Veil,       ///< structures around airway and lungs, such as ribs, heart, muscles: translucent
    Skin,       ///< a faint outline
    Ghost,      ///< an outline of a part that a person wants to see through
    Fluid,      ///< what stands in the throat: smooth, and mirrors what is around it
};

/// The number of layers in which visible pixels are counted: layer 0 has all opaque groups, each
/// other layer one group.
inline constexpr int kLayers = 6;
[[nodiscard]] constexpr int layerOf(MaterialGroup group)
{
    if (group == MaterialGroup::Fluid)
        return 0;
    return std::max(0, static_cast<int>(group) - static_cast<int>(MaterialGroup::Tool));
}

/// Whether a section leaves it whole.
[[nodiscard]] constexpr bool isNeverCut(MaterialGroup group)
{
    return group == MaterialGroup::Tool || group == MaterialGroup::Fluid;
}

/// How a surface is rasterised.
enum class DrawLayer : std::uint8_t {
    Closed,  ///< opaque, seen from outside: back faces are culled
    Open,    ///< opaque, seen from both sides, such as tubes
    Blended, ///< translucent: its triangles are drawn from back to front, after all others
};
inline constexpr std::size_t kDrawLayers = 3;
[[nodiscard]] constexpr DrawLayer drawLayerOf(MaterialGroup group)
{
    if (layerOf(group) > 0)
        return DrawLayer::Blended;
    return isNeverCut(group) ? DrawLayer::Open : DrawLayer::Closed;
}

/// The region of the body under which a list shows a part.
enum class BodyRegion : std::uint8_t { Airway, Lungs, Skeleton, Vessels, Muscles, Tools, Other };

/// One surface of a scene.
struct ScenePart {
    std::string name;     ///< as shown: "Trachea"
    std::uint16_t id = 0; ///< key of visiblePixels(); unique in the scene
    MaterialGroup group = MaterialGroup::SoftTissue;
    QColor color;
    BodyRegion listedUnder = BodyRegion::Other;
    ChestRegion region = ChestRegion::Still; ///< how it breathes; for surfaces given in A

    /// Empty for a part fixed in A, with meshes in A; else the name of the moving body that it is
    /// fixed to, such as "tube" or "jaw", with meshes in that body's frame.
    std::string body;
    /// The name of the group with which it is lifted out (SceneFrame::lifted); empty: it never is.
    std::string liftedWith{};
    /// Whether view presets show it whole. Not for a body that is sometimes absent.
    bool framed = true;

    /// At least one level of detail, finest first, each with normals. Shared with the code that
    /// computes volumes from the same meshes.
    std::vector<std::shared_ptr<const TriangleMesh>> levels;
    /// Deviation of each level from the finest, metres, 0 first. A level without one is drawn only
    /// if it is set explicitly.
    std::vector<double> deviations{};
    /// Used in place of `color`: one colour per vertex of each level, or none.
    std::vector<std::vector<Rgb>> colors{};
    /// Whether it is drawn in the level common to all parts with this flag, which is passed to the
    /// frame source. For parts whose volume matters.
    bool sharesLevel = false;
};

} // namespace carina
