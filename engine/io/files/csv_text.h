#pragma once

#include "engine/core/result.h"
#include "engine/geometry/vec.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace carina
{

/// A line of a text and its line number, from 1.
struct TextLine {
    std::size_t number;
    std::string_view text; ///< without its line end
};

/// The lines of a text that are not blank, without a byte order mark.
[[nodiscard]] std::vector<TextLine> linesOf(std::string_view text);

/// The comma-separated fields of a line (RFC 4180), without surrounding blanks and quotes.
/// @returns FileMalformed for an unclosed quote, text after a closing quote, and invalid UTF-8. The
///          detail begins with the line number.
[[nodiscard]] Result<std::vector<std::string>> csvFields(const TextLine& line);

/// A text as one field, quoted where necessary.
[[nodiscard]] std::string csvField(std::string_view text);

/// The shortest decimal text that reads back as the same number.
[[nodiscard]] std::string digitsOf(double number);

/// Three fields as a point: millimetres in the text, metres in the result.
/// @param names of the fields
/// @returns FileMalformed where a field is not a number below a kilometre. The detail names line
///          and field.
[[nodiscard]] Result<Vec3> pointOf(const TextLine& line, std::span<const std::string, 3> fields,
                                   std::span<const std::string, 3> names);

} // namespace carina
