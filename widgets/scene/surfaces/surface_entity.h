#pragma once

#include "widgets/scene/look/draw_order.h"
#include "widgets/scene/surfaces/merged_surface.h"
#include "widgets/scene/view/scene_frame.h"

#include <memory>

namespace Qt3DCore
{
class QAttribute;
class QBuffer;
class QEntity;
class QTransform;
} // namespace Qt3DCore
namespace Qt3DRender
{
class QEffect;
class QGeometryRenderer;
class QParameter;
} // namespace Qt3DRender

namespace carina
{

/// One merged surface in Qt 3D's scene: its buffers, the pose of its body and its deformation. The
/// vertex buffer holds all levels of detail and does not change; the index buffer holds the
/// triangles to draw, in drawing order, and is rewritten when these change.
class SurfaceEntity
{
public:
    /// @pre parent and effect outlive this.
    SurfaceEntity(MergedSurface surface, Qt3DRender::QEffect* effect, Qt3DCore::QEntity* parent);
    ~SurfaceEntity();
    SurfaceEntity(const SurfaceEntity&) = delete;
    SurfaceEntity& operator=(const SurfaceEntity&) = delete;

    /// Applies the pose, deformation and visibility of a frame.
    void apply(const SceneFrame& frame);
    /// Draws its parts in these levels; a blended surface is sorted for the viewing direction
    /// `forward_A`.
    /// @pre apply() was called for this frame, which sets the orientation of the body.
    void show(std::span<const int> levels, const Vec3& forward_A);
    /// Whether a section cuts it: then its inner face is drawn, too.
    void setCut(bool cut);

private:
    void drawTriangles(const std::vector<Triangle>& triangles);
    void setMotion(const BreathingChest& chest);

    SurfaceKey m_key;
    std::vector<SurfacePiece> m_pieces;
    std::vector<Triangle> m_triangles;
    std::vector<Vec3f> m_positions; ///< of a blended surface
    std::vector<int> m_levels;      ///< drawn now
    bool m_isCut = false;
    DrawOrder m_order; ///< of a blended surface, in those levels
    Vec3f m_forward_F = Vec3f::Zero();
    Quat m_R_AF = Quat::Identity();

    std::unique_ptr<Qt3DCore::QEntity> m_entity;
    Qt3DRender::QGeometryRenderer* m_renderer;
    Qt3DCore::QBuffer* m_corners;
    Qt3DCore::QAttribute* m_cornerList;
    Qt3DCore::QTransform* m_X_AF;
    Qt3DRender::QParameter* m_chest;
    /// Of its region, or of each region, by ChestRegion. One parameter for each matrix: Qt 6.4
    /// leaks a list each time it is set.
    std::vector<Qt3DRender::QParameter*> m_motions;
    Qt3DRender::QParameter* m_throat;
    Qt3DRender::QParameter* m_jaw;
    bool m_isPlaced = true;
};

} // namespace carina
