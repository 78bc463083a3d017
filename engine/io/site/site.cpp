#include "engine/io/site/site.h"

#include <algorithm>

namespace carina
{

const StylusTip* tipOfTool(const std::vector<StylusTip>& styluses, const std::string& tool)
{
    for (const std::string& name : {tool, std::string{}}) {
        const auto found = std::ranges::find(styluses, name, &StylusTip::tool);
        if (found != styluses.end())
            return &*found;
    }
    return nullptr;
}

const SiteTool* toolOfRole(const std::vector<SiteTool>& tools, ToolRole role)
{
    const auto found = std::ranges::find(tools, role, &SiteTool::role);
    return found == tools.end() ? nullptr : &*found;
}

} // namespace carina
