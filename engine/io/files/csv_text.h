#pragma once

#include "engine/core/result.h"
#include "engine/geometry/vec.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace carina
{

/// A line of a text and its number, from 1.
struct TextLine {
    std::size_t number;
    std::string_view text; ///< without its end
};

/// The lines of a text that are not blank, without a byte order mark.
[[nodiscard]] std::vector<TextLine> linesOf(std::string_view text);

/// The fields of a line, parted by commas (RFC 4180): without blanks around them, and without their
/// quotes.
/// @returns FileMalformed for a quote that is not closed, or text behind it; bytes that are no
///          UTF-8. The detail begins with the line's number.
[[nodiscard]] Result<std::vector<std::string>> csvFields(const TextLine& line);

/// A text as one field: in quotes where it needs them.
[[nodiscard]] std::string csvField(std::string_view text);

/// The shortest digits that read back as the number.
[[nodiscard]] std::string digitsOf(double number);

/// Three fields as a point, millimetres in the text and metres here.
/// @param names of the fields
/// @returns FileMalformed where one is no number below a kilometre. The detail names line and
/// field.
[[nodiscard]] Result<Vec3> pointOf(const TextLine& line, std::span<const std::string, 3> fields,
                                   std::span<const std::string, 3> names);

} // namespace carina
