#include "engine/io/files/csv_text.h"
#include "engine/io/site/landmark_text.h"

#include "engine/core/units.h"

#include <algorithm>
#include <array>
#include <optional>

namespace carina
{
namespace
{

const std::array<std::string, 3> kPointAxes{"x", "y", "z"};
const std::string kPlaced = "2";

tl::unexpected<Error> pointFault(std::size_t line, const std::string& what)
{
    return fail(Errc::FileMalformed, "line " + std::to_string(line) + ": " + what);
}

/// What stands behind "# key = " in a line; nothing in any other.
std::optional<std::string_view> headerOf(const TextLine& line, std::string_view key)
{
    const std::string begin = "# " + std::string{key} + " = ";
    if (!line.text.starts_with(begin))
        return std::nullopt;
    std::string_view value = line.text.substr(begin.size());
    while (value.ends_with(' '))
        value.remove_suffix(1);
    return value;
}

/// What the comments of a file tell.
struct PointList {
    Vec3 signs = Vec3::Zero(); ///< from its axes to those of A; zero where it names none
    std::vector<std::string> columns{};

    Result<void> read(const TextLine& comment)
    {
        if (const auto axes = headerOf(comment, "CoordinateSystem")) {
            if (*axes == "LPS" || *axes == "1")
                signs = {1.0, 1.0, 1.0};
            else if (*axes == "RAS" || *axes == "0")
                signs = {-1.0, -1.0, 1.0};
            else
                return fail(Errc::UnknownFormat, "line " + std::to_string(comment.number)
                                                     + ": the axes are \"" + std::string{*axes}
                                                     + "\", and LPS or RAS are expected");
        }
        if (const auto named = headerOf(comment, "columns")) {
            const auto fields = csvFields({comment.number, *named});
            if (!fields)
                return tl::unexpected(fields.error());
            columns = *fields;
        }
        return {};
    }

    [[nodiscard]] std::optional<std::size_t> column(const std::string& name) const
    {
        const auto found = std::ranges::find(columns, name);
        return found == columns.end() ? std::nullopt
                                      : std::optional{std::size_t(found - columns.begin())};
    }

    [[nodiscard]] Result<Landmark> landmark(const TextLine& line) const
    {
        if (signs.isZero())
            return pointFault(line.number, "no line \"# CoordinateSystem = LPS\" or RAS is before");
        const auto fields = csvFields(line);
        if (!fields)
            return tl::unexpected(fields.error());
        std::array<std::string, 4> found;
        for (std::size_t i = 0; i < 4; ++i) {
            const std::string& name = i < 3 ? kPointAxes[i] : std::string{"label"};
            const auto place = column(name);
            if (!place)
                return pointFault(line.number, "no line \"# columns = ...\" before has " + name);
            if (*place >= fields->size())
                return pointFault(line.number, name + ": the field is missing");
            found[i] = (*fields)[*place];
        }
        const Result<Vec3> p = pointOf(line, std::span{found}.first<3>(), kPointAxes);
        if (!p)
            return tl::unexpected(p.error());
        if (fields->size() == columns.size() + 2 && (*fields)[columns.size()] != kPlaced)
            return pointFault(line.number, "the point was not placed");
        return Landmark{found[3], signs.cwiseProduct(*p)};
    }
};

} // namespace

Result<std::vector<Landmark>> decodeSlicerPoints(std::string_view text)
{
    const std::vector<TextLine> lines = linesOf(text);
    if (lines.empty())
        return fail(Errc::FileEmpty, "there is no line in it");
    PointList list;
    std::vector<Landmark> landmarks;
    for (const TextLine& line : lines) {
        if (line.text.starts_with('#')) {
            if (const auto read = list.read(line); !read)
                return tl::unexpected(read.error());
            continue;
        }
        const Result<Landmark> landmark = list.landmark(line);
        if (!landmark)
            return tl::unexpected(landmark.error());
        landmarks.push_back(*landmark);
    }
    return landmarks;
}

std::string encodeSlicerPoints(const std::vector<Landmark>& landmarks)
{
    std::string text =
        "# Markups fiducial file version = 4.13\n"
        "# CoordinateSystem = LPS\n"
        "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n";
    int id = 0;
    for (const Landmark& landmark : landmarks) {
        text += std::to_string(++id);
        for (const double metresAlong : landmark.p_AQ)
            text += ',' + digitsOf(inMillimetres(metres(metresAlong)));
        text += ",0,0,0,1,1,1,0," + csvField(landmark.name) + ",,\n";
    }
    return text;
}

} // namespace carina
