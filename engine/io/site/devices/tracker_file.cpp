#include "engine/io/site/devices/tracker_file.h"

#include "engine/io/files/folder_path.h"
#include "engine/io/files/json_fields.h"
#include "engine/io/files/whole_file.h"
#include "engine/io/site/devices/camera_file.h"
#include "engine/tracking/tool_role.h"

#include <algorithm>
#include <array>
#include <set>

namespace carina
{
namespace
{

const QString kTrackerSchema = QStringLiteral("carina.tracker/1");
constexpr int kSlowestRate = 9600;
constexpr std::array kKindWords{"ndi", "openigtlink", "camera"};
constexpr std::array kPoseWords{"TX", "BX", "BX2"};
constexpr std::array kIgtlPoseWords{"TRANSFORM", "TDATA", "QTDATA"};
constexpr int kHighestRate_hz = 1000;

/// Tools with the files of their definitions, which are read when all fields are right.
struct NamedTool {
    DescribedTool tool;
    std::string definition;
};

std::vector<NamedTool> readTools(JsonFields& fields, TrackerKind kind)
{
    const char* own = kind == TrackerKind::OpenIgtLink ? "device" : "definition";
    std::vector<NamedTool> tools;
    for (JsonFields& entry : fields.objects("tools")) {
        entry.allowOnly({"name", "role", own});
        NamedTool named{{entry.text("name"), ToolRole(entry.oneOf("role", kToolRoleWords)), {}},
                        {}};
        if (entry.has(own) || kind == TrackerKind::Camera)
            (kind == TrackerKind::OpenIgtLink ? named.tool.device : named.definition) =
                entry.text(own);
        for (const NamedTool& other : tools) {
            if (other.tool.name == named.tool.name)
                entry.refuse("name", "\"" + named.tool.name + "\" is there twice");
            if (other.tool.role == named.tool.role && named.tool.role != ToolRole::Other)
                entry.refuse("role", "it is there twice");
        }
        tools.push_back(std::move(named));
    }
    if (tools.empty())
        fields.refuse("tools", "at least one tool is due");
    return tools;
}

void readNdi(JsonFields& fields, TrackerDescription& described)
{
    fields.allowOnly({"schema", "kind", "address", "poses", "fastest_rate", "tools"});
    if (fields.has("poses"))
        described.poses = static_cast<NdiPoseReply>(fields.oneOf("poses", kPoseWords));
    if (fields.has("fastest_rate")) {
        described.fastestRate = fields.count("fastest_rate");
        if (described.fastestRate < kSlowestRate)
            fields.refuse("fastest_rate", "it is at least 9600");
    }
}

/// What a file names that lies beside it or below.
struct NamedFiles {
    std::filesystem::path folder;
    std::string calibration{};
    std::vector<NamedTool> tools{};
};

void readCamera(JsonFields& fields, TrackerDescription& described, NamedFiles& files)
{
    fields.allowOnly({"schema", "kind", "address", "calibration", "looped", "rate", "tools"});
    files.calibration = fields.text("calibration");
    described.isLooped = fields.has("looped") && fields.truth("looped");
    described.rate_hz = 30;
    if (fields.has("rate")) {
        described.rate_hz = fields.count("rate");
        if (described.rate_hz < 1 || described.rate_hz > kHighestRate_hz)
            fields.refuse("rate", "it is from 1 to 1000");
    }
}

/// Reads the definition of each tool that has one, by its path.
template <class Read>
Result<void> readDefinitions(TrackerDescription& described, const NamedFiles& files, Read read)
{
    for (const NamedTool& named : files.tools) {
        described.tools.push_back(named.tool);
        if (named.definition.empty())
            continue;
        const auto done =
            pathWithin(files.folder, named.definition).and_then([&](const auto& path) {
                return read(described.tools.back(), path);
            });
        if (!done)
            return tl::unexpected(done.error());
    }
    return {};
}

/// No marker on two tools, and one dictionary.
Result<void> checkMarkers(const std::vector<DescribedTool>& tools)
{
    std::set<int> ids;
    for (const DescribedTool& tool : tools) {
        if (tool.body->dictionary != tools.front().body->dictionary)
            return fail(Errc::FileMalformed, tool.name + ": its markers are of another dictionary");
        for (const BodyMarker& marker : tool.body->markers)
            if (!ids.insert(marker.id).second)
                return fail(Errc::FileMalformed, tool.name + ": marker " + std::to_string(marker.id)
                                                     + " is on another tool, too");
    }
    return {};
}

Result<void> openCameraFiles(TrackerDescription& described, const NamedFiles& files)
{
    if (!described.address.starts_with("/dev/")) {
        const auto pictures = pathWithin(files.folder, described.address);
        if (!pictures)
            return tl::unexpected(pictures.error());
        described.address = pictures->string();
    }
    const auto camera = pathWithin(files.folder, files.calibration).and_then(&readCameraFile);
    if (!camera)
        return tl::unexpected(camera.error());
    described.camera = camera->model;
    described.calibration = (files.folder / files.calibration).string();
    return readDefinitions(described, files,
                           [](DescribedTool& tool, const auto& path) {
                               return readMarkerFile(path).map(
                                   [&](MarkedBody body) { tool.body = std::move(body); });
                           })
        .and_then([&] { return checkMarkers(described.tools); });
}

Result<void> openDefinitions(TrackerDescription& described, const NamedFiles& files)
{
    return readDefinitions(described, files, [](DescribedTool& tool, const auto& path) {
        return readToolDefinition(path).map(
            [&](NdiToolDefinition definition) { tool.definition = std::move(definition); });
    });
}

void readOpenIgtLink(JsonFields& fields, TrackerDescription& described)
{
    fields.allowOnly({"schema", "kind", "address", "poses", "rate", "tools"});
    if (fields.has("poses"))
        described.igtlPoses = static_cast<IgtlPoses>(fields.oneOf("poses", kIgtlPoseWords));
    if (fields.has("rate")) {
        described.rate_hz = fields.count("rate");
        if (described.rate_hz < 1 || described.rate_hz > kHighestRate_hz)
            fields.refuse("rate", "it is from 1 to 1000");
    }
}

/// Writes the definition of a tool beside a description. @returns its name; empty where the tool
/// has none.
Result<std::string> writeDefinition(const std::filesystem::path& file, const DescribedTool& tool,
                                    int& written)
{
    if (!tool.definition && !tool.body)
        return std::string{};
    const std::string name = file.stem().string() + "-" + std::to_string(++written)
                             + (tool.definition ? ".rom" : ".json");
    const std::filesystem::path path = file.parent_path() / name;
    const auto wrote = [&]() -> Result<void> {
        if (!tool.definition)
            return writeMarkerFile(path, *tool.body);
        const auto& bytes = tool.definition->bytes();
        return writeWholeFile(
            path, std::string_view{reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }();
    return wrote.map([&] { return name; });
}

Result<void> writeCamera(const std::filesystem::path& file, const TrackerDescription& description,
                         QJsonObject& object)
{
    const std::string calibration = file.stem().string() + "-camera.json";
    std::error_code error;
    const auto folder = std::filesystem::weakly_canonical(
        file.parent_path().empty() ? "." : file.parent_path(), error);
    if (!description.address.starts_with("/dev/"))
        object[QStringLiteral("address")] =
            QString::fromStdString(std::filesystem::weakly_canonical(description.address, error)
                                       .lexically_proximate(folder)
                                       .string());
    object[QStringLiteral("calibration")] = QString::fromStdString(calibration);
    object[QStringLiteral("looped")] = description.isLooped;
    object[QStringLiteral("rate")] = description.rate_hz;
    const std::filesystem::path path = file.parent_path() / calibration;
    if (std::filesystem::equivalent(path, description.calibration, error))
        return {}; // with when and how well it was made
    return writeCameraFile(path, CalibratedCamera{.model = description.camera});
}

} // namespace

Result<TrackerDescription> readTrackerFile(const std::filesystem::path& file)
{
    const auto object = readJsonFile(file, kTrackerSchema);
    if (!object)
        return tl::unexpected(object.error());
    std::optional<Error> fault;
    JsonFields fields{*object, fault};
    TrackerDescription described;
    described.kind = static_cast<TrackerKind>(fields.oneOf("kind", kKindWords));
    described.address = fields.text("address");
    NamedFiles files{file.parent_path()};
    if (described.kind == TrackerKind::Ndi)
        readNdi(fields, described);
    else if (described.kind == TrackerKind::OpenIgtLink)
        readOpenIgtLink(fields, described);
    else
        readCamera(fields, described, files);
    files.tools = readTools(fields, described.kind);
    if (fault)
        return fail(fault->code, file.string() + ": " + fault->detail);
    const auto opened = described.kind == TrackerKind::Camera ? openCameraFiles(described, files)
                                                              : openDefinitions(described, files);
    if (!opened)
        return fail(opened.error().code, opened.error().detail);
    return described;
}

Result<void> writeTrackerFile(const std::filesystem::path& file,
                              const TrackerDescription& description)
{
    QJsonArray tools;
    int written = 0;
    for (const DescribedTool& tool : description.tools) {
        QJsonObject entry{{QStringLiteral("name"), QString::fromStdString(tool.name)},
                          {QStringLiteral("role"), QString::fromLatin1(toolRoleWord(tool.role))}};
        const auto named = writeDefinition(file, tool, written);
        if (!named)
            return tl::unexpected(named.error());
        if (!named->empty())
            entry[QStringLiteral("definition")] = QString::fromStdString(*named);
        if (!tool.device.empty())
            entry[QStringLiteral("device")] = QString::fromStdString(tool.device);
        tools.append(entry);
    }
    QJsonObject object{
        {QStringLiteral("schema"), kTrackerSchema},
        {QStringLiteral("kind"), QString::fromLatin1(kKindWords[std::size_t(description.kind)])},
        {QStringLiteral("address"), QString::fromStdString(description.address)},
        {QStringLiteral("tools"), tools}};
    if (description.kind == TrackerKind::Camera)
        if (const auto wrote = writeCamera(file, description, object); !wrote)
            return wrote;
    if (description.kind == TrackerKind::Ndi) {
        object[QStringLiteral("poses")] =
            QString::fromLatin1(kPoseWords[std::size_t(description.poses)]);
        object[QStringLiteral("fastest_rate")] = description.fastestRate;
    }
    if (description.kind == TrackerKind::OpenIgtLink) {
        object[QStringLiteral("poses")] =
            QString::fromLatin1(kIgtlPoseWords[std::size_t(description.igtlPoses)]);
        object[QStringLiteral("rate")] = description.rate_hz;
    }
    return writeJsonFile(file, object);
}

Result<void> nameCalibration(const std::filesystem::path& file,
                             const std::filesystem::path& calibration)
{
    auto object = readJsonFile(file, kTrackerSchema);
    if (!object)
        return tl::unexpected(object.error());
    const auto folder = file.parent_path();
    const auto name = folder.empty() ? calibration : calibration.lexically_proximate(folder);
    const QString key = QStringLiteral("calibration");
    const QString now = QString::fromStdString(name.string());
    if (object->value(key).toString() == now)
        return {};
    object->insert(key, now);
    return writeJsonFile(file, *object);
}

Result<NdiToolDefinition> readToolDefinition(const std::filesystem::path& file)
{
    return readWholeFile(file, kDefinitionLimit).and_then([&](const std::string& bytes) {
        return NdiToolDefinition::read(std::as_bytes(std::span{bytes}))
            .map_error([&](const Error& error) {
                return Error{error.code, file.string() + ": " + error.detail};
            });
    });
}

} // namespace carina
