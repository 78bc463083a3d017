#include "apps/lab/tracking/simulated_tools.h"

namespace carina::lab
{
namespace
{

/// Another arrangement for each tool.
std::vector<ToolMarker> markersOf(std::size_t tool)
{
    const double more = 0.008 * double(tool);
    return {{{0.0, 0.0, 0.0}},
            {{0.050 + more, 0.0, 0.0}},
            {{0.0, 0.070 + 2.0 * more, 0.0}},
            {{-0.040, -0.045 - more, 0.015}}};
}

} // namespace

Result<std::vector<DescribedTool>>
simulatedTools(const std::vector<std::pair<std::string, ToolRole>>& named)
{
    std::vector<DescribedTool> tools;
    for (const auto& [name, role] : named) {
        auto definition = NdiToolDefinition::make(NdiToolDefinition::Kind::Pointer,
                                                  markersOf(tools.size()), "Carina", name);
        if (!definition)
            return tl::unexpected(definition.error());
        tools.push_back({name, role, *std::move(definition)});
    }
    return tools;
}

} // namespace carina::lab
