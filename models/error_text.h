#pragma once

#include "engine/core/result.h"

#include <QString>

namespace carina
{

/// What went wrong and what to do next, in one sentence or two, in the user's language, with the
/// error's particulars woven in.
[[nodiscard]] QString errorText(const Error& error);

} // namespace carina
