#pragma once

#include "engine/geometry/deformation/airway_field.h"
#include "engine/geometry/deformation/blade_field.h"
#include "engine/geometry/deformation/moved_mesh.h"

namespace carina::test
{

/// A mesh of A with its exact normals where the events of an airway take it, by the formula of the
/// vertex shader and in single precision as there.
inline TriangleMesh deformed(const TriangleMesh& mesh_A, const AirwayField& airway,
                             AirwayTissue tissue)
{
    if (!airway.isThere())
        return mesh_A;
    return movedMesh(mesh_A, [tissue, frame = inSingle(airway.frame())](const Vector3<float>& p_A) {
        return airwayPull<float>(frame, tissue, p_A);
    });
}

/// The same where a blade pushes it.
inline TriangleMesh deformed(const TriangleMesh& mesh_A, const BladeField& blade,
                             AirwayTissue tissue)
{
    if (!blade.isThere())
        return mesh_A;
    return movedMesh(mesh_A, [tissue, frame = inSingle(blade.frame())](const Vector3<float>& p_A) {
        return bladePull<float>(frame, tissue, p_A);
    });
}

} // namespace carina::test
