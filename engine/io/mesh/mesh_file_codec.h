#pragma once

#include "engine/core/result.h"
#include "engine/io/mesh/mesh_file.h"

#include <cstddef>
#include <span>
#include <vector>

namespace carina
{

/// Surfaces, lines about licences and faults of textures that a file may have each: an empty one
/// takes up to eight times as much memory as its place in the bytes, here 200 MB at most.
inline constexpr std::size_t kMostParts = std::size_t{1} << 20U;

/// The answer of carina-surface-reader for one file: its surfaces, or the error, which is
/// FileTooLarge for more than kMostParts.
[[nodiscard]] std::vector<std::byte> encodeMeshFile(const Result<MeshFile>& file);

/// Inverse of encodeMeshFile.
/// @returns FileMalformed for bytes that encodeMeshFile did not write. Where memory runs out it
///          throws std::bad_alloc, as in the process that reads the file.
[[nodiscard]] Result<Result<MeshFile>> decodeMeshFile(std::span<const std::byte> bytes);

} // namespace carina
