#pragma once

#include "apps/lab/command/words.h"

namespace carina::lab
{

/// `carina-lab anatomy dimensions`: its page, and what it does.
[[nodiscard]] Use dimensionsUse();
[[nodiscard]] Result<QJsonObject> measurePatients(const Words& words);

} // namespace carina::lab
