#pragma once

#include "apps/lab/command/command.h"

namespace carina::lab
{

/// The screen that `carina-lab help` shows: a line for each command, by themes in the order of the
/// commands.
[[nodiscard]] QString overviewOf(std::span<const Command> commands);

/// The page of one command: how it is called, what it does, its options, and what it prints.
[[nodiscard]] QString pageOf(const Command& command);

} // namespace carina::lab
