#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "engine/io/files/whole_file.h"
#include "engine/tracking/ndi/tool_definition.h"

#include <QJsonArray>

namespace carina::lab
{
namespace
{

namespace rom_key
{
constexpr Key kFile{"file", "FILE as given"};
constexpr Key kKind{"kind", "what the tool is for"};
constexpr Key kMaker{"maker", "who made the tool, as the file says"};
constexpr Key kPart{"part_number", "of the tool at its maker"};
constexpr Key kFewest{"fewest_markers", "that a pose needs"};
constexpr Key kError{"largest_error_mm", "of a marker that is used for a pose"};
constexpr Key kAngle{"largest_angle_deg", "between the normal of a marker and the camera"};
constexpr Key kSpread{"smallest_spread_mm", "extent that the markers used for a pose must have"};
constexpr Key kMarkers{"markers", "one object for each, in the order of the file:"};
constexpr Key kPosition{"p_mm", "[x, y, z] in the frame of the tool", 1};
constexpr Key kNormal{"normal", "where it faces; null where it is seen from everywhere", 1};
constexpr Key kSchema{"schema", "carina.rom/1"};
} // namespace rom_key

QJsonArray numbersOf(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

QJsonObject objectOf(const NdiToolDefinition& tool, const QString& file)
{
    QJsonArray markers;
    for (const ToolMarker& marker : tool.markers())
        markers.append(QJsonObject{
            {rom_key::kPosition, numbersOf(marker.p_OQ.unaryExpr(
                                     [](double length) { return inMillimetres(metres(length)); }))},
            {rom_key::kNormal,
             marker.normal_O.isZero() ? QJsonValue{} : QJsonValue{numbersOf(marker.normal_O)}}});
    return {{rom_key::kSchema, QLatin1StringView{rom_key::kSchema.help}},
            {rom_key::kFile, file},
            {rom_key::kKind, QString::fromStdString(kindName(tool.kind()))},
            {rom_key::kMaker, QString::fromStdString(tool.maker())},
            {rom_key::kPart, QString::fromStdString(tool.partNumber())},
            {rom_key::kFewest, qint64(tool.fewestMarkers())},
            {rom_key::kError, inMillimetres(tool.largestMarkerError())},
            {rom_key::kAngle, inDegrees(tool.largestMarkerAngle())},
            {rom_key::kSpread, inMillimetres(tool.smallestSpread())},
            {rom_key::kMarkers, markers}};
}

Result<QJsonObject> describe(const Words& words)
{
    if (words.files().size() != 1)
        return words.refuse(QStringLiteral("needs FILE."));
    const QString file = words.files()[0];
    return readWholeFile(file.toStdString(), kDefinitionLimit)
        .and_then([&](const std::string& bytes) {
            return NdiToolDefinition::read(std::as_bytes(std::span{bytes}))
                .map_error([&](const Error& error) {
                    return Error{error.code, file.toStdString() + ": " + error.detail};
                });
        })
        .map([&](const NdiToolDefinition& tool) { return objectOf(tool, file); });
}

} // namespace

Command romCommand()
{
    return {.name = "rom",
            .theme = "tracking",
            .summary = "describes a tool definition of NDI",
            .uses = {{.lines = {"FILE"},
                      .text = "Reads a tool definition of NDI (.rom), checks it, and prints the "
                              "markers of the tool.",
                      .schema = rom_key::kSchema,
                      .keys = {rom_key::kFile, rom_key::kKind, rom_key::kMaker, rom_key::kPart,
                               rom_key::kFewest, rom_key::kError, rom_key::kAngle, rom_key::kSpread,
                               rom_key::kMarkers, rom_key::kPosition, rom_key::kNormal}}},
            .mostFiles = 1,
            .reminder = "rom needs FILE.",
            .experiment = describe};
}

} // namespace carina::lab
