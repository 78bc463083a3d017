#include "engine/io/files/csv_text.h"
#include "engine/io/site/landmark_text.h"

#include "engine/core/units.h"

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

const std::array<std::string, 3> kTableAxes{"x_mm", "y_mm", "z_mm"};

tl::unexpected<Error> tableFault(std::size_t line, const std::string& what)
{
    return fail(Errc::FileMalformed, "line " + std::to_string(line) + ": " + what);
}

/// Where a table has its columns.
struct TableColumns {
    std::size_t count = 0;
    std::size_t name = 0;
    std::array<std::size_t, 3> axes{};
};

Result<TableColumns> columnsOf(const TextLine& line)
{
    const auto header = csvFields(line);
    if (!header)
        return tl::unexpected(header.error());
    TableColumns columns{.count = header->size()};
    const auto place = [&](const std::string& name, std::size_t& where) -> Result<void> {
        const auto found = std::ranges::find(*header, name);
        if (found == header->end())
            return tableFault(line.number, "there is no column \"" + name + '"');
        where = std::size_t(found - header->begin());
        return {};
    };
    Result<void> placed = place("name", columns.name);
    for (std::size_t i = 0; placed && i < 3; ++i)
        placed = place(kTableAxes[i], columns.axes[i]);
    if (!placed)
        return tl::unexpected(placed.error());
    return columns;
}

} // namespace

Result<std::vector<Landmark>> decodeLandmarkTable(std::string_view text)
{
    const std::vector<TextLine> lines = linesOf(text);
    if (lines.empty())
        return fail(Errc::FileEmpty, "there is no line in it");
    const Result<TableColumns> columns = columnsOf(lines.front());
    if (!columns)
        return tl::unexpected(columns.error());
    std::vector<Landmark> landmarks;
    for (const TextLine& line : std::span{lines}.subspan(1)) {
        const auto fields = csvFields(line);
        if (!fields)
            return tl::unexpected(fields.error());
        if (fields->size() != columns->count)
            return tableFault(line.number, "it has " + std::to_string(fields->size())
                                               + " fields, and " + std::to_string(columns->count)
                                               + " are expected");
        const auto& axes = columns->axes;
        const std::array<std::string, 3> numbers{(*fields)[axes[0]], (*fields)[axes[1]],
                                                 (*fields)[axes[2]]};
        const Result<Vec3> p_AQ = pointOf(line, numbers, kTableAxes);
        if (!p_AQ)
            return tl::unexpected(p_AQ.error());
        landmarks.push_back({(*fields)[columns->name], *p_AQ});
    }
    return landmarks;
}

std::string encodeLandmarkTable(const std::vector<Landmark>& landmarks)
{
    std::string text = "name,x_mm,y_mm,z_mm\n";
    for (const Landmark& landmark : landmarks) {
        text += csvField(landmark.name);
        for (const double metresAlong : landmark.p_AQ)
            text += ',' + digitsOf(inMillimetres(metres(metresAlong)));
        text += '\n';
    }
    return text;
}

} // namespace carina
