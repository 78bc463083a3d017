#pragma once

#include "engine/geometry/vec.h"
#include "engine/tracking/pose_sample.h"

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

/// Reads the values of the `key = value` lines of a sequence file. Nothing where the text is not
/// wholly what is asked for.
namespace carina::field
{

/// Without blanks (and the CR of a CRLF) at either end.
[[nodiscard]] std::string_view trimmed(std::string_view text);

[[nodiscard]] std::string_view lastWord(std::string_view text);

/// NaN and infinities are numbers here.
template <class Number> [[nodiscard]] std::optional<Number> numberOf(std::string_view word)
{
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size())
        return std::nullopt;
    return value;
}

/// Exactly 16 numbers, row by row.
[[nodiscard]] std::optional<Mat4> matrixOf(std::string_view text);

/// The word a tracker's status is written as.
[[nodiscard]] std::optional<Validity> validityOf(std::string_view status);

} // namespace carina::field
