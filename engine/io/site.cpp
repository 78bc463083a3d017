#include "engine/io/site.h"

#include <algorithm>

namespace carina
{

const StylusTip* Site::stylus(const std::string& tool) const
{
    for (const std::string& name : {tool, std::string{}}) {
        const auto found = std::ranges::find(styluses, name, &StylusTip::tool);
        if (found != styluses.end())
            return &*found;
    }
    return nullptr;
}

} // namespace carina
