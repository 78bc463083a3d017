#pragma once

#include "engine/core/result.h"
#include "engine/lungs/body_position.h"

#include <QCommandLineParser>

#include <string_view>

namespace carina::lab
{

/// "supine", "sitting", "prone", "right_lateral" or "left_lateral".
[[nodiscard]] std::string_view positionName(BodyPosition position);

void addPositionOption(QCommandLineParser& parser);

/// How the patient lies or sits by `--position`; on the back without it.
/// @returns OutOfRange for a word that says none.
[[nodiscard]] Result<BodyPosition> positionOption(const QCommandLineParser& parser,
                                                  const char* command);

} // namespace carina::lab
