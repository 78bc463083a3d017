#include "engine/io/files/csv_text.h"

#include "engine/core/units.h"

#include <QUtf8StringView>

#include <array>
#include <charconv>
#include <cmath>

namespace carina
{
namespace
{

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr std::string_view kBlanks = " \t";
constexpr double kFarthest_mm = 1e6;

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

tl::unexpected<Error> atLine(const TextLine& line, const std::string& what)
{
    return fail(Errc::FileMalformed, "line " + std::to_string(line.number) + ": " + what);
}

/// Takes a field in quotes off the front, and what follows it up to the comma.
/// @returns false where the quotes do not close, or more than blanks follow.
bool takeQuoted(std::string_view& rest, std::string& field)
{
    rest.remove_prefix(1);
    while (!rest.empty()) {
        const char c = rest.front();
        rest.remove_prefix(1);
        if (c != '"') {
            field += c;
        } else if (rest.starts_with('"')) {
            field += c;
            rest.remove_prefix(1);
        } else {
            const std::size_t comma = std::min(rest.find(','), rest.size());
            const bool isBlank = trimmed(rest.substr(0, comma)).empty();
            rest.remove_prefix(comma);
            return isBlank;
        }
    }
    return false;
}

} // namespace

std::vector<TextLine> linesOf(std::string_view text)
{
    if (text.starts_with(kByteOrderMark))
        text.remove_prefix(kByteOrderMark.size());
    std::vector<TextLine> lines;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        if (!trimmed(line).empty())
            lines.push_back({number, line});
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

Result<std::vector<std::string>> csvFields(const TextLine& line)
{
    if (!QUtf8StringView{line.text.data(), qsizetype(line.text.size())}.isValidUtf8())
        return atLine(line, "it is no UTF-8");
    std::vector<std::string> fields;
    std::string_view rest = line.text;
    while (true) {
        std::string field;
        const std::size_t first = std::min(rest.find_first_not_of(kBlanks), rest.size());
        if (rest.substr(first).starts_with('"')) {
            rest.remove_prefix(first);
            if (!takeQuoted(rest, field))
                return atLine(line, "the quotes of field " + std::to_string(fields.size() + 1)
                                        + " do not close at its end");
        } else {
            const std::size_t comma = std::min(rest.find(','), rest.size());
            field = trimmed(rest.substr(0, comma));
            rest.remove_prefix(comma);
        }
        fields.push_back(std::move(field));
        if (rest.empty())
            return fields;
        rest.remove_prefix(1);
    }
}

std::string csvField(std::string_view text)
{
    if (text.find_first_of("\",") == std::string_view::npos && trimmed(text) == text)
        return std::string{text};
    std::string field = "\"";
    for (const char c : text) {
        if (c == '"')
            field += c;
        field += c;
    }
    return field + '"';
}

std::string digitsOf(double number)
{
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    return {digits.data(), end};
}

Result<Vec3> pointOf(const TextLine& line, std::span<const std::string, 3> fields,
                     std::span<const std::string, 3> names)
{
    Vec3 p_mm;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string& field = fields[i];
        const char* end = field.data() + field.size();
        double& number = p_mm[Eigen::Index(i)];
        const auto [rest, error] = std::from_chars(field.data(), end, number);
        if (error != std::errc{} || rest != end || !(std::abs(number) < kFarthest_mm))
            return atLine(
                line, names[i]
                          + ": a number of millimetres below a kilometre is expected, and it is \""
                          + field + '"');
    }
    return Vec3{millimetres(1.0).si * p_mm};
}

} // namespace carina
