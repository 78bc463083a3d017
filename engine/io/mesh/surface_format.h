#pragma once

#include "engine/io/files/file_limit.h"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace carina
{

/// Surface formats that can be read.
enum class SurfaceFormat : std::uint8_t { Obj, Ply, Stl, Gltf, Glb };

/// The format of a file by its extension, in upper or lower case; nothing for another extension.
[[nodiscard]] std::optional<SurfaceFormat> surfaceFormat(const std::filesystem::path& file);

/// The most that is read of a file of an anatomy set: a surface, the buffer of a glTF, a material,
/// a picture, or a description for any other name.
[[nodiscard]] const FileLimit& limitOfSetFile(const std::filesystem::path& file);

/// The file extension of a format, without the dot.
[[nodiscard]] const char* endingOf(SurfaceFormat format);

} // namespace carina
