#include "models/tracker/tracker_form.h"

#include "engine/io/site/devices/printed_tracker.h"
#include "engine/net/devices/device_port.h"
#include "engine/net/devices/serial_ports.h"
#include "engine/tracking/tool_role.h"
#include "models/station/tool_status.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>

#include <algorithm>
#include <array>
#include <set>

namespace carina
{
namespace
{

class TrackerFormWords
{
    Q_DECLARE_TR_FUNCTIONS(TrackerForm)

public:
    static std::optional<QString> missingOfPolaris(const TrackerForm& form)
    {
        if (!isDeviceAddress(form.address.trimmed().toStdString()))
            return tr("Choose a serial port, or type the address and port of a tracker on the "
                      "network, such as 192.0.2.7:8765.");
        if (form.tools.empty())
            return tr("Add the tools that are to be tracked, the stylus at least.");
        std::set<ToolRole> roles;
        for (const FormTool& tool : form.tools)
            if (tool.role != ToolRole::Other && !roles.insert(tool.role).second)
                return twice(tool.role);
        return std::nullopt;
    }

    static std::optional<QString> missingOfServer(const TrackerForm& form)
    {
        if (!isServerAddress(form.server))
            return tr("Type the address and port of the server, such as 192.0.2.7:18944.");
        if (form.served.empty())
            return tr("Add the tools that are to be tracked: look what the server sends.");
        std::set<ToolRole> roles;
        std::set<QString> names;
        for (const ServedTool& tool : form.served) {
            if (tool.device.trimmed().isEmpty())
                return tr("Type the name by which the server sends the tool.");
            if (!names.insert(tool.device.trimmed()).second)
                return tr("The tool %1 is there twice: remove one.").arg(tool.device.trimmed());
            if (tool.role != ToolRole::Other && !roles.insert(tool.role).second)
                return twice(tool.role);
        }
        return std::nullopt;
    }

    static QString twice(ToolRole role)
    {
        return tr("Two tools have the role %1: give one of them another.").arg(toolRoleName(role));
    }

    static std::optional<QString> missingFile(const QString& file, const QString& sentence)
    {
        return file.trimmed().isEmpty() ? std::optional{sentence} : std::nullopt;
    }

    static std::optional<QString> missing(const TrackerForm& form)
    {
        switch (form.source) {
        case TrackerSource::Simulated:
            break;
        case TrackerSource::Polaris:
            return missingOfPolaris(form);
        case TrackerSource::OpenIgtLink:
            return missingOfServer(form);
        case TrackerSource::Recording:
            return missingFile(form.recording,
                               tr("Choose the file of a recording: of poses (.csv, .igs.mha, "
                                  ".tum), or of the bytes of a device (.log)."));
        case TrackerSource::Description:
            return missingFile(form.description,
                               tr("Choose the file that describes a tracker (.json), "
                                  "or a device set of PLUS (.xml)."));
        case TrackerSource::Webcam:
            return missingFile(form.webcam, tr("Choose a webcam, type its number, or choose a "
                                               "video of the printed tools."));
        }
        return std::nullopt;
    }

    static std::string nameOf(const FormTool& tool, std::size_t place)
    {
        const QString role = toolRoleName(tool.role);
        return (role.isEmpty() ? tr("Tool %1").arg(place + 1) : role).toStdString();
    }
};

const QString kDevices = QStringLiteral("/dev");

Result<TrackerDescription> describedWebcam(const TrackerForm& form)
{
    TrackerDescription described = printedTracker(webcamPlace(form.webcam).toStdString());
    const QString calibration = form.calibration.trimmed();
    if (!calibration.isEmpty())
        if (const auto taken = takeCalibration(described, calibration.toStdString()); !taken)
            return tl::unexpected(taken.error());
    return described;
}

Result<TrackerDescription> describedBy(const TrackerForm& form)
{
    TrackerDescription described;
    described.address = form.address.trimmed().toStdString();
    described.poses = form.poses;
    described.fastestRate = form.fastestRate;
    for (const FormTool& tool : form.tools) {
        DescribedTool& added = described.tools.emplace_back();
        added.name = TrackerFormWords::nameOf(tool, described.tools.size() - 1);
        added.role = tool.role;
        if (tool.definition.isEmpty())
            continue;
        auto definition = readToolDefinition(tool.definition.toStdString());
        if (!definition)
            return tl::unexpected(definition.error());
        added.definition = *std::move(definition);
    }
    return described;
}

/// @param goesOn of choiceOf
Result<TrackerChoice> deviceOf(const TrackerForm& form, const Progress& goesOn)
{
    const auto asChoice = [](TrackerDescription described) {
        return TrackerChoice{std::move(described)};
    };
    switch (form.source) {
    case TrackerSource::Simulated:
        break;
    case TrackerSource::Polaris:
        return describedBy(form).map(asChoice);
    case TrackerSource::OpenIgtLink:
        return TrackerChoice{describedServer(form)};
    case TrackerSource::Recording:
        return recordedTracker(form.recording.trimmed().toStdString(),
                               form.isLooped ? Playing::Looped : Playing::Once, goesOn);
    case TrackerSource::Description:
        return describedIn(form.description.trimmed().toStdString());
    case TrackerSource::Webcam:
        return describedWebcam(form).map(asChoice);
    }
    return trackerNamed(simulatedName(form.simulated)); // as the option of a start
}

} // namespace

std::vector<OfferedAddress> offeredAddresses()
{
    std::vector<OfferedAddress> offered;
    for (const SerialPortFound& port : serialPorts()) {
        const QString address = QString::fromStdString(port.address);
        const QString description = QString::fromStdString(port.description);
        offered.push_back({address, description.isEmpty()
                                        ? address
                                        : QStringLiteral("%1 (%2)").arg(address, description)});
    }
    return offered;
}

/// As the kernel names them.
std::vector<OfferedAddress> offeredWebcams()
{
    std::vector<OfferedAddress> offered;
    const QDir devices{kDevices};
    for (const QString& name :
         devices.entryList({QStringLiteral("video*")}, QDir::System, QDir::LocaleAware)) {
        QFile told{QStringLiteral("/sys/class/video4linux/%1/name").arg(name)};
        const QString known = told.open(QIODevice::ReadOnly)
                                  ? QString::fromUtf8(told.readAll()).trimmed()
                                  : QString{};
        const QString address = devices.filePath(name);
        offered.push_back(
            {address, known.isEmpty() ? address : QStringLiteral("%1 (%2)").arg(address, known)});
    }
    return offered;
}

QString webcamPlace(const QString& text)
{
    const QString place = text.trimmed();
    bool isNumber = false;
    const uint number = place.toUInt(&isNumber);
    return isNumber ? QDir{kDevices}.filePath(QStringLiteral("video%1").arg(number)) : place;
}

bool canHaveConversation(TrackerSource source)
{
    return source == TrackerSource::Polaris || source == TrackerSource::OpenIgtLink
           || source == TrackerSource::Description;
}

bool canCalibrateCamera(const TrackerForm& form)
{
    const bool isOfPlus =
        form.description.trimmed().endsWith(QLatin1StringView{".xml"}, Qt::CaseInsensitive);
    const bool mayBeCamera = form.source == TrackerSource::Webcam
                             || (form.source == TrackerSource::Description && !isOfPlus);
    return mayBeCamera && !whatIsMissing(form);
}

std::span<const int> offeredRates() { return usualSerialRates(); }

std::span<const ToolRole> offeredRoles()
{
    static constexpr std::array kOffered{ToolRole::Stylus,       ToolRole::Jaw,   ToolRole::Tube,
                                         ToolRole::Laryngoscope, ToolRole::Head,  ToolRole::Hand,
                                         ToolRole::Manikin,      ToolRole::Chest, ToolRole::Other};
    return kOffered;
}

std::span<const ToolRole> simulatedRoles()
{
    const auto all = offeredRoles();
    return all.first(all.size() - 1); // without Other
}

ToolRole freeRoleOf(const QString& device, const std::vector<ServedTool>& taken)
{
    QString name = device;
    if (const qsizetype to = name.indexOf(QLatin1StringView{"To"}); to > 0)
        name.truncate(to);
    const ToolRole role = toolRoleOfName(name.toStdString());
    return std::ranges::count(taken, role, &ServedTool::role) == 0 ? role : ToolRole::Other;
}

bool isServerAddress(const QString& text)
{
    const std::string address = text.trimmed().toStdString();
    return isDeviceAddress(address) && !isSerialPort(address);
}

TrackerDescription describedServer(const TrackerForm& form)
{
    TrackerDescription described;
    described.kind = TrackerKind::OpenIgtLink;
    described.address = form.server.trimmed().toStdString();
    described.igtlPoses = form.asked;
    for (const ServedTool& tool : form.served) {
        const std::string device = tool.device.trimmed().toStdString();
        if (!device.empty())
            described.tools.push_back({.name = device, .role = tool.role, .device = device});
    }
    return described;
}

std::optional<QString> whatIsMissing(const TrackerForm& form)
{
    return TrackerFormWords::missing(form);
}

Result<TrackerChoice> choiceOf(const TrackerForm& form, const Progress& goesOn)
{
    return deviceOf(form, goesOn).map([&](TrackerChoice choice) {
        if (canHaveConversation(form.source) && hasConversation(choice))
            choice.conversation = form.conversation.trimmed().toStdString();
        return choice;
    });
}

} // namespace carina
