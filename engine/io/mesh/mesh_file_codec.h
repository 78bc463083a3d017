#pragma once

#include "engine/core/result.h"
#include "engine/io/mesh/mesh_file.h"

#include <cstddef>
#include <span>
#include <vector>

namespace carina
{

/// What carina-surface-reader answers for one file: its surfaces, or why there are none.
[[nodiscard]] std::vector<std::byte> encodeMeshFile(const Result<MeshFile>& file);

/// The inverse.
/// @returns FileMalformed for bytes that encodeMeshFile did not write.
[[nodiscard]] Result<Result<MeshFile>> decodeMeshFile(std::span<const std::byte> bytes);

} // namespace carina
