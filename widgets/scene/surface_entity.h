#pragma once

#include "widgets/scene/merged_surface.h"
#include "widgets/scene/scene_frame.h"

#include <memory>

namespace Qt3DCore
{
class QEntity;
class QTransform;
} // namespace Qt3DCore
namespace Qt3DRender
{
class QEffect;
class QParameter;
} // namespace Qt3DRender

namespace carina
{

/// One merged surface in Qt 3D's scene: its buffers, the place of its body and how it breathes.
class SurfaceEntity
{
public:
    /// Copies the surface into Qt 3D's buffers.
    /// @pre parent and effect outlive this.
    SurfaceEntity(const MergedSurface& surface, Qt3DRender::QEffect* effect,
                  Qt3DCore::QEntity* parent);
    ~SurfaceEntity();
    SurfaceEntity(const SurfaceEntity&) = delete;
    SurfaceEntity& operator=(const SurfaceEntity&) = delete;

    /// Places, breathes, shows or hides it as the frame says.
    void apply(const SceneFrame& frame, int level);

private:
    SurfaceKey m_key;
    std::unique_ptr<Qt3DCore::QEntity> m_entity;
    Qt3DCore::QTransform* m_X_AF;
    Qt3DRender::QParameter* m_chest;
    Qt3DRender::QParameter* m_motion;
};

} // namespace carina
