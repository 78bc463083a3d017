#pragma once

#include "engine/core/byte_buffer.h"
#include "engine/core/result.h"
#include "engine/geometry/mesh/triangle_mesh.h"
#include "engine/geometry/mesh/vertex_color.h"

#include <string>
#include <string_view>

namespace carina
{

/// Text and meshes as bytes, little endian: 32-bit counts, then the characters, or positions and
/// normals as 32-bit floats and corners as 32-bit indices.
///
/// Reading makes ok() of the reader false for a count larger than the bytes that follow, an index
/// beyond the vertices, and normals that are neither absent nor one per vertex. Memory is allocated
/// only after the count is checked against the bytes.
void writeText(ByteWriter& writer, std::string_view text);
[[nodiscard]] std::string readText(ByteReader& reader);
void writeMesh(ByteWriter& writer, const TriangleMesh& mesh);
[[nodiscard]] TriangleMesh readMesh(ByteReader& reader);
/// Colours; reading makes ok() false unless there are none or one for each vertex.
void writeColors(ByteWriter& writer, const std::vector<Rgb>& colors);
[[nodiscard]] std::vector<Rgb> readColors(ByteReader& reader, std::size_t vertices);

/// An error of readMeshFile, with a code of its own that does not change when Errc does.
/// @pre the code is one of readMeshFile's.
void writeFileError(ByteWriter& writer, const Error& error);
[[nodiscard]] Error readFileError(ByteReader& reader);

} // namespace carina
