#pragma once

#include "widgets/scene/surfaces/bent_vertices.h"
#include "widgets/scene/surfaces/merged_surface.h"
#include "widgets/scene/surfaces/surface_share.h"
#include "widgets/scene/view/scene_frame.h"

#include <memory>
#include <string>
#include <vector>

namespace Qt3DRender
{
class QEffect;
class QMaterial;
class QParameter;
} // namespace Qt3DRender

namespace carina
{

/// One merged surface in Qt 3D's scene: its buffers, the pose of its body and its deformation. The
/// vertex buffer holds all levels of detail and does not change, but of what is bent along a line.
/// It is drawn in shares: what is in its place, and each group of parts that is lifted out.
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
    void setMotion(const BreathingChest& chest);
    void setAirway(const AirwayField& airway);
    void setNeck(const SceneFrame& frame);
    void setLine(const SceneFrame& frame);
    void liftShares(const SceneFrame& frame);
    [[nodiscard]] std::vector<SurfacePiece> piecesOf(const SurfaceShare& share) const;

    SurfaceKey m_key;
    std::vector<SurfacePiece> m_pieces;
    std::vector<Triangle> m_triangles;
    std::vector<Vec3f> m_positions; ///< of a blended surface
    std::vector<int> m_levels;      ///< drawn now
    bool m_isCut = false;

    std::unique_ptr<Qt3DCore::QEntity> m_entity; ///< parent of the shares'
    Qt3DRender::QMaterial* m_material;
    SurfaceColumns m_columns;
    BentVertices m_bent;
    Qt3DRender::QParameter* m_chest;
    /// Of its region, or of each region, by ChestRegion. One parameter for each matrix: Qt 6.4
    /// leaks a list each time it is set.
    std::vector<Qt3DRender::QParameter*> m_motions;
    std::vector<Qt3DRender::QParameter*> m_airway; ///< in the order of airwayUniforms
    bool m_isAirwayChanged = false;                ///< by the latest frame
    std::vector<Qt3DRender::QParameter*> m_neck;   ///< in the order of neckUniforms
    bool m_isNeckBent = false;                     ///< by the latest frame
    Qt3DRender::QParameter* m_throat;
    Qt3DRender::QParameter* m_jaw;
    Qt3DRender::QParameter* m_blade;
    Qt3DRender::QParameter* m_tilt;
    /// What is in its place, first, and the groups that were ever lifted out.
    std::vector<std::unique_ptr<SurfaceShare>> m_shares;
};

} // namespace carina
