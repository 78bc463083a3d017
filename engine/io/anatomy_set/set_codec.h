#pragma once

#include "engine/io/anatomy_set/imported_set.h"

#include <cstddef>
#include <span>
#include <vector>

namespace carina
{

/// An imported set as bytes, the content of a cache file. Little endian:
///
///     8 bytes  "CARINAPT"
///     u32      version of this layout and of the import, 7
///     u64      length of the payload
///     32 bytes BLAKE2b-256 of the payload
///     payload  name, content hash, unit, axes, landmarks, parts with their levels and deviations,
///              attributions, faults and what was left out, in the encoding of mesh_codec.h
[[nodiscard]] std::vector<std::byte> encodeSet(const ImportedSet& set);

/// Inverse of encodeSet.
/// @returns FileMalformed for anything that encodeSet did not write: another version, a byte
///          missing, changed or added, a count beyond the bytes that follow.
[[nodiscard]] Result<ImportedSet> decodeSet(std::span<const std::byte> bytes);

} // namespace carina
