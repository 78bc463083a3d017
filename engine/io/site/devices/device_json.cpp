#include "engine/io/site/devices/device_json.h"

#include "engine/io/site/site_fields.h"

#include <algorithm>

namespace carina
{
namespace
{

SiteDeviceFrame readFrame(JsonFields fields)
{
    fields.allowOnly({"X_TD_mm", "late_ms", "rms_mm", "rms_deg", "pairs", "calibrated_at"});
    const double late_ms = fields.number("late_ms");
    if (std::abs(late_ms) > 1e3 * toSeconds(kLatestDevice))
        fields.refuse("late_ms", "at most 5000 to either side is expected");
    return {.place = {fields.pose("X_TD_mm"), fromSeconds(1e-3 * late_ms)},
            .rms = fields.length("rms_mm"),
            .turn = degrees(fields.amount("rms_deg")),
            .pairs = fields.count("pairs"),
            .calibratedAt = readTime(fields, "calibrated_at")};
}

} // namespace

QJsonObject jsonDevice(const SiteDevice& device)
{
    QJsonObject object{{QStringLiteral("file"), jsonWords(device.file)}};
    if (device.frame)
        object.insert(
            QStringLiteral("frame"),
            QJsonObject{{QStringLiteral("X_TD_mm"), jsonPose(device.frame->place.X_FD)},
                        {QStringLiteral("late_ms"), 1e3 * toSeconds(device.frame->place.late)},
                        {QStringLiteral("rms_mm"), jsonLength(device.frame->rms)},
                        {QStringLiteral("rms_deg"), inDegrees(device.frame->turn)},
                        {QStringLiteral("pairs"), device.frame->pairs},
                        {QStringLiteral("calibrated_at"), jsonWords(device.frame->calibratedAt)}});
    return object;
}

std::vector<SiteDevice> readDevices(JsonFields& fields)
{
    std::vector<SiteDevice> devices;
    for (JsonFields& each : fields.objects("devices")) {
        each.allowOnly({"file", "frame"});
        SiteDevice device{.file = each.text("file")};
        if (std::ranges::count(devices, device.file, &SiteDevice::file) > 0)
            each.refuse("file", "\"" + device.file + "\" is there twice");
        if (!devices.empty())
            device.frame = readFrame(each.object("frame"));
        else if (each.has("frame"))
            each.refuse("frame", "that of the first device is the frame of all");
        devices.push_back(std::move(device));
        if (devices.size() > kMostDevices) {
            fields.refuse("devices", "at most eight are expected");
            break;
        }
    }
    return devices;
}

} // namespace carina
