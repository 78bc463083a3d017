#pragma once

#include "engine/core/result.h"

#include <QString>

namespace carina
{

/// One or two translated sentences for an error: what went wrong, with the error's detail, and what
/// to do next.
[[nodiscard]] QString errorText(const Error& error);

} // namespace carina
