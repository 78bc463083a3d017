#pragma once

#include "engine/core/result.h"
#include "engine/geometry/mesh/triangle_mesh.h"
#include "engine/geometry/mesh/vertex_color.h"

#include <filesystem>
#include <string>
#include <vector>

namespace carina
{

/// One surface as it is in its file: in the file's unit and axes, coincident vertices joined,
/// without normals.
struct NamedSurface {
    std::string name;      ///< from the file, else the file's stem
    std::string conceptId; ///< FMA id from the file's comments or names; empty without one
    TriangleMesh mesh;
    std::vector<Rgb> colors{}; ///< one per vertex; none where it has no texture
};

/// The contents of one file.
struct MeshFile {
    std::vector<NamedSurface> surfaces;    ///< at least one, each with at least one triangle
    std::vector<std::string> attributions; ///< lines about licence and copyright
    std::vector<Error> textureFaults{};    ///< why textures of the file were not read
};

/// Reads the surfaces of an OBJ, PLY, STL, glTF or GLB file. Groups of an OBJ and nodes of a glTF
/// are separate surfaces, placed by the transforms of their nodes; polygons are triangulated. A
/// surface has the colours of its texture, vertices or materials. Where all of it has one colour it
/// has none: that adds nothing to its role.
///
/// @returns FileNotFound; FileUnreadable, also for a link out of its folder; FileEmpty;
///          FileTooLarge; UnknownFormat, by the extension of its name;
///          FileMalformed where it is truncated, does not follow its format or has no triangle;
///          NotFinite for NaN or infinity among the coordinates. The detail begins with the file.
///
/// A damaged file can crash the library that parses it. Therefore only carina-surface-reader calls
/// this; other programs use a SurfaceReader.
[[nodiscard]] Result<MeshFile> readMeshFile(const std::filesystem::path& file);

} // namespace carina
