#pragma once

#include "apps/lab/command/words.h"

namespace carina::lab
{

/// `carina-lab anatomy sweep`: its page, and what it does.
[[nodiscard]] Use sweepUse();
[[nodiscard]] Result<QJsonObject> sweepPatient(const Words& words);

} // namespace carina::lab
