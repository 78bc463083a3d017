#pragma once

#include "engine/core/result.h"
#include "engine/io/mesh/mesh_file.h"

#include <cstddef>
#include <span>
#include <vector>

namespace carina
{

/// The answer of carina-surface-reader for one file: its surfaces, or the error.
[[nodiscard]] std::vector<std::byte> encodeMeshFile(const Result<MeshFile>& file);

/// Inverse of encodeMeshFile.
/// @returns FileMalformed for bytes that encodeMeshFile did not write.
[[nodiscard]] Result<Result<MeshFile>> decodeMeshFile(std::span<const std::byte> bytes);

} // namespace carina
