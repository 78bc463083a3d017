#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "apps/lab/tracking/watched_body.h"
#include "engine/io/site/devices/device_changes.h"
#include "engine/io/site/devices/device_json.h"
#include "engine/io/site/devices/site_devices.h"
#include "engine/io/site/site_file.h"

#include <QDateTime>
#include <QJsonArray>
#include <QLockFile>

#include <cstdio>

namespace carina::lab
{
namespace
{

namespace devices_option
{
constexpr Option kFirst{"first", "FILE",
                        "the site's first device, in whose frame all track: a description of a "
                        "tracker (docs/tracking.md) beside SITE or below"};
constexpr Option kAdd{"add", "FILE",
                      "another device, likewise described, or one of the site to be calibrated "
                      "anew: it is calibrated to the first, and stored where that is acceptable"};
constexpr Option kRemove{"remove", "FILE", "a device that the site has no more"};
constexpr Option kTool{"tool", "NAME", "of the first device, on the body that both see"};
constexpr Option kToolOfAdded{"tool-of-added", "NAME",
                              "of the added device on that body; NAME of --tool unless given"};
constexpr Option kSeconds{"seconds", "S",
                          "how long the body is watched, 5 to 600; 30 unless given"};
constexpr Option kRecording{"recording", "FILE",
                            "in place of watching: what the first device saw, recorded by Carina "
                            "(.csv)"};
constexpr Option kRecordingOfAdded{"recording-of-added", "FILE",
                                   "and what the added one saw, by the same clock"};
} // namespace devices_option

namespace devices_key
{
constexpr Key kSite{"site", "SITE as given"};
constexpr Key kDevices{"devices", "of the site, as in its file; the first has no frame"};
constexpr Key kFrame{"frame",
                     "of the added device: X_TD_mm, its frame in that of the first; late_ms, how "
                     "much later it stamps; rms_mm and rms_deg, how well both agree; pairs, how "
                     "many moments; calibrated_at. Only with --add"};
constexpr Key kOutliers{"outliers", "moments that were left out. Only with --add"};
constexpr Key kBodies{"X_OP_mm", "the added device's tool in the first's. Only with --add"};
constexpr Key kSchema{"schema", "carina.devices/1"};
} // namespace devices_key

/// The devices of a site that a command changes.
struct ChangedSite {
    std::filesystem::path file;
    Site site{};

    [[nodiscard]] std::filesystem::path folder() const
    {
        return file.parent_path().empty() ? "." : file.parent_path();
    }
    /// As the site file names it.
    [[nodiscard]] std::string nameOf(const QString& device) const
    {
        return deviceFile(folder(), device.toStdString());
    }
    [[nodiscard]] auto find(const std::string& name)
    {
        return std::ranges::find(site.devices, name, &SiteDevice::file);
    }
};

QJsonObject reportOf(const Words& words, const Site& site)
{
    QJsonArray devices;
    for (const SiteDevice& device : site.devices)
        devices.append(jsonDevice(device));
    return {{devices_key::kSchema, QLatin1StringView{devices_key::kSchema.help}},
            {devices_key::kSite, words.files()[0]},
            {devices_key::kDevices, devices}};
}

/// Writes the site with other devices, where these can be used together.
Result<QJsonObject> store(const Words& words, const std::filesystem::path& file,
                          const Result<Site>& site)
{
    if (!site)
        return tl::unexpected(site.error());
    return writeSiteFile(file, *site).map([&] { return reportOf(words, *site); });
}

Result<QJsonObject> setFirst(const Words& words, const ChangedSite& changed)
{
    if (changed.site.devices.size() > 1)
        return words.refuse(QStringLiteral("keeps the first device while others are calibrated to "
                                           "it; remove these before."));
    const std::string name = changed.nameOf(words.text(devices_option::kFirst));
    return store(words, changed.file, withFirstDevice(changed.site, changed.folder(), name));
}

Result<QJsonObject> removeOne(const Words& words, ChangedSite changed)
{
    const std::string name = changed.nameOf(words.text(devices_option::kRemove));
    const auto device = changed.find(name);
    if (device == changed.site.devices.end())
        return words.refuse(QStringLiteral("finds no such device in the site."));
    if (device == changed.site.devices.begin() && changed.site.devices.size() > 1)
        return words.refuse(QStringLiteral("keeps the first device while others are calibrated to "
                                           "it; remove these before."));
    return store(words, changed.file, withoutDevice(changed.site, changed.folder(), name));
}

/// What both devices saw of the body.
Result<WatchedBody> bodyFor(const Words& words, const std::vector<PlacedDescription>& devices,
                            std::size_t added)
{
    const std::string tool = words.text(devices_option::kTool).toStdString();
    const std::string other = words.has(devices_option::kToolOfAdded)
                                  ? words.text(devices_option::kToolOfAdded).toStdString()
                                  : tool;
    if (words.has(devices_option::kRecording)) {
        auto first = recordedBody(words.text(devices_option::kRecording).toStdString(), tool);
        if (!first)
            return tl::unexpected(first.error());
        return recordedBody(words.text(devices_option::kRecordingOfAdded).toStdString(), other)
            .map([&](BodySamples second) {
                return WatchedBody{*std::move(first), std::move(second)};
            });
    }
    const auto seconds = words.number(devices_option::kSeconds, 5.0, 600.0, 30.0);
    if (!seconds)
        return tl::unexpected(seconds.error());
    std::fprintf(stderr,
                 "For %.0f s, turn the body to and fro about all axes and move it about, where "
                 "both devices see it.\n",
                 *seconds);
    return watchBody({devices.front().described, tool}, {devices[added].described, other},
                     fromSeconds(*seconds));
}

/// Of a device with the name that the site file has for it.
Result<QJsonObject> calibrate(const Words& words, const ChangedSite& changed,
                              const std::string& name, const WatchedBody& body)
{
    const auto found = calibrateFrames(body.first, body.second);
    if (!found)
        return words.refuse(QStringLiteral("finds no frame: %1.")
                                .arg(QString::fromStdString(found.error().detail)));
    const SiteDevice device{
        .file = name,
        .frame = deviceFrame(*found,
                             QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString())};
    auto report = isAcceptable(*found) ? store(words, changed.file,
                                               withDevice(changed.site, changed.folder(), device))
                                       : Result<QJsonObject>{reportOf(words, changed.site)};
    if (!report)
        return report;
    report->insert(devices_key::kFrame, jsonDevice(device)[devices_key::kFrame]);
    report->insert(devices_key::kOutliers, qint64(found->outliers));
    report->insert(devices_key::kBodies, jsonPose(found->X_OP));
    report->insert(kAcceptable, isAcceptable(*found));
    return report;
}

Result<QJsonObject> add(const Words& words, ChangedSite changed)
{
    if (changed.site.devices.empty())
        return words.refuse(QStringLiteral("needs a first device; name it by --first."));
    if (!words.has(devices_option::kTool))
        return words.refuse(QStringLiteral("needs --tool NAME with --add."));
    if (words.has(devices_option::kRecording) != words.has(devices_option::kRecordingOfAdded))
        return words.refuse(QStringLiteral("needs both recordings, or none."));
    const std::string name = changed.nameOf(words.text(devices_option::kAdd));
    auto device = changed.find(name);
    if (device == changed.site.devices.begin())
        return words.refuse(QStringLiteral("calibrates other devices to the first."));
    const auto added = std::size_t(device - changed.site.devices.begin());
    std::vector<SiteDevice> withAdded = changed.site.devices;
    if (added == withAdded.size())
        withAdded.push_back({.file = name, .frame = SiteDeviceFrame{}});
    const auto devices = readSiteDevices(changed.folder(), withAdded);
    if (!devices)
        return tl::unexpected(devices.error());
    return bodyFor(words, *devices, added).and_then([&](const WatchedBody& body) {
        return calibrate(words, changed, name, body);
    });
}

Result<QJsonObject> devices(const Words& words)
{
    if (words.files().size() != 1)
        return words.refuse(QStringLiteral("needs SITE."));
    const int wishes = int(words.has(devices_option::kFirst)) + int(words.has(devices_option::kAdd))
                       + int(words.has(devices_option::kRemove));
    if (wishes > 1)
        return words.refuse(QStringLiteral("takes one of --first, --add and --remove at a time."));
    QLockFile lock{words.files()[0] + QStringLiteral(".lock")};
    lock.setStaleLockTime(0); // it is stale when its program is gone
    const std::string file = words.files()[0].toStdString();
    if (wishes > 0 && !lock.tryLock())
        return fail(Errc::SiteInUse, file);
    auto site = readSiteFile(file);
    if (!site && !(site.error().code == Errc::FileNotFound && words.has(devices_option::kFirst)))
        return tl::unexpected(site.error());
    ChangedSite changed{file, site ? *std::move(site) : Site{}};
    if (words.has(devices_option::kFirst))
        return setFirst(words, changed);
    if (words.has(devices_option::kAdd))
        return add(words, std::move(changed));
    if (words.has(devices_option::kRemove))
        return removeOne(words, std::move(changed));
    return reportOf(words, changed.site);
}

} // namespace

Command devicesCommand()
{
    return {
        .name = "devices",
        .theme = "tracking",
        .summary = "names the devices of a site, and calibrates one to another",
        .uses = {{.lines = {"SITE", "SITE --first FILE", "SITE --remove FILE",
                            "SITE --add FILE --tool NAME [--tool-of-added NAME] [--seconds S]",
                            "SITE --add FILE --tool NAME --recording FILE --recording-of-added "
                            "FILE"},
                  .text = "Prints or changes which devices track at a site (the file of "
                          "carina-registration). All programs track with these unless --tracker "
                          "names another one. Of a device that is added, the frame is found from a "
                          "body that both see, with a tool of each on it, or one that both know, "
                          "while it is turned to and fro about all axes.",
                  .options = {devices_option::kFirst, devices_option::kAdd, devices_option::kRemove,
                              devices_option::kTool, devices_option::kToolOfAdded,
                              devices_option::kSeconds, devices_option::kRecording,
                              devices_option::kRecordingOfAdded},
                  .schema = devices_key::kSchema,
                  .keys = {devices_key::kSite, devices_key::kDevices, devices_key::kFrame,
                           devices_key::kOutliers, devices_key::kBodies, kAcceptable}}},
        .mostFiles = 1,
        .reminder = "devices needs SITE.",
        .experiment = devices};
}

} // namespace carina::lab
