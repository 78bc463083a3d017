#pragma once

#include "engine/io/site/devices/tracker_file.h"

namespace carina::lab
{

/// Wireless tools with these names and roles, of four markers each, no two of which can be taken
/// for one another. A tool's part number is its name.
/// @returns the errors of NdiToolDefinition::make.
[[nodiscard]] Result<std::vector<DescribedTool>>
simulatedTools(const std::vector<std::pair<std::string, ToolRole>>& named);

} // namespace carina::lab
