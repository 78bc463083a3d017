#pragma once

#include "widgets/scene/look/draw_order.h"
#include "widgets/scene/surfaces/merged_surface.h"
#include "widgets/scene/view/scene_frame.h"

#include <optional>
#include <string>
#include <vector>

namespace Qt3DCore
{
class QAttribute;
class QBuffer;
class QEntity;
class QTransform;
} // namespace Qt3DCore
namespace Qt3DRender
{
class QGeometryRenderer;
class QMaterial;
} // namespace Qt3DRender

namespace carina
{

/// The vertices of a merged surface, in one buffer that its shares have in common.
struct SurfaceColumns {
    Qt3DCore::QBuffer* vertices = nullptr; ///< of SurfaceVertex
    std::vector<Qt3DCore::QAttribute*> attributes;
    Vec3f low = Vec3f::Zero(); ///< bounds of the positions
    Vec3f high = Vec3f::Zero();
};

/// Uploads them. @pre owner outlives the shares
[[nodiscard]] SurfaceColumns surfaceColumns(const std::vector<SurfaceVertex>& vertices,
                                            Qt3DCore::QEntity* owner);

/// What of a merged surface is drawn at one pose: its parts in their place, or those lifted out
/// with one group. The index buffer holds the triangles to draw, in drawing order, and is rewritten
/// when these change; vertices and material are those of the surface.
class SurfaceShare
{
public:
    /// @param liftedWith the group; empty for what is in its place
    SurfaceShare(std::string liftedWith, const SurfaceColumns& columns,
                 Qt3DRender::QMaterial* material, Qt3DCore::QEntity* parent);

    [[nodiscard]] const std::string& liftedWith() const { return m_liftedWith; }
    /// Whether there is anything for it to draw: of a group only while that is lifted out.
    [[nodiscard]] bool isInUse() const { return m_isInUse; }
    void setInUse(bool inUse) { m_isInUse = inUse; }
    /// Draws it there; not at all without a place.
    void place(const std::optional<PlacedBody>& place);
    /// Draws these triangles, in their order.
    void draw(const std::vector<Triangle>& triangles);
    /// Draws these triangles from back to front, as blended ones are.
    void drawSorted(std::vector<Triangle> triangles, const std::vector<Vec3f>& positions,
                    const Vec3& forward_A);
    /// Sorts them anew if the view has turned. @pre drawSorted
    void sort(const Vec3& forward_A);
    /// Makes it visible where it is placed and has triangles.
    void show();

private:
    [[nodiscard]] Vec3f inBody(const Vec3& forward_A) const;

    std::string m_liftedWith;
    DrawOrder m_order;
    Vec3f m_forward_F = Vec3f::Zero(); ///< it is sorted for
    Quat m_R_AF = Quat::Identity();
    bool m_isInUse = false;
    bool m_isPlaced = true;

    Qt3DCore::QEntity* m_entity;
    Qt3DRender::QGeometryRenderer* m_renderer;
    Qt3DCore::QBuffer* m_corners;
    Qt3DCore::QAttribute* m_cornerList;
    Qt3DCore::QTransform* m_X_AF;
};

} // namespace carina
