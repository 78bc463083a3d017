#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace carina
{

/// Surface formats that can be read.
enum class SurfaceFormat : std::uint8_t { Obj, Ply, Stl, Gltf, Glb };

/// The format of a file by its extension, in upper or lower case; nothing for another extension.
[[nodiscard]] std::optional<SurfaceFormat> surfaceFormat(const std::filesystem::path& file);

/// The file extension of a format, without the dot.
[[nodiscard]] const char* endingOf(SurfaceFormat format);

} // namespace carina
