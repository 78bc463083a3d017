#include "models/tracker/kept_trackers.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr int kMostKept = 100;
constexpr double kSameNumber = 1e-9; ///< relative

/// The underscore keeps them apart from tracker-2.json and tracker-2.rom, which belong to
/// tracker.json.
std::filesystem::path keptName(const std::filesystem::path& kept, int number)
{
    if (number == 1)
        return kept;
    return kept.parent_path()
           / (kept.stem().string() + '_' + std::to_string(number) + kept.extension().string());
}

bool isThere(const std::filesystem::path& file)
{
    std::error_code ignored;
    return std::filesystem::exists(file, ignored);
}

/// Whether neither the file nor one that would be written beside it is there.
bool isFree(const std::filesystem::path& file, const TrackerDescription& description)
{
    if (isThere(file))
        return false;
    for (std::size_t tool = 1; tool <= description.tools.size(); ++tool)
        if (isThere(file.parent_path()
                    / (file.stem().string() + '-' + std::to_string(tool)
                       + (description.kind == TrackerKind::Camera ? ".json" : ".rom"))))
            return false;
    return description.kind != TrackerKind::Camera
           || !isThere(file.parent_path() / (file.stem().string() + "-camera.json"));
}

bool isNear(double a, double b) { return std::abs(a - b) <= kSameNumber * (1.0 + std::abs(a)); }

/// Of a file that was written: its millimetres were rounded.
bool isSameMarker(const BodyMarker& a, const BodyMarker& b)
{
    return a.id == b.id && isNear(a.side, b.side)
           && a.X_BK.matrix().isApprox(b.X_BK.matrix(), kSameNumber);
}

bool isSameBody(const std::optional<MarkedBody>& a, const std::optional<MarkedBody>& b)
{
    if (!a || !b)
        return a.has_value() == b.has_value();
    return a->dictionary == b->dictionary
           && std::ranges::equal(a->markers, b->markers, isSameMarker);
}

bool isSameCamera(const CameraModel& a, const CameraModel& b)
{
    return a.width == b.width && a.height == b.height && isNear(a.focal.x(), b.focal.x())
           && isNear(a.focal.y(), b.focal.y()) && isNear(a.centre.x(), b.centre.x())
           && isNear(a.centre.y(), b.centre.y())
           && std::ranges::equal(a.distortion, b.distortion, isNear);
}

bool isSameTool(const DescribedTool& a, const DescribedTool& b)
{
    const bool isDefined = a.definition.has_value();
    return a.name == b.name && a.role == b.role && a.device == b.device
           && isDefined == b.definition.has_value()
           && (!isDefined || a.definition->bytes() == b.definition->bytes())
           && isSameBody(a.body, b.body);
}

bool isSameTracker(const TrackerDescription& a, const TrackerDescription& b)
{
    if (a.kind != b.kind || a.address != b.address)
        return false;
    const bool isAskedAlike = a.kind == TrackerKind::Ndi
                                  ? a.poses == b.poses && a.fastestRate == b.fastestRate
                                  : a.igtlPoses == b.igtlPoses && a.rate_hz == b.rate_hz;
    const bool seesAlike = a.kind != TrackerKind::Camera
                           || (a.isLooped == b.isLooped && isSameCamera(a.camera, b.camera));
    return isAskedAlike && seesAlike && std::ranges::equal(a.tools, b.tools, isSameTool);
}

} // namespace

bool isToBeKept(const TrackerForm& form)
{
    return form.source == TrackerSource::Polaris || form.source == TrackerSource::OpenIgtLink
           || (form.source == TrackerSource::Webcam
               && webcamPlace(form.webcam).startsWith(QStringLiteral("/dev/")));
}

std::optional<std::filesystem::path> lastKeptTracker(const std::filesystem::path& kept)
{
    std::optional<std::filesystem::path> last;
    std::filesystem::file_time_type written{};
    for (int number = 1; number <= kMostKept; ++number) {
        const auto file = keptName(kept, number);
        std::error_code error;
        const auto time = std::filesystem::last_write_time(file, error);
        if (error || (last && time < written))
            continue;
        last = file;
        written = time;
    }
    return last;
}

Result<std::filesystem::path> keepTracker(const std::filesystem::path& kept,
                                          const TrackerDescription& description)
{
    for (int number = 1; number <= kMostKept; ++number) {
        const auto file = keptName(kept, number);
        if (isFree(file, description))
            return writeTrackerFile(file, description).map([&] { return file; });
        const auto there = readTrackerFile(file);
        if (!there || !isSameTracker(*there, description))
            continue;
        std::error_code ignored; // it is offered first the next time
        std::filesystem::last_write_time(file, std::filesystem::file_time_type::clock::now(),
                                         ignored);
        return file;
    }
    return fail(Errc::FileUnwritable, kept.string() + ": there are too many like it");
}

TrackerForm formOfKept(const std::filesystem::path& kept)
{
    TrackerForm form;
    const auto last = lastKeptTracker(kept);
    if (!last)
        return form;
    form.source = TrackerSource::Description;
    form.description = QString::fromStdString(last->string());
    const auto described = readTrackerFile(*last);
    if (!described)
        return form; // the window says why when it is chosen
    const QString address = QString::fromStdString(described->address);
    if (described->kind == TrackerKind::Ndi) {
        form.address = address;
        form.poses = described->poses;
        form.fastestRate = described->fastestRate;
    }
    if (described->kind == TrackerKind::Camera)
        form.webcam = address;
    if (described->kind == TrackerKind::OpenIgtLink) {
        form.server = address;
        form.asked = described->igtlPoses;
        for (const DescribedTool& tool : described->tools)
            form.served.push_back(
                {QString::fromStdString(tool.device.empty() ? tool.name : tool.device), tool.role});
    }
    return form;
}

} // namespace carina
