#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace carina
{

/// The formats of surfaces that are read.
enum class SurfaceFormat : std::uint8_t { Obj, Ply, Stl, Gltf, Glb };

/// The format that a file has by the ending of its name, in any case; nothing for another.
[[nodiscard]] std::optional<SurfaceFormat> surfaceFormat(const std::filesystem::path& file);

/// The ending of a format's files, without the dot.
[[nodiscard]] const char* endingOf(SurfaceFormat format);

} // namespace carina
