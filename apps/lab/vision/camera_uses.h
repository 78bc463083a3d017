#pragma once

#include "apps/lab/command/words.h"

namespace carina::lab
{

// What `carina-lab camera` does, by the first word behind it. Each takes one place or folder.

[[nodiscard]] Use findUse();
[[nodiscard]] Result<QJsonObject> findMarkers(const Words& words);

[[nodiscard]] Use accuracyUse();
[[nodiscard]] Result<QJsonObject> measureAccuracy(const Words& words);

[[nodiscard]] Use videoUse();
[[nodiscard]] Result<QJsonObject> renderVideo(const Words& words);

[[nodiscard]] Use calibrateUse();
[[nodiscard]] Result<QJsonObject> calibrateCamera(const Words& words);

} // namespace carina::lab
