#include "models/tracker/tracker_form.h"

#include "engine/net/devices/device_port.h"
#include "engine/net/devices/serial_ports.h"
#include "models/station/tool_status.h"

#include <QCoreApplication>

#include <algorithm>
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
                return tr("Two tools have the role %1: give one of them another.")
                    .arg(toolRoleName(tool.role));
        return std::nullopt;
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
        case TrackerSource::Recording:
            return missingFile(form.recording, tr("Choose the file of a recording (.igs.mha)."));
        case TrackerSource::Description:
            return missingFile(form.description,
                               tr("Choose the file that describes a tracker (.json)."));
        }
        return std::nullopt;
    }

    static std::string nameOf(const FormTool& tool, std::size_t place)
    {
        const QString role = toolRoleName(tool.role);
        return (role.isEmpty() ? tr("Tool %1").arg(place + 1) : role).toStdString();
    }
};

Result<TrackerDescription> describedBy(const TrackerForm& form)
{
    TrackerDescription described;
    described.address = form.address.trimmed().toStdString();
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

std::optional<QString> whatIsMissing(const TrackerForm& form)
{
    return TrackerFormWords::missing(form);
}

Result<TrackerChoice> choiceOf(const TrackerForm& form)
{
    const auto asChoice = [](TrackerDescription described) {
        return TrackerChoice{std::move(described)};
    };
    switch (form.source) {
    case TrackerSource::Simulated:
        break;
    case TrackerSource::Polaris:
        return describedBy(form).map(asChoice);
    case TrackerSource::Recording:
        return recordedTracker(form.recording.trimmed().toStdString(),
                               form.isLooped ? Playing::Looped : Playing::Once);
    case TrackerSource::Description:
        return readTrackerFile(form.description.trimmed().toStdString()).map(asChoice);
    }
    return TrackerChoice{SimulatedDevice{}};
}

} // namespace carina
