#include "engine/io/site/devices/device_changes.h"

#include "engine/core/expects.h"
#include "engine/io/files/folder_path.h"
#include "engine/io/site/devices/any_description.h"
#include "engine/io/site/devices/site_devices.h"
#include "engine/io/site/stale_marks.h"

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

/// The tools that a device sees.
class SeenTools
{
public:
    SeenTools(const std::filesystem::path& folder, const std::string& file)
        : m_described{pathWithin(folder, file).and_then(&readAnyDescription)}
    {
    }

    /// Nothing where that is not known any more.
    [[nodiscard]] std::optional<bool> has(ToolRole role) const
    {
        if (!m_described)
            return std::nullopt;
        return std::ranges::count(m_described->tools, role, &DescribedTool::role) > 0;
    }
    [[nodiscard]] bool mayHave(ToolRole role) const { return has(role).value_or(true); }
    /// Whether a device between them makes that they are not seen by one.
    [[nodiscard]] bool parts(ToolRole a, ToolRole b) const
    {
        return !m_described || *has(a) != *has(b);
    }

private:
    Result<TrackerDescription> m_described;
};

Site withFrameChanged(Site site, const SeenTools& seen)
{
    for (SiteTool& tool : site.tools)
        if (seen.parts(tool.role, ToolRole::Stylus))
            makeStale(tool.stale, StaleCause::Tracker);
    if (seen.mayHave(ToolRole::Stylus)) {
        site.relay.reset();
        makeTouchesStale(site, StaleCause::Tracker);
    }
    const auto& registration = site.registration;
    const bool followsChin = registration && registration->X_JM && seen.mayHave(ToolRole::Jaw);
    const bool followsBody = registration && registration->X_BM && seen.mayHave(ToolRole::Manikin);
    if (followsChin || followsBody)
        makeFitStale(site, StaleCause::Tracker);
    return site;
}

Result<Site> usableTogether(Site site, const std::filesystem::path& folder)
{
    return readSiteDevices(folder, site.devices).map([&](const auto&) { return std::move(site); });
}

} // namespace

Result<Site> withFirstDevice(Site site, const std::filesystem::path& folder, std::string file)
{
    CARINA_EXPECTS(site.devices.size() <= 1);
    site.devices = {{.file = std::move(file)}};
    return usableTogether(std::move(site), folder);
}

Result<Site> withDevice(Site site, const std::filesystem::path& folder, SiteDevice device)
{
    CARINA_EXPECTS(!site.devices.empty() && device.file != site.devices.front().file
                   && device.frame);
    const auto before = std::ranges::find(site.devices, device.file, &SiteDevice::file);
    if (before == site.devices.end()) {
        site.devices.push_back(std::move(device));
        return usableTogether(std::move(site), folder);
    }
    const SeenTools seen{folder, device.file};
    *before = std::move(device);
    return usableTogether(withFrameChanged(std::move(site), seen), folder);
}

Result<Site> withoutDevice(Site site, const std::filesystem::path& folder, std::string file)
{
    const auto device = std::ranges::find(site.devices, file, &SiteDevice::file);
    CARINA_EXPECTS(device != site.devices.end()
                   && (device != site.devices.begin() || site.devices.size() == 1));
    if (device != site.devices.begin()) // what the first saw tells itself by the tracker's name
        site = withFrameChanged(std::move(site), SeenTools{folder, file});
    std::erase_if(site.devices, [&](const SiteDevice& each) { return each.file == file; });
    return usableTogether(std::move(site), folder);
}

std::string deviceFile(const std::filesystem::path& folder, const std::filesystem::path& file)
{
    std::error_code ignored;
    return std::filesystem::proximate(file, folder, ignored).string();
}

SiteDeviceFrame deviceFrame(const FrameCalibration& found, std::string at)
{
    return {.place = found.place,
            .rms = found.rms.si,
            .turn = found.turn,
            .pairs = int(found.pairs),
            .calibratedAt = std::move(at)};
}

} // namespace carina
