#pragma once

#include "engine/core/result.h"

#include <filesystem>
#include <string_view>

namespace carina
{

/// Find what a reader would pass over in silence: a file that ends too early, an index beyond the
/// vertices, a coordinate that is no number. `bytes` is the whole file; an error's detail says what
/// is wrong, without the file's name.
///
/// OBJ: every vertex has three finite coordinates, every face three or more known vertices. A file
/// cut in its list of faces shows in vertices that belong to no face: up to one in a hundred is
/// tolerated, none where the last line has no end.
[[nodiscard]] Result<void> checkObj(std::string_view bytes);

/// PLY, ASCII or binary: the header's counts are there to the last byte, faces name known vertices.
[[nodiscard]] Result<void> checkPly(std::string_view bytes);

/// STL: the declared number of triangles is there (binary), every facet and the solid end (ASCII).
[[nodiscard]] Result<void> checkStl(std::string_view bytes);

/// glTF: JSON whose accessors lie inside their views, whose views lie inside their buffers and
/// whose buffers are there: in the file, or beside it in `folder` and nowhere else.
[[nodiscard]] Result<void> checkGltf(std::string_view bytes, const std::filesystem::path& folder);

/// GLB: glTF in one binary file, whose chunks fill it exactly.
[[nodiscard]] Result<void> checkGlb(std::string_view bytes);

} // namespace carina
