#pragma once

#include "engine/core/result.h"
#include "engine/geometry/mesh/triangle_mesh.h"
#include "engine/geometry/mesh/vertex_color.h"
#include "engine/sync/wire/byte_buffer.h"

#include <string>
#include <string_view>

namespace carina
{

/// Text and meshes as bytes, little endian: 32-bit counts, then the characters, or positions and
/// normals as 32-bit floats and corners as 32-bit indices.
///
/// Reading makes the reader not ok() for a count larger than the bytes that follow, for an index
/// beyond the vertices and for normals that are neither absent nor one per vertex. Nothing is
/// allocated by a count before the bytes are known to be there.
void writeText(ByteWriter& writer, std::string_view text);
[[nodiscard]] std::string readText(ByteReader& reader);
void writeMesh(ByteWriter& writer, const TriangleMesh& mesh);
[[nodiscard]] TriangleMesh readMesh(ByteReader& reader);
/// The reader is not ok() unless there are none or one for each vertex.
void writeColors(ByteWriter& writer, const std::vector<Rgb>& colors);
[[nodiscard]] std::vector<Rgb> readColors(ByteReader& reader, std::size_t vertices);

/// Why a file could not be read: what readMeshFile fails with, as a number of its own that does not
/// change when Errc does.
/// @pre the code is one of those.
void writeFileError(ByteWriter& writer, const Error& error);
[[nodiscard]] Error readFileError(ByteReader& reader);

} // namespace carina
