#include "apps/lab/tracking/polaris_tools.h"

#include "apps/lab/tracking/simulated_tools.h"
#include "engine/io/files/whole_file.h"

#include <algorithm>
#include <optional>

namespace carina::lab
{
namespace
{

constexpr std::size_t kMostTools = 9;
constexpr std::size_t kLongestName = 20; // of a part number
constexpr double kOnALine_mm = 1.0;      // of a marker from the line through two others

/// kWiredTool would be taken for the wired one.
bool canBePartNumber(const std::string& name)
{
    return !name.empty() && name != kWiredTool && name.size() <= kLongestName
           && std::ranges::all_of(name, [](char each) { return each >= ' ' && each <= '~'; });
}

bool areOnALine(const std::vector<PolarisTool::Marker>& markers)
{
    const Vec3 first = markers.front().p_mm;
    Vec3 along = Vec3::Zero();
    for (const PolarisTool::Marker& marker : markers)
        if ((marker.p_mm - first).norm() > along.norm())
            along = marker.p_mm - first;
    return std::ranges::all_of(markers, [&](const PolarisTool::Marker& marker) {
        return along.normalized().cross(marker.p_mm - first).norm() < kOnALine_mm;
    });
}

/// What the device reads in a definition.
Result<PolarisTool> knownFrom(const NdiToolDefinition& definition)
{
    std::string bytes;
    for (const std::byte each : definition.bytes())
        bytes += char(std::to_integer<unsigned char>(each));
    return polarisTool(bytes);
}

/// Puts what a file says in place of a tool's definition.
Result<void> putFile(const Words& words, DescribedTool& tool, const QString& file)
{
    const auto named = [&](const Error& error) {
        return Error{error.code, file.toStdString() + ": " + error.detail};
    };
    const auto bytes = readWholeFile(file.toStdString(), kDefinitionLimit);
    if (!bytes)
        return tl::unexpected(bytes.error());
    const auto known = polarisTool(*bytes);
    if (!known)
        return tl::unexpected(named(known.error()));
    auto definition = NdiToolDefinition::read(std::as_bytes(std::span{*bytes}));
    if (!definition)
        return tl::unexpected(named(definition.error()));
    if (areOnALine(known->markers))
        return words.refuse(
            QStringLiteral("cannot show %1: its markers are on one line, so that nothing tells "
                           "how it is turned about it.")
                .arg(file));
    tool.definition = *std::move(definition);
    return {};
}

/// Two tools that a device cannot tell apart.
std::optional<std::pair<std::string, std::string>>
likeTools(const std::map<std::string, PolarisTool>& known)
{
    for (auto one = known.begin(); one != known.end(); ++one)
        for (auto other = std::next(one); other != known.end(); ++other)
            if (haveSameMarkers(one->second, other->second))
                return std::pair{one->first, other->first};
    return std::nullopt;
}

} // namespace

Result<std::vector<NamedTool>> toolsOf(const Words& words, const TrackerSequence& sequence)
{
    if (sequence.tools.empty() || sequence.tools.size() > kMostTools)
        return words.refuse(QStringLiteral("sees one to nine tools, and the recording has %1.")
                                .arg(sequence.tools.size()));
    std::vector<NamedTool> tools;
    for (const RecordedTool& tool : sequence.tools) {
        if (!canBePartNumber(tool.name)
            || std::ranges::count(tools, tool.name, &NamedTool::first) != 0)
            return words.refuse(QStringLiteral("needs a name of its own for each tool, of at most "
                                               "20 plain characters, not '%1'.")
                                    .arg(QString::fromStdString(tool.name)));
        const bool isTaken = std::ranges::count(tools, tool.role, &NamedTool::second) != 0;
        tools.emplace_back(tool.name, isTaken ? ToolRole::Other : tool.role);
    }
    return tools;
}

Result<PolarisTools> polarisTools(const Words& words, const std::vector<NamedTool>& named,
                                  const QString& files)
{
    auto described = simulatedTools(named);
    if (!described)
        return tl::unexpected(described.error());
    PolarisTools tools{.described = *std::move(described), .known = {}};
    for (const QString& each : files.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        const QString name = each.section(QLatin1Char('='), 0, 0);
        const QString file = each.section(QLatin1Char('='), 1);
        const auto tool =
            std::ranges::find(tools.described, name.toStdString(), &DescribedTool::name);
        if (tool == tools.described.end() || file.isEmpty())
            return words.refuse(
                QStringLiteral("needs --tool with TOOL=FILE of one of its tools, not '%1'.")
                    .arg(each));
        if (const auto put = putFile(words, *tool, file); !put)
            return tl::unexpected(put.error());
    }
    for (const DescribedTool& tool : tools.described) {
        const auto known = knownFrom(*tool.definition);
        if (!known)
            return tl::unexpected(known.error());
        tools.known[tool.name] = *known;
    }
    if (const auto like = likeTools(tools.known))
        return words.refuse(
            QStringLiteral("cannot tell %1 and %2 apart: their markers are at the "
                           "same places.")
                .arg(QString::fromStdString(like->first), QString::fromStdString(like->second)));
    return tools;
}

} // namespace carina::lab
