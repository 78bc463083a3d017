#include "engine/net/devices/device_log_header.h"

#include "engine/io/files/json_fields.h"
#include "engine/tracking/tool_role.h"

#include <QByteArray>

#include <array>

namespace carina
{
namespace
{

constexpr std::array kLoggedKinds{"ndi", "openigtlink"};
constexpr std::array kLoggedPoses{"TX", "BX", "BX2"};
constexpr std::array kLoggedIgtlPoses{"TRANSFORM", "TDATA", "QTDATA"};
constexpr std::size_t kMostLoggedTools = 64;

QString asQString(const char* word) { return QString::fromLatin1(word); }

Result<NdiToolDefinition> definitionIn(const std::string& base64)
{
    const QByteArray bytes = QByteArray::fromBase64(QByteArray::fromStdString(base64));
    return NdiToolDefinition::read(
        std::as_bytes(std::span{bytes.constData(), std::size_t(bytes.size())}));
}

Result<DescribedTool> loggedTool(JsonFields& entry)
{
    DescribedTool tool{.name = entry.text("name"),
                       .role = ToolRole(entry.oneOf("role", kToolRoleWords))};
    if (entry.has("device"))
        tool.device = entry.text("device");
    if (!entry.has("definition_base64"))
        return tool;
    return definitionIn(entry.text("definition_base64")).map([&](NdiToolDefinition definition) {
        tool.definition = std::move(definition);
        return tool;
    });
}

} // namespace

QJsonObject deviceLogHeader(const TrackerDescription& description)
{
    QJsonArray tools;
    for (const DescribedTool& tool : description.tools) {
        QJsonObject entry{{QStringLiteral("name"), QString::fromStdString(tool.name)},
                          {QStringLiteral("role"), asQString(toolRoleWord(tool.role))}};
        if (!tool.device.empty())
            entry[QStringLiteral("device")] = QString::fromStdString(tool.device);
        if (tool.definition) {
            const auto& bytes = tool.definition->bytes();
            const QByteArray raw{reinterpret_cast<const char*>(bytes.data()),
                                 qsizetype(bytes.size())};
            entry[QStringLiteral("definition_base64")] = QString::fromLatin1(raw.toBase64());
        }
        tools.append(entry);
    }
    const bool isNdi = description.kind == TrackerKind::Ndi;
    return {{QStringLiteral("kind"), asQString(kLoggedKinds[isNdi ? 0 : 1])},
            {QStringLiteral("address"), QString::fromStdString(description.address)},
            {QStringLiteral("poses"),
             asQString(isNdi ? kLoggedPoses[std::size_t(description.poses)]
                             : kLoggedIgtlPoses[std::size_t(description.igtlPoses)])},
            {QStringLiteral("rate"), isNdi ? description.fastestRate : description.rate_hz},
            {QStringLiteral("tools"), tools}};
}

Result<TrackerDescription> readDeviceLogHeader(std::string_view json)
{
    const auto object = jsonObjectIn(json);
    if (!object)
        return tl::unexpected(object.error());
    std::optional<Error> fault;
    JsonFields fields{*object, fault};
    TrackerDescription described;
    described.kind =
        fields.oneOf("kind", kLoggedKinds) == 0 ? TrackerKind::Ndi : TrackerKind::OpenIgtLink;
    described.address = fields.text("address");
    if (described.kind == TrackerKind::Ndi) {
        described.poses = static_cast<NdiPoseReply>(fields.oneOf("poses", kLoggedPoses));
        described.fastestRate = std::max(9600, fields.count("rate"));
    } else {
        described.igtlPoses = static_cast<IgtlPoses>(fields.oneOf("poses", kLoggedIgtlPoses));
        described.rate_hz = std::max(1, fields.count("rate"));
    }
    std::vector<JsonFields> tools = fields.objects("tools");
    if (tools.size() > kMostLoggedTools)
        fields.refuse("tools", "there are too many");
    for (JsonFields& entry : tools) {
        auto tool = loggedTool(entry);
        if (!tool && !fault)
            return tl::unexpected(tool.error());
        if (fault)
            return tl::unexpected(*fault);
        described.tools.push_back(*std::move(tool));
    }
    if (fault)
        return tl::unexpected(*fault);
    return described;
}

} // namespace carina
