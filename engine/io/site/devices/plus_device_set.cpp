#include "engine/io/site/devices/plus_device_set.h"

#include "engine/io/files/folder_path.h"
#include "engine/io/files/whole_file.h"
#include "engine/tracking/tool_role.h"

#include <QByteArray>
#include <QXmlStreamReader>

#include <algorithm>

namespace carina
{
namespace
{

constexpr std::size_t kMostPlusTools = 64;
constexpr int kNdiPort = 8765;
constexpr int kIgtlPort = 18944;
constexpr int kSlowestPlusRate = 9600;

struct PlusTool {
    std::string id;
    std::string rom;
    int port = 0;
};

/// A Device element with what is in it.
struct PlusDevice {
    QXmlStreamAttributes attributes;
    std::vector<PlusTool> tools{};

    [[nodiscard]] QString text(const char* name) const
    {
        return attributes.value(QLatin1StringView{name}).toString().trimmed();
    }
    [[nodiscard]] bool isOf(const char* type) const
    {
        return text("Type").compare(QLatin1StringView{type}, Qt::CaseInsensitive) == 0;
    }
    [[nodiscard]] bool isNdi() const { return isOf("PolarisTracker") || isOf("NDITracker"); }
    [[nodiscard]] bool isUsed() const { return isNdi() || isOf("OpenIGTLinkTracker"); }
};

class DeviceSetReader
{
public:
    DeviceSetReader(const QByteArray& xml, const std::filesystem::path& file)
        : m_xml{xml}, m_file{file}
    {
    }

    /// The first device that is used.
    Result<PlusDevice> read()
    {
        std::optional<PlusDevice> device;
        bool isPlus = false;
        while (!m_xml.atEnd()) {
            const auto token = m_xml.readNext();
            if (token == QXmlStreamReader::DTD)
                return refused("it has a document type");
            if (token != QXmlStreamReader::StartElement)
                continue;
            if (m_xml.name() == QLatin1StringView{"PlusConfiguration"})
                isPlus = true;
            if (isPlus && !device && m_xml.name() == QLatin1StringView{"Device"}) {
                auto taken = takeDevice();
                if (!taken)
                    return tl::unexpected(taken.error());
                if (taken->isUsed())
                    device = *std::move(taken);
            }
        }
        if (m_xml.hasError())
            return refused(m_xml.errorString().toStdString());
        if (!isPlus)
            return refused("it is no configuration of PLUS");
        if (!device)
            return fail(Errc::UnknownFormat,
                        m_file.string()
                            + ": it names no tracker of a supported type, which are "
                              "PolarisTracker, NDITracker and OpenIGTLinkTracker");
        return *std::move(device);
    }

private:
    [[nodiscard]] tl::unexpected<Error> refused(const std::string& why) const
    {
        return fail(Errc::FileMalformed,
                    m_file.string() + ": line " + std::to_string(m_xml.lineNumber()) + ": " + why);
    }

    Result<PlusDevice> takeDevice()
    {
        PlusDevice device{m_xml.attributes()};
        int sources = 0; ///< depth of the DataSources that it is in
        for (int depth = 1; depth > 0 && !m_xml.atEnd();) {
            const auto token = m_xml.readNext();
            if (token == QXmlStreamReader::EndElement && --depth < sources)
                sources = 0;
            if (token != QXmlStreamReader::StartElement)
                continue;
            ++depth;
            if (m_xml.name() == QLatin1StringView{"DataSources"})
                sources = depth; // those of an OutputChannel are the same again
            const auto attributes = m_xml.attributes();
            if (sources == 0 || m_xml.name() != QLatin1StringView{"DataSource"}
                || attributes.value(QLatin1StringView{"Type"})
                           .compare(QLatin1StringView{"Tool"}, Qt::CaseInsensitive)
                       != 0)
                continue;
            if (device.tools.size() == kMostPlusTools)
                return refused("there are more than 64 tools");
            const auto text = [&](const char* name) {
                return attributes.value(QLatin1StringView{name}).trimmed();
            };
            device.tools.push_back({text("Id").toString().toStdString(),
                                    text("RomFile").toString().toStdString(),
                                    text("PortName").toInt()});
            if (device.tools.back().id.empty())
                return refused("a tool without Id");
        }
        return device;
    }

    QXmlStreamReader m_xml;
    std::filesystem::path m_file;
};

std::string hostAndPort(const QString& host, const QString& port, int otherwise)
{
    bool isNumber = false;
    const int number = port.toInt(&isNumber);
    return host.toStdString() + ':' + std::to_string(isNumber ? number : otherwise);
}

TrackerDescription ndiOf(const PlusDevice& device)
{
    TrackerDescription described;
    const QString host = device.text("NetworkHostname");
    const int serial = std::clamp(device.text("SerialPort").toInt(), 1, 256);
    described.address = host.isEmpty() ? "/dev/ttyS" + std::to_string(serial - 1)
                                       : hostAndPort(host, device.text("NetworkPort"), kNdiPort);
    if (const int rate = device.text("BaudRate").toInt(); rate >= kSlowestPlusRate)
        described.fastestRate = rate;
    return described;
}

TrackerDescription igtlOf(const PlusDevice& device)
{
    TrackerDescription described;
    described.kind = TrackerKind::OpenIgtLink;
    described.address =
        hostAndPort(device.text("ServerAddress"), device.text("ServerPort"), kIgtlPort);
    const QString type = device.text("MessageType").toUpper();
    if (type == QLatin1StringView{"TDATA"})
        described.igtlPoses = IgtlPoses::Tdata;
    else if (type == QLatin1StringView{"QTDATA"})
        described.igtlPoses = IgtlPoses::Qtdata;
    return described;
}

/// The role that a name tells, once.
ToolRole roleFor(const std::string& name, const std::vector<DescribedTool>& taken)
{
    const ToolRole role = toolRoleOfName(name);
    return std::ranges::count(taken, role, &DescribedTool::role) == 0 ? role : ToolRole::Other;
}

Result<TrackerDescription> describedBy(const PlusDevice& device,
                                       const std::filesystem::path& folder)
{
    TrackerDescription described = device.isNdi() ? ndiOf(device) : igtlOf(device);
    const QString frame = device.text("ToolReferenceFrame");
    const std::string reference = frame.isEmpty() ? "Tracker" : frame.toStdString();
    for (const PlusTool& tool : device.tools) {
        DescribedTool& added = described.tools.emplace_back();
        added.name = tool.id;
        added.role = roleFor(tool.id, {described.tools.begin(), described.tools.end() - 1});
        if (!device.isNdi())
            added.device = tool.id + "To" + reference;
        if (!device.isNdi() || tool.rom.empty())
            continue;
        auto definition = pathWithin(folder, tool.rom).and_then(&readToolDefinition);
        if (!definition)
            return tl::unexpected(definition.error());
        added.definition = *std::move(definition);
    }
    return described;
}

} // namespace

Result<TrackerDescription> readPlusDeviceSet(const std::filesystem::path& file)
{
    const auto xml = readWholeFile(file, kDescriptionLimit);
    if (!xml)
        return tl::unexpected(xml.error());
    auto device = DeviceSetReader{QByteArray::fromStdString(*xml), file}.read();
    if (!device)
        return tl::unexpected(device.error());
    if (device->tools.empty())
        return fail(Errc::FileMalformed, file.string() + ": its tracker has no tools");
    std::ranges::stable_sort(device->tools, {}, &PlusTool::port);
    return describedBy(*device, file.parent_path());
}

} // namespace carina
