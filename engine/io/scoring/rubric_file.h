#pragma once

#include "engine/core/result.h"
#include "engine/scoring/score/rubric.h"

#include <QJsonObject>

#include <filesystem>
#include <string_view>

namespace carina
{

/// A rubric as JSON:
///
///     {"schema": "carina.rubric/1", "name": "Our course", "source": "Skills laboratory",
///      "criteria": [{"metric": "time_to_breath_s", "at_most": 60, "points": 5},
///                   {"metric": "in_trachea", "at_least": 1, "points": 5, "penalty": 10,
///                    "name": "In the trachea"}]}
///
/// A metric is called as by entryOf(), with the unit of its limit in its name; 1 is yes and 0 no.
/// Each criterion has either "at_most" or "at_least". "source", "name" of a criterion and "penalty"
/// may be left out.
inline constexpr std::size_t kMostCriteria = 100;

/// @returns FileMalformed with the field at fault; UnknownFormat where the schema is another.
[[nodiscard]] Result<Rubric> rubricIn(std::string_view text);
/// The object that rubricIn reads.
[[nodiscard]] QJsonObject jsonRubric(const Rubric& rubric);

/// @returns the errors of rubricIn, and FileNotFound, FileUnreadable, FileEmpty, FileTooLarge. The
///          detail begins with the file.
[[nodiscard]] Result<Rubric> readRubricFile(const std::filesystem::path& file);

} // namespace carina
