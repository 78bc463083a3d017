#pragma once

#include "engine/io/anatomy_set/set_frame.h"

#include <string>
#include <vector>

namespace carina
{

/// Removes duplicates, and returns what was removed, one line each:
/// - a surface with the same triangles as an earlier one;
/// - a whole lung where a lobe of that side is present.
[[nodiscard]] std::vector<std::string> leaveOutRepeated(std::vector<RecognisedSurface>& surfaces);

} // namespace carina
