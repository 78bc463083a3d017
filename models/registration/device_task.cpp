#include "models/registration/device_task.h"

#include "engine/io/files/folder_path.h"
#include "engine/io/site/devices/any_description.h"
#include "engine/io/site/devices/device_changes.h"
#include "engine/net/devices/described_tracker.h"
#include "models/errors/error_text.h"
#include "models/station/tool_status.h"
#include "models/tracker/kept_trackers.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

constexpr const char* kKeptName = "tracker.json";

bool isSameDevice(const SiteDevice& a, const SiteDevice& b)
{
    const DevicePlace one = a.frame ? a.frame->place : DevicePlace{};
    const DevicePlace other = b.frame ? b.frame->place : DevicePlace{};
    return a.file == b.file && one.late == other.late
           && one.X_FD.translation() == other.X_FD.translation()
           && one.X_FD.rotation().coeffs() == other.X_FD.rotation().coeffs();
}

class DeviceWords
{
    Q_DECLARE_TR_FUNCTIONS(DeviceTask)

public:
    static QString calibrated(const SiteDeviceFrame& frame)
    {
        const auto at =
            QDateTime::fromString(QString::fromStdString(frame.calibratedAt), Qt::ISODate);
        const QString when = at.isValid()
                                 ? at.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm"))
                                 : QString::fromStdString(frame.calibratedAt);
        const double late_ms = 1e3 * toSeconds(frame.place.late);
        const QString stamps = (late_ms < 0.0 ? tr("%1\u00a0ms earlier than the first device")
                                              : tr("%1\u00a0ms later than the first device"))
                                   .arg(std::abs(late_ms), 0, 'f', 1);
        return tr("Frame: by a body that both saw, %1. Agrees within %2\u00a0mm and %3° (RMS) at "
                  "%4 moments. Stamps %5.")
            .arg(when)
            .arg(inMillimetres(metres(frame.rms)), 0, 'f', 1)
            .arg(inDegrees(frame.turn), 0, 'f', 1)
            .arg(frame.pairs)
            .arg(stamps);
    }

    static QString visible(const QStringList& tools)
    {
        return tools.isEmpty() ? tr("▲ It delivers, and sees none of its tools.")
                               : tr("✓ It sees: %1").arg(tools.join(QStringLiteral(", ")));
    }
};

} // namespace

DeviceTask::DeviceTask(SiteEditor& editor, std::filesystem::path file, Access access)
    : m_editor{editor},
      m_file{std::move(file)},
      m_folder{m_file.parent_path().empty() ? "." : m_file.parent_path()},
      m_access{std::move(access)}
{
    if (!m_access.make)
        m_access.make = [clock = m_access.clock](const TrackerDescription& described) {
            return describedTracker(described, clock);
        };
    follow();
}

void DeviceTask::follow()
{
    std::vector<std::string> files;
    for (const SiteDevice& device : devices())
        files.push_back(device.file);
    if (files == m_files)
        return;
    m_files = std::move(files);
    m_described.clear();
    for (const std::string& file : m_files)
        m_described.push_back(pathWithin(m_folder, file).and_then(&readAnyDescription));
}

std::vector<DeviceTask::Row> DeviceTask::rows() const
{
    std::vector<Row> rows;
    for (std::size_t i = 0; i < std::min(m_described.size(), count()); ++i)
        rows.push_back(rowOf(i));
    return rows;
}

DeviceTask::Row DeviceTask::rowOf(std::size_t device) const
{
    const SiteDevice& stored = devices().at(device);
    const auto& described = m_described.at(device);
    Row row{.name = QString::fromStdString(stored.file)};
    row.calibrated = stored.frame ? DeviceWords::calibrated(*stored.frame)
                                  : DeviceWords::tr("Frame: that of all devices of this site.");
    if (!described) {
        row.state = QStringLiteral("▲ ") + errorText(described.error());
        return row;
    }
    row.name = trackerName({*described});
    row.state = stateOf(*described);
    return row;
}

QString DeviceTask::stateOf(const TrackerDescription& described) const
{
    if (!isTracked())
        return DeviceWords::tr("○ Not used now: this program tracks with another tracker (%1).")
            .arg(m_access.trackerName);
    const auto now = m_access.clock();
    const auto tools = m_access.tracker->tools();
    const auto seen = now ? toolStatus(*m_access.tracker, *now) : std::vector<ToolStatus>{};
    QStringList visible;
    bool delivers = false;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (std::ranges::count(described.tools, tools[i].name, &DescribedTool::name) == 0)
            continue;
        delivers = delivers || seen[i].rate_Hz > 0.0;
        if (seen[i].isVisible)
            visible << seen[i].name;
    }
    return delivers ? DeviceWords::visible(visible)
                    : DeviceWords::tr("▲ It delivers nothing now: show it a tool, and look whether "
                                      "it is connected.");
}

bool DeviceTask::isTracked() const
{
    return m_access.tracked && std::ranges::equal(*m_access.tracked, devices(), &isSameDevice);
}

QString DeviceTask::whyKept(std::size_t device) const
{
    return device == 0 && devices().size() > 1
               ? DeviceWords::tr("The other devices are calibrated to the first one: remove these "
                                 "before.")
               : QString{};
}

TrackerForm DeviceTask::offeredForm() const { return formOfKept(m_folder / kKeptName); }

std::optional<std::string> DeviceTask::kept(const TrackerForm& form, const TrackerChoice& choice)
{
    const auto refuse = [this](const QString& sentence) {
        m_editor.refuse(sentence);
        return std::nullopt;
    };
    const auto* described = std::get_if<TrackerDescription>(&choice.device);
    if (described == nullptr)
        return refuse(DeviceWords::tr("A site cannot have this as one of its devices: choose a "
                                      "Polaris, a server or what a file describes."));
    const std::filesystem::path chosen = form.description.trimmed().toStdString();
    std::string file = deviceFile(m_folder, chosen);
    const bool isBeside = form.source == TrackerSource::Description && pathWithin(m_folder, file);
    if (!isBeside && described->kind == TrackerKind::Camera && !isToBeKept(form))
        return refuse(
            DeviceWords::tr("The description of a camera has to lie beside the site or below: copy "
                            "it, with its calibration and its markers, to this folder: %1")
                .arg(QDir::toNativeSeparators(QString::fromStdString(m_folder.string()))));
    if (!isBeside) {
        const auto written = keepTracker(m_folder / kKeptName, *described);
        if (!written) {
            m_editor.refuse(written.error());
            return std::nullopt;
        }
        file = deviceFile(m_folder, *written);
    }
    if (std::ranges::count(devices(), file, &SiteDevice::file) > 0)
        return refuse(DeviceWords::tr("The site has this device already: calibrate it again, or "
                                      "choose another one."));
    return file;
}

bool DeviceTask::isFirst(const Wanted& wanted) const
{
    return devices().empty() || wanted.replaced == 0U;
}

void DeviceTask::setFirst(const Wanted& wanted)
{
    if (devices().size() > 1)
        return m_editor.refuse(whyKept(0));
    const auto made =
        pathWithin(m_folder, wanted.file).and_then(&readAnyDescription).and_then(m_access.make);
    if (!made) // with nothing else it could not be tracked
        return m_editor.refuse(made.error());
    adopt(withFirstDevice(m_editor.site(), m_folder, wanted.file));
}

Result<Site> DeviceTask::withoutReplaced(const Wanted& wanted) const
{
    return wanted.replaced
               ? withoutDevice(m_editor.site(), m_folder, devices().at(*wanted.replaced).file)
               : Result<Site>{m_editor.site()};
}

std::optional<DevicesToCalibrate> DeviceTask::toCalibrate(const Wanted& wanted)
{
    const auto both = withoutReplaced(wanted).and_then([&](Site site) {
        if (std::ranges::count(site.devices, wanted.file, &SiteDevice::file) == 0)
            site.devices.push_back({.file = wanted.file, .frame = SiteDeviceFrame{}});
        return readSiteDevices(m_folder, site.devices).map([&](auto placed) {
            const auto it = std::ranges::find(site.devices, wanted.file, &SiteDevice::file);
            return DevicesToCalibrate{placed.front().described,
                                      placed.at(std::size_t(it - site.devices.begin())).described};
        });
    });
    if (!both) {
        m_editor.refuse(both.error());
        return std::nullopt;
    }
    return *both;
}

bool DeviceTask::lend()
{
    if (!m_access.track)
        return true;
    if (const auto free = m_access.track(false); !free) {
        m_editor.refuse(free.error());
        return false;
    }
    return true;
}

void DeviceTask::takeBack()
{
    if (!m_access.track)
        return;
    if (const auto tracks = m_access.track(true); !tracks)
        m_editor.refuse(tracks.error());
}

void DeviceTask::store(const Wanted& wanted, const FrameCalibration& found)
{
    adopt(withoutReplaced(wanted).and_then([&](Site site) {
        return withDevice(std::move(site), m_folder,
                          {.file = wanted.file, .frame = deviceFrame(found, m_editor.now())});
    }));
}

void DeviceTask::remove(std::size_t device)
{
    if (const QString why = whyKept(device); !why.isEmpty())
        return m_editor.refuse(why);
    adopt(withoutDevice(m_editor.site(), m_folder, devices().at(device).file));
}

void DeviceTask::adopt(Result<Site> site)
{
    if (!site)
        return m_editor.refuse(site.error());
    m_editor.become(*std::move(site));
}

} // namespace carina
