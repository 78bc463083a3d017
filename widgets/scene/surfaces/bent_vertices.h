#pragma once

#include "engine/anatomy/shapes/line_bend.h"
#include "widgets/scene/surfaces/merged_surface.h"

#include <vector>

namespace Qt3DCore
{
class QBuffer;
} // namespace Qt3DCore

namespace carina
{

/// The vertices of a surface that is bent along a line, as those of a tube: a few thousand, which
/// are computed here and uploaded anew when the line has changed.
class BentVertices
{
public:
    /// @param buffer of SurfaceVertex, as at rest. @pre it outlives this
    explicit BentVertices(Qt3DCore::QBuffer* buffer) : m_buffer{buffer} {}

    /// @param bend of the surface; nullptr: as at rest
    void follow(const LineBend* bend);

private:
    /// Of a vertex, in the line's axes there.
    struct Fixed {
        double along = 0.0;
        Vec3 offset = Vec3::Zero();
        Vec3 normal = Vec3::Zero();
    };
    void fixTo(const LineBend& bend);
    void upload(const std::vector<SurfaceVertex>& vertices);

    Qt3DCore::QBuffer* m_buffer;
    std::vector<SurfaceVertex> m_rest; ///< none before it was first bent
    std::vector<Vec3> m_restLine;      ///< to which they are fixed
    std::vector<Fixed> m_fixed;
    std::vector<Vec3> m_line; ///< along which they lie; empty: at rest
};

} // namespace carina
