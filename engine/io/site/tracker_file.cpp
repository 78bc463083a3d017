#include "engine/io/site/tracker_file.h"

#include "engine/io/files/folder_path.h"
#include "engine/io/files/json_fields.h"
#include "engine/io/files/whole_file.h"
#include "engine/tracking/tool_role.h"

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

const QString kTrackerSchema = QStringLiteral("carina.tracker/1");
constexpr int kSlowestRate = 9600;
constexpr std::array kKindWords{"ndi", "openigtlink"};
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
    const char* own = kind == TrackerKind::Ndi ? "definition" : "device";
    std::vector<NamedTool> tools;
    for (JsonFields& entry : fields.objects("tools")) {
        entry.allowOnly({"name", "role", own});
        NamedTool named{{entry.text("name"), ToolRole(entry.oneOf("role", kToolRoleWords)), {}},
                        {}};
        if (entry.has(own))
            (kind == TrackerKind::Ndi ? named.definition : named.tool.device) = entry.text(own);
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
    if (described.kind == TrackerKind::Ndi)
        readNdi(fields, described);
    else
        readOpenIgtLink(fields, described);
    const std::vector<NamedTool> tools = readTools(fields, described.kind);
    if (fault)
        return fail(fault->code, file.string() + ": " + fault->detail);
    for (const NamedTool& named : tools) {
        described.tools.push_back(named.tool);
        if (named.definition.empty())
            continue;
        auto definition =
            pathWithin(file.parent_path(), named.definition).and_then(&readToolDefinition);
        if (!definition)
            return tl::unexpected(definition.error());
        described.tools.back().definition = *std::move(definition);
    }
    return described;
}

Result<void> writeTrackerFile(const std::filesystem::path& file,
                              const TrackerDescription& description)
{
    QJsonArray tools;
    int wireless = 0;
    for (const DescribedTool& tool : description.tools) {
        QJsonObject entry{{QStringLiteral("name"), QString::fromStdString(tool.name)},
                          {QStringLiteral("role"), QString::fromLatin1(toolRoleWord(tool.role))}};
        if (tool.definition) {
            const std::string name =
                file.stem().string() + "-" + std::to_string(++wireless) + ".rom";
            const auto& bytes = tool.definition->bytes();
            const auto wrote = writeWholeFile(
                file.parent_path() / name,
                std::string_view{reinterpret_cast<const char*>(bytes.data()), bytes.size()});
            if (!wrote)
                return wrote;
            entry[QStringLiteral("definition")] = QString::fromStdString(name);
        }
        if (!tool.device.empty())
            entry[QStringLiteral("device")] = QString::fromStdString(tool.device);
        tools.append(entry);
    }
    const bool isNdi = description.kind == TrackerKind::Ndi;
    const char* poses = isNdi ? kPoseWords[std::size_t(description.poses)]
                              : kIgtlPoseWords[std::size_t(description.igtlPoses)];
    return writeJsonFile(
        file,
        {{QStringLiteral("schema"), kTrackerSchema},
         {QStringLiteral("kind"), QString::fromLatin1(kKindWords[std::size_t(description.kind)])},
         {QStringLiteral("address"), QString::fromStdString(description.address)},
         {QStringLiteral("poses"), QString::fromLatin1(poses)},
         {isNdi ? QStringLiteral("fastest_rate") : QStringLiteral("rate"),
          isNdi ? description.fastestRate : description.rate_hz},
         {QStringLiteral("tools"), tools}});
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
