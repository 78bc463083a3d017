#pragma once

#include "engine/core/result.h"
#include "engine/geometry/vec.h"
#include "engine/tracking/pose_sample.h"

#include <charconv>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>

/// Parses the values in files of poses. The parsers return nothing where the text, as a whole, is
/// not such a value.
namespace carina::field
{

/// Largest amount of a time in a file: a century, so that two times can be subtracted.
inline constexpr double kLongestSeconds = 3e9;

/// Opens a file of poses. @returns FileNotFound; FileUnreadable, also for a folder.
[[nodiscard]] Result<std::ifstream> openFile(const std::filesystem::path& path);

/// The text without blanks (and the CR of a CRLF) at either end.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The part after the last blank of the trimmed text.
[[nodiscard]] std::string_view lastWord(std::string_view text);

/// A number; NaN and infinities are accepted.
template <class Number> [[nodiscard]] std::optional<Number> numberOf(std::string_view word)
{
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size())
        return std::nullopt;
    return value;
}

/// A 4x4 matrix: exactly 16 numbers, row by row.
[[nodiscard]] std::optional<Mat4> matrixOf(std::string_view text);

/// The validity that a tracker's status word stands for (see readSequence).
[[nodiscard]] std::optional<Validity> validityOf(std::string_view status);

} // namespace carina::field
