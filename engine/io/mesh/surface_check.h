#pragma once

#include "engine/core/result.h"

#include <filesystem>
#include <string_view>

namespace carina
{

/// Checks that find what a parser may ignore: a truncated file, an index beyond the vertices, a
/// coordinate that is not a number. `bytes` is the whole file; the detail of an error says what is
/// wrong, without the file's name.
///
/// OBJ: every vertex has three finite coordinates, every face three or more existing vertices. A
/// file truncated in its list of faces has vertices that belong to no face: up to 1 % is tolerated,
/// none where the last line has no line end.
[[nodiscard]] Result<void> checkObj(std::string_view bytes);

/// PLY, ASCII or binary: all elements that the header declares are there, faces refer to existing
/// vertices.
[[nodiscard]] Result<void> checkPly(std::string_view bytes);

/// STL: the declared number of triangles is there (binary); every facet and the solid are closed
/// (ASCII).
[[nodiscard]] Result<void> checkStl(std::string_view bytes);

/// glTF: JSON whose accessors are inside their views, whose views are inside their buffers and
/// whose buffers are in the file, or beside it in `folder`; other locations are refused.
[[nodiscard]] Result<void> checkGltf(std::string_view bytes, const std::filesystem::path& folder);

/// GLB: glTF in one binary file that consists of its chunks exactly.
[[nodiscard]] Result<void> checkGlb(std::string_view bytes);

} // namespace carina
