#pragma once

#include "engine/anatomy/chest/chest_region.h"
#include "engine/core/result.h"
#include "engine/geometry/deformation/airway_field.h"
#include "engine/geometry/deformation/blade_field.h"
#include "engine/geometry/deformation/chest_field.h"
#include "engine/geometry/deformation/throat_field.h"
#include "widgets/scene/look/organ_shader.h"

#include <memory>

namespace carina
{

/// Computes the vertices of one mesh with the vertex shader on the GPU, to measure what is drawn.
///
/// Runs resources/shaders/organ.vert, the shader that draws every organ, in any of its variants in
/// an own OpenGL 3.3 context, and captures its outputs by transform feedback. The model matrix is
/// the identity, so positions and normals are in the frame of the mesh. The mesh is uploaded once.
/// The OpenGL context that was current stays current.
class DrawnVertices
{
public:
    /// @param region by which the mesh follows the jaw, gives way to a blade and is changed
    /// @returns NoGraphics if there is no OpenGL 3.3 core context or the shader does not run.
    /// @pre there is a QGuiApplication, this is its thread, and the mesh has vertices.
    [[nodiscard]] static Result<DrawnVertices> of(const TriangleMesh& mesh,
                                                  ChestRegion region = ChestRegion::Still,
                                                  const OrganShader& shader = {});

    DrawnVertices(DrawnVertices&&) noexcept;
    DrawnVertices& operator=(DrawnVertices&&) noexcept;
    ~DrawnVertices();

    /// Each vertex in the order of the mesh.
    struct Vertices {
        std::vector<Vec3f> positions; ///< metres
        std::vector<Vec3f> normals;   ///< unit
    };

    /// The whole mesh bends with the throat's neck.
    /// @returns NoGraphics when the context is lost.
    [[nodiscard]] Result<Vertices> at(const ChestField& field, const ChestMotion& motion,
                                      const FollowingThroat& throat = {},
                                      const BladeField& blade = {}, const AirwayField& airway = {});

private:
    class Card;

    explicit DrawnVertices(std::unique_ptr<Card> card);

    std::unique_ptr<Card> m_card;
};

} // namespace carina
