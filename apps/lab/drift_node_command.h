#pragma once

#include "apps/lab/command.h"

namespace carina::lab
{

/// `carina-lab drift-node`: one program of `carina-lab drift --live`, which starts it and speaks
/// with it over its standard input and output:
///
///     in:  the orders, one line (LiveOrders)
///     out: "port <n>" of the host
///     out: "ready" when it shows both objects at rest
///     in:  "start <ns>", the machine's CLOCK_MONOTONIC of the first action
///     out: its log (LiveLog), a JSON object
///
/// It ends when its standard input does, so that none outlives the one that started it.
[[nodiscard]] Command driftNodeCommand();

} // namespace carina::lab
