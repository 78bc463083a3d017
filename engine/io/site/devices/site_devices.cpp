#include "engine/io/site/devices/site_devices.h"

#include "engine/io/files/folder_path.h"
#include "engine/io/site/devices/any_description.h"
#include "engine/tracking/tool_role.h"

namespace carina
{
namespace
{

/// A tool of the devices before it that it could be taken for.
Result<void> checkTool(const DescribedTool& tool, const std::string& file,
                       const std::vector<PlacedDescription>& before)
{
    for (const PlacedDescription& device : before)
        for (const DescribedTool& other : device.described.tools) {
            if (tool.role != ToolRole::Other && tool.role == other.role)
                return fail(Errc::FileMalformed, file + ": another device has a tool with the role "
                                                     + toolRoleWord(tool.role) + ", too");
            if (tool.name == other.name)
                return fail(Errc::FileMalformed,
                            file + ": another device has a tool \"" + tool.name + "\", too");
        }
    return {};
}

} // namespace

Result<std::vector<PlacedDescription>> readSiteDevices(const std::filesystem::path& folder,
                                                       const std::vector<SiteDevice>& devices)
{
    std::vector<PlacedDescription> placed;
    for (const SiteDevice& device : devices) {
        auto described = pathWithin(folder, device.file).and_then(&readAnyDescription);
        if (!described)
            return tl::unexpected(described.error());
        for (const DescribedTool& tool : described->tools)
            if (const auto checked = checkTool(tool, device.file, placed); !checked)
                return tl::unexpected(checked.error());
        placed.push_back(
            {*std::move(described), device.frame ? device.frame->place : DevicePlace{}});
    }
    return placed;
}

} // namespace carina
