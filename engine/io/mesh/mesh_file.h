#pragma once

#include "engine/core/result.h"
#include "engine/geometry/mesh/triangle_mesh.h"
#include "engine/geometry/mesh/vertex_color.h"

#include <filesystem>
#include <string>
#include <vector>

namespace carina
{

/// One surface as its file has it: in the file's own unit and axes, vertices at one place joined,
/// no normals.
struct NamedSurface {
    std::string name;      ///< what the file calls it, else the file's stem
    std::string conceptId; ///< FMA id found in the file's comments or names; empty without one
    TriangleMesh mesh;
    std::vector<Rgb> colors{}; ///< one per vertex, see SurfaceColors; none where it has no texture
};

/// What one file holds.
struct MeshFile {
    std::vector<NamedSurface> surfaces;    ///< at least one, each with at least one triangle
    std::vector<std::string> attributions; ///< its lines about licence and copyright
    std::vector<Error> textureFaults{};    ///< why textures it names were not read
};

/// Reads the surfaces of an OBJ, PLY, STL, glTF or GLB file. Groups of an OBJ and nodes of a glTF
/// are surfaces of their own, placed by their nodes' transforms; polygons are cut into triangles.
/// A surface has the colours of its texture, its vertices or its materials, unless all of it has
/// one: that is no more than its role tells.
///
/// @returns FileNotFound; FileUnreadable; FileEmpty; UnknownFormat by the name's ending;
///          FileMalformed when it is truncated, does not follow its format or has no triangle;
///          NotFinite for NaN or infinity among the coordinates. The detail begins with the file.
///
/// A damaged file can bring down the library that parses it: called by carina-surface-reader alone,
/// everybody else asks a SurfaceReader.
[[nodiscard]] Result<MeshFile> readMeshFile(const std::filesystem::path& file);

} // namespace carina
